// What each line of a program costs: every call of GL is counted for the address that it returns to. Images
// that do not count link nothing of this.
#pragma once

#include <cstddef>

namespace spangle::measure {

#ifdef MEASURE_LINES
/// Counts from here on; the processor's timer runs (mcu::InstructionCount).
void begin_frame();
void end_frame();
/// Prints a line "line ADDRESS COMMAND CALLS TICKS" for each address that commands returned to.
void print_lines();
/// The bytes of RAM that the counting itself takes.
std::size_t line_bytes();
#else
inline void begin_frame() {}
inline void end_frame() {}
inline void print_lines() {}
inline std::size_t line_bytes() {
    return 0;
}
#endif

} // namespace spangle::measure
