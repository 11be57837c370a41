// Counts the instructions of a frame on this machine, with valgrind's callgrind.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spangle::cli {

/// Runs this program with these words, once for one frame and once for more frames. The difference gives the
/// instructions of a frame. Returns 0 and sets `problem` where valgrind is not installed or has failed.
std::uint64_t instructions_of_frame(const std::vector<std::string>& words, std::string& problem);

} // namespace spangle::cli
