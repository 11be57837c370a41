// The display of Arm's MPS3 board, landscape.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

inline constexpr hal::Board mps3_an547 = hal::board({
    .name = "mps3_an547",
    .summary = "Arm MPS3 (Cortex-M55), HX8347 320x240, SPI with start bytes",
    .display = {.panel = &hal::panels::hx8347_240x320, .orientation = {hal::Rotation::r90}},
    .bus = hal::BusKind::spi_start,
    .write_hz = 16000000, // 32 MHz / 2
});

} // namespace spangle::boards
