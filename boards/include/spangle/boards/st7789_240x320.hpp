// ST7789 behind 240x320 IPS [glass](docs/glossary.md#glass), landscape, with TE: the 2.0" and 2.4" modules.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board st7789_240x320 = hal::board({
    .name = "st7789-240x320",
    .summary = "ST7789 320x240 (landscape), 4-wire SPI at 62.5 MHz, TE",
    .display = {.panel = &hal::panels::st7789_240x320, .orientation = {hal::Rotation::r90}},
    .bus = hal::BusKind::spi4,
    .write_hz = 62500000, // Hz; ST7789VW datasheet: a write cycle of 16 ns or more
    .has_te = true,
});

} // namespace spangle::boards
