// The kinds of spans say which attributes vary in which way over a primitive.
#pragma once

#include <cstdint>

#include <spangle/raster/features.hpp>
#include <spangle/raster/limits.hpp>

namespace spangle::raster {

/// Every list of stages exists once per kind. Set-up picks the cheapest kind whose error is within the bounds
/// of the tier (docs/architecture/fragments.md, "Tiers").
enum class Kind : std::uint8_t {
    flat, ///< one colour, and no projective texture or fog
    /// All attributes are affine: 1/w is constant, or the error is small enough over the whole primitive.
    affine,
    textured, ///< texture coordinates and fog are projective, colours are affine
    full,     ///< all attributes are projective
};
inline constexpr int kind_count = 4;
/// True where some fragments divide, by 1/w or because an attribute lies too far away for affine forms.
inline constexpr bool has_division = has_perspective || has_chain || has_fog;

} // namespace spangle::raster
