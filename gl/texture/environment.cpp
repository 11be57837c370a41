// TexEnv: how a texel is combined with the fragment's colour (GL 1.3, 3.8.12, 3.8.13).
#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/api/generated/shapes.hpp"
#include "gl/context/context.hpp"
#include "gl/context/tokens.hpp"

namespace spangle::gl::cmd {

namespace {

#if SPANGLE_FEATURE_TEXTURE_COMBINE

bool is_function(GLenum v, bool alpha) {
    constexpr auto first_dot3 = static_cast<unsigned>(raster::CombineFunc::dot3_rgb);
    // The last two functions, DOT3_RGB and DOT3_RGBA, exist for RGB only (GL 1.3, table 3.24).
    static_assert(combine_functions.size() == first_dot3 + 2);
    return place_in(combine_functions, v) < (alpha ? first_dot3 : combine_functions.size());
}

bool is_source(GLenum v) {
    return is_in(combine_sources, v) || unit_of(v) < texture_units;
}

bool is_operand(GLenum v, bool alpha) {
    return is_combine_operand(v) && (!alpha || combine_operand_of(v) >= raster::CombineOperand::alpha);
}

/// Whether v is 1, 2 or 4.
bool is_scale(Real v) {
    constexpr Real two = numeric::from_i32(2), four = numeric::from_i32(4);
    return v.bits == numeric::one.bits || v.bits == two.bits || v.bits == four.bits;
}

static_assert(GL_COMBINE_ALPHA - GL_COMBINE_RGB == 1 && GL_SOURCE2_RGB - GL_SOURCE0_RGB == 2 &&
              GL_SOURCE2_ALPHA - GL_SOURCE0_ALPHA == 2 && GL_OPERAND2_RGB - GL_OPERAND0_RGB == 2 &&
              GL_OPERAND2_ALPHA - GL_OPERAND0_ALPHA == 2);

/// Returns the address of a parameter of a combiner whose value is a token, or null for other parameters. In
/// each kind of parameter, the tokens for alpha follow those for RGB.
GLenum* combiner_token(TexEnvState& env, GLenum pname) {
    for (unsigned alpha = 0; alpha < 2; ++alpha) {
        if (pname == GL_COMBINE_RGB + alpha)
            return &env.func[alpha];
        const GLenum source = pname - (alpha == 0 ? GL_SOURCE0_RGB : GL_SOURCE0_ALPHA),
                     operand = pname - (alpha == 0 ? GL_OPERAND0_RGB : GL_OPERAND0_ALPHA);
        if (source < 3)
            return &env.source[alpha][source];
        if (operand < 3)
            return &env.operand[alpha][operand];
    }
    return nullptr;
}

Real* combiner_scale(TexEnvState& env, GLenum pname) {
    return pname == GL_RGB_SCALE ? &env.scale[0] : pname == GL_ALPHA_SCALE ? &env.scale[1] : nullptr;
}

bool legal_token(GLenum pname, GLenum value) {
    if (pname <= GL_COMBINE_ALPHA)
        return is_function(value, pname == GL_COMBINE_ALPHA);
    return pname < GL_OPERAND0_RGB ? is_source(value) : is_operand(value, pname >= GL_OPERAND0_ALPHA);
}

/// Sets a parameter of a combiner. Returns the error, which is INVALID_ENUM if `pname` is no parameter of
/// combiners.
GLenum set_combiner(TexEnvState& env, GLenum pname, Param value) {
    if (GLenum* const token = combiner_token(env, pname); token != nullptr) {
        if (!legal_token(pname, value.token()))
            return GL_INVALID_ENUM;
        *token = value.token();
        return GL_NO_ERROR;
    }
    Real* const scale = combiner_scale(env, pname);
    if (scale == nullptr)
        return GL_INVALID_ENUM;
    if (!is_scale(value.real()))
        return GL_INVALID_VALUE;
    *scale = value.real();
    return GL_NO_ERROR;
}

bool get_combiner(TexEnvState& env, GLenum pname, Param& value) {
    if (const GLenum* const token = combiner_token(env, pname); token != nullptr) {
        value = Param::from_integer(*token);
        return true;
    }
    const Real* const scale = combiner_scale(env, pname);
    if (scale != nullptr)
        value = Param::from(*scale);
    return scale != nullptr;
}

#endif

/// Whether `pname` belongs to a system that this build leaves out; if so, raises an error that names the
/// system.
bool left_out(Context& context, GLenum pname) {
#if !SPANGLE_FEATURE_TEXTURE_COMBINE
    if (pname != GL_TEXTURE_ENV_MODE && pname != GL_TEXTURE_ENV_COLOR && pname != GL_TEXTURE_LOD_BIAS &&
        pname != GL_COORD_REPLACE && find_shape(shape::TexEnv, pname).count != 0) {
        error(context, GL_INVALID_OPERATION,
              SPANGLE_TEXT("this build has no SPANGLE_FEATURE_TEXTURE_COMBINE"));
        return true;
    }
#endif
#if !SPANGLE_FEATURE_POINT_PARAMETERS
    if (pname == GL_COORD_REPLACE) {
        error(context, GL_INVALID_OPERATION,
              SPANGLE_TEXT("this build has no SPANGLE_FEATURE_POINT_PARAMETERS"));
        return true;
    }
#endif
    static_cast<void>(context);
    static_cast<void>(pname);
    return false;
}

GLenum set(TexEnvState& env, GLenum pname, const Params& params) {
    switch (pname) {
    case GL_TEXTURE_ENV_MODE:
        if (!is_in(env_modes, params.v[0].token()))
            return GL_INVALID_ENUM;
        env.mode = params.v[0].token();
        return GL_NO_ERROR;
    case GL_TEXTURE_ENV_COLOR:
        for (int c = 0; c < 4; ++c)
            env.color[c] = numeric::clamp01(params.v[c].real());
        return GL_NO_ERROR;
    default:
#if SPANGLE_FEATURE_TEXTURE_COMBINE
        return set_combiner(env, pname, params.v[0]);
#else
        return GL_INVALID_ENUM;
#endif
    }
}

bool get(TexEnvState& env, GLenum pname, Params& params) {
    params.count = 1;
    switch (pname) {
    case GL_TEXTURE_ENV_MODE:
        params.v[0] = Param::from_integer(env.mode);
        return true;
    case GL_TEXTURE_ENV_COLOR:
        std::memcpy(static_cast<void*>(params.v), env.color, sizeof env.color);
        params.count = 4;
        return true;
    default:
#if SPANGLE_FEATURE_TEXTURE_COMBINE
        return get_combiner(env, pname, params.v[0]);
#else
        return false;
#endif
    }
}

/// Whether `pname` belongs to `target`. The targets of GL 1.4 and 2.0 have one parameter each; TEXTURE_ENV
/// has all others.
bool legal_target(GLenum target, GLenum pname) {
    return target == (pname == GL_TEXTURE_LOD_BIAS ? GL_TEXTURE_FILTER_CONTROL
                      : pname == GL_COORD_REPLACE  ? GL_POINT_SPRITE
                                                   : GL_TEXTURE_ENV);
}

} // namespace

void ActiveTexture(Context& context, GLenum texture) {
    if (unit_of(texture) >= texture_units)
        return error(context, GL_INVALID_ENUM,
                     SPANGLE_TEXT("texture is beyond the units of this build (SPANGLE_TEXTURE_UNITS)"));
    context.texture.active = unit_of(texture);
}

void TexEnv(Context& context, GLenum target, GLenum pname, const Params& params) {
    TexEnvState& env = context.texture.unit[context.texture.active_unit()].env;
    if (!legal_target(target, pname) || params.count == 0)
        return error(context, GL_INVALID_ENUM,
                     legal_target(target, pname) ? nullptr : SPANGLE_TEXT("pname is not of this target"));
    if (left_out(context, pname))
        return;
    if (pname == GL_TEXTURE_LOD_BIAS) {
        env.lod_bias = params.v[0].real();
#if SPANGLE_FEATURE_POINT_PARAMETERS
    } else if (pname == GL_COORD_REPLACE) {
        context.polygon.coord_replace[context.texture.active_unit()] = params.v[0].token() != 0;
#endif
    } else if (const GLenum refused = set(env, pname, params); refused != GL_NO_ERROR) {
        return error(context, refused);
    }
    context.changed(dirty_fragment);
}

void GetTexEnv(Context& context, GLenum target, GLenum pname, Params& params) {
    TexEnvState& env = context.texture.unit[context.texture.active_unit()].env;
    params.count = 0;
    if (!legal_target(target, pname))
        return error(context, GL_INVALID_ENUM, SPANGLE_TEXT("pname is not of this target"));
    if (left_out(context, pname))
        return;
    if (pname == GL_TEXTURE_LOD_BIAS) {
        params.v[0] = Param::from(env.lod_bias);
        params.count = 1;
#if SPANGLE_FEATURE_POINT_PARAMETERS
    } else if (pname == GL_COORD_REPLACE) {
        params.v[0] = Param::from_integer(context.polygon.coord_replace[context.texture.active_unit()]);
        params.count = 1;
#endif
    } else if (!get(env, pname, params)) {
        params.count = 0;
        error(context, GL_INVALID_ENUM);
    }
}

} // namespace spangle::gl::cmd
