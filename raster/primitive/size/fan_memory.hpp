// How many triangles of a fan are walked along with its outline.
#pragma once

namespace spangle::raster {

/// The largest number of triangles of a fan whose columns a FanRow keeps. Small builds compute columns again
/// wherever they are asked for.
inline constexpr int kept_fan_triangles = 0;

} // namespace spangle::raster
