// Compressed internal formats: paletted textures and blocks of ETC1 (OES_compressed_paletted_texture,
// OES_compressed_ETC1_RGB8_texture).
#pragma once

#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

inline constexpr GLenum first_palette_format = GL_PALETTE4_RGB8_OES;
inline constexpr unsigned palette_formats = 10, compressed_formats = palette_formats + 1;

// Builds without compressed textures answer false for every format.
constexpr bool is_palette(GLenum internal_format) {
    return SPANGLE_FEATURE_COMPRESSED_TEXTURES && internal_format - first_palette_format < palette_formats;
}
constexpr bool is_compressed(GLenum internal_format) {
    return SPANGLE_FEATURE_COMPRESSED_TEXTURES &&
           (is_palette(internal_format) || internal_format == GL_ETC1_RGB8_OES);
}
/// The texel format of a palette's entries.
constexpr raster::TexelFormat palette_format_of(GLenum internal_format) {
    constexpr raster::TexelFormat of[] = {raster::TexelFormat::rgb888, raster::TexelFormat::rgba8888,
                                          raster::TexelFormat::rgb565, raster::TexelFormat::rgba4444,
                                          raster::TexelFormat::rgba5551};
    return of[(internal_format - first_palette_format) % 5];
}
constexpr bool has_small_palette(GLenum internal_format) {
    return internal_format - first_palette_format < 5;
}

constexpr raster::TexelFormat compressed_texels_of(GLenum internal_format) {
    return !is_palette(internal_format)         ? raster::TexelFormat::etc1
           : has_small_palette(internal_format) ? raster::TexelFormat::p4
                                                : raster::TexelFormat::p8;
}

/// Whether the build supports the texels of the format and, for paletted formats, the entries of the palette.
constexpr bool is_held(GLenum internal_format) {
    return raster::has_format(compressed_texels_of(internal_format)) &&
           (!is_palette(internal_format) || raster::has_format(palette_format_of(internal_format)));
}

/// Returns the bytes of all palette entries, or 0 if the format has no palette.
std::uint32_t palette_bytes(GLenum internal_format);

/// Bytes of the image of a level, without its palette. Rows of 4-bit indices are packed without gaps.
std::uint32_t compressed_bytes(GLenum internal_format, std::uint32_t width, std::uint32_t height);

} // namespace spangle::gl
