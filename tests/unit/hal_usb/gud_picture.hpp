// Draws pictures on a GUD display of Spangle, and computes what the device should then show.
#pragma once

#include <algorithm>
#include <array>
#include <string>

#include <spangle/usb/gud_display.hpp>

#include "host_sim/usb/gud_device.hpp"

namespace gud_test {

using namespace spangle;

/// Draws a pattern that depends on `seed` into the frame, and marks it touched. A `flat` pattern can be
/// compressed.
inline bool draw_pattern(hal::GudDisplay& display, unsigned seed, Rect area, bool flat = false) {
    const auto frame = display.acquire();
    if (!frame.ok())
        return false;
    for (std::int32_t y = area.y; y < area.y + area.h; ++y) {
        for (std::int32_t x = area.x; x < area.x + area.w; ++x) {
            const unsigned noise = static_cast<unsigned>(x) * 40503u ^ static_cast<unsigned>(y) * 9973u;
            const unsigned word = ((flat ? 0 : noise) + seed) * 2654435761u;
            std::uint8_t* const at = frame.value().pixels + y * frame.value().stride + 2 * x;
            at[0] = static_cast<std::uint8_t>(word >> 24);
            at[1] = static_cast<std::uint8_t>(word >> 16);
        }
        RowSpan& row = frame.value().extents->rows[y];
        row = {std::min(row.begin, static_cast<std::int16_t>(area.x)),
               std::max(row.end, static_cast<std::int16_t>(area.x + area.w))};
    }
    return true;
}

/// Presents a frame, waits for its end, and returns the result.
inline hal::Result<void> show(hal::GudDisplay& display) {
    const auto presented = display.present();
    return presented ? display.finish() : presented;
}

/// Returns what a device of this format makes of an RGB565 word, by the definition of the format; `y` counts
/// from the bottom. Formats of fewer bits are dithered as GL dithers.
inline std::array<int, 3> expected_pixel(const sim::GudDevice& device, unsigned word, int x, int y) {
    constexpr int k[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const double threshold = (k[y & 3][x & 3] + 0.5) / 16;
    const auto dithered = [&](unsigned v, unsigned all, int most) {
        return static_cast<int>(static_cast<double>(v) / all * most + threshold) * 255 / most;
    };
    const auto nearest = [](unsigned v, unsigned most) { return static_cast<int>(v * 255.0 / most + 0.5); };
    const int r = nearest(word >> 11, 31), g = nearest(word >> 5 & 63, 63), b = nearest(word & 31, 31);
    const int grey = (3 * r + 6 * g + b) / 10;
    switch (device.formats.front()) {
    case 0x01:
        return {dithered(static_cast<unsigned>(grey), 255, 1), dithered(static_cast<unsigned>(grey), 255, 1),
                dithered(static_cast<unsigned>(grey), 255, 1)};
    case 0x08:
        return {grey, grey, grey};
    case 0x20:
        return {dithered(word >> 11, 31, 1), dithered(word >> 5 & 63, 63, 1), dithered(word & 31, 31, 1)};
    case 0x30:
        return {dithered(word >> 11, 31, 7), dithered(word >> 5 & 63, 63, 7), dithered(word & 31, 31, 3)};
    case 0x40: // the device widens the components, rounding down
        return {static_cast<int>((word >> 11) * 255 / 31), static_cast<int>((word >> 5 & 63) * 255 / 63),
                static_cast<int>((word & 31) * 255 / 31)};
    default:
        return {r, g, b};
    }
}

/// Returns an empty text if the device shows the frame as well as its format can.
inline std::string glass_difference(hal::GudDisplay& display, const sim::GudDevice& device) {
    const auto frame = display.acquire();
    if (!frame.ok())
        return frame.error().rule;
    const sim::Image glass = device.glass();
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x) {
            const std::uint8_t* const p = frame.value().pixels + y * frame.value().stride + 2 * x;
            const std::uint8_t* const got = glass.at(x, y);
            const auto want =
                expected_pixel(device, static_cast<unsigned>(p[0] | p[1] << 8), x, glass.height - 1 - y);
            if (got[0] != want[0] || got[1] != want[1] || got[2] != want[2])
                return "pixel " + std::to_string(x) + ", " + std::to_string(y) + " differs";
        }
    return device.violations();
}

} // namespace gud_test
