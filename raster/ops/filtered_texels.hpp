// Four texels that LINEAR mixes.
#pragma once

#include "raster/ops/texel_color.hpp"
#include "raster/ops/texel_other.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The places of four texels in a level: columns i0 and i1, rows j0 and j1. The weights are those of i1 and
/// of j1.
struct FilteredTexels {
    std::int32_t i0, i1, j0, j1;
    std::uint32_t a, b;
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
