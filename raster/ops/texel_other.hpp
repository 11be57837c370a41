// Texels of formats without fused loops: 16-bit colours with alpha, palettes, and ETC1 blocks. Textures of
// these formats are sampled as they lie in memory, without expansion.
#pragma once

#include "raster/ops/texel.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// True for formats whose texels are found by column and row (i, j), not by an address.
constexpr bool is_indirect(TexelFormat format) {
    return has_indirect_texels && format >= TexelFormat::p4;
}

/// The form in which lanes get texels.
enum class TexelWords : std::uint8_t {
    rgb565,
    bytes,  ///< components of exactly 8 bits
    colors, ///< words of up to 16 bits that become colours before they are filtered (texel_as_color.hpp)
    none,   ///< texels are read one by one, not in lanes
};
constexpr TexelWords words_of(TexelFormat format) {
    switch (sampled(format)) {
    case TexelFormat::rgb565:
        return TexelWords::rgb565;
    case TexelFormat::rgba5551:
    case TexelFormat::rgb332:
        return TexelWords::colors;
    case TexelFormat::z16:
    case TexelFormat::z24:
        return TexelWords::none;
    default:
        return TexelWords::bytes;
    }
}
/// The format of the words that a palette holds, or that texels are.
constexpr TexelFormat word_format(const Texture& texture) {
    return texture.format == TexelFormat::p4 || texture.format == TexelFormat::p8 ? texture.palette_format
                                                                                  : texture.format;
}
constexpr TexelWords words_of(const Texture& texture) {
    return words_of(word_format(texture));
}

/// R, G and B of one texel of an ETC1 image, with R in the lowest byte (OES_compressed_ETC1_RGB8_texture).
inline std::uint32_t etc1_word(const std::uint8_t* blocks, std::int32_t width, std::int32_t i,
                               std::int32_t j) {
    constexpr std::uint8_t steps[8][2] = {{2, 8},   {5, 17},  {9, 29},   {13, 42},
                                          {18, 60}, {24, 80}, {33, 106}, {47, 183}};
    const std::int32_t x = i & 3, y = j & 3;
    const std::uint8_t* const at = blocks + std::ptrdiff_t{(j >> 2) * ((width + 3) >> 2) + (i >> 2)} * 8;
    const bool flip = (at[3] & 1) != 0, differential = (at[3] & 2) != 0;
    const bool second = (flip ? y : x) >= 2;
    const unsigned bit = static_cast<unsigned>(x * 4 + y);
    const unsigned high = static_cast<unsigned>(at[4] << 8 | at[5]) >> bit & 1,
                   low = static_cast<unsigned>(at[6] << 8 | at[7]) >> bit & 1;
    const std::int32_t step = steps[at[3] >> (second ? 2 : 5) & 7][low], moved = high != 0 ? -step : step;
    std::uint32_t word = 0;
    for (unsigned c = 0; c < 3; ++c) {
        const std::int32_t byte = at[c];
        std::int32_t base;
        if (differential) {
            const std::int32_t delta = ((byte & 7) ^ 4) - 4, five = ((byte >> 3) + (second ? delta : 0)) & 31;
            base = five << 3 | five >> 2;
        } else {
            base = (second ? byte & 15 : byte >> 4) * 17;
        }
        const std::int32_t v = base + moved;
        word |= static_cast<std::uint32_t>(v < 0 ? 0 : v > 255 ? 255 : v) << (8 * c);
    }
    return word;
}

inline const std::uint8_t* palette_entry(const Texture& texture, const TextureLevel& image, std::int32_t i,
                                         std::int32_t j) {
    const std::int32_t n = j * image.width + i;
    const std::int32_t index = texture.format == TexelFormat::p8 ? image.texels[n]
                               : (n & 1) == 0                    ? image.texels[n >> 1] >> 4
                                                                 : image.texels[n >> 1] & 15;
    return texture.palette + index * texel_bytes(texture.palette_format);
}

/// A texel of an indirect format.
template <class N>
[[gnu::noinline]] typename N::Color read_indirect(const Texture& texture, const TextureLevel& image,
                                                  std::int32_t i, std::int32_t j) {
    if (texture.format != TexelFormat::etc1)
        return read_texel<N>(texture.palette_format, palette_entry(texture, image, i, j));
    const std::uint32_t word = etc1_word(image.texels, image.width, i, j);
    return {N::from8(word & 255), N::from8(word >> 8 & 255), N::from8(word >> 16), N::from_units(color_one)};
}

inline std::uint32_t word_4444(const std::uint8_t* at) {
    const std::uint32_t w = Lanes<1>::load(at);
    return (w >> 12 | (w & 0xF00) | (w & 0xF0) << 12 | (w & 15) << 24) * 17;
}

/// The RGBA bytes of a texel of TexelWords::bytes whose format is not common. s and t are the numbers that
/// find_texels() has found.
inline std::uint32_t other_word(const Texture& texture, const TextureLevel& image, std::int32_t s,
                                std::int32_t t) {
    constexpr std::uint32_t opaque = 0xFF000000;
    if constexpr (has_indirect_texels) {
        if (texture.format == TexelFormat::etc1)
            return etc1_word(image.texels, image.width, s, t) | opaque;
        if (is_indirect(texture.format)) {
            const std::uint8_t* const entry = palette_entry(texture, image, s, t);
            return texture.palette_format == TexelFormat::rgb888     ? rgba_word<TexelFormat::rgb888>(entry)
                   : texture.palette_format == TexelFormat::rgba8888 ? rgba_word<TexelFormat::rgba8888>(entry)
                                                                     : word_4444(entry);
        }
    }
    return word_4444(image.texels + t + s);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
