// What a build of the rasterizer is made for (cmake/Limits.cmake); a build by hand has all of it.
#pragma once

#include <spangle/format.hpp>

#ifndef SPANGLE_TEXTURE_UNITS
/// Texture units: 0, 1 or 2.
#define SPANGLE_TEXTURE_UNITS 2
#endif
#ifndef SPANGLE_TEXTURE_LEVELS
/// Levels of a mipmap, 1 to 12; see max_texture_levels.
#define SPANGLE_TEXTURE_LEVELS 12
#endif
#ifndef SPANGLE_TIER_SET
/// The [tiers](docs/glossary.md#tier) of this build, a bit each: 1 exact, 2 balanced, 4 fast.
#define SPANGLE_TIER_SET 7
#endif
#ifndef SPANGLE_PACKET
/// Fragments that pass between two stages at once: 2, 4, 8 or 16; see `packet`.
#define SPANGLE_PACKET 16
#endif
#ifndef SPANGLE_LINE_BATCH
/// Lines that are collected for one loop, an even number; 0: as many as the processor's word suggests.
#define SPANGLE_LINE_BATCH 0
#endif
#ifndef SPANGLE_EXTENTS
/// 1: surfaces record what was drawn (Surface::extents).
#define SPANGLE_EXTENTS 1
#endif
#ifndef SPANGLE_FUSED_SPANS
/// 1: states that programs draw with often have loops of their own.
#define SPANGLE_FUSED_SPANS 1
#endif
#ifndef SPANGLE_SHORTCUTS
/// 1: code that only makes drawing faster is built in.
#define SPANGLE_SHORTCUTS 1
#endif
#ifndef SPANGLE_CHAIN
/// 1: the general chain of stages is built in. Without it a state that has no fused span is an error.
#define SPANGLE_CHAIN 1
#endif
#ifndef SPANGLE_AFFINE_TEXTURES
/// 1: texture coordinates may be affine. 0: they are divided wherever textures are drawn.
#define SPANGLE_AFFINE_TEXTURES 1
#endif
#ifndef SPANGLE_PERSPECTIVE
/// 1: vertices may have any w and q. 0: both are 1 at every vertex.
#define SPANGLE_PERSPECTIVE 1
#endif
#ifndef SPANGLE_TEXTURE_FORMATS
/// The texel formats of this build, a bit each, in the order of TexelFormat.
#define SPANGLE_TEXTURE_FORMATS 32767
#endif
#ifndef SPANGLE_COLOR_FORMATS
/// The formats of surfaces of this build, a bit each, in the order of PixelFormat.
#define SPANGLE_COLOR_FORMATS 1023
#endif
#ifndef SPANGLE_DEPTH_FORMATS
/// The depth formats of this build, a bit each, in the order of DepthFormat.
#define SPANGLE_DEPTH_FORMATS 7
#endif

namespace spangle::raster {

/// Without texture units nothing is textured; arrays of units then have one element, which is never on.
inline constexpr bool has_textures = SPANGLE_TEXTURE_UNITS != 0;
/// Elements of arrays of texture units, 1 or 2.
inline constexpr int max_texture_units = has_textures ? SPANGLE_TEXTURE_UNITS : 1;
static_assert(max_texture_units == 1 || max_texture_units == 2);

/// A texture of the most levels is 2^(levels - 1) texels wide and high.
inline constexpr int max_texture_levels = SPANGLE_TEXTURE_LEVELS;
static_assert(max_texture_levels >= 1 && max_texture_levels <= 12);

/// The tiers of this build, a bit each, in the order of Tier.
inline constexpr unsigned tiers = SPANGLE_TIER_SET;
static_assert(tiers != 0 && tiers < 8);
/// Whether surfaces record what was drawn (Surface::extents).
inline constexpr bool has_extents = SPANGLE_EXTENTS != 0;
/// Whether states that programs draw with often have loops of their own.
inline constexpr bool has_fused_spans = SPANGLE_FUSED_SPANS != 0;
/// Whether code that only makes drawing faster is built in.
inline constexpr bool has_shortcuts = SPANGLE_SHORTCUTS != 0;
/// Whether the general chain of stages is built in. Without it, a state that has no fused span is an error.
inline constexpr bool has_chain = SPANGLE_CHAIN != 0;
static_assert(has_chain || has_fused_spans);
/// Whether texture coordinates may be affine. Otherwise they are divided wherever textures are drawn.
inline constexpr bool has_affine_textures = SPANGLE_AFFINE_TEXTURES != 0;
/// Whether vertices may have any w and q. Otherwise both are 1 at every vertex.
inline constexpr bool has_perspective = SPANGLE_PERSPECTIVE != 0;
static_assert(has_perspective || has_affine_textures);

/// The fragments that pass between two stages of the chain at once, unless lanes need more. Pen::batch, the
/// most rows that a primitive hands to its span function at once, is a multiple of it. Both lie on the stack.
inline constexpr int packet = SPANGLE_PACKET;
static_assert(packet == 2 || packet == 4 || packet == 8 || packet == 16);

/// Lines that are collected for one loop, an even number; with two, lines are drawn one by one. They lie on
/// the stack, some 50 bytes each.
inline constexpr int line_batch = SPANGLE_LINE_BATCH != 0 ? SPANGLE_LINE_BATCH : sizeof(void*) == 4 ? 24 : 16;
static_assert(line_batch >= 2 && line_batch % 2 == 0);

/// The set of formats from `first` to `last`, one bit each.
constexpr unsigned formats_between(PixelFormat first, PixelFormat last) {
    return (2u << static_cast<unsigned>(last)) - (1u << static_cast<unsigned>(first));
}
/// Formats whose pixels are drawn by loops of their own, the narrow ones, and those of indices; as bits.
inline constexpr unsigned wide_formats = formats_between(PixelFormat::rgb565_be, PixelFormat::rgba8888),
                          narrow_formats = SPANGLE_FEATURE_NARROW_SURFACES
                                               ? formats_between(PixelFormat::rgb666, PixelFormat::mono)
                                               : 0,
                          index_formats = SPANGLE_FEATURE_COLOR_INDEX
                                              ? formats_between(PixelFormat::index8, PixelFormat::index8)
                                              : 0;
/// The formats of colour, depth and textures of this build; as bits.
inline constexpr unsigned color_formats =
                              SPANGLE_COLOR_FORMATS & (wide_formats | narrow_formats | index_formats),
                          depth_formats = SPANGLE_DEPTH_FORMATS, texture_formats = SPANGLE_TEXTURE_FORMATS;
static_assert(SPANGLE_COLOR_FORMATS < 1u << pixel_formats);
static_assert(color_formats != 0, "the format needs NARROW_SURFACES or COLOR_INDEX");
static_assert(texture_formats < 1u << 15);
static_assert((depth_formats & 1) != 0 && depth_formats < 8, "a surface may always be without depth");

/// Whether this build draws on surfaces of this format.
constexpr bool has_format(PixelFormat format) {
    return (color_formats >> static_cast<unsigned>(format) & 1) != 0;
}
/// Whether this build draws on surfaces with a depth plane of this format.
constexpr bool has_format(DepthFormat format) {
    return (depth_formats >> static_cast<unsigned>(format) & 1) != 0;
}
/// Whether this build has surfaces of indices, narrow ones, and ones whose pixels have an address each.
inline constexpr bool has_indices = has_format(PixelFormat::index8),
                      has_narrow_formats = (color_formats & narrow_formats) != 0,
                      has_wide_formats = (color_formats & ~narrow_formats) != 0;

/// Whether some surfaces of this build are drawn by the chain only: narrow surfaces and those of indices.
/// These surfaces have the exact number system in every tier (key.cpp), and no loops of their own.
inline constexpr bool chain_only = (color_formats & (narrow_formats | index_formats)) != 0;
/// Whether this build has the number system of the exact tier, and that of the faster ones.
inline constexpr bool has_exact = chain_only || (tiers & 1) != 0, has_balanced = (tiers & 6) != 0;
static_assert(has_chain || !chain_only, "narrow surfaces and those of indices are drawn by the chain");

/// Returns `value`. Where `set` has only one element, the result is that element, as a constant.
template <class E> [[gnu::always_inline]] constexpr E one_of(unsigned set, E value) {
    return (set & (set - 1)) != 0 || set == 0 ? value : static_cast<E>(__builtin_ctz(set));
}

/// The format of a surface; a constant in a build that draws on one format only.
constexpr PixelFormat drawn(PixelFormat format) {
    return one_of(color_formats, format);
}
namespace detail {
inline constexpr FormatInfo only_info = format_info(drawn(PixelFormat{}));
}
/// The properties of a surface's format; constants in a build that draws on one format only.
[[gnu::always_inline]] constexpr const FormatInfo& drawn_info(PixelFormat format) {
    if constexpr ((color_formats & (color_formats - 1)) == 0)
        return detail::only_info;
    return format_info(format);
}
/// Whether a surface of this format is narrow; a constant in builds that have no other choice.
constexpr bool drawn_narrow(PixelFormat format) {
    return has_narrow_formats && (!has_wide_formats || is_narrow(format));
}
/// Whether a surface of this format holds indices; a constant in builds that have no other choice.
constexpr bool drawn_indexed(PixelFormat format) {
    return has_indices && is_indexed(drawn(format));
}

} // namespace spangle::raster
