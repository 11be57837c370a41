// What measure() and measure_recording() make of frames, however they were drawn.
#pragma once

#include "host_sim/capture/drawn_frame.hpp"
#include "host_sim/trade/measure.hpp"

namespace spangle::trade {

/// A picture as it is seen: top row first, opaque.
sim::Image image_of(const DrawnPicture& drawn);

/// Adds a frame of the tier, held against double's in the same format.
void judge(const DrawnFrame& ours, const DrawnFrame& twin, Measured& out);

/// Holds the last frame against that of double in eight bits, `out.plain`, which nothing rounds further.
void judge_plain(Measured& out);

} // namespace spangle::trade
