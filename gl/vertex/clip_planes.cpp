// ClipPlane and its query (GL 1.3, 2.11).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_CLIP_PLANES

#include "gl/api/convert.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/vertex/eye_plane.hpp"

namespace spangle::gl::cmd {

void ClipPlane(Context& context, GLenum plane, Real a, Real b, Real c, Real d) {
    if (plane - GL_CLIP_PLANE0 >= max_clip_planes)
        return error(context, GL_INVALID_ENUM);
    to_eye_plane(context.transform, {a, b, c, d}, context.transform.clip_plane[plane - GL_CLIP_PLANE0]);
    context.changed(dirty_others);
}

void GetClipPlane(Context& context, GLenum plane, GLdouble* equation) {
    if (plane - GL_CLIP_PLANE0 >= max_clip_planes)
        return error(context, GL_INVALID_ENUM);
    if (equation == nullptr)
        return error(context, GL_INVALID_VALUE);
    const Real(&kept)[4] = context.transform.clip_plane[plane - GL_CLIP_PLANE0];
    for (int i = 0; i < 4; ++i)
        equation[i] = convert::to_double(Kind::real, Param::from(kept[i]));
}

} // namespace spangle::gl::cmd

#endif
