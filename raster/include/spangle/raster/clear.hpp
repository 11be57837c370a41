// Clears: rectangles of colour, depth and stencil under write masks (GL 1.3, 4.2.3). Ownership, scissor,
// dithering and masks apply, nothing else does.
#pragma once

#include <cstdint>

#include <spangle/raster/surface.hpp>
#include <spangle/raster/units.hpp>

namespace spangle::raster {

/// What a clear writes, and where.
struct ClearRequest {
    Rect area; ///< inside the surface; may be empty
    /// Colour channels to write: bit 0 red, 1 green, 2 blue, 3 alpha, or bits of an index; 0: none.
    std::uint8_t channels = 0;
    /// Dithers the colour (GL 1.3, 4.1.8).
    bool dither = false;
    /// Writes `z` to the depth buffer.
    bool depth = false;
    std::uint8_t stencil_mask = 0; ///< bits to write; 0 = no stencil clear
    std::uint32_t color[4] = {};   ///< RGBA, colour units; on an index surface [0] is the index, in 2^-20
    std::uint32_t z = depth_one;   ///< the depth, in Q0.30
    /// The value for the stencil buffer.
    std::uint8_t stencil = 0;
};

/// Clears the planes that the request names; those that the surface does not have are ignored. A clear of the
/// whole surface with all its channels resets the record of [touched rows](docs/glossary.md#touched-rows);
/// any other colour clear widens it.
void clear(const Surface& surface, const ClearRequest& request);

/// Whether the request clears the whole surface with all its channels.
bool clears_all(const Surface& surface, const ClearRequest& request);

} // namespace spangle::raster
