// ST7789 behind 240x240 IPS glass: the 1.3" and 1.54" modules. The modules do not
// [wire](docs/glossary.md#wire) the controller's data output.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board st7789_240 = hal::board({
    .name = "st7789-240",
    .summary = "ST7789 240x240, 4-wire SPI at 62.5 MHz",
    .display = {.panel = &hal::panels::st7789_240x240},
    .bus = hal::BusKind::spi4,
    .write_hz = 62500000, // Hz; ST7789VW datasheet: a write cycle of 16 ns or more
});

} // namespace spangle::boards
