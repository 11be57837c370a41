// SSD0323 grey OLED of the LM3S6965 evaluation board, on its SPI.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ssd0323_spi = hal::board({
    .name = "ssd0323-spi",
    .summary = "SSD0323 128x64, sixteen greys, 4-wire SPI at 4 MHz",
    .display = {.panel = &hal::panels::ssd0323_128x64, .wire = hal::wires::grey4},
    .bus = hal::BusKind::spi4,
    .write_hz = 4000000, // Hz; datasheet: a write cycle of 250 ns or more
});

} // namespace spangle::boards
