// The figures that measure() and measure_recording() compute from frames, however these were drawn.
#pragma once

#include "host_sim/capture/drawn_frame.hpp"
#include "host_sim/trade/measure.hpp"

namespace spangle::trade {

/// A picture as it is seen: top row first, opaque.
sim::Image image_of(const DrawnPicture& drawn);

/// Adds a frame of the tier, compared with the frame in double in the same format.
void judge(const DrawnFrame& ours, const DrawnFrame& twin, Measured& out);

/// Compares the last frame with that of double in eight bits, `out.plain`, which nothing rounds further.
void judge_plain(Measured& out);

} // namespace spangle::trade
