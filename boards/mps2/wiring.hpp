// How the display of Arm's MPS2+ and MPS3 boards is wired: landscape, behind an SPI block.
#pragma once

#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

namespace spangle::boards {

/// The SPI block takes half the clock of its board.
consteval hal::Board mps2_board(const char* name, const char* summary, std::uint32_t clock_hz) {
    return hal::board({
        .name = name,
        .summary = summary,
        .display = {.panel = &hal::panels::hx8347_240x320, .orientation = {hal::Rotation::r90}},
        .bus = hal::BusKind::spi_start,
        .write_hz = clock_hz / 2,
    });
}

/// The clock of the boards with a Cortex-M3, M4 or M7.
inline constexpr std::uint32_t mps2_clock_hz = 25000000;

} // namespace spangle::boards
