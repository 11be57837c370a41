// A tier of accuracy that a program composes, on hosts: to find out what a knob costs and gains.
// docs/trade.md says what each knob trades.
//
//   spangle::raster::Knobs knobs = spangle::raster::balanced_knobs;
//   knobs.texel_bits = 4; // coordinates within 1/16 texel
//   if (spangle::use_tier(knobs)) ...
#pragma once

#include <spangle/raster/tier.hpp>

namespace spangle {

/// The current context draws with these knobs from now on, wherever GL_PERSPECTIVE_CORRECTION_HINT is
/// GL_DONT_CARE; the other hints still mean their tiers. DOUBLE contexts take no notice. False, and nothing
/// is changed: there is no context, it is between glBegin and glEnd, a field is out of its range, or the
/// library was built for firmware or without one of the tiers.
bool use_tier(const raster::Knobs& knobs);

} // namespace spangle
