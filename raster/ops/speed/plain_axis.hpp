// Axes of textures whose coordinates are read by shifts.
#pragma once

#include "raster/ops/power_of_two.hpp"
#include "raster/span/instructions.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// True for axes whose coordinates are read by shifts, which is only a matter of speed.
constexpr bool is_plain_axis(Wrap wrap, std::int32_t size) {
    return wrap != Wrap::mirrored_repeat && is_power_of_two(size);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
