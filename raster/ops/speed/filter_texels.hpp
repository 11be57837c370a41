// Mixes four texels as words, where all of them have words.
#pragma once

#include "raster/ops/filtered_texels.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The colour of four texels of one level of a texture. Function is TextureFunction.
template <class N, class Function>
SPANGLE_INLINE typename N::Color filter_texels(const Function& f, const TextureLevel& image,
                                               const FilteredTexels& of) {
    const TexelWords words = words_of(f.texture);
    if constexpr (is_balanced<N>) {
        if (words == TexelWords::rgb565 && f.stored(image, of)) {
            const auto word = [&](std::int32_t x, std::int32_t y) {
                return Lanes<1>::load(is_indirect(f.texture.format) ? palette_entry(f.texture, image, x, y)
                                                                    : f.address(image, x, y));
            };
            return Filter565<1>(of.b)(word(of.i0, of.j0), word(of.i1, of.j0), word(of.i0, of.j1),
                                      word(of.i1, of.j1), of.a);
        }
    }
    if constexpr (is_balanced<N> || std::is_same_v<N, Exact>) {
        if (words == TexelWords::bytes && f.stored(image, of))
            return f.filtered_bytes(image, of.i0, of.i1, of.j0, of.j1, of.a, of.b);
    }
    typename N::Color c[4];
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k)
        c[k] = f.texel(image, of, k);
    return f.mixed(c, of);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
