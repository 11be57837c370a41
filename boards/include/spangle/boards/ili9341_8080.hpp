// ILI9341 shield, landscape, on an 8-bit 8080 bus.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ili9341_8080 = hal::board({
    .name = "ili9341-8080",
    .summary = "ILI9341 320x240, 8-bit 8080 bus at 15 MHz, TE",
    .display = {.panel = &hal::panels::ili9341_240x320,
                .orientation = {hal::Rotation::r90},
                .read_back = true},
    .bus = hal::BusKind::i8080,
    .write_hz = 15000000, // Hz; datasheet: a write cycle of 66 ns or more
    .read_hz = 2000000,   // Hz; datasheet: a read cycle of 450 ns or more for frame memory
    .has_te = true,
});

} // namespace spangle::boards
