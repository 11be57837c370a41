// SSD1327 grey OLED (1.5"), on I2C.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ssd1327_i2c = hal::board({
    .name = "ssd1327-i2c",
    .summary = "SSD1327 128x128, sixteen greys, I2C at 400 kHz",
    .display = {.panel = &hal::panels::ssd1327_128x128, .wire = hal::wires::grey4, .reset_line = false},
    .bus = hal::BusKind::i2c,
    .write_hz = 400000, // Hz; datasheet: a write cycle of 2.5 us or more
});

} // namespace spangle::boards
