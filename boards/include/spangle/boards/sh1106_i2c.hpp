// SH1106 OLED (1.3"), on I2C.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board sh1106_i2c = hal::board({
    .name = "sh1106-i2c",
    .summary = "SH1106 128x64, I2C at 400 kHz",
    .display = {.panel = &hal::panels::sh1106_128x64, .wire = hal::wires::mono, .reset_line = false},
    .bus = hal::BusKind::i2c,
    .write_hz = 400000, // Hz; datasheet: a write cycle of 2.5 us or more
});

} // namespace spangle::boards
