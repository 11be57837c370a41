// How many values a pname takes, and of what kind.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#pragma once

#include "gl/api/family.hpp"

namespace spangle::gl::shape {

inline constexpr ShapeRow TexGen[] = {
    {GL_TEXTURE_GEN_MODE, 1, Kind::integer, 1},
    {GL_OBJECT_PLANE, 2, Kind::real, 4},
    {},
};

inline constexpr const auto& GetTexGen = TexGen;

inline constexpr ShapeRow Light[] = {
    {GL_AMBIENT, 3, Kind::color, 4},
    {GL_POSITION, 1, Kind::real, 4},
    {GL_SPOT_DIRECTION, 1, Kind::real, 3},
    {GL_SPOT_EXPONENT, 5, Kind::real, 1},
    {},
};

inline constexpr const auto& GetLight = Light;

inline constexpr ShapeRow LightModel[] = {
    {GL_LIGHT_MODEL_LOCAL_VIEWER, 2, Kind::integer, 1},
    {GL_LIGHT_MODEL_AMBIENT, 1, Kind::color, 4},
    {GL_LIGHT_MODEL_COLOR_CONTROL, 1, Kind::integer, 1},
    {},
};

inline constexpr ShapeRow Material[] = {
    {GL_AMBIENT, 3, Kind::color, 4},
    {GL_EMISSION, 1, Kind::color, 4},
    {GL_SHININESS, 1, Kind::real, 1},
    {GL_AMBIENT_AND_DIFFUSE, 1, Kind::color, 4},
    {GL_COLOR_INDEXES, 1, Kind::real, 3},
    {},
};

inline constexpr const auto& GetMaterial = Material;

inline constexpr ShapeRow PointParameter[] = {
    {GL_POINT_SIZE_MIN, 3, Kind::real, 1},
    {GL_POINT_DISTANCE_ATTENUATION, 1, Kind::real, 3},
    {GL_POINT_SPRITE_COORD_ORIGIN, 1, Kind::integer, 1},
    {},
};

inline constexpr ShapeRow PixelStore[] = {
    {GL_UNPACK_SWAP_BYTES, 2, Kind::real, 1},
    {GL_UNPACK_ROW_LENGTH, 4, Kind::integer, 1},
    {GL_PACK_SWAP_BYTES, 2, Kind::real, 1},
    {GL_PACK_ROW_LENGTH, 4, Kind::integer, 1},
    {GL_PACK_SKIP_IMAGES, 4, Kind::integer, 1},
    {},
};

inline constexpr ShapeRow PixelTransfer[] = {
    {GL_MAP_COLOR, 2, Kind::real, 1},
    {GL_INDEX_SHIFT, 2, Kind::integer, 1},
    {GL_RED_SCALE, 2, Kind::real, 1},
    {GL_GREEN_SCALE, 8, Kind::real, 1},
    {},
};

inline constexpr ShapeRow Fog[] = {
    {GL_FOG_INDEX, 4, Kind::real, 1},
    {GL_FOG_MODE, 1, Kind::integer, 1},
    {GL_FOG_COLOR, 1, Kind::color, 4},
    {GL_FOG_COORDINATE_SOURCE, 1, Kind::integer, 1},
    {},
};

inline constexpr ShapeRow TexParameter[] = {
    {GL_TEXTURE_BORDER_COLOR, 1, Kind::color, 4},
    {GL_TEXTURE_MAG_FILTER, 4, Kind::integer, 1},
    {GL_TEXTURE_PRIORITY, 1, Kind::real, 1},
    {GL_TEXTURE_RESIDENT, 1, Kind::integer, 1},
    {GL_TEXTURE_WRAP_R, 1, Kind::integer, 1},
    {GL_TEXTURE_MIN_LOD, 2, Kind::real, 1},
    {GL_TEXTURE_BASE_LEVEL, 2, Kind::integer, 1},
    {GL_GENERATE_MIPMAP, 1, Kind::integer, 1},
    {GL_TEXTURE_LOD_BIAS, 1, Kind::real, 1},
    {GL_DEPTH_TEXTURE_MODE, 3, Kind::integer, 1},
    {},
};

inline constexpr const auto& GetTexParameter = TexParameter;

inline constexpr ShapeRow TexEnv[] = {
    {GL_ALPHA_SCALE, 1, Kind::real, 1},
    {GL_TEXTURE_ENV_MODE, 1, Kind::integer, 1},
    {GL_TEXTURE_ENV_COLOR, 1, Kind::color, 4},
    {GL_TEXTURE_LOD_BIAS, 1, Kind::real, 1},
    {GL_COMBINE_RGB, 2, Kind::integer, 1},
    {GL_RGB_SCALE, 1, Kind::real, 1},
    {GL_SOURCE0_RGB, 3, Kind::integer, 1},
    {GL_SOURCE0_ALPHA, 3, Kind::integer, 1},
    {GL_OPERAND0_RGB, 3, Kind::integer, 1},
    {GL_OPERAND0_ALPHA, 3, Kind::integer, 1},
    {GL_COORD_REPLACE, 1, Kind::integer, 1},
    {},
};

inline constexpr const auto& GetTexEnv = TexEnv;

inline constexpr ShapeRow GetTexLevelParameter[] = {
    {GL_TEXTURE_WIDTH, 2, Kind::integer, 1},
    {GL_TEXTURE_INTERNAL_FORMAT, 1, Kind::integer, 1},
    {GL_TEXTURE_BORDER, 1, Kind::integer, 1},
    {GL_TEXTURE_RED_SIZE, 6, Kind::integer, 1},
    {GL_TEXTURE_DEPTH, 1, Kind::integer, 1},
    {GL_TEXTURE_COMPRESSED_IMAGE_SIZE, 2, Kind::integer, 1},
    {GL_TEXTURE_DEPTH_SIZE, 1, Kind::integer, 1},
    {},
};

} // namespace spangle::gl::shape
