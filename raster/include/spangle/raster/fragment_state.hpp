// What GL asks of a fragment, in the rasterizer's own words. GL fills this plain description;
// raster::compile() turns it into a DrawState (canonical key + constants + chosen span function). Order of
// operations: Red Book, appendix E.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/raster/features.hpp>
#include <spangle/raster/limits.hpp>
#include <spangle/raster/tier.hpp>

namespace spangle::raster {

/// Enumerators stand in the order of GL's tokens, so a token minus the first token of its group is the
/// enumerator.
enum class Compare : std::uint8_t { never, less, equal, lequal, greater, notequal, gequal, always };
/// What happens to a stencil value (GL 1.3, 4.1.5; the wrapping ones: GL 1.4, 4.1.5).
enum class StencilOp : std::uint8_t { keep, zero, replace, incr, decr, invert, incr_wrap, decr_wrap };
/// What a colour is multiplied with in blending (GL 1.4, 4.1.7).
enum class BlendFactor : std::uint8_t {
    zero,
    one,
    src_color,
    one_minus_src_color,
    src_alpha,
    one_minus_src_alpha,
    dst_alpha,
    one_minus_dst_alpha,
    dst_color,
    one_minus_dst_color,
    src_alpha_saturate,
    constant_color,
    one_minus_constant_color,
    constant_alpha,
    one_minus_constant_alpha,
};
/// How the two products of blending are joined (GL 1.4, 4.1.7).
enum class BlendEquation : std::uint8_t { add, subtract, reverse_subtract, min, max };
/// Bit 0: s and d, 1: s and not d, 2: not s and d, 3: neither; the order of GL's tokens.
enum class LogicOp : std::uint8_t {
    clear,
    logical_and,
    and_reverse,
    copy,
    and_inverted,
    noop,
    logical_xor,
    logical_or,
    nor,
    equiv,
    invert,
    or_reverse,
    copy_inverted,
    or_inverted,
    nand,
    set,
};
/// What a texture coordinate outside of [0, 1] means (GL 1.4, 3.8.7).
enum class Wrap : std::uint8_t { repeat, clamp, clamp_to_edge, clamp_to_border, mirrored_repeat };
/// How texels of one image become a colour (GL 1.3, 3.8.8).
enum class Filter : std::uint8_t { nearest, linear };
/// Which images of a mipmap a minification reads (GL 1.3, 3.8.8).
enum class MipFilter : std::uint8_t { none, nearest, linear };
/// How a texture's colour meets the fragment's (GL 1.3, 3.8.12).
enum class TexEnv : std::uint8_t { replace, modulate, decal, blend, add, combine };
/// What TexEnv::combine does with its arguments (GL 1.3, table 3.24).
enum class CombineFunc : std::uint8_t {
    replace,
    modulate,
    add,
    add_signed,
    interpolate,
    subtract,
    dot3_rgb,
    dot3_rgba,
};
/// `texture0` + n: the texture colour of unit n, whichever unit asks for it.
enum class CombineSource : std::uint8_t { texture, constant, primary_color, previous, texture0 };
/// Operands in the order of GL's tokens: SRC_COLOR, ONE_MINUS_SRC_COLOR, SRC_ALPHA, ONE_MINUS_SRC_ALPHA.
enum class CombineOperand : std::uint8_t { color, one_minus_color, alpha, one_minus_alpha };
/// Which components a texture has (GL 1.3, 3.8.1).
enum class BaseFormat : std::uint8_t { alpha, luminance, luminance_alpha, intensity, rgb, rgba };
/// Where a fragment's primary colour comes from: its vertices, or the image that is drawn. With
/// `of_pixels_565` the image has components k/31, k/63 and k/31, so that 16 bits hold its colours exactly.
enum class Colors : std::uint8_t { of_vertices, of_pixels, of_pixels_565 };
/// How the fog factor follows from the distance (GL 1.3, 3.10).
enum class FogMode : std::uint8_t { exp, exp2, linear };

/// How texels lie in memory; 16-bit texels are host-order uint16_t, the first component in the top bits.
enum class TexelFormat : std::uint8_t {
    a8,
    l8,
    i8,
    la88,
    rgb565,
    rgb888,
    rgba8888,
    rgba4444,
    rgba5551,
    rgb332,
    z16, ///< depths, read as components of the texture's `base` format
    z24, ///< depths in the low 24 bits of a uint32_t
    p4,  ///< indices of a palette, without padding of rows, the first in the top bits
    p8,
    etc1, ///< blocks of 4 x 4 texels, 8 bytes each, in rows
};

/// The texel formats of this build, without those whose systems are left out.
inline constexpr unsigned sampled_formats = [] {
    constexpr unsigned depths = 3u << static_cast<unsigned>(TexelFormat::z16),
                       compressed = 7u << static_cast<unsigned>(TexelFormat::p4);
    return texture_formats & ~(has_depth_textures ? 0 : depths) & ~(has_compressed_textures ? 0 : compressed);
}();
/// Whether textures may have this format.
constexpr bool has_format(TexelFormat format) {
    return (sampled_formats >> static_cast<unsigned>(format) & 1) != 0;
}
/// The format of a texture; a constant in a build that has only one.
constexpr TexelFormat sampled(TexelFormat format) {
    return one_of(sampled_formats, format);
}
/// Whether there are texel formats without loops of their own (`has_other_texels`), or whose texels are found
/// by their place (i, j), not by an address (`has_indirect_texels`).
inline constexpr bool has_other_texels = sampled_formats >> static_cast<unsigned>(TexelFormat::rgba4444) != 0,
                      has_indirect_texels = sampled_formats >> static_cast<unsigned>(TexelFormat::p4) != 0;

/// line: one row, t is ignored. volume: images one behind the other, each as high as the first one with its
/// border.
enum class TextureShape : std::uint8_t { line, plane, volume, cube };

/// One image of a texture.
struct TextureLevel {
    /// The first texel inside the border, row t = 0 first; texels of 16 and 32 bits are aligned. The memory
    /// must stay as long as anything draws with the texture.
    const std::uint8_t* texels = nullptr;
    std::uint16_t width = 0, height = 0; ///< size in texels, without the border
    std::uint32_t stride = 0;            ///< bytes from row t to t + 1
    friend constexpr bool operator==(const TextureLevel&, const TextureLevel&) = default;
};

/// Texels of every face and level of a cube map, in the order of GL's tokens; all else is as for the first
/// face.
struct CubeFaces {
    /// The first texel inside the border, by face and level.
    const std::uint8_t* texels[6][max_texture_levels];
};

/// An immutable view of a complete texture, ready to sample. Colours of 8 bits are k/255, of 5 and 6 bits
/// k/31, k/63.
struct Texture {
    /// The images; `level[0]` is the base level (TEXTURE_BASE_LEVEL already applied).
    TextureLevel level[max_texture_levels];
    std::uint8_t level_count = 0; ///< 1 without mipmaps
    /// How the texels lie in memory.
    TexelFormat format = TexelFormat::rgb888;
    /// Which components the texels have.
    BaseFormat base = BaseFormat::rgb;
    /// TEXTURE_WRAP_S and TEXTURE_WRAP_T.
    Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
    /// TEXTURE_MAG_FILTER, and what TEXTURE_MIN_FILTER asks within an image.
    Filter mag = Filter::linear, min = Filter::nearest;
    /// What TEXTURE_MIN_FILTER asks between images.
    MipFilter mip = MipFilter::none;
    /// The dimensions of the texture, and which of the coordinates s, t and r select a texel.
    TextureShape shape = TextureShape::plane;
    std::uint16_t depth = 1; ///< images of a volume's base level; level l has 1/2^l of them, at least one
    /// TEXTURE_WRAP_R.
    Wrap wrap_r = Wrap::repeat;
    bool compares = false; ///< depth textures: a texel is 1 where `r compare depth` holds, else 0
    /// TEXTURE_COMPARE_FUNC (GL 1.4, 3.8.14).
    Compare compare = Compare::lequal;
    /// How a colour lies in `palette`.
    TexelFormat palette_format = TexelFormat::rgb888;
    const std::uint8_t* palette = nullptr; ///< palette of p4 and p8, for all levels
    const CubeFaces* faces = nullptr;      ///< texels of the faces of a cube map
    /// 1 when the image has a border around [0,w) x [0,h): texel -1 is readable.
    std::uint8_t border_texels = 0;
    std::int32_t min_lod = -1000 * 256, max_lod = 1000 * 256; ///< limits of the level of detail, in s23.8
    std::uint8_t border_color[4] = {0, 0, 0, 0};              ///< RGBA, 255ths
    friend constexpr bool operator==(const Texture&, const Texture&) = default;
};

/// Whether a texture needs the third coordinate, which is then interpolated and divided at every fragment.
constexpr bool wants_r(const Texture& texture) {
    return texture.shape >= TextureShape::volume || texture.compares;
}

/// The function that COMBINE applies to RGB or to alpha (GL 1.3, tables 3.24 to 3.26).
struct Combiner {
    /// COMBINE_RGB or COMBINE_ALPHA.
    CombineFunc func = CombineFunc::modulate;
    std::uint8_t log2_scale = 0; ///< log2 of the scale, 0 to 2
    /// One argument of the function.
    struct Argument {
        /// SOURCEn_RGB or SOURCEn_ALPHA.
        CombineSource source = CombineSource::previous;
        /// OPERANDn_RGB or OPERANDn_ALPHA.
        CombineOperand operand = CombineOperand::color;
        friend constexpr bool operator==(const Argument&, const Argument&) = default;
    } argument[3]; ///< the arguments, as many as `func` has
    friend constexpr bool operator==(const Combiner&, const Combiner&) = default;
};

/// A texture unit as fragments see it (GL 1.3, 3.8.12).
struct TextureUnit {
    const Texture* texture = nullptr; ///< null: unit off
    /// TEXTURE_ENV_MODE.
    TexEnv env = TexEnv::modulate;
    /// The combiners of TexEnv::combine. Every unit that they name as a source is on.
    Combiner rgb, alpha;
    /// The LOD biases of the texture and of the unit together, in s23.8.
    std::int32_t lod_bias = 0;
    std::uint32_t env_color[4] = {0, 0, 0, 0}; ///< Colour units (see vertex.hpp)
    friend constexpr bool operator==(const TextureUnit&, const TextureUnit&) = default;
};

/// The stencil test (GL 1.3, 4.1.5).
struct StencilState {
    /// How `ref` is compared with the stored value.
    Compare func = Compare::always;
    /// The reference value, and the bits that are compared and written.
    std::uint8_t ref = 0, compare_mask = 0xFF, write_mask = 0xFF;
    /// What is done where the stencil test fails, the depth test fails, and both pass.
    StencilOp fail = StencilOp::keep, depth_fail = StencilOp::keep, pass = StencilOp::keep;
    friend constexpr bool operator==(const StencilState&, const StencilState&) = default;
};

/// How one part of a colour is blended: C = src Cs + dst Cd and the like.
struct Blending {
    /// Factors of the fragment's colour and of the stored one.
    BlendFactor src = BlendFactor::one, dst = BlendFactor::zero;
    /// The equation that joins both colours, multiplied by their factors.
    BlendEquation equation = BlendEquation::add;
    friend constexpr bool operator==(const Blending&, const Blending&) = default;
};
/// What most programs blend with: SRC_ALPHA, ONE_MINUS_SRC_ALPHA.
inline constexpr Blending blend_over = {BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha};

/// All that decides what a fragment of a primitive does. Textures that it names must stay while it is drawn
/// with.
struct FragmentState {
    [[gnu::noinline]] FragmentState(); ///< not inline, because the code is long

    /// The texture units.
    TextureUnit unit[max_texture_units];
    /// Where the primary colour comes from.
    Colors colors = Colors::of_vertices;
    bool flat = false;       ///< flat shading, with the colour of the provoking vertex
    bool color_sum = false;  ///< the secondary colour is added after texturing
    bool perspective = true; ///< some w != 1 may occur; false lets 2D programs skip 1/w altogether
    /// FOG is enabled.
    bool fog = false;
    /// FOG_MODE.
    FogMode fog_mode = FogMode::exp;
    /// Colour units (see vertex.hpp); of an index surface [0] is the index, with 20 fraction bits.
    std::uint32_t fog_color[3] = {0, 0, 0};
    std::uint32_t fog_density = 0, fog_start = 0, fog_end = 0x3F800000; ///< bits of the floats that were set
    /// ALPHA_TEST is enabled (GL 1.3, 4.1.4).
    bool alpha_test = false;
    /// ALPHA_TEST_FUNC.
    Compare alpha_func = Compare::always;
    std::uint8_t alpha_ref = 0; ///< reference value of the alpha test, in 255ths
    /// STENCIL_TEST is enabled.
    bool stencil_test = false;
    /// The stencil test of both faces; GL fills it for the face that is drawn.
    StencilState stencil;
    /// DEPTH_TEST is enabled, and DEPTH_WRITEMASK (GL 1.3, 4.1.6).
    bool depth_test = false, depth_write = true;
    /// DEPTH_FUNC.
    Compare depth_func = Compare::less;
    /// BLEND is enabled (GL 1.3, 4.1.7).
    bool blend = false;
    /// How red, green and blue are blended, and how alpha is.
    Blending blend_rgb, blend_alpha;
    std::uint32_t blend_color[4] = {0, 0, 0, 0}; ///< Colour units
    bool logic = false;                          ///< a logic operation replaces blending
    /// LOGIC_OP_MODE (GL 1.3, 4.1.9).
    LogicOp logic_op = LogicOp::copy;
    /// DITHER is enabled.
    bool dither = true;
    /// Bit 0 red, 1 green, 2 blue, 3 alpha, or the bits of an index; 0 also when DrawBuffer is NONE.
    std::uint8_t color_mask = 0xF;
    Rect scissor;            ///< already intersected with the surface; drawing never leaves it
    Tier tier = Tier::exact; ///< the tier of fog, too (PERSPECTIVE_CORRECTION_HINT)
#if SPANGLE_OWN_TIERS
    bool own_tier = false; ///< `knobs` replaces the knobs of `tier`
    Knobs knobs{};         ///< must satisfy are_valid()
#endif
    bool count = false; ///< count passing fragments in Counters::passed (costs time)
    // The next three members switch data that primitives have beside their planes
    // (raster/span/primitive_state.hpp). A Rasterizer draws no primitives with such data.
    bool coverage = false;     ///< coverage goes into alpha, or an index: antialiasing (GL 1.3, 3.11)
    bool depth_offset = false; ///< a depth offset of polygons (GL 1.3, 3.5.5)
    const std::uint32_t* polygon_stipple = nullptr; ///< 32 rows, bit x: column x is drawn; null: off
    // Multisample fragment operations (GL 1.3, 4.1.3); Rasterizer has none.
    /// SAMPLE_ALPHA_TO_COVERAGE and SAMPLE_ALPHA_TO_ONE are enabled.
    bool alpha_to_coverage = false, alpha_to_one = false;
    /// SAMPLE_COVERAGE is enabled, and SAMPLE_COVERAGE_INVERT.
    bool sample_coverage = false, invert_sample_coverage = false;
    std::uint8_t sample_coverage_value = 255; ///< coverage value, in 255ths
    friend constexpr bool operator==(const FragmentState&, const FragmentState&) = default;
};

} // namespace spangle::raster
