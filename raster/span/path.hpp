// Paths: what a line of width 1 hands to a loop of its own, one fragment per step along its major axis.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

/// Fragments from (x, y) on: each next one is a pixel further along x (or y), and a pixel further along the
/// other axis (back, when `falls`) whenever `remainder`, grown by `rise`, reaches `denominator`.
struct Path {
    std::int32_t x, y; ///< window
    std::int32_t count;
    std::int32_t remainder, rise,
        denominator; ///< 0 <= remainder, rise < denominator (rise = it at 45 degrees)
    bool along_x, falls;

    /// f(x, y) of every fragment.
    template <class F> SPANGLE_INLINE void each(F f) const {
        std::int32_t at_x = x, at_y = y, rest = remainder;
        const std::int32_t aside = falls ? -1 : 1;
        for (std::int32_t i = 0; i < count; ++i) {
            f(at_x, at_y);
            (along_x ? at_x : at_y) += 1;
            rest += rise;
            if (rest >= denominator) {
                rest -= denominator;
                (along_x ? at_y : at_x) += aside;
            }
        }
    }
};

/// Draws a path. The planes of the span have the major axis in place of x and start at its row.
template <class P> using PathFunction = void (*)(Span<P>&, const Path&);

} // namespace spangle::raster
