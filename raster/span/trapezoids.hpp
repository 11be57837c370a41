// On hosts with eight lanes, triangles of moderate size are drawn as trapezoids, by a loop of their own. The
// loop walks along the sides itself. Rows of a handful of fragments would cost more to store and to read
// back.
#pragma once

#include <cstdint>

namespace spangle::raster {

/// A triangle that is cut at its middle vertex, from the lowest row upwards. Its rows, its columns and seven
/// more columns lie inside of the scissor rectangle. Pixels under dead lanes keep their bits.
struct Trapezoids {
    /// A side of a part, in columns with 32 fraction bits, modulo 2^64. The whole part of `at` is the first
    /// column whose centre is on the side or to the right of it. `step` leads to the next row.
    struct Side {
        std::uint64_t at, step;
        std::int32_t column() const { return static_cast<std::int32_t>(at >> 32); }
        Side after(std::int32_t rows) const {
            return {at + static_cast<std::uint64_t>(std::int64_t{rows}) * step, step};
        }
    };
    struct Part {
        std::int32_t end; ///< the row after the last row of the part
        Side left, right; ///< columns [left, right) are covered
    };
    std::int32_t y; ///< window coordinate of the first row
    Part part[2];
};

} // namespace spangle::raster
