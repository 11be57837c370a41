// The extensions that GL_EXTENSIONS names: each that this build has the whole of.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#pragma once

#include "gl/context/features.hpp"

namespace spangle::gl {

inline constexpr const char* extensions = ""
    "GL_APPLE_packed_pixels "
#if SPANGLE_FEATURE_DEPTH_TEXTURES
    "GL_ARB_depth_texture "
#endif
#if SPANGLE_FEATURE_BUFFERS
    "GL_ARB_map_buffer_range "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS && SPANGLE_FEATURE_MULTISAMPLE
    "GL_ARB_multisample "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_ARB_multitexture "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS && SPANGLE_FEATURE_QUERIES
    "GL_ARB_occlusion_query "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS && SPANGLE_FEATURE_POINT_PARAMETERS
    "GL_ARB_point_parameters "
#endif
#if SPANGLE_FEATURE_POINT_PARAMETERS
    "GL_ARB_point_sprite "
#endif
#if SPANGLE_FEATURE_DEPTH_TEXTURES
    "GL_ARB_shadow "
#endif
    "GL_ARB_texture_border_clamp "
#if SPANGLE_FEATURE_COMPRESSED_TEXTURES && SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_ARB_texture_compression "
#endif
#if SPANGLE_FEATURE_TEXTURE_CUBE_MAP
    "GL_ARB_texture_cube_map "
#endif
    "GL_ARB_texture_env_add "
#if SPANGLE_FEATURE_TEXTURE_COMBINE
    "GL_ARB_texture_env_combine "
#endif
#if SPANGLE_FEATURE_TEXTURE_COMBINE
    "GL_ARB_texture_env_crossbar "
#endif
#if SPANGLE_FEATURE_TEXTURE_COMBINE
    "GL_ARB_texture_env_dot3 "
#endif
    "GL_ARB_texture_mirrored_repeat "
    "GL_ARB_texture_non_power_of_two "
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_ARB_transpose_matrix "
#endif
#if SPANGLE_FEATURE_BUFFERS && SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS
    "GL_ARB_vertex_array_object "
#endif
#if SPANGLE_FEATURE_BUFFERS && SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_ARB_vertex_buffer_object "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS && SPANGLE_FEATURE_RASTER_POS
    "GL_ARB_window_pos "
#endif
    "GL_EXT_bgra "
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_EXT_blend_color "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_EXT_blend_equation_separate "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_EXT_blend_func_separate "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_EXT_blend_minmax "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_EXT_blend_subtract "
#endif
#if SPANGLE_FEATURE_COPY_TEXTURE && SPANGLE_FEATURE_GET_PROC_ADDRESS && SPANGLE_FEATURE_TEXTURE_1D && SPANGLE_FEATURE_TEXTURE_3D
    "GL_EXT_copy_texture "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_EXT_draw_range_elements "
#endif
#if SPANGLE_FEATURE_FOG && SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_EXT_fog_coord "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_EXT_multi_draw_arrays "
#endif
    "GL_EXT_packed_pixels "
#if SPANGLE_FEATURE_GET_PROC_ADDRESS && SPANGLE_FEATURE_POINT_PARAMETERS
    "GL_EXT_point_parameters "
#endif
    "GL_EXT_rescale_normal "
#if SPANGLE_FEATURE_GET_PROC_ADDRESS && SPANGLE_FEATURE_SECONDARY_COLOR
    "GL_EXT_secondary_color "
#endif
#if SPANGLE_FEATURE_LIGHTING
    "GL_EXT_separate_specular_color "
#endif
#if SPANGLE_FEATURE_DEPTH_TEXTURES
    "GL_EXT_shadow_funcs "
#endif
    "GL_EXT_stencil_wrap "
#if SPANGLE_FEATURE_GET_PROC_ADDRESS && SPANGLE_FEATURE_TEXTURE_1D
    "GL_EXT_subtexture "
#endif
#if SPANGLE_FEATURE_GET_PROC_ADDRESS && SPANGLE_FEATURE_TEXTURE_3D
    "GL_EXT_texture3D "
#endif
#if SPANGLE_FEATURE_TEXTURE_CUBE_MAP
    "GL_EXT_texture_cube_map "
#endif
    "GL_EXT_texture_edge_clamp "
    "GL_EXT_texture_env_add "
#if SPANGLE_FEATURE_TEXTURE_COMBINE
    "GL_EXT_texture_env_combine "
#endif
    "GL_EXT_texture_lod_bias "
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_EXT_texture_object "
#endif
    "GL_IBM_texture_mirrored_repeat "
    "GL_NV_blend_square "
#if SPANGLE_FEATURE_TEXGEN
    "GL_NV_texgen_reflection "
#endif
#if SPANGLE_FEATURE_COMPRESSED_TEXTURES
    "GL_OES_compressed_ETC1_RGB8_texture "
#endif
#if SPANGLE_FEATURE_COMPRESSED_TEXTURES
    "GL_OES_compressed_paletted_texture "
#endif
#if SPANGLE_FEATURE_MIPMAP_GENERATION
    "GL_SGIS_generate_mipmap "
#endif
    "GL_SGIS_texture_border_clamp "
    "GL_SGIS_texture_edge_clamp "
    "GL_SGIS_texture_lod "
#if SPANGLE_FEATURE_GET_PROC_ADDRESS
    "GL_SUN_multi_draw_arrays "
#endif
    ;

} // namespace spangle::gl
