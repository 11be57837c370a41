// How many triangles of a fan are walked along with its outline.
#pragma once

#include "raster/ops/lanes.hpp"

namespace spangle::raster {

/// The largest number of triangles of a fan whose columns a FanRow keeps. Vectors draw the rows of larger
/// fans fast enough to pay for more memory.
inline constexpr int kept_fan_triangles = host_lanes > 1 ? 6 : 2;

} // namespace spangle::raster
