// From GL state to the rasterizer's DrawState, derived once per change of state.
#pragma once

#include "gl/context/context.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::gl {

/// What the next primitive is drawn with. Near-free while no state has changed.
const raster::DrawState& draw_state(Context& context, Drawn drawn = Drawn::pixels,
                                    raster::Colors colors = raster::Colors::of_vertices);

/// Back faces have a stencil test of their own (GL 2.0, 4.1.5).
bool stencil_sides(const Context& context);

/// What polygons of side 0 (front) or 1 (back) are drawn with, while `draw_state` is good.
const raster::DrawState& draw_state_of(const Context& context, int side);

/// The scissor rectangle cut to the surface; the whole surface while SCISSOR_TEST is off. May be empty.
Rect drawing_rect(const Context& context);

/// Bits 0..3: red, green, blue, alpha of the colour buffer are written, or the bits of an index that are. 0
/// while DrawBuffer is NONE.
std::uint8_t written_channels(const Context& context);

/// A real colour component, clamped, in the rasterizer's units: 255ths with 20 fraction bits.
std::uint32_t color_units(Real component);

/// The tier a hint asks for: FASTEST fast, NICEST exact, DONT_CARE what the EGL config says.
raster::Tier tier_of(const Context& context, GLenum hint);

/// Host tools count what a context draws; null stops.
void observe(Context& context, raster::Counters* counters, bool count_passed);

} // namespace spangle::gl
