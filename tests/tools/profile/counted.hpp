// A clock that advances five ticks between two readings, and output that is kept, for code that counts
// pixels.
#pragma once

#include <cstdint>
#include <string>

namespace spangle::measure {

inline constexpr std::uint32_t ticks_of_a_look = 5;
inline std::uint32_t looks = 0;
inline std::string said;

inline std::uint32_t now() {
    return looks += ticks_of_a_look;
}

inline std::uint32_t ticks_between(std::uint32_t begin, std::uint32_t end) {
    return end - begin;
}

inline void print(const char* text) {
    said += text;
}

inline void print(std::uint32_t number) {
    said += std::to_string(number);
}

} // namespace spangle::measure
