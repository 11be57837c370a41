// Readers of other people's files run in a process of their own, with limits on memory and time. Whatever a
// file does to a library that reads it, crash, hang or take all memory, is one sentence here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace spangle::cli {

struct ReadLimits {
    std::uint64_t memory = std::uint64_t{2} << 30;  ///< bytes that the reader may have
    int seconds = 120;                              ///< of the clock, until the reader has handed over
    std::size_t handed_over = std::size_t{1} << 30; ///< bytes of its answer
};

/// Runs `read` in a child process and takes the bytes that it returns into `answer`. What it writes to
/// standard output and standard error is lost, and it cannot make files. Empty, or why there is no answer: a
/// clause about the reader ("takes longer than 60 s").
std::string confined(const std::function<std::string()>& read, const ReadLimits& limits, std::string& answer);

/// Text that a file brought along, fit for one line of a terminal: control characters are spaces, and what is
/// longer than a few lines is cut.
std::string one_line(const std::string& text);

} // namespace spangle::cli
