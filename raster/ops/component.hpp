// Compares and selects components of a number system, with one lane or with several.
#pragma once

#include "raster/ops/number_wide.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {
namespace component {

/// The component with the value v, in all lanes.
template <class N> SPANGLE_INLINE typename N::T constant(std::uint32_t v) {
    if constexpr (N::lanes == 1)
        return static_cast<typename N::T>(v);
    else if constexpr (is_exact<N>)
        return N::L::splat32(v);
    else
        return N::L::splat(v);
}
/// The component that stands for 1. In the double reference N::one is not a count of units.
template <class N> SPANGLE_INLINE typename N::T one() {
    return N::from_units(color_one);
}
template <class N> SPANGLE_INLINE typename N::T smaller(const typename N::T& a, const typename N::T& b) {
    if constexpr (N::lanes == 1)
        return a < b ? a : b;
    else
        return N::L::minimum(a, b);
}
template <class N> SPANGLE_INLINE typename N::T larger(const typename N::T& a, const typename N::T& b) {
    if constexpr (N::lanes == 1)
        return a < b ? b : a;
    else
        return N::L::maximum(a, b);
}
/// Selects lane by lane: x where a < b, and otherwise y.
template <class N>
SPANGLE_INLINE typename N::T where_less(const typename N::T& a, const typename N::T& b,
                                        const typename N::T& x, const typename N::T& y) {
    if constexpr (N::lanes == 1)
        return a < b ? x : y;
    else
        return N::L::select(N::L::less(a, b), x, y);
}

} // namespace component
} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
