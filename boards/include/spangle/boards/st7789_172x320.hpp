// ST7789 behind 172x320 IPS [glass](docs/glossary.md#glass), landscape: the 1.47" modules.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board st7789_172x320 = hal::board({
    .name = "st7789-172x320",
    .summary = "ST7789 320x172 (landscape), 4-wire SPI at 62.5 MHz",
    .display = {.panel = &hal::panels::st7789_172x320, .orientation = {hal::Rotation::r90}},
    .bus = hal::BusKind::spi4,
    .write_hz = 62500000, // Hz; ST7789VW datasheet: a write cycle of 16 ns or more
});

} // namespace spangle::boards
