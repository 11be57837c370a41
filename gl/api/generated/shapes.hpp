// How many values a pname takes, and of what kind.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#pragma once

#include "gl/api/family.hpp"

namespace spangle::gl::shape {

inline constexpr ShapeRow TexGen[] = {
    {GL_TEXTURE_GEN_MODE, Kind::integer, 1},
    {GL_OBJECT_PLANE, Kind::real, 4},
    {GL_EYE_PLANE, Kind::real, 4},
    {},
};

inline constexpr const auto& GetTexGen = TexGen;

inline constexpr ShapeRow Light[] = {
    {GL_AMBIENT, Kind::color, 4},
    {GL_DIFFUSE, Kind::color, 4},
    {GL_SPECULAR, Kind::color, 4},
    {GL_POSITION, Kind::real, 4},
    {GL_SPOT_DIRECTION, Kind::real, 3},
    {GL_SPOT_EXPONENT, Kind::real, 1},
    {GL_SPOT_CUTOFF, Kind::real, 1},
    {GL_CONSTANT_ATTENUATION, Kind::real, 1},
    {GL_LINEAR_ATTENUATION, Kind::real, 1},
    {GL_QUADRATIC_ATTENUATION, Kind::real, 1},
    {},
};

inline constexpr const auto& GetLight = Light;

inline constexpr ShapeRow LightModel[] = {
    {GL_LIGHT_MODEL_AMBIENT, Kind::color, 4},
    {GL_LIGHT_MODEL_LOCAL_VIEWER, Kind::integer, 1},
    {GL_LIGHT_MODEL_TWO_SIDE, Kind::integer, 1},
    {GL_LIGHT_MODEL_COLOR_CONTROL, Kind::integer, 1},
    {},
};

inline constexpr ShapeRow Material[] = {
    {GL_AMBIENT, Kind::color, 4},
    {GL_DIFFUSE, Kind::color, 4},
    {GL_SPECULAR, Kind::color, 4},
    {GL_EMISSION, Kind::color, 4},
    {GL_SHININESS, Kind::real, 1},
    {GL_AMBIENT_AND_DIFFUSE, Kind::color, 4},
    {GL_COLOR_INDEXES, Kind::real, 3},
    {},
};

inline constexpr ShapeRow GetMaterial[] = {
    {GL_AMBIENT, Kind::color, 4},
    {GL_DIFFUSE, Kind::color, 4},
    {GL_SPECULAR, Kind::color, 4},
    {GL_EMISSION, Kind::color, 4},
    {GL_SHININESS, Kind::real, 1},
    {GL_COLOR_INDEXES, Kind::real, 3},
    {},
};

inline constexpr ShapeRow PointParameter[] = {
    {GL_POINT_SIZE_MIN, Kind::real, 1},
    {GL_POINT_SIZE_MAX, Kind::real, 1},
    {GL_POINT_FADE_THRESHOLD_SIZE, Kind::real, 1},
    {GL_POINT_DISTANCE_ATTENUATION, Kind::real, 3},
    {GL_POINT_SPRITE_COORD_ORIGIN, Kind::integer, 1},
    {},
};

inline constexpr ShapeRow PixelStore[] = {
    {GL_UNPACK_SWAP_BYTES, Kind::real, 1},
    {GL_UNPACK_LSB_FIRST, Kind::real, 1},
    {GL_UNPACK_ROW_LENGTH, Kind::integer, 1},
    {GL_UNPACK_SKIP_ROWS, Kind::integer, 1},
    {GL_UNPACK_SKIP_PIXELS, Kind::integer, 1},
    {GL_UNPACK_ALIGNMENT, Kind::integer, 1},
    {GL_UNPACK_IMAGE_HEIGHT, Kind::integer, 1},
    {GL_UNPACK_SKIP_IMAGES, Kind::integer, 1},
    {GL_PACK_SWAP_BYTES, Kind::real, 1},
    {GL_PACK_LSB_FIRST, Kind::real, 1},
    {GL_PACK_ROW_LENGTH, Kind::integer, 1},
    {GL_PACK_SKIP_ROWS, Kind::integer, 1},
    {GL_PACK_SKIP_PIXELS, Kind::integer, 1},
    {GL_PACK_ALIGNMENT, Kind::integer, 1},
    {GL_PACK_IMAGE_HEIGHT, Kind::integer, 1},
    {GL_PACK_SKIP_IMAGES, Kind::integer, 1},
    {},
};

inline constexpr ShapeRow PixelTransfer[] = {
    {GL_MAP_COLOR, Kind::real, 1},
    {GL_MAP_STENCIL, Kind::real, 1},
    {GL_INDEX_SHIFT, Kind::integer, 1},
    {GL_INDEX_OFFSET, Kind::integer, 1},
    {GL_RED_SCALE, Kind::real, 1},
    {GL_RED_BIAS, Kind::real, 1},
    {GL_GREEN_SCALE, Kind::real, 1},
    {GL_GREEN_BIAS, Kind::real, 1},
    {GL_BLUE_SCALE, Kind::real, 1},
    {GL_BLUE_BIAS, Kind::real, 1},
    {GL_ALPHA_SCALE, Kind::real, 1},
    {GL_ALPHA_BIAS, Kind::real, 1},
    {GL_DEPTH_SCALE, Kind::real, 1},
    {GL_DEPTH_BIAS, Kind::real, 1},
    {},
};

inline constexpr ShapeRow Fog[] = {
    {GL_FOG_MODE, Kind::integer, 1},
    {GL_FOG_DENSITY, Kind::real, 1},
    {GL_FOG_START, Kind::real, 1},
    {GL_FOG_END, Kind::real, 1},
    {GL_FOG_COLOR, Kind::color, 4},
    {GL_FOG_INDEX, Kind::real, 1},
    {GL_FOG_COORDINATE_SOURCE, Kind::integer, 1},
    {},
};

inline constexpr ShapeRow TexParameter[] = {
    {GL_TEXTURE_MIN_FILTER, Kind::integer, 1},
    {GL_TEXTURE_MAG_FILTER, Kind::integer, 1},
    {GL_TEXTURE_WRAP_S, Kind::integer, 1},
    {GL_TEXTURE_WRAP_T, Kind::integer, 1},
    {GL_TEXTURE_BORDER_COLOR, Kind::color, 4},
    {GL_TEXTURE_PRIORITY, Kind::real, 1},
    {GL_TEXTURE_MIN_LOD, Kind::real, 1},
    {GL_TEXTURE_MAX_LOD, Kind::real, 1},
    {GL_TEXTURE_BASE_LEVEL, Kind::integer, 1},
    {GL_TEXTURE_MAX_LEVEL, Kind::integer, 1},
    {GL_TEXTURE_LOD_BIAS, Kind::real, 1},
    {GL_TEXTURE_WRAP_R, Kind::integer, 1},
    {GL_GENERATE_MIPMAP, Kind::integer, 1},
    {GL_DEPTH_TEXTURE_MODE, Kind::integer, 1},
    {GL_TEXTURE_COMPARE_MODE, Kind::integer, 1},
    {GL_TEXTURE_COMPARE_FUNC, Kind::integer, 1},
    {},
};

inline constexpr ShapeRow GetTexParameter[] = {
    {GL_TEXTURE_MIN_FILTER, Kind::integer, 1},
    {GL_TEXTURE_MAG_FILTER, Kind::integer, 1},
    {GL_TEXTURE_WRAP_S, Kind::integer, 1},
    {GL_TEXTURE_WRAP_T, Kind::integer, 1},
    {GL_TEXTURE_BORDER_COLOR, Kind::color, 4},
    {GL_TEXTURE_PRIORITY, Kind::real, 1},
    {GL_TEXTURE_MIN_LOD, Kind::real, 1},
    {GL_TEXTURE_MAX_LOD, Kind::real, 1},
    {GL_TEXTURE_BASE_LEVEL, Kind::integer, 1},
    {GL_TEXTURE_MAX_LEVEL, Kind::integer, 1},
    {GL_TEXTURE_LOD_BIAS, Kind::real, 1},
    {GL_TEXTURE_WRAP_R, Kind::integer, 1},
    {GL_GENERATE_MIPMAP, Kind::integer, 1},
    {GL_DEPTH_TEXTURE_MODE, Kind::integer, 1},
    {GL_TEXTURE_COMPARE_MODE, Kind::integer, 1},
    {GL_TEXTURE_COMPARE_FUNC, Kind::integer, 1},
    {GL_TEXTURE_RESIDENT, Kind::integer, 1},
    {},
};

inline constexpr ShapeRow TexEnv[] = {
    {GL_TEXTURE_ENV_MODE, Kind::integer, 1},
    {GL_TEXTURE_ENV_COLOR, Kind::color, 4},
    {GL_COMBINE_RGB, Kind::integer, 1},
    {GL_COMBINE_ALPHA, Kind::integer, 1},
    {GL_SOURCE0_RGB, Kind::integer, 1},
    {GL_SOURCE1_RGB, Kind::integer, 1},
    {GL_SOURCE2_RGB, Kind::integer, 1},
    {GL_SOURCE0_ALPHA, Kind::integer, 1},
    {GL_SOURCE1_ALPHA, Kind::integer, 1},
    {GL_SOURCE2_ALPHA, Kind::integer, 1},
    {GL_OPERAND0_RGB, Kind::integer, 1},
    {GL_OPERAND1_RGB, Kind::integer, 1},
    {GL_OPERAND2_RGB, Kind::integer, 1},
    {GL_OPERAND0_ALPHA, Kind::integer, 1},
    {GL_OPERAND1_ALPHA, Kind::integer, 1},
    {GL_OPERAND2_ALPHA, Kind::integer, 1},
    {GL_RGB_SCALE, Kind::real, 1},
    {GL_ALPHA_SCALE, Kind::real, 1},
    {GL_TEXTURE_LOD_BIAS, Kind::real, 1},
    {GL_COORD_REPLACE, Kind::integer, 1},
    {},
};

inline constexpr const auto& GetTexEnv = TexEnv;

inline constexpr ShapeRow GetTexLevelParameter[] = {
    {GL_TEXTURE_WIDTH, Kind::integer, 1},
    {GL_TEXTURE_HEIGHT, Kind::integer, 1},
    {GL_TEXTURE_BORDER, Kind::integer, 1},
    {GL_TEXTURE_INTERNAL_FORMAT, Kind::integer, 1},
    {GL_TEXTURE_RED_SIZE, Kind::integer, 1},
    {GL_TEXTURE_GREEN_SIZE, Kind::integer, 1},
    {GL_TEXTURE_BLUE_SIZE, Kind::integer, 1},
    {GL_TEXTURE_ALPHA_SIZE, Kind::integer, 1},
    {GL_TEXTURE_LUMINANCE_SIZE, Kind::integer, 1},
    {GL_TEXTURE_INTENSITY_SIZE, Kind::integer, 1},
    {GL_TEXTURE_DEPTH, Kind::integer, 1},
    {GL_TEXTURE_DEPTH_SIZE, Kind::integer, 1},
    {GL_TEXTURE_COMPRESSED, Kind::integer, 1},
    {GL_TEXTURE_COMPRESSED_IMAGE_SIZE, Kind::integer, 1},
    {},
};

} // namespace spangle::gl::shape
