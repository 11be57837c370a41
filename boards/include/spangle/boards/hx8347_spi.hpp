// HX8347 module without a D/C pin, landscape, on SPI with start bytes: the display of Arm's MPS2 boards.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board hx8347_spi = hal::board({
    .name = "hx8347-spi",
    .summary = "HX8347 320x240, SPI with start bytes at 20 MHz",
    .display = {.panel = &hal::panels::hx8347_240x320, .orientation = {hal::Rotation::r90}},
    .bus = hal::BusKind::spi_start,
    .write_hz = 20000000, // Hz; datasheet: a write cycle of 50 ns or more
});

} // namespace spangle::boards
