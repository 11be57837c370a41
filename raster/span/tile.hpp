// Tiles: what a small triangle hands to a loop of its own where there are eight lanes. Its rows are not found
// first: lanes are alive where three edges say so, and nothing is divided.
#pragma once

#include <cstdint>

namespace spangle::raster {

/// Eight columns of a few rows, all of them inside of the scissor rectangle: lanes that are dead keep what
/// they hold.
struct Tile {
    static constexpr std::int32_t columns = 8, most_rows = 12;

    /// Twice the signed area that the centre of a lane spans with an edge, in units of 2^-8 pixels, rounded
    /// down: negative outside. A pixel further it is `dx` more, a row further `dy`.
    struct Edge {
        std::int16_t value, dx, dy;
    };
    std::int32_t x, y; ///< window position of lane 0 of the first row
    std::int32_t rows;
    Edge edge[3];
};

} // namespace spangle::raster
