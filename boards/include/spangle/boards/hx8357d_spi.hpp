// HX8357D breakout, landscape, on 4-wire SPI.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board hx8357d_spi = hal::board({
    .name = "hx8357d-spi",
    .summary = "HX8357D 480x320 (landscape), 4-wire SPI at 24 MHz",
    .display = {.panel = &hal::panels::hx8357d_320x480,
                .orientation = {hal::Rotation::r90},
                .read_back = true},
    .bus = hal::BusKind::spi4,
    .write_hz = 24000000, // Hz; datasheet: a write cycle of 66 ns or more; modules work at this clock
    .read_hz = 2000000,
});

} // namespace spangle::boards
