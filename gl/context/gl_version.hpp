// The version of GL that this build implements completely (GL 1.3, 6.1.11).
#pragma once

#include "gl/context/context.hpp"
#include "gl/context/limits.hpp"
#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

/// True if the build has all optional systems that GL 1.3 requires.
inline constexpr bool has_systems_of_1_3 =
    SPANGLE_FEATURE_LISTS && SPANGLE_FEATURE_LIGHTING && SPANGLE_FEATURE_FOG &&
    SPANGLE_FEATURE_POLYGON_MODE && SPANGLE_FEATURE_STIPPLE && SPANGLE_FEATURE_ANTIALIASING &&
    SPANGLE_FEATURE_POLYGON_OFFSET && SPANGLE_FEATURE_CLIP_PLANES && SPANGLE_FEATURE_TEXGEN &&
    SPANGLE_FEATURE_TEXTURE_COMBINE && SPANGLE_FEATURE_TEXTURE_1D && SPANGLE_FEATURE_TEXTURE_3D &&
    SPANGLE_FEATURE_TEXTURE_CUBE_MAP && SPANGLE_FEATURE_COPY_TEXTURE && SPANGLE_FEATURE_COMPRESSED_TEXTURES &&
    SPANGLE_FEATURE_RASTER_POS && SPANGLE_FEATURE_PIXEL_TRANSFER && SPANGLE_FEATURE_DRAW_PIXELS &&
    SPANGLE_FEATURE_BITMAPS && SPANGLE_FEATURE_ACCUM && SPANGLE_FEATURE_COLOR_INDEX &&
    SPANGLE_FEATURE_ATTRIB_STACKS && SPANGLE_FEATURE_SELECTION && SPANGLE_FEATURE_FEEDBACK &&
    SPANGLE_FEATURE_EVALUATORS;

/// True if the build has the optional systems that GL 1.4 adds. Separate blend functions, wrapping stencil
/// operations, the crossbar, LOD biases, mirrored repeat, draws of several arrays and window positions have
/// no switch of their own.
inline constexpr bool has_systems_of_1_4 =
    SPANGLE_FEATURE_DEPTH_TEXTURES && SPANGLE_FEATURE_MIPMAP_GENERATION && SPANGLE_FEATURE_SECONDARY_COLOR &&
    SPANGLE_FEATURE_POINT_PARAMETERS;

/// True if the build has the optional systems that GL 1.5 adds. The eight comparisons of depth textures have
/// no switch of their own.
inline constexpr bool has_systems_of_1_5 = SPANGLE_FEATURE_BUFFERS && SPANGLE_FEATURE_QUERIES;

/// True if all limits reach the minimum values of GL 1.3, tables 6.26 to 6.28.
inline constexpr bool has_limits_of_gl =
    max_lights >= 8 && max_clip_planes >= 6 && modelview_stack_entries >= 32 &&
    projection_stack_entries >= 2 && texture_stack_entries >= 2 && attrib_stack_entries >= 16 &&
    name_stack_entries >= 64 && has_full_lighting && max_list_nesting >= 64 && texture_units >= 2 &&
    max_texture_size >= 64 && max_3d_texture_size >= 16;

/// True if the build has every texture, depth and stencil format and can draw with every state.
inline constexpr bool has_formats_of_gl = [] {
    constexpr unsigned textures = (2u << static_cast<unsigned>(raster::TexelFormat::z24)) - 1,
                       depths = (2u << static_cast<unsigned>(DepthFormat::z24s8)) - 1;
    return (raster::texture_formats & textures) == textures && (raster::depth_formats & depths) == depths &&
           raster::has_chain;
}();

/// Minor version of GL 1.x. 0: the build does not have all of GL 1.3.
inline constexpr int gl_minor = !has_systems_of_1_3 || !has_limits_of_gl || !has_formats_of_gl ? 0
                                : !has_systems_of_1_4                                          ? 3
                                : !has_systems_of_1_5                                          ? 4
                                                                                               : 5;

} // namespace spangle::gl
