// Internal formats, and the texel formats that they are stored in (GL 1.3, 3.8.1, tables 3.15 and 3.16).
#pragma once

#include <spangle/format.hpp>

#include "gl/pixel/group.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::gl {

/// Finds the texel format of an internal format. Returns false if TexImage has no such format, or the build
/// leaves it out (SPANGLE_TEXTURE_FORMATS). Sized formats keep their resolution if such texels exist. For
/// 16-bit surfaces, texels of unsized colour formats have 16 bits, because boards have little memory. GL asks
/// only for a close match. For generic compressed formats `internal_format` becomes the base format, which
/// replaces them (GL 1.3, 3.8.1).
bool texel_format_of(GLint& internal_format, PixelFormat surface, raster::TexelFormat& out);

/// The base format of a texel format, for formats of TexImage and of CompressedTexImage.
raster::BaseFormat base_format_of(raster::TexelFormat format, GLenum internal_format);

/// Whether texels are depths; builds without depth textures answer false.
constexpr bool is_depth(raster::TexelFormat format) {
    return SPANGLE_FEATURE_DEPTH_TEXTURES &&
           (format == raster::TexelFormat::z16 || format == raster::TexelFormat::z24);
}

unsigned texel_size(raster::TexelFormat format);

/// How a texel lies in memory. Luminance and intensity come from R (GL 1.3, table 3.15). The format must not
/// be a compressed one.
PixelLayout texel_layout(raster::TexelFormat format);

/// Returns the bits that a texel has for a channel, or 0 if it does not have the channel.
unsigned texel_bits(raster::TexelFormat format, Channel channel);

} // namespace spangle::gl
