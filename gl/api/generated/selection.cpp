// Entry points: Selection, feedback.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#include "gl/api/components.hpp"
#include "gl/api/convert.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/api/generated/shapes.hpp"
#include "gl/api/issue.hpp"
#include "gl/api/params.hpp"
#include "gl/api/refused.hpp"

using namespace spangle::gl;
namespace numeric = spangle::numeric;

extern "C" {

#if SPANGLE_FEATURE_SELECTION || SPANGLE_FEATURE_FEEDBACK

GLint GLAPIENTRY glRenderMode(GLenum mode) {
    return ask<family::RenderMode>(mode);
}

#endif

#if SPANGLE_FEATURE_SELECTION

void GLAPIENTRY glSelectBuffer(GLsizei size, GLuint* buffer) {
    issue<family::SelectBuffer>(size, buffer);
}

void GLAPIENTRY glInitNames() {
    issue<family::InitNames>();
}

void GLAPIENTRY glPushName(GLuint name) {
    issue<family::PushName>(name);
}

void GLAPIENTRY glPopName() {
    issue<family::PopName>();
}

void GLAPIENTRY glLoadName(GLuint name) {
    issue<family::LoadName>(name);
}

#endif

#if SPANGLE_FEATURE_FEEDBACK

void GLAPIENTRY glFeedbackBuffer(GLsizei size, GLenum type, GLfloat* buffer) {
    issue_array<family::FeedbackBuffer>(size, type, buffer, GL_FLOAT);
}

#endif

#if SPANGLE_FEATURE_FEEDBACK && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glFeedbackBufferxOES(GLsizei size, GLenum type, GLfixed* buffer) {
    issue_array<family::FeedbackBuffer>(size, type, buffer, GL_FIXED);
}

#endif

#if SPANGLE_FEATURE_FEEDBACK

void GLAPIENTRY glPassThrough(GLfloat token) {
    issue<family::PassThrough>(convert::cast_f(token));
}

#endif

#if SPANGLE_FEATURE_FEEDBACK && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glPassThroughxOES(GLfixed token) {
    issue<family::PassThrough>(convert::cast_x(token));
}

#endif

#if !SPANGLE_FEATURE_FEEDBACK

SPANGLE_REFUSED("glFeedbackBuffer: this build has no SPANGLE_FEATURE_FEEDBACK", void GLAPIENTRY glFeedbackBuffer(GLsizei, GLenum, GLfloat*))

SPANGLE_REFUSED("glPassThrough: this build has no SPANGLE_FEATURE_FEEDBACK", void GLAPIENTRY glPassThrough(GLfloat))

#endif

#if !SPANGLE_FEATURE_FEEDBACK

SPANGLE_REFUSED("glFeedbackBufferxOES: this build has no SPANGLE_FEATURE_FEEDBACK", void GLAPIENTRY glFeedbackBufferxOES(GLsizei, GLenum, GLfixed*))

SPANGLE_REFUSED("glPassThroughxOES: this build has no SPANGLE_FEATURE_FEEDBACK", void GLAPIENTRY glPassThroughxOES(GLfixed))

#endif

#if SPANGLE_FEATURE_FEEDBACK && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glFeedbackBufferxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glFeedbackBufferxOES(GLsizei, GLenum, GLfixed*))

SPANGLE_REFUSED("glPassThroughxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glPassThroughxOES(GLfixed))

#endif

#if !SPANGLE_FEATURE_SELECTION

SPANGLE_REFUSED("glSelectBuffer: this build has no SPANGLE_FEATURE_SELECTION", void GLAPIENTRY glSelectBuffer(GLsizei, GLuint*))

SPANGLE_REFUSED("glInitNames: this build has no SPANGLE_FEATURE_SELECTION", void GLAPIENTRY glInitNames())

SPANGLE_REFUSED("glPushName: this build has no SPANGLE_FEATURE_SELECTION", void GLAPIENTRY glPushName(GLuint))

SPANGLE_REFUSED("glPopName: this build has no SPANGLE_FEATURE_SELECTION", void GLAPIENTRY glPopName())

SPANGLE_REFUSED("glLoadName: this build has no SPANGLE_FEATURE_SELECTION", void GLAPIENTRY glLoadName(GLuint))

#endif

#if !(SPANGLE_FEATURE_SELECTION || SPANGLE_FEATURE_FEEDBACK)

GLint GLAPIENTRY glRenderMode(GLenum) {
    refuse_feature(SPANGLE_TEXT("glRenderMode: this build has no SPANGLE_FEATURE_SELECTION and no SPANGLE_FEATURE_FEEDBACK"));
    return 0;
}

#endif

} // extern "C"
