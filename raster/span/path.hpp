// Paths: what lines of width 1 hand to a loop of their own, one fragment per step along the major axis.
// Several at a time, so that what finds them and what draws them each run without waiting for the other.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

/// Each fragment is `along` from the one before it, and `aside` further whenever `rest`, grown by `rise`, is
/// no longer negative; then `denominator` is taken off. Pixels, in planes whose rows have the same stride.
/// Element by element, for vectors.
struct Paths {
    static constexpr int size = numeric::cheap_branches ? 8 : 16;
    struct alignas(16) Word {
        std::int32_t at[size];
    };
    /// An attribute: at the first fragment, and from one to the next.
    struct Ramp {
        Fixed::Affine value[size], step[size];
    };
    Word count; ///< of fragments; none if not positive
    Word first; ///< from the pixel of window (0, 0)
    Word along, aside;
    Word rest, rise, denominator; ///< -denominator <= rest < 0 <= rise <= denominator
    Ramp z, color[3];
    std::uint32_t word[size]; ///< Kind::flat
};

/// Draws the first `count` paths.
using PathFunction = void (*)(const DrawState&, const Surface&, const Paths&, int count);

} // namespace spangle::raster
