// Lets a program on a host compose a [tier](docs/glossary.md#tier) of accuracy of its own, to find out what
// each [knob](docs/glossary.md#knob) costs and gains. docs/trade.md says what the knobs trade.
//
//   spangle::raster::Knobs knobs = spangle::raster::balanced_knobs;
//   knobs.texel_bits = 4; // coordinates within 1/16 texel
//   if (spangle::use_tier(knobs)) ...
#pragma once

#include <spangle/raster/tier.hpp>

namespace spangle {

/// Makes the current context draw with these knobs while GL_PERSPECTIVE_CORRECTION_HINT is GL_DONT_CARE. The
/// other values of the hint still mean their tiers. DOUBLE contexts ignore the knobs. False, and nothing
/// changes: there is no current context, a primitive is open between glBegin and glEnd, a field is out of its
/// range, or the library was built for firmware or without one of the tiers.
bool use_tier(const raster::Knobs& knobs);

} // namespace spangle
