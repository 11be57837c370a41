// What the number system of a chain says about its stages.
#pragma once

#include <type_traits>

#include "raster/chain/chain.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/key.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <class N> inline constexpr bool is_fixed = std::is_same_v<typename N::Policy, Fixed>;

/// True where attributes over w are divided in lanes. All of them are multiplied by one 1/w.
template <class N> inline constexpr bool by_lanes = is_fixed<N> && (N::lanes > 1);
} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
