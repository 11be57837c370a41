// Fills bytes with a pattern, by simple loops.
#pragma once

#include "raster/surface/pattern.hpp"

namespace spangle::raster {

namespace clearing {

/// Whether rows that touch are filled as one piece.
inline constexpr bool joins_rows = false;

/// Fills `bytes` bytes with the pattern from its start. No byte beyond them is touched.
inline void fill(std::uint8_t* to, const Pattern& pattern, std::int32_t bytes) {
    std::int32_t from = 0;
    for (; bytes >= 16; bytes -= 16, to += 16) {
        __builtin_memcpy(to, pattern.byte + from, 16);
        if (has_format(PixelFormat::rgb888)) // only this format has a period above 16
            from = from + 16 == pattern.period() ? 0 : from + 16;
    }
    copy_bytes(to, pattern.byte + from, bytes);
}

/// Like fill(), but writes only the bits of the mask, which has the period of the pattern.
inline void fill_masked(std::uint8_t* to, const Pattern& pattern, const Pattern& mask, std::int32_t bytes) {
    std::int32_t from = 0;
    const auto next = [&](std::int32_t step) {
        to += step, bytes -= step, from += step;
        if (from == pattern.period())
            from = 0;
    };
    while (bytes > 0) {
        const unsigned open = mask.byte[from];
        *to = static_cast<std::uint8_t>((*to & ~open) | (pattern.byte[from] & open));
        next(1);
    }
}

} // namespace clearing

} // namespace spangle::raster
