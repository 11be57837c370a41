// The optional systems of the rasterizer (docs/architecture/boards-and-profiles.md). CMake defines them; a
// build by hand has everything.
#pragma once

#include <spangle/raster/limits.hpp>

#ifndef SPANGLE_FEATURE_FOG
/// Fog (GL 1.3, 3.10).
#define SPANGLE_FEATURE_FOG 1
#endif
#ifndef SPANGLE_FEATURE_LIGHTING
/// Lighting (GL 1.3, 2.13.1).
#define SPANGLE_FEATURE_LIGHTING 1
#endif
#ifndef SPANGLE_FEATURE_SECONDARY_COLOR
/// Secondary colours of vertices (GL 1.4, 2.7).
#define SPANGLE_FEATURE_SECONDARY_COLOR 1
#endif
#ifndef SPANGLE_FEATURE_TEXTURE_COMBINE
/// Texture environments of COMBINE (GL 1.3, 3.8.12).
#define SPANGLE_FEATURE_TEXTURE_COMBINE 1
#endif
#ifndef SPANGLE_FEATURE_TEXTURE_3D
/// Textures of three dimensions (GL 1.3, 3.8.1).
#define SPANGLE_FEATURE_TEXTURE_3D 1
#endif
#ifndef SPANGLE_FEATURE_TEXTURE_CUBE_MAP
/// Cube maps (GL 1.3, 3.8.6).
#define SPANGLE_FEATURE_TEXTURE_CUBE_MAP 1
#endif
#ifndef SPANGLE_FEATURE_COMPRESSED_TEXTURES
/// Textures with a palette or of ETC1.
#define SPANGLE_FEATURE_COMPRESSED_TEXTURES 1
#endif
#ifndef SPANGLE_FEATURE_DEPTH_TEXTURES
/// Depth textures and their comparison (GL 1.4, 3.8.14).
#define SPANGLE_FEATURE_DEPTH_TEXTURES 1
#endif
#ifndef SPANGLE_FEATURE_STIPPLE
/// Stipples of lines and polygons (GL 1.3, 3.4.2 and 3.5.2).
#define SPANGLE_FEATURE_STIPPLE 1
#endif
#ifndef SPANGLE_FEATURE_ANTIALIASING
/// Antialiased points, lines and polygons (GL 1.3, 3.3 to 3.5).
#define SPANGLE_FEATURE_ANTIALIASING 1
#endif
#ifndef SPANGLE_FEATURE_POLYGON_OFFSET
/// Depth offsets of polygons (GL 1.3, 3.5.5).
#define SPANGLE_FEATURE_POLYGON_OFFSET 1
#endif
#ifndef SPANGLE_FEATURE_DRAW_PIXELS
/// Images that become fragments: DrawPixels, CopyPixels, Bitmap (GL 1.3, 3.6 and 3.7).
#define SPANGLE_FEATURE_DRAW_PIXELS 1
#endif
#ifndef SPANGLE_FEATURE_MULTISAMPLE
/// Multisampling (GL 1.3, 3.2.1).
#define SPANGLE_FEATURE_MULTISAMPLE 1
#endif
#ifndef SPANGLE_FEATURE_BANDS
/// Surfaces that hold some rows of a picture only (docs/bands.md).
#define SPANGLE_FEATURE_BANDS 1
#endif
#ifndef SPANGLE_FEATURE_BAND_RECORDS
/// Records of frames, from which [bands](docs/glossary.md#band) are drawn (docs/bands.md).
#define SPANGLE_FEATURE_BAND_RECORDS 1
#endif
/// Whether bands and their records are built in.
#define SPANGLE_HAS_RECORDS (SPANGLE_FEATURE_BANDS && SPANGLE_FEATURE_BAND_RECORDS)

namespace spangle::raster {

/// Whether fog is built in.
inline constexpr bool has_fog = SPANGLE_FEATURE_FOG != 0;
/// Secondary colours come from lights or from vertices. Only the chain adds them, so in builds without a
/// chain a state with a colour sum is an error.
#define SPANGLE_SECONDARY_COLORS                                                                             \
    (SPANGLE_CHAIN && (SPANGLE_FEATURE_LIGHTING || SPANGLE_FEATURE_SECONDARY_COLOR))
/// Whether secondary colours are built in.
inline constexpr bool has_color_sum = SPANGLE_SECONDARY_COLORS;
/// Fragments may bring colours of their own (Colors::of_pixels): those of images.
inline constexpr bool has_pixel_colors = SPANGLE_FEATURE_DRAW_PIXELS != 0;
/// Whether TexEnv::combine is built in.
inline constexpr bool has_combine = SPANGLE_FEATURE_TEXTURE_COMBINE != 0;
/// Whether textures of three dimensions are built in.
inline constexpr bool has_volumes = SPANGLE_FEATURE_TEXTURE_3D != 0;
/// Whether cube maps are built in.
inline constexpr bool has_cube_maps = SPANGLE_FEATURE_TEXTURE_CUBE_MAP != 0;
/// Whether some texture may read a third coordinate.
inline constexpr bool has_third_coordinates =
    SPANGLE_FEATURE_TEXTURE_3D || SPANGLE_FEATURE_TEXTURE_CUBE_MAP || SPANGLE_FEATURE_DEPTH_TEXTURES;
/// Whether textures with a palette or of ETC1 are built in.
inline constexpr bool has_compressed_textures = SPANGLE_FEATURE_COMPRESSED_TEXTURES != 0;
/// Whether depth textures are built in.
inline constexpr bool has_depth_textures = SPANGLE_FEATURE_DEPTH_TEXTURES != 0;
/// Whether multisampling is built in.
inline constexpr bool has_samples = SPANGLE_FEATURE_MULTISAMPLE != 0;

} // namespace spangle::raster
