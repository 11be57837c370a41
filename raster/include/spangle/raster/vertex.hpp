// A vertex as the rasterizer takes it: in window space, clipped, lit.
#pragma once

#include <cstdint>

#include <spangle/raster/fragment_state.hpp>
#include <spangle/raster/units.hpp>

namespace spangle::raster {

/// Subpixel bits: window x and y are n.8 in every policy (docs/architecture/numbers.md, "Window
/// coordinates").
inline constexpr int subpixel_bits = 8;
/// One pixel in n.8.
inline constexpr std::int32_t subpixel_one = 1 << subpixel_bits;

/// Fixed policy. Everything here is a pure function of the vertex's own values and the matrices. Members that
/// a build never reads are constants that all vertices share.
struct FixedVertex {
    std::int32_t x, y; ///< window, n.8, y up; |x|, |y| within the guard band (4 x the largest viewport)
    std::uint32_t z;   ///< 0 .. depth_one
    std::uint32_t w_mantissa; ///< 1/w = w_mantissa * 2^w_exponent, mantissa in [2^31, 2^32)
    /// The exponent of 1/w.
    std::int16_t w_exponent;
    std::int16_t fog_exponent; ///< eye distance |z_e|, or fog coordinate = fog_mantissa * 2^fog_exponent
    /// What snapping took off x and y, in 2^-16 of their last bit: the exact [tier](docs/glossary.md#tier)
    /// has planes of attributes, but not coverage and depth, go through x + x_rest, y + y_rest.
#if SPANGLE_TIER_SET & 1
    std::int16_t x_rest, y_rest;
#else
    /// 0: builds without the exact tier do not keep what snapping took off.
    static constexpr std::int16_t x_rest = 0, y_rest = 0;
#endif
#if SPANGLE_FEATURE_FOG
    /// The mantissa of the fog distance.
    std::int32_t fog_mantissa;
#else
    /// 0: builds without fog have no fog distance.
    static constexpr std::int32_t fog_mantissa = 0;
#endif
    std::uint32_t color[4]; ///< RGBA, colour units, 0 .. color_one; [0] may be an index, 20 fraction bits
#if SPANGLE_SECONDARY_COLORS
    std::uint32_t secondary[3]; ///< RGB, colour units
#else
    /// 0: builds without secondary colours have none.
    static constexpr std::uint32_t secondary[3] = {};
#endif
    /// The coordinates of one texture unit.
    struct TexCoord {
        std::int32_t s, t, q; ///< value = mantissa * 2^exponent, after the texture matrix; common exponent
        /// The exponent that s, t, q and r share.
        std::int16_t exponent;
        std::int16_t q_is_one; ///< nonzero: q is exactly 1 (and its mantissa is not looked at)
    };
#if SPANGLE_TEXTURE_UNITS
    /// The coordinates of each unit.
    TexCoord tex[max_texture_units];
#else
    /// 0: builds without textures have no coordinates.
    static constexpr TexCoord tex[max_texture_units] = {};
#endif
    /// Third texture coordinates, with the exponent of their unit; only for textures that read them
    /// (wants_r()).
#if SPANGLE_FEATURE_TEXTURE_3D || SPANGLE_FEATURE_TEXTURE_CUBE_MAP || SPANGLE_FEATURE_DEPTH_TEXTURES
    std::int32_t r[max_texture_units];
#else
    /// 0: no texture of this build reads third coordinates.
    static constexpr std::int32_t r[max_texture_units] = {};
#endif
};

} // namespace spangle::raster
