// SSD1306 OLED of half the height (0.91"), on I2C.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ssd1306_128x32 = hal::board({
    .name = "ssd1306-128x32",
    .summary = "SSD1306 128x32, I2C at 400 kHz",
    .display = {.panel = &hal::panels::ssd1306_128x32, .wire = hal::wires::mono, .reset_line = false},
    .bus = hal::BusKind::i2c,
    .write_hz = 400000, // Hz; datasheet: a write cycle of 2.5 us or more
});

} // namespace spangle::boards
