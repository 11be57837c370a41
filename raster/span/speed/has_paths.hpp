// Whether lines are drawn as paths: where there are fused loops.
#pragma once

#include <spangle/raster/limits.hpp>

namespace spangle::raster {

/// True where a fused loop of this build draws paths.
inline constexpr bool has_paths = has_fused_spans;

} // namespace spangle::raster
