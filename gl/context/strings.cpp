// GetString: who draws, which GL this build is, which extensions (GL 1.3, 6.1.11).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/limits.hpp"
#include "gl/context/version.hpp"
#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

namespace {

/// All systems that GL 1.3 has.
constexpr bool every_system =
    SPANGLE_FEATURE_LISTS && SPANGLE_FEATURE_LIGHTING && SPANGLE_FEATURE_FOG &&
    SPANGLE_FEATURE_POLYGON_MODE && SPANGLE_FEATURE_STIPPLE && SPANGLE_FEATURE_ANTIALIASING &&
    SPANGLE_FEATURE_POLYGON_OFFSET && SPANGLE_FEATURE_CLIP_PLANES && SPANGLE_FEATURE_TEXGEN &&
    SPANGLE_FEATURE_TEXTURE_COMBINE && SPANGLE_FEATURE_TEXTURE_1D && SPANGLE_FEATURE_TEXTURE_3D &&
    SPANGLE_FEATURE_TEXTURE_CUBE_MAP && SPANGLE_FEATURE_COPY_TEXTURE && SPANGLE_FEATURE_COMPRESSED_TEXTURES &&
    SPANGLE_FEATURE_RASTER_POS && SPANGLE_FEATURE_PIXEL_TRANSFER && SPANGLE_FEATURE_DRAW_PIXELS &&
    SPANGLE_FEATURE_BITMAPS && SPANGLE_FEATURE_ACCUM && SPANGLE_FEATURE_COLOR_INDEX &&
    SPANGLE_FEATURE_ATTRIB_STACKS && SPANGLE_FEATURE_SELECTION && SPANGLE_FEATURE_FEEDBACK &&
    SPANGLE_FEATURE_EVALUATORS;

/// At least the minimum maxima of tables 6.26 to 6.28.
constexpr bool every_limit = max_lights >= 8 && max_clip_planes >= 6 && modelview_stack_entries >= 32 &&
                             projection_stack_entries >= 2 && texture_stack_entries >= 2 &&
                             attrib_stack_entries >= 16 && name_stack_entries >= 64 && has_full_lighting &&
                             max_list_nesting >= 64 && texture_units >= 2 && max_texture_size >= 64 &&
                             max_3d_texture_size >= 16;

/// Whatever textures are made of, and whatever state they are drawn with, is there; so is a stencil.
constexpr unsigned all_textures = (2u << static_cast<unsigned>(raster::TexelFormat::z24)) - 1,
                   all_depths = (2u << static_cast<unsigned>(DepthFormat::z24s8)) - 1;
constexpr bool every_format = (raster::texture_formats & all_textures) == all_textures &&
                              (raster::depth_formats & all_depths) == all_depths && raster::has_chain;

constexpr bool whole = every_system && every_limit && every_format;
constexpr const char* version =
    whole ? "1.3 Spangle " SPANGLE_VERSION : "1.0 Spangle " SPANGLE_VERSION " (a subset of 1.3)";

/// Those that are nothing but tokens, with all that they say: this library has no commands with suffixes.
constexpr const char* extensions =
    "GL_ARB_texture_border_clamp GL_ARB_texture_env_add GL_ARB_texture_mirrored_repeat "
    "GL_ARB_texture_non_power_of_two GL_EXT_stencil_wrap GL_EXT_texture_lod_bias "
#if SPANGLE_FEATURE_TEXTURE_CUBE_MAP
    "GL_ARB_texture_cube_map "
#endif
#if SPANGLE_FEATURE_TEXTURE_COMBINE
    "GL_ARB_texture_env_combine GL_ARB_texture_env_crossbar GL_ARB_texture_env_dot3 "
#endif
#if SPANGLE_FEATURE_DEPTH_TEXTURES
    "GL_ARB_depth_texture GL_ARB_shadow "
#endif
#if SPANGLE_FEATURE_MIPMAP_GENERATION
    "GL_SGIS_generate_mipmap "
#endif
#if SPANGLE_FEATURE_COMPRESSED_TEXTURES
    "GL_OES_compressed_paletted_texture GL_OES_compressed_ETC1_RGB8_texture "
#endif
    "GL_SGIS_texture_edge_clamp";

} // namespace

namespace cmd {

const GLubyte* GetString(Context& context, GLenum name) {
    const char* text = nullptr;
    switch (name) {
    case GL_VENDOR:
        text = "Spangle";
        break;
    case GL_RENDERER:
        text = "Spangle fixed point";
        break;
    case GL_VERSION:
        text = version;
        break;
    case GL_EXTENSIONS:
        text = extensions;
        break;
    default:
        error(context, GL_INVALID_ENUM);
    }
    return reinterpret_cast<const GLubyte*>(text);
}

} // namespace cmd

} // namespace spangle::gl
