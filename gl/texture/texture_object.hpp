// A texture object: its images, its parameters, and the view that the rasterizer samples (GL 1.3, 3.8.10,
// 3.8.11).
#pragma once

#include <array>

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::gl {

/// Number of levels of a texture. Each side of level l has at most 2^(texture_levels - 1 - l) texels without
/// the border.
inline constexpr int texture_levels = raster::max_texture_levels;
inline constexpr GLsizei max_texture_size = 1 << (texture_levels - 1);
inline constexpr GLsizei max_3d_texture_size = max_texture_size < 256 ? max_texture_size : 256;
inline constexpr std::int32_t max_texture_lod_bias = 12; ///< reaches past either end of every mipmap chain

/// The kind of a texture, fixed by its first binding. A unit samples the last kind that is enabled (GL 1.3,
/// 3.8.15).
enum class TextureKind : std::uint8_t { one, two, three, cube };
inline constexpr int texture_kinds = 4;
inline constexpr unsigned cube_faces = 6;

constexpr std::size_t index_of(TextureKind kind) {
    return static_cast<std::size_t>(kind);
}
/// True for each kind of texture that this build has.
inline constexpr bool texture_kind_is_there[texture_kinds] = {SPANGLE_FEATURE_TEXTURE_1D != 0, true,
                                                              SPANGLE_FEATURE_TEXTURE_3D != 0,
                                                              SPANGLE_FEATURE_TEXTURE_CUBE_MAP != 0};
inline constexpr unsigned kinds_there = [] {
    unsigned set = 0;
    for (unsigned k = 0; k < texture_kinds; ++k)
        set |= texture_kind_is_there[k] ? 1u << k : 0u;
    return set;
}();
/// Returns the kind of a texture that exists. In builds with one kind the result is a constant.
[[gnu::always_inline]] constexpr TextureKind existing_kind(TextureKind kind) {
    return raster::one_of(kinds_there, kind);
}
inline constexpr auto kinds_before = [] {
    std::array<std::uint8_t, texture_kinds + 1> before{};
    for (std::size_t k = 0; k < texture_kinds; ++k)
        before[k + 1] = static_cast<std::uint8_t>(before[k] + (texture_kind_is_there[k] ? 1u : 0u));
    return before;
}();
/// Returns the number of dimensions of an image. Along other dimensions its size is 1, without border.
constexpr unsigned dimensions_of(TextureKind kind) {
    return kind == TextureKind::one ? 1 : kind == TextureKind::three ? 3 : 2;
}

/// The shape of an image. If all sizes are 0, it is the empty image that a level has initially.
struct LevelShape {
    std::uint16_t size[3] = {};        ///< width, height, depth in texels, border included
    std::uint16_t internal_format = 1; ///< the format that the program gave; every token fits 16 bits
    std::uint8_t border = 0;
    std::uint8_t dimensions = 2;
    raster::TexelFormat format = raster::TexelFormat::l8;

    /// Returns the number of dimensions, which is a constant in builds that have only 2D textures and cube
    /// maps.
    unsigned dimension_count() const {
        return SPANGLE_FEATURE_TEXTURE_1D || SPANGLE_FEATURE_TEXTURE_3D ? dimensions : 2;
    }
    std::uint32_t border_along(unsigned axis) const { return axis < dimension_count() ? border : 0u; }
    std::uint32_t size_without_border(unsigned axis) const { return size[axis] - 2 * border_along(axis); }
    bool is_volume() const { return dimension_count() == 3; }
    /// Returns the number of two-dimensional images. The shape must not be empty.
    unsigned images() const { return SPANGLE_FEATURE_TEXTURE_3D ? size[2] : 1; }
    bool empty() const { return size[0] == 0 || size[1] == 0 || size[2] == 0; }
};

/// The image of a level. It is a block of the share group's arena. Its texels follow in the same block, or
/// lie in the program's constant memory.
struct LevelImage {
    LevelShape shape;
    std::uint32_t stride = 0;             ///< bytes from row to row; 0 for formats without rows
    std::uint32_t bytes = 0;              ///< bytes of the texels
    const std::uint8_t* texels = nullptr; ///< first texel of the border, or first block of a compressed image
    union {
        const std::uint8_t* palette = nullptr; ///< palette of formats that have one
        LevelImage* next_kept;                 ///< list of images that no texture has any more (ShareGroup)
    };
#if SPANGLE_HAS_RECORDS
    std::uint32_t frame = 0; ///< recorded draws of this frame use the image (ShareGroup)
#endif

    std::uint8_t* own_texels() {
        return reinterpret_cast<std::uint8_t*>(this + 1);
    }
    std::uint32_t slice() const {
        return stride * shape.size[1];
    }
};

/// The initial limits of a level of detail are this number and its negative (GL 1.3, table 3.19).
inline constexpr Real farthest_lod = numeric::from_i32(1000);

/// The parameters that TexParameter sets.
struct TextureParameters {
    GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR, mag_filter = GL_LINEAR;
    GLenum wrap[3] = {GL_REPEAT, GL_REPEAT, GL_REPEAT}; ///< wrap modes of S, T, R
    Real border_color[4] = {};
    Real priority = numeric::one;
    Real min_lod = -farthest_lod, max_lod = farthest_lod;
    Real lod_bias = {};
    GLint base_level = 0, max_level = 1000;
    bool generate_mipmap = false;
#if SPANGLE_FEATURE_DEPTH_TEXTURES
    GLenum depth_mode = GL_LUMINANCE, compare_mode = GL_NONE, compare_func = GL_LEQUAL;
#endif
};

struct TextureObject {
    GLuint name = 0;
    std::uint32_t bindings = 0; ///< texture units that bind the object, in all contexts of the share group
    TextureKind kind = TextureKind::two;
    bool deleted = false; ///< the name is free again, and the object is freed with its last binding
    LevelImage* level[texture_levels] = {}; ///< images; of a cube map those of POSITIVE_X
    TextureParameters parameters;

    // complete_texture() derives the following members from those above, when a primitive needs them.
    mutable bool view_valid = false, complete = false;
    mutable raster::Texture view;

    constexpr explicit TextureObject(TextureKind k = TextureKind::two) : kind(k) {}
    LevelImage*& image(unsigned face, GLint l);
    const LevelImage* image(unsigned face, GLint l) const {
        return const_cast<TextureObject*>(this)->image(face, l);
    }
    unsigned faces() const { return existing_kind(kind) == TextureKind::cube ? cube_faces : 1; }
};

/// A cube map. `object` is its first member, so that a pointer to one is a pointer to the other.
struct CubeTexture {
    TextureObject object{TextureKind::cube};
    LevelImage* other[cube_faces - 1][texture_levels] = {}; ///< images of the other faces, in token order
                                                            ///< from NEGATIVE_X on
    mutable raster::CubeFaces view_faces;
};

#if !SPANGLE_FEATURE_TEXTURE_CUBE_MAP
inline LevelImage*& TextureObject::image(unsigned, GLint l) {
    return level[l];
}
#endif

} // namespace spangle::gl
