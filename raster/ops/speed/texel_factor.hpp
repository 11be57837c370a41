// One factor by which a texel multiplies a colour, from a table.
#pragma once

#include "raster/ops/texel_factors.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Factor k of TexelFactors.
template <unsigned Bits, class N, int Steps> SPANGLE_INLINE std::uint32_t texel_factor(std::uint32_t k) {
    return Bits == 5 ? texel_factors<N, Steps>.of5[k] : texel_factors<N, Steps>.of6[k];
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
