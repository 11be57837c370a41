// Trapezoids: what a triangle of moderate size hands to a loop of its own where there are eight lanes. The
// loop walks the sides itself: no row is written down, to be read back for a handful of fragments.
#pragma once

#include <cstdint>

namespace spangle::raster {

/// A triangle cut at its middle corner, upwards. Its columns, and seven more, lie inside of the scissor
/// rectangle, as do its rows: lanes that are dead keep what they hold.
struct Trapezoids {
    /// Columns with 32 fraction bits, mod 2^64: the first whose centre is on the side or right of it. `step`
    /// leads to the next row.
    struct Side {
        std::uint64_t at, step;
        std::int32_t column() const { return static_cast<std::int32_t>(at >> 32); }
        Side after(std::int32_t rows) const {
            return {at + static_cast<std::uint64_t>(std::int64_t{rows}) * step, step};
        }
    };
    struct Part {
        std::int32_t end; ///< the row behind its last
        Side left, right; ///< [left, right) are covered
    };
    std::int32_t y; ///< first row
    Part part[2];
};

} // namespace spangle::raster
