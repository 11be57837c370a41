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
    std::uint16_t weight[packet_length];
};

/// An axis of an image.
struct TexelScale {
    Wrap wrap;
    std::int32_t size, bytes; ///< texels of the axis, and bytes from texel to texel
    bool border;              ///< the image has border texels
};

/// Does what find_texels() does, for any size and wrap mode.
template <int Lanes>
[[gnu::noinline]] bool find_general_texels(TexelOffsets& to, bool linear, const TexelScale& axis,
                                           const std::uint32_t* coord, std::int32_t group, std::int32_t n) {
    bool stored = true;
    for (std::int32_t i = 0; i < n; ++i) {
        const std::uint32_t v = coord[i / Lanes * group + i % Lanes];
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
        to.weight[i] = static_cast<std::uint16_t>(texel.weight);
    }
    return axis.border || stored;
}

/// Finds the texels along one axis. `coord` holds coordinates in groups that are `group` words apart. Returns
/// false where a texel belongs to a border that is only a colour.
template <int Lanes>
[[gnu::noinline]] bool find_texels(TexelOffsets& to, bool linear, const TexelScale& of,
                                   const std::uint32_t* coord, std::int32_t group, std::int32_t n) {
    const TexelScale axis = of; // a copy, so compilers know that writing offsets does not change it
    const int log2_size = log2_of(axis.size);
    const auto each = [&](auto f) __attribute__((always_inline)) {
        for (std::int32_t i = 0; i < n; i += Lanes, coord += group)
            for (int lane = 0; lane < Lanes; ++lane)
                f(i + lane, coord[lane]);
    };
    if (!is_plain_axis(axis.wrap, axis.size))
        return find_general_texels<Lanes>(to, linear, axis, coord, group, n);
    if (axis.wrap == Wrap::repeat) {
        const std::int32_t mask = axis.size - 1;
        if (linear)
            each([&](std::int32_t i, std::uint32_t v) __attribute__((always_inline)) {
                const TexelIndex texel = repeat_linear(v, log2_size);
                to.at[i] = texel.i * axis.bytes;
                to.next[i] = ((texel.i + 1) & mask) * axis.bytes;
                to.weight[i] = static_cast<std::uint16_t>(texel.weight);
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
    std::int32_t outside = 0; // below 0: some texel lies beyond the image
    if (linear)
        each([&](std::int32_t i, std::uint32_t v) __attribute__((always_inline)) {
            const TexelIndex texel = clamped_linear(axis.wrap, static_cast<std::int32_t>(v), log2_size);
            const std::int32_t at = inside(texel.i), next = inside(texel.i + 1);
            outside |= at | (last - next);
            to.at[i] = at * axis.bytes;
            to.next[i] = next * axis.bytes;
            to.weight[i] = static_cast<std::uint16_t>(texel.weight);
        });
    else
        each([&](std::int32_t i, std::uint32_t v) __attribute__((always_inline)) {
            const std::int32_t at = inside(clamped_nearest(static_cast<std::int32_t>(v), log2_size));
            outside |= at | (last - at);
            to.at[i] = at * axis.bytes;
        });
    return axis.border || outside >= 0;
}

/// Fetches n texels as words R5 G6 B5.
inline void fetch_texels(const Texture& texture, const TextureLevel& image, const std::int32_t* s,
                         const std::int32_t* t, std::int32_t n, std::uint16_t* to) {
    if (is_indirect(texture.format)) {
        for (std::int32_t i = 0; i < n; ++i)
            to[i] = static_cast<std::uint16_t>(Lanes<1>::load(palette_entry(texture, image, s[i], t[i])));
        return;
    }
    for (std::int32_t i = 0; i < n; ++i)
        to[i] = static_cast<std::uint16_t>(Lanes<1>::load(image.texels + t[i] + s[i]));
}
/// Fetches n texels as words of 8-bit components. Components that a format lacks are filled in.
[[gnu::noinline]] inline void fetch_texels(const Texture& texture, const TextureLevel& image,
                                           const std::int32_t* s, const std::int32_t* t, std::int32_t n,
                                           std::uint32_t* to) {
    const auto each = [&](auto word) {
        for (std::int32_t i = 0; i < n; ++i)
            to[i] = word(image.texels + t[i] + s[i]);
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
        for (std::int32_t i = 0; has_other_texels && i < n; ++i)
            to[i] = other_word(texture, image, s[i], t[i]);
    }
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
