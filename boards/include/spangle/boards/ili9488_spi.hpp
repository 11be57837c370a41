// ILI9488 module, landscape, on 4-wire SPI: the 3.5" red boards. The controller's SPI demands three bytes a
// pixel.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board ili9488_spi = hal::board({
    .name = "ili9488-spi",
    .summary = "ILI9488 480x320 (landscape), 18 bit, 4-wire SPI at 40 MHz",
    .display = {.panel = &hal::panels::ili9488_320x480,
                .orientation = {hal::Rotation::r90},
                .format = PixelFormat::rgb888,
                .read_back = true},
    .bus = hal::BusKind::spi4,
    .write_hz = 40000000, // Hz; datasheet: a write cycle of 50 ns or more; modules work at this clock
    .read_hz = 6000000,
});

} // namespace spangle::boards
