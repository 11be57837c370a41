// TexParameter and its queries (GL 1.3, 3.8.4, 6.1.3).
#include <type_traits>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/texture/texture_target.hpp"

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
    return v == GL_REPEAT || v == GL_CLAMP || v == GL_CLAMP_TO_EDGE || v == GL_CLAMP_TO_BORDER ||
           v == GL_MIRRORED_REPEAT;
}

[[maybe_unused]] bool is_compare_mode(GLenum v) {
    return v == GL_NONE || v == GL_COMPARE_R_TO_TEXTURE;
}
[[maybe_unused]] bool is_compare_func(GLenum v) {
    return v - GL_NEVER < 8;
}
[[maybe_unused]] bool is_depth_mode(GLenum v) {
    return v == GL_LUMINANCE || v == GL_INTENSITY || v == GL_ALPHA;
}

GLenum set_level(GLint& where, GLint value) {
    if (value < 0)
        return GL_INVALID_VALUE;
    where = value;
    return GL_NO_ERROR;
}

/// A parameter that is a token: where it is kept, and what it may be.
template <class Token> struct TokenParameter {
    Token* where;
    bool (*legal)(GLenum);
};

/// Null: not one of these.
template <class Parameters> auto token_parameter(Parameters& p, GLenum pname) {
    using Token = std::remove_reference_t<decltype((p.min_filter))>;
    switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
        return TokenParameter<Token>{&p.min_filter, is_min_filter};
    case GL_TEXTURE_MAG_FILTER:
        return TokenParameter<Token>{&p.mag_filter, is_mag_filter};
    case GL_TEXTURE_WRAP_S:
        return TokenParameter<Token>{&p.wrap[0], is_wrap};
    case GL_TEXTURE_WRAP_T:
        return TokenParameter<Token>{&p.wrap[1], is_wrap};
    case GL_TEXTURE_WRAP_R:
        return TokenParameter<Token>{&p.wrap[2], is_wrap};
#if SPANGLE_FEATURE_DEPTH_TEXTURES
    case GL_DEPTH_TEXTURE_MODE:
        return TokenParameter<Token>{&p.depth_mode, is_depth_mode};
    case GL_TEXTURE_COMPARE_MODE:
        return TokenParameter<Token>{&p.compare_mode, is_compare_mode};
    case GL_TEXTURE_COMPARE_FUNC:
        return TokenParameter<Token>{&p.compare_func, is_compare_func};
#endif
    default:
        return TokenParameter<Token>{nullptr, nullptr};
    }
}

template <class Parameters> auto* real_parameter(Parameters& p, GLenum pname) {
    switch (pname) {
    case GL_TEXTURE_MIN_LOD:
        return &p.min_lod;
    case GL_TEXTURE_MAX_LOD:
        return &p.max_lod;
    case GL_TEXTURE_LOD_BIAS:
        return &p.lod_bias;
    case GL_TEXTURE_PRIORITY:
        return &p.priority;
    default:
        return static_cast<std::remove_reference_t<decltype((p.min_lod))>*>(nullptr);
    }
}

/// Table 3.19. The error, and then nothing is changed.
GLenum set_parameter(TextureParameters& p, GLenum pname, const Params& params) {
    const Param value = params.v[0];
    if (const auto token = token_parameter(p, pname); token.where != nullptr) {
        if (!token.legal(value.token()))
            return GL_INVALID_ENUM;
        *token.where = value.token();
        return GL_NO_ERROR;
    }
    if (Real* const real = real_parameter(p, pname); real != nullptr) {
        *real = pname == GL_TEXTURE_PRIORITY ? numeric::clamp01(value.real()) : value.real();
        return GL_NO_ERROR;
    }
    switch (pname) {
    case GL_TEXTURE_BASE_LEVEL:
        return set_level(p.base_level, value.integer());
    case GL_TEXTURE_MAX_LEVEL:
        return set_level(p.max_level, value.integer());
    case GL_GENERATE_MIPMAP:
        p.generate_mipmap = value.integer() != 0;
        return GL_NO_ERROR;
    case GL_TEXTURE_BORDER_COLOR:
        for (int c = 0; c < 4; ++c)
            p.border_color[c] = numeric::clamp01(params.v[c].real());
        return GL_NO_ERROR;
    default:
        return GL_INVALID_ENUM;
    }
}

/// False: not a parameter.
bool get_parameter(const TextureParameters& p, GLenum pname, Params& params) {
    params.count = 1;
    if (const auto token = token_parameter(p, pname); token.where != nullptr) {
        params.v[0] = Param::from_integer(*token.where);
        return true;
    }
    if (const Real* const real = real_parameter(p, pname); real != nullptr) {
        params.v[0] = Param::from(*real);
        return true;
    }
    switch (pname) {
    case GL_TEXTURE_BASE_LEVEL:
        params.v[0] = Param::from_integer(static_cast<std::uint32_t>(p.base_level));
        return true;
    case GL_TEXTURE_MAX_LEVEL:
        params.v[0] = Param::from_integer(static_cast<std::uint32_t>(p.max_level));
        return true;
    case GL_GENERATE_MIPMAP:
        params.v[0] = Param::from_integer(p.generate_mipmap ? 1 : 0);
        return true;
    case GL_TEXTURE_RESIDENT: // there is one kind of memory
        params.v[0] = Param::from_integer(GL_TRUE);
        return true;
    case GL_TEXTURE_BORDER_COLOR:
        for (int c = 0; c < 4; ++c)
            params.v[c] = Param::from(p.border_color[c]);
        params.count = 4;
        return true;
    default:
        params.count = 0;
        return false;
    }
}

/// A parameter of a system that this build has left out: says so.
bool left_out(Context& context, GLenum pname) {
    const char* missing = nullptr;
    bool absent = false;
    if (!SPANGLE_FEATURE_DEPTH_TEXTURES &&
        (pname == GL_DEPTH_TEXTURE_MODE || pname == GL_TEXTURE_COMPARE_MODE ||
         pname == GL_TEXTURE_COMPARE_FUNC)) {
        absent = true;
        missing = SPANGLE_TEXT("glTexParameter: this build has no SPANGLE_FEATURE_DEPTH_TEXTURES");
    }
    if (!SPANGLE_FEATURE_MIPMAP_GENERATION && pname == GL_GENERATE_MIPMAP) {
        absent = true;
        missing = SPANGLE_TEXT("glTexParameter: this build has no SPANGLE_FEATURE_MIPMAP_GENERATION");
    }
    if (absent)
        error(context, GL_INVALID_OPERATION, missing);
    return absent;
}

} // namespace

namespace cmd {

void TexParameter(Context& context, GLenum target, GLenum pname, const Params& params) {
    TextureKind kind;
    if (params.count == 0)
        return error(context, GL_INVALID_ENUM);
    if (!find_texture_target(context, target, kind) || left_out(context, pname))
        return;
    TextureObject& texture = bound_texture(context, kind);
    const GLenum refused = set_parameter(texture.parameters, pname, params);
    if (refused != GL_NO_ERROR)
        return error(context, refused);
    texture_changed(context, texture);
}

void GetTexParameter(Context& context, GLenum target, GLenum pname, Params& params) {
    TextureKind kind;
    params.count = 0;
    if (!find_texture_target(context, target, kind) || left_out(context, pname))
        return;
    if (!get_parameter(bound_texture(context, kind).parameters, pname, params))
        error(context, GL_INVALID_ENUM);
}

} // namespace cmd

} // namespace spangle::gl
