// Draws a pattern into a panel's frame and compares the glass with the frame. The tests of every transport
// use it.
#pragma once

#include <algorithm>
#include <string>

#include <spangle/hal/panel_display.hpp>
#include <spangle/panels.hpp>
#include <spangle/sim/image.hpp>

namespace spangle::test {

/// A glass in a corner of an ST7735's memory, so small that thousands of frames are quick.
inline constexpr hal::PanelDesc tiny_panel =
    hal::panels::st7735::on_glass("tiny", {132, 162}, {24, 16}, {5, 7}, hal::ColorOrder::rgb);

/// A panel display with a public destructor, which std::optional needs.
struct OwnedDisplay final : hal::PanelDisplay {
    using hal::PanelDisplay::PanelDisplay;
};

/// Draws a pattern that depends on `seed` into `area` of the frame, and marks it touched.
inline bool draw_pattern(hal::Display& display, unsigned seed, Rect area) {
    const auto frame = display.acquire();
    if (!frame.ok())
        return false;
    for (std::int32_t y = area.y; y < area.y + area.h; ++y)
        for (std::int32_t x = area.x; x < area.x + area.w; ++x) {
            std::uint8_t* const at = frame.value().pixels + y * frame.value().stride + 2 * x;
            const unsigned word =
                (static_cast<unsigned>(x) * 40503u ^ static_cast<unsigned>(y) * 9973u) + seed * 2654435761u;
            at[0] = static_cast<std::uint8_t>(word >> 24);
            at[1] = static_cast<std::uint8_t>(word >> 16);
        }
    for (std::int32_t y = area.y; y < area.y + area.h; ++y) {
        RowSpan& row = frame.value().extents->rows[y];
        const RowSpan drawn = {static_cast<std::int16_t>(area.x), static_cast<std::int16_t>(area.x + area.w)};
        row = row.begin < row.end ? RowSpan{std::min(row.begin, drawn.begin), std::max(row.end, drawn.end)}
                                  : drawn;
    }
    return true;
}

inline bool draw_pattern(hal::Display& display, unsigned seed) {
    const hal::DisplayInfo info = display.info();
    return draw_pattern(display, seed, {0, 0, info.width, info.height});
}

/// Returns an empty text if the glass shows the frame, else what differs. The display must have one buffer
/// only, so that the frame still has its content.
inline std::string glass_difference(hal::Display& display, const sim::Image& glass) {
    const auto frame = display.acquire();
    if (!frame.ok())
        return frame.error().rule;
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x) {
            const std::uint8_t* const want = frame.value().pixels + y * frame.value().stride + 2 * x;
            const unsigned word = static_cast<unsigned>(want[0] << 8 | want[1]);
            const std::uint8_t* const got = glass.at(x, y);
            if ((got[0] >> 3) != (word >> 11) || (got[1] >> 2) != (word >> 5 & 63) ||
                (got[2] >> 3) != (word & 31))
                return "pixel " + std::to_string(x) + ", " + std::to_string(y) + " differs";
        }
    return "";
}

} // namespace spangle::test
