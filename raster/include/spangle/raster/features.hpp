// The optional systems of the rasterizer (design 5). CMake defines them; a build by hand has everything.
#pragma once

#ifndef SPANGLE_FEATURE_TEXTURE_COMBINE
#define SPANGLE_FEATURE_TEXTURE_COMBINE 1
#endif

namespace spangle::raster {

inline constexpr bool has_combine = SPANGLE_FEATURE_TEXTURE_COMBINE != 0;

} // namespace spangle::raster
