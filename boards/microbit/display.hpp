// SSD1306 on a micro:bit's I2C: 128x64 of one bit, drawn in bands of one page.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board microbit = hal::board({
    .name = "microbit",
    .summary = "BBC micro:bit (nRF51822, 16 KB), SSD1306 128x64, I2C, bands of 8 rows",
    .display =
        {.panel = &hal::panels::ssd1306_128x64, .format = PixelFormat::mono, .reset_line = false, .band = 8},
    .bus = hal::BusKind::i2c,
    .write_hz = 400000,
});

} // namespace spangle::boards
