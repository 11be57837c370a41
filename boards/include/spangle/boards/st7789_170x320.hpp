// ST7789 behind 170x320 IPS [glass](docs/glossary.md#glass), landscape: the 1.9" modules.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board st7789_170x320 = hal::board({
    .name = "st7789-170x320",
    .summary = "ST7789 320x170 (landscape), 4-wire SPI at 62.5 MHz",
    .display = {.panel = &hal::panels::st7789_170x320, .orientation = {hal::Rotation::r90}},
    .bus = hal::BusKind::spi4,
    .write_hz = 62500000, // Hz; ST7789VW datasheet: a write cycle of 16 ns or more
});

} // namespace spangle::boards
