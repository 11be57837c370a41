// ILI9342C, landscape by itself: the 2.0" [glass](docs/glossary.md#glass) of square boxes.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ili9342c = hal::board({
    .name = "ili9342c",
    .summary = "ILI9342C 320x240, 4-wire SPI at 40 MHz",
    .display = {.panel = &hal::panels::ili9342c_320x240, .read_back = true},
    .bus = hal::BusKind::spi4,
    .write_hz = 40000000, // Hz; datasheet: a write cycle of 100 ns or more; modules work at this clock
    .read_hz = 6000000,
});

} // namespace spangle::boards
