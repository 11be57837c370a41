// Runs readers of untrusted files in a process of their own, with limits on memory and time. Whatever a file
// does to its reader, crash, hang or take all memory, is reported as one sentence.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace spangle::cli {

struct ReadLimits {
    std::uint64_t memory = std::uint64_t{2} << 30;  ///< bytes of memory that the reader may have
    int seconds = 120;                              ///< s of wall-clock time until the answer is complete
    std::size_t handed_over = std::size_t{1} << 30; ///< bytes of the answer
};

/// Runs `read` in a child process and takes the bytes that it returns into `answer`. What the child writes to
/// standard output and standard error is lost, and it cannot make files. Returns an empty string, or why
/// there is no answer, as a clause about the reader ("takes longer than 60 s").
std::string run_confined(const std::function<std::string()>& read, const ReadLimits& limits,
                         std::string& answer);

/// Makes text from a file fit for one line of a terminal: control characters become spaces, and what is
/// longer than a few lines is cut.
std::string one_line(const std::string& text);

} // namespace spangle::cli
