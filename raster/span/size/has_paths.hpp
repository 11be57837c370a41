// Whether lines are drawn as paths: never, because the chain draws the same bytes.
#pragma once

namespace spangle::raster {

/// True where a fused loop of this build draws paths.
inline constexpr bool has_paths = false;

} // namespace spangle::raster
