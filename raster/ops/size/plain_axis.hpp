// Axes of textures whose coordinates are read by shifts: none.
#pragma once

#include "raster/span/instructions.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// True for axes whose coordinates are read by shifts, which is only a matter of speed. Small builds read all
/// coordinates by products.
constexpr bool is_plain_axis(Wrap, std::int32_t) {
    return false;
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
