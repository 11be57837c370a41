// How many values a pname takes, and of what kind.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#pragma once

#include "gl/api/family.hpp"

namespace spangle::gl::shape {

inline Shape TexGen(GLenum pname) {
    switch (pname) {
    case GL_TEXTURE_GEN_MODE:
        return {Kind::integer, 1};
    case GL_OBJECT_PLANE:
    case GL_EYE_PLANE:
        return {Kind::real, 4};
    default:
        return {};
    }
}

inline Shape GetTexGen(GLenum pname) {
    switch (pname) {
    case GL_TEXTURE_GEN_MODE:
        return {Kind::integer, 1};
    case GL_OBJECT_PLANE:
    case GL_EYE_PLANE:
        return {Kind::real, 4};
    default:
        return {};
    }
}

inline Shape Light(GLenum pname) {
    switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
        return {Kind::color, 4};
    case GL_POSITION:
        return {Kind::real, 4};
    case GL_SPOT_DIRECTION:
        return {Kind::real, 3};
    case GL_SPOT_EXPONENT:
    case GL_SPOT_CUTOFF:
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION:
        return {Kind::real, 1};
    default:
        return {};
    }
}

inline Shape GetLight(GLenum pname) {
    switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
        return {Kind::color, 4};
    case GL_POSITION:
        return {Kind::real, 4};
    case GL_SPOT_DIRECTION:
        return {Kind::real, 3};
    case GL_SPOT_EXPONENT:
    case GL_SPOT_CUTOFF:
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION:
        return {Kind::real, 1};
    default:
        return {};
    }
}

inline Shape LightModel(GLenum pname) {
    switch (pname) {
    case GL_LIGHT_MODEL_AMBIENT:
        return {Kind::color, 4};
    case GL_LIGHT_MODEL_LOCAL_VIEWER:
    case GL_LIGHT_MODEL_TWO_SIDE:
    case GL_LIGHT_MODEL_COLOR_CONTROL:
        return {Kind::integer, 1};
    default:
        return {};
    }
}

inline Shape Material(GLenum pname) {
    switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
    case GL_AMBIENT_AND_DIFFUSE:
        return {Kind::color, 4};
    case GL_SHININESS:
        return {Kind::real, 1};
    case GL_COLOR_INDEXES:
        return {Kind::real, 3};
    default:
        return {};
    }
}

inline Shape GetMaterial(GLenum pname) {
    switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
        return {Kind::color, 4};
    case GL_SHININESS:
        return {Kind::real, 1};
    case GL_COLOR_INDEXES:
        return {Kind::real, 3};
    default:
        return {};
    }
}

inline Shape PointParameter(GLenum pname) {
    switch (pname) {
    case GL_POINT_SIZE_MIN:
    case GL_POINT_SIZE_MAX:
    case GL_POINT_FADE_THRESHOLD_SIZE:
        return {Kind::real, 1};
    case GL_POINT_DISTANCE_ATTENUATION:
        return {Kind::real, 3};
    case GL_POINT_SPRITE_COORD_ORIGIN:
        return {Kind::integer, 1};
    default:
        return {};
    }
}

inline Shape PixelStore(GLenum pname) {
    switch (pname) {
    case GL_UNPACK_SWAP_BYTES:
    case GL_UNPACK_LSB_FIRST:
    case GL_PACK_SWAP_BYTES:
    case GL_PACK_LSB_FIRST:
        return {Kind::real, 1};
    case GL_UNPACK_ROW_LENGTH:
    case GL_UNPACK_SKIP_ROWS:
    case GL_UNPACK_SKIP_PIXELS:
    case GL_UNPACK_ALIGNMENT:
    case GL_UNPACK_IMAGE_HEIGHT:
    case GL_UNPACK_SKIP_IMAGES:
    case GL_PACK_ROW_LENGTH:
    case GL_PACK_SKIP_ROWS:
    case GL_PACK_SKIP_PIXELS:
    case GL_PACK_ALIGNMENT:
    case GL_PACK_IMAGE_HEIGHT:
    case GL_PACK_SKIP_IMAGES:
        return {Kind::integer, 1};
    default:
        return {};
    }
}

inline Shape PixelTransfer(GLenum pname) {
    switch (pname) {
    case GL_MAP_COLOR:
    case GL_MAP_STENCIL:
    case GL_RED_SCALE:
    case GL_RED_BIAS:
    case GL_GREEN_SCALE:
    case GL_GREEN_BIAS:
    case GL_BLUE_SCALE:
    case GL_BLUE_BIAS:
    case GL_ALPHA_SCALE:
    case GL_ALPHA_BIAS:
    case GL_DEPTH_SCALE:
    case GL_DEPTH_BIAS:
        return {Kind::real, 1};
    case GL_INDEX_SHIFT:
    case GL_INDEX_OFFSET:
        return {Kind::integer, 1};
    default:
        return {};
    }
}

inline Shape Fog(GLenum pname) {
    switch (pname) {
    case GL_FOG_MODE:
    case GL_FOG_COORDINATE_SOURCE:
        return {Kind::integer, 1};
    case GL_FOG_DENSITY:
    case GL_FOG_START:
    case GL_FOG_END:
    case GL_FOG_INDEX:
        return {Kind::real, 1};
    case GL_FOG_COLOR:
        return {Kind::color, 4};
    default:
        return {};
    }
}

inline Shape TexParameter(GLenum pname) {
    switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
    case GL_TEXTURE_MAG_FILTER:
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
    case GL_TEXTURE_BASE_LEVEL:
    case GL_TEXTURE_MAX_LEVEL:
    case GL_TEXTURE_WRAP_R:
    case GL_GENERATE_MIPMAP:
    case GL_DEPTH_TEXTURE_MODE:
    case GL_TEXTURE_COMPARE_MODE:
    case GL_TEXTURE_COMPARE_FUNC:
        return {Kind::integer, 1};
    case GL_TEXTURE_BORDER_COLOR:
        return {Kind::color, 4};
    case GL_TEXTURE_PRIORITY:
    case GL_TEXTURE_MIN_LOD:
    case GL_TEXTURE_MAX_LOD:
    case GL_TEXTURE_LOD_BIAS:
        return {Kind::real, 1};
    default:
        return {};
    }
}

inline Shape GetTexParameter(GLenum pname) {
    switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
    case GL_TEXTURE_MAG_FILTER:
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
    case GL_TEXTURE_BASE_LEVEL:
    case GL_TEXTURE_MAX_LEVEL:
    case GL_TEXTURE_WRAP_R:
    case GL_GENERATE_MIPMAP:
    case GL_DEPTH_TEXTURE_MODE:
    case GL_TEXTURE_COMPARE_MODE:
    case GL_TEXTURE_COMPARE_FUNC:
    case GL_TEXTURE_RESIDENT:
        return {Kind::integer, 1};
    case GL_TEXTURE_BORDER_COLOR:
        return {Kind::color, 4};
    case GL_TEXTURE_PRIORITY:
    case GL_TEXTURE_MIN_LOD:
    case GL_TEXTURE_MAX_LOD:
    case GL_TEXTURE_LOD_BIAS:
        return {Kind::real, 1};
    default:
        return {};
    }
}

inline Shape TexEnv(GLenum pname) {
    switch (pname) {
    case GL_TEXTURE_ENV_MODE:
    case GL_COMBINE_RGB:
    case GL_COMBINE_ALPHA:
    case GL_SOURCE0_RGB:
    case GL_SOURCE1_RGB:
    case GL_SOURCE2_RGB:
    case GL_SOURCE0_ALPHA:
    case GL_SOURCE1_ALPHA:
    case GL_SOURCE2_ALPHA:
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
    case GL_OPERAND0_ALPHA:
    case GL_OPERAND1_ALPHA:
    case GL_OPERAND2_ALPHA:
    case GL_COORD_REPLACE:
        return {Kind::integer, 1};
    case GL_TEXTURE_ENV_COLOR:
        return {Kind::color, 4};
    case GL_RGB_SCALE:
    case GL_ALPHA_SCALE:
    case GL_TEXTURE_LOD_BIAS:
        return {Kind::real, 1};
    default:
        return {};
    }
}

inline Shape GetTexEnv(GLenum pname) {
    switch (pname) {
    case GL_TEXTURE_ENV_MODE:
    case GL_COMBINE_RGB:
    case GL_COMBINE_ALPHA:
    case GL_SOURCE0_RGB:
    case GL_SOURCE1_RGB:
    case GL_SOURCE2_RGB:
    case GL_SOURCE0_ALPHA:
    case GL_SOURCE1_ALPHA:
    case GL_SOURCE2_ALPHA:
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
    case GL_OPERAND0_ALPHA:
    case GL_OPERAND1_ALPHA:
    case GL_OPERAND2_ALPHA:
    case GL_COORD_REPLACE:
        return {Kind::integer, 1};
    case GL_TEXTURE_ENV_COLOR:
        return {Kind::color, 4};
    case GL_RGB_SCALE:
    case GL_ALPHA_SCALE:
    case GL_TEXTURE_LOD_BIAS:
        return {Kind::real, 1};
    default:
        return {};
    }
}

inline Shape GetTexLevelParameter(GLenum pname) {
    switch (pname) {
    case GL_TEXTURE_WIDTH:
    case GL_TEXTURE_HEIGHT:
    case GL_TEXTURE_BORDER:
    case GL_TEXTURE_INTERNAL_FORMAT:
    case GL_TEXTURE_RED_SIZE:
    case GL_TEXTURE_GREEN_SIZE:
    case GL_TEXTURE_BLUE_SIZE:
    case GL_TEXTURE_ALPHA_SIZE:
    case GL_TEXTURE_LUMINANCE_SIZE:
    case GL_TEXTURE_INTENSITY_SIZE:
    case GL_TEXTURE_DEPTH:
    case GL_TEXTURE_DEPTH_SIZE:
    case GL_TEXTURE_COMPRESSED:
    case GL_TEXTURE_COMPRESSED_IMAGE_SIZE:
        return {Kind::integer, 1};
    default:
        return {};
    }
}

} // namespace spangle::gl::shape
