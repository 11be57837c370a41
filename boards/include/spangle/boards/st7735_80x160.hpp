// ST7735S behind 80x160 IPS [glass](docs/glossary.md#glass), landscape: the 0.96" modules.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board st7735_80x160 = hal::board({
    .name = "st7735-80x160",
    .summary = "ST7735 160x80 (landscape), 4-wire SPI at 15 MHz",
    .display = {.panel = &hal::panels::st7735_80x160_26, .orientation = {hal::Rotation::r90}},
    .bus = hal::BusKind::spi4,
    .write_hz = 15000000, // Hz; datasheet: a write cycle of 66 ns or more
});

} // namespace spangle::boards
