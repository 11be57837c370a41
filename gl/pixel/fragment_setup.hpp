// Derives the rasterizer's DrawState from GL state, once per change of state.
#pragma once

#include "gl/context/context.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::gl {

/// The state that the next primitive is drawn with. The call is almost free while no state has changed.
const raster::DrawState& draw_state(Context& context, PrimitiveKind drawn = PrimitiveKind::pixels,
                                    raster::Colors colors = raster::Colors::of_vertices);

/// Whether back faces have a different stencil test than front faces (GL 2.0, 4.1.5).
bool stencil_sides(const Context& context);

/// The state that polygons of side 0 (front) or 1 (back) are drawn with, valid as long as draw_state()'s
/// result.
const raster::DrawState& draw_state_of(const Context& context, int side);

/// The part of the surface that lies in the scissor rectangle, or all of it while SCISSOR_TEST is off. The
/// result may be empty.
Rect drawing_rect(const Context& context);

/// The channels of the colour buffer that are written. Bits 0..3 are red, green, blue and alpha; on surfaces
/// of indices they are the bits of an index. The result is 0 when DrawBuffer is NONE.
std::uint8_t written_channels(const Context& context);

/// A colour component clamped to [0, 1], in the rasterizer's units: 255ths with 20 fraction bits.
std::uint32_t color_units(Real component);

/// The tier that a hint selects: FASTEST is fast, NICEST is exact, DONT_CARE is the EGL config's.
raster::Tier tier_of(const Context& context, GLenum hint);

/// Lets host tools count what a context draws; null counters stop that.
void observe(Context& context, raster::Counters* counters, bool count_passed);

} // namespace spangle::gl
