// Draws pixel rectangles and bitmaps at the current raster position.
#pragma once

#include "gl/context/context.hpp"
#include "raster/primitive/draw.hpp"

namespace spangle::gl {

/// Draws the fragments that `source` places, with colour, depth and texture coordinates of the current raster
/// position.
template <class M>
void draw_at_raster_position(const Context& context, const raster::DrawState& state,
                             const raster::Surface& target, raster::PixelSource& source) {
    typename M::Window at;
    M::set_raster(context.current.raster, at);
    if (is_indexed(context.drawable))
        M::set_index(context.current.raster.index, context.drawable.index_bits, at);
    raster::draw_pixels(state, target, at, source);
}

} // namespace spangle::gl
