// ST7789 behind 240x240 IPS glass: the 1.3" and 1.54" modules. Their data line is not wired back.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board st7789_240 = hal::board({
    .name = "st7789-240",
    .summary = "ST7789 240x240, 4-wire SPI at 62.5 MHz",
    .display = {.panel = &hal::panels::st7789_240x240},
    .bus = hal::BusKind::spi4,
    .write_hz = 62500000, // ST7789VW datasheet: 16 ns
});

} // namespace spangle::boards
