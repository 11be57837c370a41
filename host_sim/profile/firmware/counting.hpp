// Counts what an image costs while it draws: for each line of the program (lines.cpp, MEASURE_LINES), or for
// each state key (keys.cpp, MEASURE_KEYS). Images that do not count link nothing of this.
#pragma once

#include <cstddef>

/// The header with the clock and the output that counting uses; builds for a host name another.
#ifndef MEASURE_BOARD
#define MEASURE_BOARD "host_sim/profile/firmware/board.hpp"
#endif

namespace spangle::raster {

struct FragmentState;
struct Surface;
struct DrawState;

} // namespace spangle::raster

namespace spangle::measure {

#if defined(MEASURE_LINES) || defined(MEASURE_KEYS)
/// Starts counting. The processor's timer must run (mcu::InstructionCount).
void begin_frame();
void end_frame();
/// Prints a line of text for each thing that was counted.
void print_counts();
/// Makes a state count what it draws; it is called when the state was compiled.
void count_state(const raster::FragmentState& fragment, const raster::Surface& target,
                 raster::DrawState& out);
/// Forgets the state keys that were counted, so that one process can count several programs.
void forget_counts();
/// The bytes of RAM that the counting itself takes.
std::size_t counting_bytes();
#else
inline void begin_frame() {}
inline void end_frame() {}
inline void print_counts() {}
inline std::size_t counting_bytes() {
    return 0;
}
#endif

} // namespace spangle::measure
