// Filters texels of TexelWords::colors. Each texel becomes a colour, and LINEAR mixes four colours. The bits
// are those of TextureFunction, in any number of lanes.
#pragma once

#include "raster/ops/number_wide.hpp"
#include "raster/ops/texel_other.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// `format` is word_format() of the texture.
template <class N>
SPANGLE_INLINE typename N::Color texel_as_color(TexelFormat format, const typename N::L::U16& word) {
    return format == TexelFormat::rgb332 ? color_of_332<N>(word) : color_of_5551<N>(word);
}

/// Mixes four colours as bilinear() does. `right` and `down` are the weights of the next column and of the
/// next row, in 256ths.
template <class N>
SPANGLE_INLINE typename N::Color
mixed_colors(const typename N::Color& c00, const typename N::Color& c10, const typename N::Color& c01,
             const typename N::Color& c11, const typename N::L::U16& right, const typename N::L::U16& down) {
    using L = typename N::L;
    using U16 = typename L::U16;
    using T = typename N::T;
    if constexpr (N::lanes == 1) {
        return bilinear<N>(c00, c10, c01, c11, right, down);
    } else if constexpr (is_exact<N>) {
        const typename N::Weights weights(down);
        const T a = L::widened(right);
        return {weights.components(c00.r, c10.r, c01.r, c11.r, a),
                weights.components(c00.g, c10.g, c01.g, c11.g, a),
                weights.components(c00.b, c10.b, c01.b, c11.b, a),
                weights.components(c00.a, c10.a, c01.a, c11.a, a)};
    } else {
        // Weights of the balanced tier would take a bit off c00 where it has the whole weight.
        const auto whole = L::equal(right | down, L::splat(0));
        const U16 w11 = right * down, w10 = right * (256 - down), w01 = (256 - right) * down,
                  w00 = L::splat(weight_one<N>) - w11 - w10 - w01;
        const auto mix = [&](const T& a, const T& b, const T& c, const T& d) __attribute__((always_inline)) {
            return L::select(whole, a, N::weighted(a, w00, b, w10, c, w01, d, w11));
        };
        return {mix(c00.r, c10.r, c01.r, c11.r), mix(c00.g, c10.g, c01.g, c11.g),
                mix(c00.b, c10.b, c01.b, c11.b), mix(c00.a, c10.a, c01.a, c11.a)};
    }
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
