// SSD1306 OLED with four pins (0.96"), on I2C. It has no reset pin; the reset follows the supply voltage.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ssd1306_i2c = hal::board({
    .name = "ssd1306-i2c",
    .summary = "SSD1306 128x64, I2C at 400 kHz",
    .display = {.panel = &hal::panels::ssd1306_128x64, .wire = hal::wires::mono, .reset_line = false},
    .bus = hal::BusKind::i2c,
    .write_hz = 400000, // Hz; datasheet: a write cycle of 2.5 us or more
});

} // namespace spangle::boards
