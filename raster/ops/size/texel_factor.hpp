// One factor by which a texel multiplies a colour, computed without a table.
#pragma once

#include "raster/ops/texel_factors.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Factor k of TexelFactors.
template <unsigned Bits, class N, int Steps> SPANGLE_INLINE std::uint32_t texel_factor(std::uint32_t k) {
    return std::remove_const_t<decltype(texel_factors<N, Steps>)>::template of<Bits>(k);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
