// Trapezoids are what a triangle of moderate size hands to a loop of its own where there are eight lanes. The
// loop walks the sides itself: no row is written down, to be read back for a handful of fragments.
#pragma once

#include <cstdint>

namespace spangle::raster {

/// A triangle that is cut at its middle vertex, from the lowest row upwards. Its columns, and seven columns
/// more, lie inside of the scissor rectangle, as do its rows: pixels under dead lanes keep what they hold.
struct Trapezoids {
    /// A side of a part: in columns with 32 fraction bits, mod 2^64. The whole part of `at` is the first
    /// column whose centre is on the side or right of it. `step` leads to the next row.
    struct Side {
        std::uint64_t at, step;
        std::int32_t column() const { return static_cast<std::int32_t>(at >> 32); }
        Side after(std::int32_t rows) const {
            return {at + static_cast<std::uint64_t>(std::int64_t{rows}) * step, step};
        }
    };
    struct Part {
        std::int32_t end; ///< the row behind the last row of the part
        Side left, right; ///< columns [left, right) are covered
    };
    std::int32_t y; ///< first row, window coordinate
    Part part[2];
};

} // namespace spangle::raster
