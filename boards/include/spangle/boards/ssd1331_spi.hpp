// SSD1331 colour OLED (0.95"), on 4-wire SPI.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ssd1331_spi = hal::board({
    .name = "ssd1331-spi",
    .summary = "SSD1331 96x64, 4-wire SPI at 6 MHz",
    .display = {.panel = &hal::panels::ssd1331_96x64},
    .bus = hal::BusKind::spi4,
    .write_hz = 6000000, // Hz; datasheet: a write cycle of 150 ns or more
});

} // namespace spangle::boards
