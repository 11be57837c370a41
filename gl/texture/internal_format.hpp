// Internal formats: what was asked for and how it is kept (GL 1.3, 3.8.1, tables 3.15 and 3.16).
#pragma once

#include <spangle/format.hpp>

#include "gl/pixel/group.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::gl {

/// False: not an internal format of TexImage, or one that the build leaves out (SPANGLE_TEXTURE_FORMATS).
/// Resolutions that are asked for are kept where the board has such texels; where none is, colours of 16-bit
/// surfaces are kept in 16 bits: "closely" is all GL wants, and a board's memory is small. Of generic
/// compressed formats `internal_format` becomes the base format, which is what stands in for them
/// (GL 1.3, 3.8.1).
bool texel_format_of(GLint& internal_format, PixelFormat surface, raster::TexelFormat& out);

/// Of the table above and of CompressedTexImage.
raster::BaseFormat base_format_of(raster::TexelFormat format, GLenum internal_format);

/// False of every image in a build without these.
constexpr bool is_depth(raster::TexelFormat format) {
    return SPANGLE_FEATURE_DEPTH_TEXTURES &&
           (format == raster::TexelFormat::z16 || format == raster::TexelFormat::z24);
}

unsigned texel_size(raster::TexelFormat format);

/// How a texel lies in memory. Luminance and intensity come from R (table 3.15). Not of compressed formats.
PixelLayout texel_layout(raster::TexelFormat format);

/// Bits that a texel keeps of a channel.
unsigned texel_bits(raster::TexelFormat format, Channel channel);

} // namespace spangle::gl
