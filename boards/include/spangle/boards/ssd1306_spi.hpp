// SSD1306 OLED with seven pins, on 4-wire SPI.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ssd1306_spi = hal::board({
    .name = "ssd1306-spi",
    .summary = "SSD1306 128x64, 4-wire SPI at 10 MHz",
    .display = {.panel = &hal::panels::ssd1306_128x64, .wire = hal::wires::mono},
    .bus = hal::BusKind::spi4,
    .write_hz = 10000000, // Hz; datasheet: a write cycle of 100 ns or more
});

} // namespace spangle::boards
