// ST7789 behind 240x280 IPS [glass](docs/glossary.md#glass) with round corners: the 1.69" modules.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board st7789_240x280 = hal::board({
    .name = "st7789-240x280",
    .summary = "ST7789 240x280, 4-wire SPI at 62.5 MHz",
    .display = {.panel = &hal::panels::st7789_240x280},
    .bus = hal::BusKind::spi4,
    .write_hz = 62500000, // Hz; ST7789VW datasheet: a write cycle of 16 ns or more
});

} // namespace spangle::boards
