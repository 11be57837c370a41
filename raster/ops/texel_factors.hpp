// Tables of the factors by which texels multiply colours.
#pragma once

#include <cstdint>
#include <type_traits>

#include "raster/ops/number.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Tables of the factors by which MODULATE multiplies. Entry k is N::fraction() of k/31 or of k/63. Where
/// `Steps` is not 0, it is `Steps` times the factor of N::in_steps().
template <class N, class Word, int Steps> struct TexelFactors {
    Word of5[32], of6[64];
    constexpr TexelFactors() : of5{}, of6{} {
        for (std::uint32_t k = 0; k < 64; ++k) {
            of5[k & 31] = static_cast<Word>(of<5>(k & 31));
            of6[k] = static_cast<Word>(of<6>(k));
        }
    }
    template <unsigned Bits> SPANGLE_INLINE static constexpr std::uint32_t of(std::uint32_t k) {
        if constexpr (Bits == 5)
            return factor<5>(N::texel5(k));
        else
            return factor<6>(N::texel6(k));
    }

  private:
    template <unsigned Bits> static constexpr std::uint32_t factor(std::uint32_t v) {
        if constexpr (Steps != 0)
            return Steps * N::fraction(N::template steps15<Bits>(v));
        else
            return N::fraction(v);
    }
};
template <class N, int Steps = 0>
inline constexpr TexelFactors<N, std::conditional_t<is_balanced<N>, std::uint16_t, std::uint32_t>, Steps>
    texel_factors;

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
