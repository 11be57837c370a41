// SSD0303 OLED of the LM3S811 evaluation board, on its I2C (address 3Dh).
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ssd0303_i2c = hal::board({
    .name = "ssd0303-i2c",
    .summary = "SSD0303 96x16, I2C at 400 kHz",
    .display = {.panel = &hal::panels::ssd0303_96x16, .wire = hal::wires::mono, .reset_line = false},
    .bus = hal::BusKind::i2c,
    .write_hz = 400000, // Hz; datasheet: a write cycle of 2.5 us or more
});

} // namespace spangle::boards
