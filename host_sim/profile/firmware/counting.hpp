// What an image counts while it draws: what each line of the program costs (lines.cpp, MEASURE_LINES), or
// each state key (keys.cpp, MEASURE_KEYS). Images that do not count link nothing of this.
#pragma once

#include <cstddef>

/// The clock and the voice of what counts; a host names others.
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
/// Counts from here on; the processor's timer runs (mcu::InstructionCount).
void begin_frame();
void end_frame();
/// Prints a line of text for each thing that was counted.
void print_counts();
/// Counts what a state draws, from when it was compiled on.
void count_state(const raster::FragmentState& fragment, const raster::Surface& target,
                 raster::DrawState& out);
/// State keys that were counted are forgotten, so that one process can count several programs.
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
