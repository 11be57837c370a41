// A texture object: its images, its parameters, and what the rasterizer samples (GL 1.3, 3.8.10, 3.8.11).
#pragma once

#include "gl/context/types.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::gl {

/// Level l has at most 2^(11 - l) texels a side, without border.
inline constexpr int texture_levels = raster::max_texture_levels;
inline constexpr GLsizei max_texture_size = 1 << (texture_levels - 1);

inline constexpr std::int32_t max_texture_lod_bias = 12; ///< past either end of every chain

/// Border included; all zero is GL's initial texture array.
struct LevelShape {
    std::uint16_t width = 0, height = 0;
    std::uint16_t internal_format = 1; ///< as asked for; every token of GL 1.3 has 16 bits
    std::uint8_t border = 0;
    raster::TexelFormat format = raster::TexelFormat::l8;
};

/// Texels follow their header in one block of the share group's arena.
struct LevelImage {
    LevelShape shape;
    std::uint32_t stride = 0; ///< bytes from row to row

    std::uint8_t* texels() { return reinterpret_cast<std::uint8_t*>(this + 1); }
    const std::uint8_t* texels() const { return reinterpret_cast<const std::uint8_t*>(this + 1); }
};

/// What TexParameter sets.
struct TextureParameters {
    GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR, mag_filter = GL_LINEAR;
    GLenum wrap_s = GL_REPEAT, wrap_t = GL_REPEAT;
    Real border_color[4] = {};
    Real priority = numeric::one;
    Real min_lod{0xC47A0000}, max_lod{0x447A0000}; ///< -1000, 1000
    Real lod_bias = {};
    GLint base_level = 0, max_level = 1000;
};

struct TextureObject {
    GLuint name = 0;
    std::uint32_t bindings = 0; ///< units, of all contexts of the share group, that hold it
    bool deleted = false;       ///< its name is free again; the last binding keeps it
    LevelImage* level[texture_levels] = {};
    TextureParameters parameters;

    // Derived from the above by complete_texture when a primitive needs it.
    mutable bool view_valid = false, complete = false;
    mutable raster::Texture view;
};

} // namespace spangle::gl
