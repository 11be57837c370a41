// Entry points: Errors, enables, queries.
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

GLenum GLAPIENTRY glGetError() {
    return ask<family::GetError>();
}

void GLAPIENTRY glEnable(GLenum cap) {
    issue<family::Enable>(cap);
}

void GLAPIENTRY glDisable(GLenum cap) {
    issue<family::Disable>(cap);
}

GLboolean GLAPIENTRY glIsEnabled(GLenum cap) {
    return ask<family::IsEnabled>(cap);
}

void GLAPIENTRY glGetBooleanv(GLenum pname, GLboolean* params) {
    issue<family::GetBooleanv>(pname, params);
}

void GLAPIENTRY glGetIntegerv(GLenum pname, GLint* params) {
    issue<family::GetIntegerv>(pname, params);
}

void GLAPIENTRY glGetFloatv(GLenum pname, GLfloat* params) {
    issue<family::GetFloatv>(pname, params);
}

void GLAPIENTRY glGetDoublev(GLenum pname, GLdouble* params) {
    issue<family::GetDoublev>(pname, params);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetFixedvOES(GLenum pname, GLfixed* params) {
    issue<family::GetFixedvOES>(pname, params);
}

#endif

void GLAPIENTRY glGetPointerv(GLenum pname, void** params) {
    issue<family::GetPointerv>(pname, params);
}

const GLubyte* GLAPIENTRY glGetString(GLenum name) {
    return ask<family::GetString>(name);
}

#if SPANGLE_FEATURE_ATTRIB_STACKS

void GLAPIENTRY glPushAttrib(GLbitfield mask) {
    issue<family::PushAttrib>(mask);
}

void GLAPIENTRY glPopAttrib() {
    issue<family::PopAttrib>();
}

void GLAPIENTRY glPushClientAttrib(GLbitfield mask) {
    issue<family::PushClientAttrib>(mask);
}

void GLAPIENTRY glPopClientAttrib() {
    issue<family::PopClientAttrib>();
}

#endif

#if !SPANGLE_FEATURE_ATTRIB_STACKS

SPANGLE_REFUSED("glPushAttrib: this build has no SPANGLE_FEATURE_ATTRIB_STACKS", void GLAPIENTRY glPushAttrib(GLbitfield))

SPANGLE_REFUSED("glPopAttrib: this build has no SPANGLE_FEATURE_ATTRIB_STACKS", void GLAPIENTRY glPopAttrib())

SPANGLE_REFUSED("glPushClientAttrib: this build has no SPANGLE_FEATURE_ATTRIB_STACKS", void GLAPIENTRY glPushClientAttrib(GLbitfield))

SPANGLE_REFUSED("glPopClientAttrib: this build has no SPANGLE_FEATURE_ATTRIB_STACKS", void GLAPIENTRY glPopClientAttrib())

#endif

#if !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glGetFixedvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glGetFixedvOES(GLenum, GLfixed*))

#endif

} // extern "C"
