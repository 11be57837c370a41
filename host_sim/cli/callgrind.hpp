// How many instructions a frame takes on this machine, as valgrind's callgrind counts them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spangle::cli {

/// This program with those words, drawing one frame and then more: the difference, for each frame. 0 and
/// `problem`, where valgrind is not installed or failed.
std::uint64_t instructions_of_frame(const std::vector<std::string>& words, std::string& problem);

} // namespace spangle::cli
