// ST7796S module, landscape, on 4-wire SPI: the 3.5" and 4.0" boards.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board st7796s_spi = hal::board({
    .name = "st7796s-spi",
    .summary = "ST7796S 480x320 (landscape), 4-wire SPI at 80 MHz",
    .display = {.panel = &hal::panels::st7796s_320x480, .orientation = {hal::Rotation::r90}},
    .bus = hal::BusKind::spi4,
    .write_hz = 80000000, // Hz; datasheet: a write cycle of 66 ns or more; modules work at this clock
});

} // namespace spangle::boards
