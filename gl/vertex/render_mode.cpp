// RenderMode sets where primitives go, and returns the number of hits or of feedback values of the previous
// mode (GL 1.3, 5.2 and 5.3).
#include "gl/vertex/render_mode.hpp"

#if SPANGLE_FEATURE_SELECTION || SPANGLE_FEATURE_FEEDBACK

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"

namespace spangle::gl {

namespace {

/// True if the render mode can begin. Otherwise the error is set.
bool may_begin(Context& context, GLenum mode) {
    switch (mode) {
    case GL_RENDER:
        return true;
    case GL_SELECT:
#if SPANGLE_FEATURE_SELECTION
        if (context.render.select.given)
            return true;
        error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("GL_SELECT needs glSelectBuffer first"));
#else
        error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("this build has no SPANGLE_FEATURE_SELECTION"));
#endif
        return false;
    case GL_FEEDBACK:
#if SPANGLE_FEATURE_FEEDBACK
        if (context.render.feedback.given)
            return true;
        error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("GL_FEEDBACK needs glFeedbackBuffer first"));
#else
        error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("this build has no SPANGLE_FEATURE_FEEDBACK"));
#endif
        return false;
    default:
        error(context, GL_INVALID_ENUM);
        return false;
    }
}

#if SPANGLE_FEATURE_SELECTION
GLint end_selection(SelectState& s) {
    end_hit_record(s);
    const GLint found = s.overflow ? -1 : s.hits;
    s.written = 0;
    s.hits = s.depth = 0;
    s.overflow = false;
    return found;
}
#endif

#if SPANGLE_FEATURE_FEEDBACK
GLint end_feedback(FeedbackState& f) {
    const GLint found = f.overflow ? -1 : f.written;
    f.written = 0;
    f.overflow = false;
    return found;
}
#endif

} // namespace

GLint cmd::RenderMode(Context& context, GLenum mode) {
    if (!may_begin(context, mode))
        return 0;
    GLint found = 0;
#if SPANGLE_FEATURE_SELECTION
    if (context.render.mode == GL_SELECT)
        found = end_selection(context.render.select);
#endif
#if SPANGLE_FEATURE_FEEDBACK
    if (context.render.mode == GL_FEEDBACK)
        found = end_feedback(context.render.feedback);
#endif
    context.render.mode = mode;
    return found;
}

} // namespace spangle::gl

#endif
