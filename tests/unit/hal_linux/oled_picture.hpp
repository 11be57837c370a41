// Draws dots on an OLED of 128x64, and compares its glass with them.
#pragma once

#include <algorithm>
#include <string>

#include <spangle/hal/display.hpp>

#include "host_sim/controller/controller.hpp"

namespace linux_test {

/// Draws black and white pixels, which dithering does not change, and marks them touched.
inline bool draw_dots(spangle::hal::Display& display, unsigned seed, spangle::Rect area) {
    const auto frame = display.acquire();
    if (!frame.ok())
        return false;
    for (int y = area.y; y < area.y + area.h; ++y) {
        for (int x = area.x; x < area.x + area.w; ++x) {
            const unsigned noise = (static_cast<unsigned>(x * 131 + y * 977) + seed) * 2654435761u;
            const auto byte = static_cast<std::uint8_t>((noise >> 20 & 1) != 0 ? 0xFF : 0);
            std::uint8_t* const at = frame.value().pixels + y * frame.value().stride + 2 * x;
            at[0] = at[1] = byte;
        }
        spangle::RowSpan& row = frame.value().extents->rows[y];
        row = {std::min(row.begin, static_cast<std::int16_t>(area.x)),
               std::max(row.end, static_cast<std::int16_t>(area.x + area.w))};
    }
    return true;
}

/// Returns which pixel differs from the surface first; empty if none does.
inline std::string dots_difference(spangle::hal::Display& display, spangle::sim::Controller& oled,
                                   spangle::sim::Time now) {
    const auto frame = display.acquire();
    if (!frame.ok())
        return frame.error().rule;
    const auto glass = oled.glass(now);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 128; ++x) {
            const bool wanted = frame.value().pixels[y * frame.value().stride + 2 * x] != 0;
            if ((glass[static_cast<std::size_t>(y * 128 + x)].g != 0) != wanted)
                return "pixel " + std::to_string(x) + ", " + std::to_string(y) + " differs";
        }
    return "";
}

} // namespace linux_test
