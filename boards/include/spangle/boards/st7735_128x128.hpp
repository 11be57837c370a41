// ST7735 behind 128x128 [glass](docs/glossary.md#glass), green tab: the 1.44" modules.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board st7735_128x128 = hal::board({
    .name = "st7735-128x128",
    .summary = "ST7735 128x128 green tab, 4-wire SPI at 15 MHz",
    .display = {.panel = &hal::panels::st7735_128x128_green},
    .bus = hal::BusKind::spi4,
    .write_hz = 15000000, // Hz; datasheet: a write cycle of 66 ns or more
});

} // namespace spangle::boards
