// The calls of a trace as a program; replay.py writes the frames.
#pragma once

namespace spangle::measure {

void replay_frame(int frame);

/// All frames before the first one that is measured are drawn, too: each goes on from the one before.
struct Replay {
    static void setup(int, int) {
        for (int frame = 0; frame < MEASURE_FIRST; ++frame)
            replay_frame(frame);
    }
    static void draw(int frame) { replay_frame(frame); }
};
inline constexpr Replay replay;

} // namespace spangle::measure
