// SSD1351 colour OLED (1.5"), on 4-wire SPI.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ssd1351_spi = hal::board({
    .name = "ssd1351-spi",
    .summary = "SSD1351 128x128, 4-wire SPI at 20 MHz",
    .display = {.panel = &hal::panels::ssd1351_128x128},
    .bus = hal::BusKind::spi4,
    .write_hz = 20000000, // Hz; datasheet: a write cycle of 50 ns or more
});

} // namespace spangle::boards
