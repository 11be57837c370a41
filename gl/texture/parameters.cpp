// TexParameter and the texture queries (GL 1.3, 3.8.4, 6.1.3).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/internal_format.hpp"

namespace spangle::gl {

namespace {

bool is_min_filter(GLenum v) {
    return v == GL_NEAREST || v == GL_LINEAR ||
           (v >= GL_NEAREST_MIPMAP_NEAREST && v <= GL_LINEAR_MIPMAP_LINEAR);
}
bool is_mag_filter(GLenum v) {
    return v == GL_NEAREST || v == GL_LINEAR;
}
bool is_wrap(GLenum v) {
    return v == GL_REPEAT || v == GL_CLAMP || v == GL_CLAMP_TO_EDGE || v == GL_CLAMP_TO_BORDER;
}

GLenum set_token(GLenum& where, GLenum value, bool (*legal)(GLenum)) {
    if (!legal(value))
        return GL_INVALID_ENUM;
    where = value;
    return GL_NO_ERROR;
}

GLenum set_level(GLint& where, GLint value) {
    if (value < 0)
        return GL_INVALID_VALUE;
    where = value;
    return GL_NO_ERROR;
}

/// Table 3.19. The error, and then nothing is changed.
GLenum set_parameter(TextureObject& texture, GLenum pname, const Params& params) {
    const Param value = params.v[0];
    switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
        return set_token(texture.parameters.min_filter, value.token(), is_min_filter);
    case GL_TEXTURE_MAG_FILTER:
        return set_token(texture.parameters.mag_filter, value.token(), is_mag_filter);
    case GL_TEXTURE_WRAP_S:
        return set_token(texture.parameters.wrap_s, value.token(), is_wrap);
    case GL_TEXTURE_WRAP_T:
        return set_token(texture.parameters.wrap_t, value.token(), is_wrap);
    case GL_TEXTURE_BASE_LEVEL:
        return set_level(texture.parameters.base_level, value.integer());
    case GL_TEXTURE_MAX_LEVEL:
        return set_level(texture.parameters.max_level, value.integer());
    case GL_TEXTURE_MIN_LOD:
        texture.parameters.min_lod = value.real();
        return GL_NO_ERROR;
    case GL_TEXTURE_MAX_LOD:
        texture.parameters.max_lod = value.real();
        return GL_NO_ERROR;
    case GL_TEXTURE_LOD_BIAS:
        texture.parameters.lod_bias = value.real();
        return GL_NO_ERROR;
    case GL_TEXTURE_PRIORITY:
        texture.parameters.priority = numeric::clamp01(value.real());
        return GL_NO_ERROR;
    case GL_TEXTURE_BORDER_COLOR:
        for (int c = 0; c < 4; ++c)
            texture.parameters.border_color[c] = numeric::clamp01(params.v[c].real());
        return GL_NO_ERROR;
    default:
        return GL_INVALID_ENUM;
    }
}

void answer(Params& params, Param value) {
    params.v[0] = value;
    params.count = 1;
}
void answer(Params& params, GLint value) {
    answer(params, Param::from_integer(static_cast<std::uint32_t>(value)));
}
void answer(Params& params, GLuint value) {
    answer(params, Param::from_integer(value));
}

/// Bits a texel keeps of what a ..._SIZE token asks (GL 1.3, 6.1.3: the resolution that is there).
unsigned size_of(raster::TexelFormat format, GLenum pname) {
    using raster::BaseFormat;
    const BaseFormat base = base_format_of(format);
    const ColorBits bits = texel_bits(format);
    const bool color = base == BaseFormat::rgb || base == BaseFormat::rgba;
    switch (pname) {
    case GL_TEXTURE_RED_SIZE:
    case GL_TEXTURE_GREEN_SIZE:
    case GL_TEXTURE_BLUE_SIZE:
        return color ? bits.of[pname - GL_TEXTURE_RED_SIZE] : 0;
    case GL_TEXTURE_ALPHA_SIZE:
        return base == BaseFormat::alpha || base == BaseFormat::luminance_alpha || base == BaseFormat::rgba
                   ? 8
                   : 0;
    case GL_TEXTURE_LUMINANCE_SIZE:
        return base == BaseFormat::luminance || base == BaseFormat::luminance_alpha ? 8 : 0;
    default: // INTENSITY_SIZE
        return base == BaseFormat::intensity ? 8 : 0;
    }
}

} // namespace

namespace cmd {

void TexParameter(Context& context, GLenum target, GLenum pname, const Params& params) {
    if (target != GL_TEXTURE_2D || params.count == 0)
        return error(context, GL_INVALID_ENUM);
    TextureObject& texture = context.texture.bound(context.texture.active);
    const GLenum refused = set_parameter(texture, pname, params);
    if (refused != GL_NO_ERROR)
        return error(context, refused);
    texture.view_valid = false;
    ++context.share->texture_changes;
    context.changed(dirty_fragment);
}

void GetTexParameter(Context& context, GLenum target, GLenum pname, Params& params) {
    params.count = 0;
    if (target != GL_TEXTURE_2D)
        return error(context, GL_INVALID_ENUM);
    const TextureObject& texture = context.texture.bound(context.texture.active);
    switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
        return answer(params, texture.parameters.min_filter);
    case GL_TEXTURE_MAG_FILTER:
        return answer(params, texture.parameters.mag_filter);
    case GL_TEXTURE_WRAP_S:
        return answer(params, texture.parameters.wrap_s);
    case GL_TEXTURE_WRAP_T:
        return answer(params, texture.parameters.wrap_t);
    case GL_TEXTURE_BASE_LEVEL:
        return answer(params, texture.parameters.base_level);
    case GL_TEXTURE_MAX_LEVEL:
        return answer(params, texture.parameters.max_level);
    case GL_TEXTURE_MIN_LOD:
        return answer(params, Param::from(texture.parameters.min_lod));
    case GL_TEXTURE_MAX_LOD:
        return answer(params, Param::from(texture.parameters.max_lod));
    case GL_TEXTURE_LOD_BIAS:
        return answer(params, Param::from(texture.parameters.lod_bias));
    case GL_TEXTURE_PRIORITY:
        return answer(params, Param::from(texture.parameters.priority));
    case GL_TEXTURE_RESIDENT: // there is one kind of memory
        return answer(params, GLuint{GL_TRUE});
    case GL_TEXTURE_BORDER_COLOR:
        for (int c = 0; c < 4; ++c)
            params.v[c] = Param::from(texture.parameters.border_color[c]);
        params.count = 4;
        return;
    default:
        return error(context, GL_INVALID_ENUM);
    }
}

void GetTexLevelParameter(Context& context, GLenum target, GLint level, GLenum pname, Params& params) {
    params.count = 0;
    if (target != GL_TEXTURE_2D && target != GL_PROXY_TEXTURE_2D)
        return error(context, GL_INVALID_ENUM);
    if (level < 0 || level >= texture_levels)
        return error(context, GL_INVALID_VALUE);
    LevelShape shape;
    const LevelImage* image = context.texture.bound(context.texture.active).level[level];
    if (target == GL_PROXY_TEXTURE_2D)
        shape = context.texture.proxy_2d[level];
    else if (image != nullptr)
        shape = image->shape;
    switch (pname) {
    case GL_TEXTURE_WIDTH:
        return answer(params, GLuint{shape.width});
    case GL_TEXTURE_HEIGHT:
        return answer(params, GLuint{shape.height});
    case GL_TEXTURE_BORDER:
        return answer(params, GLuint{shape.border});
    case GL_TEXTURE_INTERNAL_FORMAT:
        return answer(params, GLuint{shape.internal_format});
    case GL_TEXTURE_RED_SIZE:
    case GL_TEXTURE_GREEN_SIZE:
    case GL_TEXTURE_BLUE_SIZE:
    case GL_TEXTURE_ALPHA_SIZE:
    case GL_TEXTURE_LUMINANCE_SIZE:
    case GL_TEXTURE_INTENSITY_SIZE: // a level without texels keeps no bits
        return answer(params, shape.width == 0 ? 0u : size_of(shape.format, pname));
    default:
        return error(context, GL_INVALID_ENUM);
    }
}

} // namespace cmd

} // namespace spangle::gl
