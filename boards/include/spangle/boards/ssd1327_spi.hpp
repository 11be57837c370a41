// SSD1327 grey OLED (1.5"), on 4-wire SPI.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ssd1327_spi = hal::board({
    .name = "ssd1327-spi",
    .summary = "SSD1327 128x128, sixteen greys, 4-wire SPI at 10 MHz",
    .display = {.panel = &hal::panels::ssd1327_128x128, .wire = hal::wires::grey4},
    .bus = hal::BusKind::spi4,
    .write_hz = 10000000, // Hz; datasheet: a write cycle of 100 ns or more
});

} // namespace spangle::boards
