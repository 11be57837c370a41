#include <spangle/hal/palette.hpp>

namespace spangle::hal {

void Palette::begin() {
    for (std::int32_t i = 0; i < palette_size; ++i)
        for (int c = 0; c < 3; ++c)
            color[i][c] = initial_color(i).c[c];
    all_fresh();
}

void Palette::set(std::int32_t first, std::int32_t count, const std::uint8_t* rgb) {
    for (std::int32_t i = first; i < first + count; ++i)
        for (int c = 0; c < 3; ++c, ++rgb) {
            std::uint8_t& now = color[i][c];
            if (now != *rgb)
                stale[i / 32] |= 1u << i % 32;
            now = *rgb;
        }
}

} // namespace spangle::hal
