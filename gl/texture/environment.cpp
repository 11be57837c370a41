// TexEnv: how a texel meets the fragment's colour (GL 1.3, 3.8.12).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"

namespace spangle::gl::cmd {

namespace {

bool is_mode(GLenum v) {
    return v == GL_MODULATE || v == GL_REPLACE || v == GL_DECAL || v == GL_BLEND || v == GL_ADD;
}

} // namespace

void ActiveTexture(Context& context, GLenum texture) {
    if (unit_of(texture) >= texture_units)
        return error(context, GL_INVALID_ENUM);
    context.texture.active = unit_of(texture);
}

void TexEnv(Context& context, GLenum target, GLenum pname, const Params& params) {
    TextureUnitState& unit = context.texture.unit[context.texture.active];
    if (target != GL_TEXTURE_ENV || params.count == 0)
        return error(context, GL_INVALID_ENUM);
    if (pname == GL_TEXTURE_ENV_MODE) {
        if (!is_mode(params.v[0].token()))
            return error(context, GL_INVALID_ENUM);
        unit.env_mode = params.v[0].token();
    } else if (pname == GL_TEXTURE_ENV_COLOR) {
        for (int c = 0; c < 4; ++c)
            unit.env_color[c] = numeric::clamp01(params.v[c].real());
    } else {
        return error(context, GL_INVALID_ENUM);
    }
    context.changed(dirty_fragment);
}

void GetTexEnv(Context& context, GLenum target, GLenum pname, Params& params) {
    const TextureUnitState& unit = context.texture.unit[context.texture.active];
    params.count = 0;
    if (target != GL_TEXTURE_ENV)
        return error(context, GL_INVALID_ENUM);
    if (pname == GL_TEXTURE_ENV_MODE) {
        params.v[0] = Param::from_integer(unit.env_mode);
        params.count = 1;
    } else if (pname == GL_TEXTURE_ENV_COLOR) {
        for (int c = 0; c < 4; ++c)
            params.v[c] = Param::from(unit.env_color[c]);
        params.count = 4;
    } else {
        return error(context, GL_INVALID_ENUM);
    }
}

} // namespace spangle::gl::cmd
