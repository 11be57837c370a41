// ILI9341 module, landscape, on 4-wire SPI: the common 2.2" to 3.2" red boards.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ili9341_spi = hal::board({
    .name = "ili9341-spi",
    .summary = "ILI9341 320x240, 4-wire SPI at 40 MHz",
    .display = {.panel = &hal::panels::ili9341_240x320,
                .orientation = {hal::Rotation::r90},
                .read_back = true},
    .bus = hal::BusKind::spi4,
    .write_hz = 40000000,
    .read_hz = 6000000, // Hz; datasheet: a read cycle of 150 ns or more
});

} // namespace spangle::boards
