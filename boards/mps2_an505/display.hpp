// The display of Arm's MPS2+ board, landscape.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board mps2_an505 = hal::board({
    .name = "mps2_an505",
    .summary = "Arm MPS2+ (Cortex-M33), HX8347 320x240, SPI with start bytes",
    .display = {.panel = &hal::panels::hx8347_240x320, .orientation = {hal::Rotation::r90}},
    .bus = hal::BusKind::spi_start,
    .write_hz = 10000000, // 20 MHz / 2
});

} // namespace spangle::boards
