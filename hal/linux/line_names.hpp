// What errors call lines, and where chips are looked for. Shared by the back ends for both libgpiod majors.
#pragma once

#include <cstddef>
#include <cstdio>
#include <span>

namespace spangle::hal {

inline constexpr const char* line_consumer = "spangle";
inline constexpr int most_chips = 64; ///< the most chips whose labels are read

inline bool is_path(const char* chip) {
    return chip[0] == '/';
}

inline void name_chip(char (&text)[32], int number) {
    std::snprintf(text, sizeof text, "/dev/gpiochip%d", number);
}

template <std::size_t N>
void name_lines(char (&text)[N], const char* chip, std::span<const unsigned> offsets) {
    int at = std::snprintf(text, N, "%.40s line%s", chip, offsets.size() == 1 ? "" : "s");
    for (std::size_t i = 0; i < offsets.size() && at > 0 && static_cast<std::size_t>(at) < N; ++i)
        at += std::snprintf(text + at, N - static_cast<std::size_t>(at), "%c%u", i == 0 ? ' ' : ',',
                            offsets[i]);
}

/// Why a request failed: the program that uses the line, or null.
inline const char* in_use(char (&text)[64], const char* consumer) {
    if (consumer == nullptr)
        return nullptr;
    std::snprintf(text, sizeof text, "the line is in use by '%.32s'", consumer);
    return text;
}

} // namespace spangle::hal
