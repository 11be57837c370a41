// Mixes four texels of any format as colours.
#pragma once

#include "raster/ops/filtered_texels.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The colour of four texels of one level of a texture. Function is TextureFunction.
template <class N, class Function>
SPANGLE_INLINE typename N::Color filter_texels(const Function& f, const TextureLevel& image,
                                               const FilteredTexels& of) {
    typename N::Color c[4];
#pragma GCC unroll 1
    for (int k = 0; k < 4; ++k)
        c[k] = f.texel(image, of, k);
    if constexpr (is_balanced<N>) {
        // In the colour of a texel R5 G6 B5, the top bits of each component are the bits of the texel's word.
        const auto word = [](const typename N::Color& of) -> std::uint32_t {
            return of.r >> 11 << 11 | of.g >> 10 << 5 | of.b >> 11;
        };
        if (words_of(f.texture) == TexelWords::rgb565 && f.stored(image, of))
            return Filter565<1>(of.b)(word(c[0]), word(c[1]), word(c[2]), word(c[3]), of.a);
    }
    return f.mixed(c, of);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
