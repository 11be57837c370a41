// What a program asks of the board that it runs on. Each folder of boards/ with a board.json defines these
// functions.
#pragma once

#include <cstdint>

#include <spangle/hal/display.hpp>

namespace spangle::board {

/// Starts clocks and pins, gives GL its memory, and returns the display, which is not yet initialised. Call
/// it once, before anything else.
hal::Display& start();

/// Bytes that were sent to the display so far, commands included, modulo 2^32. The number stays 0 where the
/// display reads memory by itself.
std::uint32_t bus_bytes();

/// Frequency in Hz of the clock that mcu::InstructionCount reads: SysTick on Cortex-M, the global timer on
/// Cortex-A9. RISC-V counts instructions and does not use the number.
extern const std::uint32_t clock_hz;

} // namespace spangle::board
