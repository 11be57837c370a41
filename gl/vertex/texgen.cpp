// TexGen and its queries (GL 1.3, 2.10.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_TEXGEN

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/vertex/eye_plane.hpp"

namespace spangle::gl::cmd {

namespace {

/// True if coordinate S, T, R or Q can be generated in this mode (GL 1.3, 2.10.4).
bool has_mode(GLenum coord, GLenum mode) {
    switch (mode) {
    case GL_OBJECT_LINEAR:
    case GL_EYE_LINEAR:
        return true;
    case GL_SPHERE_MAP:
        return coord <= GL_T;
    case GL_REFLECTION_MAP:
    case GL_NORMAL_MAP:
        return coord <= GL_R;
    default:
        return false;
    }
}

bool is_coord(GLenum coord) {
    return coord >= GL_S && coord <= GL_Q;
}

TexGenState& state_of(Context& context, GLenum coord) {
    return context.texture.unit[context.texture.active_unit()].gen[coord - GL_S];
}

} // namespace

void TexGen(Context& context, GLenum coord, GLenum pname, const Params& params) {
    if (!is_coord(coord) || params.count == 0)
        return error(context, GL_INVALID_ENUM);
    TexGenState& gen = state_of(context, coord);
    if (pname == GL_TEXTURE_GEN_MODE) {
        if (!has_mode(coord, params.v[0].token()))
            return error(context, GL_INVALID_ENUM);
        gen.mode = params.v[0].token();
    } else {
        const Real plane[4] = {params.v[0].real(), params.v[1].real(), params.v[2].real(),
                               params.v[3].real()};
        if (pname == GL_EYE_PLANE)
            to_eye_plane(context.transform, plane, gen.eye_plane);
        else
            for (int k = 0; k < 4; ++k)
                gen.object_plane[k] = plane[k];
    }
    context.changed(dirty_others);
}

void GetTexGen(Context& context, GLenum coord, GLenum pname, Params& params) {
    params.count = 0;
    if (!is_coord(coord) ||
        (pname != GL_TEXTURE_GEN_MODE && pname != GL_OBJECT_PLANE && pname != GL_EYE_PLANE))
        return error(context, GL_INVALID_ENUM);
    const TexGenState& gen = state_of(context, coord);
    if (pname == GL_TEXTURE_GEN_MODE) {
        params.v[0] = Param::from_integer(gen.mode);
        params.count = 1;
        return;
    }
    for (int k = 0; k < 4; ++k)
        params.v[k] = Param::from((pname == GL_EYE_PLANE ? gen.eye_plane : gen.object_plane)[k]);
    params.count = 4;
}

} // namespace spangle::gl::cmd

#endif
