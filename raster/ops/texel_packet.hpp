// Finds the addresses and the words of the texels for a packet. Modes are looked at once per packet.
#pragma once

#include "raster/ops/packet.hpp"
#include "raster/ops/texel_other.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The texels of one axis, as offsets in bytes. LINEAR also has the offsets of the next texels, and their
/// weights in 256ths.
struct TexelOffsets {
    std::int32_t at[packet_length], next[packet_length];
    std::uint32_t weight[packet_length];
};

/// An axis of an image.
struct TexelScale {
    Wrap wrap;
    std::int32_t size, bytes; ///< texels of the axis, and bytes from texel to texel
    bool border;              ///< the image has border texels
};

/// Does what find_texels() does, for any size and wrap mode.
[[gnu::noinline]] inline bool find_general_texels(TexelOffsets& to, bool linear, const TexelScale& axis,
                                                  const std::uint32_t* coord, std::int32_t apart,
                                                  std::int32_t n) {
    bool stored = true;
    for (std::int32_t i = 0; i < n; ++i, coord += apart) {
        const std::uint32_t v = *coord;
        TexelIndex texel{};
        if (linear)
            texel = general_linear(axis.wrap, v, axis.size);
        else
            texel.i = general_nearest(axis.wrap, v, axis.size);
        const std::int32_t at = linear ? wrap_texel(axis.wrap, texel.i, axis.size) : texel.i,
                           next = linear ? wrap_texel(axis.wrap, texel.i + 1, axis.size) : at;
        stored = stored && at >= 0 && next < axis.size;
        to.at[i] = at * axis.bytes;
        to.next[i] = next * axis.bytes;
        to.weight[i] = texel.weight;
    }
    return axis.border || stored;
}

/// Finds the texels along one axis. The n coordinates are `apart` words apart. Returns false where a texel
/// belongs to a border that is only a colour.
[[gnu::noinline]] inline bool find_texels(TexelOffsets& to, bool linear, const TexelScale& of,
                                          const std::uint32_t* coord, std::int32_t apart, std::int32_t n) {
    const TexelScale axis = of; // a copy, so compilers know that writing offsets does not change it
    const int log2_size = log2_of(axis.size);
    const auto each = [&](auto f) __attribute__((always_inline)) {
        for (std::int32_t i = 0; i < n; ++i, coord += apart)
            f(i, *coord);
    };
    if (!is_plain_axis(axis.wrap, axis.size))
        return find_general_texels(to, linear, axis, coord, apart, n);
    if (axis.wrap == Wrap::repeat) {
        const std::int32_t mask = axis.size - 1;
        if (linear)
            each([&](std::int32_t i, std::uint32_t v) __attribute__((always_inline)) {
                const TexelIndex texel = repeat_linear(v, log2_size);
                to.at[i] = texel.i * axis.bytes;
                to.next[i] = ((texel.i + 1) & mask) * axis.bytes;
                to.weight[i] = texel.weight;
            });
        else
            each([&](std::int32_t i, std::uint32_t v) __attribute__((always_inline)) {
                to.at[i] = repeat_nearest(v, log2_size) * axis.bytes;
            });
        return true;
    }
    // CLAMP limits coordinates to [0, 1], so its texels of NEAREST are those of CLAMP_TO_EDGE.
    const bool edge = axis.wrap == Wrap::clamp_to_edge || (axis.wrap == Wrap::clamp && !linear);
    const std::int32_t last = axis.size - 1, low = edge ? 0 : -1, high = edge ? last : axis.size;
    const auto inside = [&](std::int32_t i) __attribute__((always_inline)) {
        return i < low ? low : i > high ? high : i;
    };
    std::int32_t outside = 0; // negative where some texel lies beyond the image
    if (linear)
        each([&](std::int32_t i, std::uint32_t v) __attribute__((always_inline)) {
            const TexelIndex texel = clamped_linear(axis.wrap, static_cast<std::int32_t>(v), log2_size);
            const std::int32_t at = inside(texel.i), next = inside(texel.i + 1);
            outside |= at | (last - next);
            to.at[i] = at * axis.bytes;
            to.next[i] = next * axis.bytes;
            to.weight[i] = texel.weight;
        });
    else
        each([&](std::int32_t i, std::uint32_t v) __attribute__((always_inline)) {
            const std::int32_t at = inside(clamped_nearest(static_cast<std::int32_t>(v), log2_size));
            outside |= at | (last - at);
            to.at[i] = at * axis.bytes;
        });
    return axis.border || outside >= 0;
}

/// Reads one texel for each of n fragments or, with LINEAR, four: those of column i and i + 1 in row j, and
/// the same columns in row j + 1. read(s, t) takes offsets.
template <class Word, class Read>
SPANGLE_INLINE void read_texels(const TexelOffsets& s, const TexelOffsets& t, bool linear, std::int32_t n,
                                Word (*to)[4], Read read) {
    const auto word = [&](std::int32_t across, std::int32_t up) __attribute__((always_inline)) {
        return static_cast<Word>(read(across, up));
    };
    if (!linear) {
        for (std::int32_t i = 0; i < n; ++i)
            to[i][0] = word(s.at[i], t.at[i]);
        return;
    }
    for (std::int32_t i = 0; i < n; ++i) {
        const std::int32_t near = t.at[i], far = t.next[i], left = s.at[i], right = s.next[i];
        to[i][0] = word(left, near);
        to[i][1] = word(right, near);
        to[i][2] = word(left, far);
        to[i][3] = word(right, far);
    }
}
/// Fetches the texels of n fragments as words R5 G6 B5, or of another format of up to 16 bits.
inline void fetch_texels(const Texture& texture, const TextureLevel& image, const TexelOffsets& s,
                         const TexelOffsets& t, bool linear, std::int32_t n, std::uint16_t (*to)[4]) {
    if (is_indirect(texture.format))
        return read_texels(
            s, t, linear, n, to, [&](std::int32_t i, std::int32_t j) __attribute__((noinline)) {
                return Lanes<1>::load(palette_entry(texture, image, i, j));
            });
    if (has_other_texels && texture.format == TexelFormat::rgb332)
        return read_texels(
            s, t, linear, n,
            to, [texels = image.texels](std::int32_t across, std::int32_t up) __attribute__((noinline)) {
                return texels[up + across];
            });
    read_texels(
        s, t, linear, n,
        to, [texels = image.texels](std::int32_t across, std::int32_t up) __attribute__((always_inline)) {
            return Lanes<1>::load(texels + up + across);
        });
}
/// Fetches the texels of n fragments as words of 8-bit components. Components that a format lacks are filled
/// in.
[[gnu::noinline]] inline void fetch_texels(const Texture& texture, const TextureLevel& image,
                                           const TexelOffsets& s, const TexelOffsets& t, bool linear,
                                           std::int32_t n, std::uint32_t (*to)[4]) {
    const auto each = [&](auto word) __attribute__((always_inline)) {
        read_texels(
            s, t, linear, n, to,
            [ word, texels = image.texels ](std::int32_t across, std::int32_t up)
                __attribute__((always_inline)) { return word(texels + up + across); });
    };
    switch (sampled(texture.format)) {
    case TexelFormat::a8:
        return each([](const std::uint8_t* at) { return rgba_word<TexelFormat::a8>(at); });
    case TexelFormat::l8:
        return each([](const std::uint8_t* at) { return rgba_word<TexelFormat::l8>(at); });
    case TexelFormat::i8:
        return each([](const std::uint8_t* at) { return rgba_word<TexelFormat::i8>(at); });
    case TexelFormat::la88:
        return each([](const std::uint8_t* at) { return rgba_word<TexelFormat::la88>(at); });
    case TexelFormat::rgb888:
        return each([](const std::uint8_t* at) { return rgba_word<TexelFormat::rgb888>(at); });
    case TexelFormat::rgba8888:
        return each([](const std::uint8_t* at) { return rgba_word<TexelFormat::rgba8888>(at); });
    default:
        if (has_other_texels && !is_indirect(texture.format))
            return each(word_4444);
        if constexpr (has_other_texels)
            read_texels(
                s, t, linear, n, to, [&](std::int32_t i, std::int32_t j) __attribute__((noinline)) {
                    return other_word(texture, image, i, j);
                });
    }
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
