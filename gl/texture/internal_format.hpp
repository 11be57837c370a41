// Internal formats: what was asked for and how it is kept (GL 1.3, 3.8.1, tables 3.15 and 3.16).
#pragma once

#include <spangle/format.hpp>

#include "gl/pixel/group.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::gl {

/// False: not an internal format. Colours of 16-bit surfaces are kept in 16 bits unless 8 bits or more are
/// asked for; "closely" is all GL wants of a resolution, and a board's memory is small.
bool texel_format_of(GLint internal_format, PixelFormat surface, raster::TexelFormat& out);

raster::BaseFormat base_format_of(raster::TexelFormat format);

unsigned texel_bytes(raster::TexelFormat format);

/// Bits of R, G, B, A as a texel keeps them. Luminance and intensity come from R (table 3.15).
ColorBits texel_bits(raster::TexelFormat format);

} // namespace spangle::gl
