// How texels lie in memory, how coordinates wrap, and how texels are filtered (GL 1.3, 3.8.7).
#pragma once

#include <cstring>

#include "raster/numeric/reciprocal.hpp"
#include "raster/ops/number.hpp"
#include "raster/ops/plain_axis.hpp"
#include "raster/ops/power_of_two.hpp"
#include "raster/span/instructions.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

constexpr int texel_bytes(TexelFormat format) {
    // Bytes of a texel, by format. 0 means that texels of the format have no addresses.
    constexpr std::uint8_t bytes[] = {1, 1, 1, 2, 2, 3, 4, 2, 2, 1, 2, 4, 0, 0, 0};
    return bytes[static_cast<unsigned>(format)];
}

/// True for formats for which fused loops exist. read_other_texel() and texel_other.hpp read texels of other
/// formats.
constexpr bool is_common(TexelFormat format) {
    return format <= TexelFormat::rgba8888;
}

/// The components of one texel. A missing alpha is 1. Luminance stands for all three colours.
template <class N, TexelFormat Format> SPANGLE_INLINE typename N::Color read_texel(const std::uint8_t* at) {
    static_assert(N::lanes == 1);
    const typename N::T one = N::from_units(color_one);
    if constexpr (Format == TexelFormat::a8) {
        return {one, one, one, N::from8(at[0])};
    } else if constexpr (Format == TexelFormat::l8) {
        const typename N::T l = N::from8(at[0]);
        return {l, l, l, one};
    } else if constexpr (Format == TexelFormat::i8) {
        const typename N::T i = N::from8(at[0]);
        return {i, i, i, i};
    } else if constexpr (Format == TexelFormat::la88) {
        const typename N::T l = N::from8(at[0]);
        return {l, l, l, N::from8(at[1])};
    } else if constexpr (Format == TexelFormat::rgb565) {
        const std::uint32_t word = Lanes<1>::load(at);
        return {N::texel5(word >> 11), N::texel6((word >> 5) & 63), N::texel5(word & 31), one};
    } else if constexpr (Format == TexelFormat::rgb888) {
        return {N::from8(at[0]), N::from8(at[1]), N::from8(at[2]), one};
    } else {
        static_assert(Format == TexelFormat::rgba8888);
        return {N::from8(at[0]), N::from8(at[1]), N::from8(at[2]), N::from8(at[3])};
    }
}

/// k / Most as a component, rounded up, as texels are (Exact::weighted()). For 1, 2 and 4 bits it is a whole
/// number of 255ths.
template <class N, std::uint32_t Most> SPANGLE_INLINE typename N::T from_steps(std::uint32_t k) {
    if constexpr (255 % Most == 0) {
        return N::from8(static_cast<typename N::L::U16>(k * (255 / Most)));
    } else {
        constexpr std::uint32_t common = Most % 255 == 0 ? 255 : 1, parts = 255 / common, of = Most / common;
        if constexpr (of >= 1u << (32 - color_fraction_bits))
            return N::from_units(
                static_cast<std::uint32_t>(numeric::quotient(std::int64_t{k} * color_one + Most - 1, Most)));
        else // k parts / of, split into whole 255ths and a rest, so that words suffice
            return N::from_units((k * parts / of << color_fraction_bits) +
                                 ((k * parts % of << color_fraction_bits) + of - 1) / of);
    }
}

/// The colour of a texel R5 G5 B5 A1, or of R3 G3 B2, from the word that holds its bits. N may have lanes.
template <class N> SPANGLE_INLINE typename N::Color color_of_5551(const typename N::L::U16& word) {
    return {N::texel5(word >> 11), N::texel5((word >> 6) & 31), N::texel5((word >> 1) & 31),
            N::from8((word & 1) * 255)};
}
template <class N> SPANGLE_INLINE typename N::Color color_of_332(const typename N::L::U16& word) {
    return {N::texel3(word >> 5), N::texel3((word >> 2) & 7), N::from8((word & 3) * 85),
            N::from_units(color_one)};
}

/// A texel of a format that is not common, but whose texels have addresses. A depth stands for all four
/// components.
template <class N>
[[gnu::noinline]] typename N::Color read_other_texel(TexelFormat format, const std::uint8_t* at) {
    const auto grey = [](typename N::T v) { return typename N::Color{v, v, v, v}; };
    std::uint32_t word = format == TexelFormat::rgb332 ? at[0] : Lanes<1>::load(at);
    switch (format) {
    case TexelFormat::rgba4444:
        return {from_steps<N, 15>(word >> 12), from_steps<N, 15>(word >> 8 & 15),
                from_steps<N, 15>(word >> 4 & 15), from_steps<N, 15>(word & 15)};
    case TexelFormat::rgba5551:
        return color_of_5551<N>(word);
    case TexelFormat::rgb332:
        return color_of_332<N>(word);
    case TexelFormat::z16:
        if constexpr (has_format(TexelFormat::z16))
            return grey(from_steps<N, 65535>(word));
        break;
    default:
        break;
    }
    if constexpr (has_format(TexelFormat::z24)) {
        __builtin_memcpy(&word, at, 4);
        return grey(from_steps<N, 0xFFFFFF>(word));
    }
    return {};
}

/// A texel of a format that the build may lack; the colour is 0 then.
template <class N, TexelFormat Format>
SPANGLE_INLINE typename N::Color read_texel_of(const std::uint8_t* at) {
    if constexpr (has_format(Format))
        return read_texel<N, Format>(at);
    else
        return {};
}

/// A texel of a format that is known only at run time.
template <class N>
[[gnu::noinline]] typename N::Color read_texel(TexelFormat format, const std::uint8_t* at) {
    switch (sampled(format)) {
    case TexelFormat::a8:
        return read_texel_of<N, TexelFormat::a8>(at);
    case TexelFormat::l8:
        return read_texel_of<N, TexelFormat::l8>(at);
    case TexelFormat::i8:
        return read_texel_of<N, TexelFormat::i8>(at);
    case TexelFormat::la88:
        return read_texel_of<N, TexelFormat::la88>(at);
    case TexelFormat::rgb565:
        return read_texel_of<N, TexelFormat::rgb565>(at);
    case TexelFormat::rgb888:
        return read_texel_of<N, TexelFormat::rgb888>(at);
    case TexelFormat::rgba8888:
        return read_texel_of<N, TexelFormat::rgba8888>(at);
    default:
        if constexpr (has_other_texels)
            return read_other_texel<N>(format, at);
        else
            return {};
    }
}

/// A position along one axis: the index of a texel, and the weight of the next texel in 256ths.
struct TexelIndex {
    std::int32_t i;
    std::uint32_t weight;
};

/// The texel index of a coordinate that wraps; 2^32 is one repeat.
SPANGLE_INLINE std::int32_t repeat_index(std::uint32_t s, int log2_size) {
    return static_cast<std::int32_t>((s >> 1) >> (31 - log2_size));
}
/// Where the position of LINEAR begins. In every policy LINEAR rounds the place between two texels to the
/// nearest 256th by definition. So where a coordinate meets the centre of a texel, except for arithmetic
/// error, this texel has the whole weight. The first place that is rounded down to 0 lies half a texel minus
/// half a 256th inside of the image.
SPANGLE_INLINE constexpr std::uint32_t linear_origin(int log2_size) {
    return ((1u << 31) - (1u << 23)) >> log2_size;
}
SPANGLE_INLINE TexelIndex repeat_linear(std::uint32_t s, int log2_size) {
    const std::uint32_t u = s - linear_origin(log2_size);
    return {repeat_index(u, log2_size), (u << log2_size) >> 24};
}

/// NEAREST is floor(u + 2^-13 texel) by definition, in every policy. So sprites whose texels meet pixel
/// centres exactly do not depend on the last bit of u.
inline constexpr int nearest_bias_bits = 13;
SPANGLE_INLINE constexpr std::uint32_t nearest_bias(int log2_size) {
    return 1u << (32 - nearest_bias_bits - log2_size);
}
SPANGLE_INLINE std::int32_t repeat_nearest(std::uint32_t s, int log2_size) {
    return repeat_index(s + nearest_bias(log2_size), log2_size);
}

/// The texel index of a coordinate that does not wrap (s3.28). What a shift drops is less than one unit of
/// the bias, so that words hold the place; textures have at most 2^11 texels along an axis.
SPANGLE_INLINE std::int32_t clamped_nearest(std::int32_t s, int log2_size) {
    const std::int32_t i =
        ((s >> (clamped_coord_bits - nearest_bias_bits - log2_size)) + 1) >> nearest_bias_bits;
    // s = 1 is the last texel (GL 1.3, 3.8.8), also with CLAMP_TO_BORDER.
    return i == 1 << log2_size && s <= 1 << clamped_coord_bits ? i - 1 : i;
}
SPANGLE_INLINE TexelIndex clamped_linear(Wrap wrap, std::int32_t s, int log2_size) {
    constexpr std::int32_t one = 1 << clamped_coord_bits;
    if (wrap == Wrap::clamp) // CLAMP limits s to [0, 1] first: at the edge half of the border is mixed in
        s = s < 0 ? 0 : s > one ? one : s;
    // The position, in 512ths of a texel, is rounded to 256ths. Half a texel is 128 of them.
    const std::int32_t fixed = (((s >> (clamped_coord_bits - 9 - log2_size)) + 1) >> 1) - 128;
    return {fixed >> 8, static_cast<std::uint32_t>(fixed) & 255};
}

/// The texel that stands for texel i in a wrap mode, where i is at most one beyond the image:
/// - REPEAT: i modulo size;
/// - MIRRORED_REPEAT: i counts two repeats, of which the second runs backwards;
/// - CLAMP_TO_EDGE: limited to 0 .. size - 1;
/// - the other modes: limited to -1 .. size.
SPANGLE_INLINE std::int32_t wrap_texel(Wrap wrap, std::int32_t i, std::int32_t size) {
    if (wrap == Wrap::repeat)
        return i < 0 ? i + size : i >= size ? i - size : i;
    if (wrap == Wrap::mirrored_repeat) {
        const std::int32_t both = 2 * size, k = i < 0 ? i + both : i >= both ? i - both : i;
        return k < size ? k : both - 1 - k;
    }
    const std::int32_t low = wrap == Wrap::clamp_to_edge ? 0 : -1;
    const std::int32_t high = wrap == Wrap::clamp_to_edge ? size - 1 : size;
    return i < low ? low : i > high ? high : i;
}

/// The position of a coordinate in 2^-Fraction texels, before wrapping, for any size and wrap mode. A
/// mirrored image counts as a repeating image of twice the size.
template <int Fraction> constexpr std::int64_t axis_position(Wrap wrap, std::uint32_t s, std::int32_t size) {
    if (wrap == Wrap::repeat || wrap == Wrap::mirrored_repeat) {
        const std::uint32_t whole = static_cast<std::uint32_t>(wrap == Wrap::repeat ? size : 2 * size);
        return static_cast<std::int64_t>(std::uint64_t{s} * whole >> (32 - Fraction));
    }
    std::int64_t v = static_cast<std::int32_t>(s);
    if (wrap == Wrap::clamp)
        v = numeric::clamp<std::int64_t>(v, 0, 1 << clamped_coord_bits);
    return v * size >> (clamped_coord_bits - Fraction);
}
inline std::int32_t general_nearest(Wrap wrap, std::uint32_t s, std::int32_t size) {
    const auto i =
        static_cast<std::int32_t>((axis_position<nearest_bias_bits>(wrap, s, size) + 1) >> nearest_bias_bits);
    const bool clamps = wrap != Wrap::repeat && wrap != Wrap::mirrored_repeat;
    // s = 1 belongs to the last texel (GL 1.3, 3.8.8), also with CLAMP_TO_BORDER.
    const bool last = clamps && i == size && static_cast<std::int32_t>(s) <= 1 << clamped_coord_bits;
    return wrap_texel(wrap == Wrap::clamp ? Wrap::clamp_to_edge : wrap, last ? i - 1 : i, size);
}
inline TexelIndex general_linear(Wrap wrap, std::uint32_t s, std::int32_t size) {
    const auto fixed = static_cast<std::int32_t>(((axis_position<9>(wrap, s, size) + 1) >> 1) - 128);
    return {fixed >> 8, static_cast<std::uint32_t>(fixed) & 255};
}

/// The texel of a coordinate (NEAREST) in any wrap mode. wrapped_linear() gives the place between two texels
/// (LINEAR).
inline std::int32_t wrapped_nearest(Wrap wrap, std::uint32_t s, int log2_size, std::int32_t size) {
    if (!is_plain_axis(wrap, size))
        return general_nearest(wrap, s, size);
    if (wrap == Wrap::repeat)
        return repeat_nearest(s, log2_size);
    const std::int32_t i = clamped_nearest(static_cast<std::int32_t>(s), log2_size);
    // CLAMP limits coordinates to [0, 1], so it meets the same texels as CLAMP_TO_EDGE.
    return wrap_texel(wrap == Wrap::clamp ? Wrap::clamp_to_edge : wrap, i, size);
}
inline TexelIndex wrapped_linear(Wrap wrap, std::uint32_t s, int log2_size, std::int32_t size) {
    if (!is_plain_axis(wrap, size))
        return general_linear(wrap, s, size);
    return wrap == Wrap::repeat ? repeat_linear(s, log2_size)
                                : clamped_linear(wrap, static_cast<std::int32_t>(s), log2_size);
}
constexpr std::uint8_t log2_of(std::int32_t size) {
    return static_cast<std::uint8_t>(31 - numeric::clz32(static_cast<std::uint32_t>(size) | 1));
}

/// log2 of the least power of two that is not below the size.
constexpr std::uint8_t ceil_log2_of(std::int32_t size) {
    return static_cast<std::uint8_t>(log2_of(size) + (is_power_of_two(size) ? 0 : 1));
}

/// The bytes of an 8-bit texel in one word, with R in the lowest byte. Lanes take texels in this form.
template <TexelFormat Format> SPANGLE_INLINE std::uint32_t texel_word(const std::uint8_t* at) {
    static_assert(Format == TexelFormat::rgb888 || Format == TexelFormat::rgba8888);
    if constexpr (Format == TexelFormat::rgba8888)
        return numeric::load_low_first<std::uint32_t>(at);
    else
        return numeric::load_low_first<std::uint16_t>(at) | std::uint32_t{at[2]} << 16;
}

/// The four bytes R, G, B, A of a texel in one word, with R in the lowest byte. All formats with 8-bit
/// components are possible; missing components are filled in.
template <TexelFormat Format> SPANGLE_INLINE std::uint32_t rgba_word(const std::uint8_t* at) {
    constexpr std::uint32_t gray = 0x00010101, opaque = 0xFF000000;
    if constexpr (Format == TexelFormat::a8)
        return std::uint32_t{at[0]} << 24 | 0x00FFFFFF;
    else if constexpr (Format == TexelFormat::l8)
        return at[0] * gray | opaque;
    else if constexpr (Format == TexelFormat::i8)
        return at[0] * (gray | 0x01000000);
    else if constexpr (Format == TexelFormat::la88)
        return at[0] * gray | std::uint32_t{at[1]} << 24;
    else if constexpr (Format == TexelFormat::rgb888)
        return texel_word<Format>(at) | opaque;
    else
        return texel_word<Format>(at);
}

/// Mixes four texels by 8-bit weights. a is the weight of the next column (along s), and b that of the next
/// row (along t).
template <class N>
SPANGLE_INLINE typename N::Color bilinear(const typename N::Color& c00, const typename N::Color& c10,
                                          const typename N::Color& c01, const typename N::Color& c11,
                                          std::uint32_t a, std::uint32_t b) {
    if constexpr (is_balanced<N>) // balanced weights would take a bit off c00, which has the whole weight
        if ((a | b) == 0)
            return c00;
    const std::uint32_t w11 = a * b, w10 = a * (256 - b), w01 = (256 - a) * b,
                        w00 = weight_one<N> - w11 - w10 - w01;
    return {N::weighted(c00.r, w00, c10.r, w10, c01.r, w01, c11.r, w11),
            N::weighted(c00.g, w00, c10.g, w10, c01.g, w01, c11.g, w11),
            N::weighted(c00.b, w00, c10.b, w10, c01.b, w01, c11.b, w11),
            N::weighted(c00.a, w00, c10.a, w10, c01.a, w01, c11.a, w11)};
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
