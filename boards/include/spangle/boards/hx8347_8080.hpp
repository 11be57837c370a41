// HX8347 shield, landscape, on an 8-bit 8080 bus.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board hx8347_8080 = hal::board({
    .name = "hx8347-8080",
    .summary = "HX8347 320x240, 8-bit 8080 bus at 15 MHz",
    .display = {.panel = &hal::panels::hx8347_240x320,
                .orientation = {hal::Rotation::r90},
                .read_back = true},
    .bus = hal::BusKind::i8080,
    .write_hz = 15000000, // Hz; datasheet: a write cycle of 66 ns or more
    .read_hz = 2000000,
});

} // namespace spangle::boards
