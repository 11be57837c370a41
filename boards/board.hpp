// What a program asks of the board it runs on. Each folder of boards/ that holds a board.json defines these.
#pragma once

#include <cstdint>

#include <spangle/hal/display.hpp>

namespace spangle::board {

/// Clocks, pins, memory for GL; then the display, not yet initialised. Call it once, first.
hal::Display& start();

/// Bytes sent to the display so far, commands included; 0 where it scans memory by itself. Wraps.
std::uint32_t bus_bytes();

/// Of the processor, as SysTick counts them.
extern const std::uint32_t clock_hz;

} // namespace spangle::board
