// The kinds of spans: which attributes vary in which way over a primitive.
#pragma once

#include <cstdint>

#include <spangle/raster/features.hpp>
#include <spangle/raster/limits.hpp>

namespace spangle::raster {

/// Every stage list exists once per kind; set-up picks the cheapest kind whose error is within the bounds of
/// the tier (docs/architecture/fragments.md, "Tiers").
enum class Kind : std::uint8_t {
    flat,     ///< one colour (state without projective texture or fog)
    affine,   ///< everything affine: 1/w is constant, or the bound is met over the whole primitive
    textured, ///< texture coordinates and fog projective, colours affine
    full,     ///< everything projective
};
inline constexpr int kind_count = 4;
/// True where some fragments divide: by 1/w, or because an attribute lies too far away for affine forms.
inline constexpr bool has_division = has_perspective || has_chain || has_fog;

} // namespace spangle::raster
