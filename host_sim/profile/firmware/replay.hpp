// The calls of a trace as a program; replay.py writes the frames.
#pragma once

namespace spangle::measure {

void replay_frame(int frame);

/// Draws the frames of the trace. Each frame continues the one before, so setup() draws all frames before the
/// first that is measured.
struct Replay {
    static void setup(int, int) {
        for (int frame = 0; frame < MEASURE_FIRST; ++frame)
            replay_frame(frame);
    }
    static void draw(int frame) { replay_frame(frame); }
};
inline constexpr Replay replay;

} // namespace spangle::measure
