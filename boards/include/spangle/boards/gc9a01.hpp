// GC9A01 behind round 240x240 IPS glass: the 1.28" modules.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board gc9a01 = hal::board({
    .name = "gc9a01",
    .summary = "GC9A01 240x240 round, 4-wire SPI at 80 MHz",
    .display = {.panel = &hal::panels::gc9a01_240x240},
    .bus = hal::BusKind::spi4,
    .write_hz = 80000000, // Hz; datasheet: a write cycle of 10 ns or more
});

} // namespace spangle::boards
