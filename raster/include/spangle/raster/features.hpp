// The optional systems of the rasterizer (docs/architecture/boards-and-profiles.md). CMake defines them; a
// build by hand has everything.
#pragma once

#include <spangle/raster/limits.hpp>

#ifndef SPANGLE_FEATURE_FOG
#define SPANGLE_FEATURE_FOG 1
#endif
#ifndef SPANGLE_FEATURE_LIGHTING
#define SPANGLE_FEATURE_LIGHTING 1
#endif
#ifndef SPANGLE_FEATURE_SECONDARY_COLOR
#define SPANGLE_FEATURE_SECONDARY_COLOR 1
#endif
#ifndef SPANGLE_FEATURE_TEXTURE_COMBINE
#define SPANGLE_FEATURE_TEXTURE_COMBINE 1
#endif
#ifndef SPANGLE_FEATURE_TEXTURE_3D
#define SPANGLE_FEATURE_TEXTURE_3D 1
#endif
#ifndef SPANGLE_FEATURE_TEXTURE_CUBE_MAP
#define SPANGLE_FEATURE_TEXTURE_CUBE_MAP 1
#endif
#ifndef SPANGLE_FEATURE_COMPRESSED_TEXTURES
#define SPANGLE_FEATURE_COMPRESSED_TEXTURES 1
#endif
#ifndef SPANGLE_FEATURE_DEPTH_TEXTURES
#define SPANGLE_FEATURE_DEPTH_TEXTURES 1
#endif
#ifndef SPANGLE_FEATURE_STIPPLE
#define SPANGLE_FEATURE_STIPPLE 1
#endif
#ifndef SPANGLE_FEATURE_ANTIALIASING
#define SPANGLE_FEATURE_ANTIALIASING 1
#endif
#ifndef SPANGLE_FEATURE_POLYGON_OFFSET
#define SPANGLE_FEATURE_POLYGON_OFFSET 1
#endif
#ifndef SPANGLE_FEATURE_DRAW_PIXELS
#define SPANGLE_FEATURE_DRAW_PIXELS 1
#endif
#ifndef SPANGLE_FEATURE_MULTISAMPLE
#define SPANGLE_FEATURE_MULTISAMPLE 1
#endif
#ifndef SPANGLE_FEATURE_BANDS
#define SPANGLE_FEATURE_BANDS 1
#endif
#ifndef SPANGLE_FEATURE_BAND_RECORDS
#define SPANGLE_FEATURE_BAND_RECORDS 1
#endif
#define SPANGLE_HAS_RECORDS (SPANGLE_FEATURE_BANDS && SPANGLE_FEATURE_BAND_RECORDS)

namespace spangle::raster {

inline constexpr bool has_fog = SPANGLE_FEATURE_FOG != 0;
/// Secondary colours come from lights or from vertices. Only the chain adds them: without it such a state is
/// an error.
#define SPANGLE_SECONDARY_COLORS                                                                             \
    (SPANGLE_CHAIN && (SPANGLE_FEATURE_LIGHTING || SPANGLE_FEATURE_SECONDARY_COLOR))
inline constexpr bool has_color_sum = SPANGLE_SECONDARY_COLORS;
/// Fragments may bring colours of their own (Colors::of_pixels): those of images.
inline constexpr bool has_pixel_colors = SPANGLE_FEATURE_DRAW_PIXELS != 0;
inline constexpr bool has_combine = SPANGLE_FEATURE_TEXTURE_COMBINE != 0;
inline constexpr bool has_volumes = SPANGLE_FEATURE_TEXTURE_3D != 0;
inline constexpr bool has_cube_maps = SPANGLE_FEATURE_TEXTURE_CUBE_MAP != 0;
inline constexpr bool has_third_coordinates =
    SPANGLE_FEATURE_TEXTURE_3D || SPANGLE_FEATURE_TEXTURE_CUBE_MAP || SPANGLE_FEATURE_DEPTH_TEXTURES;
inline constexpr bool has_compressed_textures = SPANGLE_FEATURE_COMPRESSED_TEXTURES != 0;
inline constexpr bool has_depth_textures = SPANGLE_FEATURE_DEPTH_TEXTURES != 0;
inline constexpr bool has_samples = SPANGLE_FEATURE_MULTISAMPLE != 0;

} // namespace spangle::raster
