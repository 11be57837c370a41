// Reads the value of the option --size.
#pragma once

#include <cstdio>
#include <string>

namespace spangle::cli {

/// Reads "320x240", both sides 1 to 2048. Returns what is wrong with the text, or an empty string.
inline std::string read_size(const std::string& text, int& width, int& height) {
    constexpr int largest = 2048;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 || height < 1 ||
        width > largest || height > largest)
        return "--size takes WIDTHxHEIGHT, each 1 to 2048, not '" + text + "'";
    return "";
}

} // namespace spangle::cli
