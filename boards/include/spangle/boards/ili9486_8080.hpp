// ILI9486 shield, landscape, on an 8-bit 8080 bus.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ili9486_8080 = hal::board({
    .name = "ili9486-8080",
    .summary = "ILI9486 480x320 (landscape), 8-bit 8080 bus at 15 MHz",
    .display = {.panel = &hal::panels::ili9486_320x480,
                .orientation = {hal::Rotation::r90},
                .read_back = true},
    .bus = hal::BusKind::i8080,
    .write_hz = 15000000, // Hz; datasheet: a write cycle of 50 ns or more; 66 ns for boards of jumper wires
    .read_hz = 2000000,
});

} // namespace spangle::boards
