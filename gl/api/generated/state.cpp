// Entry points: Errors, enables, queries.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#include "gl/api/components.hpp"
#include "gl/api/convert.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/api/generated/shapes.hpp"
#include "gl/api/issue.hpp"
#include "gl/api/params.hpp"

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

void GLAPIENTRY glPushAttrib(GLbitfield) {
    refuse_feature(SPANGLE_TEXT("glPushAttrib: this build has no SPANGLE_FEATURE_ATTRIB_STACKS"));
}

void GLAPIENTRY glPopAttrib() {
    refuse_feature(SPANGLE_TEXT("glPopAttrib: this build has no SPANGLE_FEATURE_ATTRIB_STACKS"));
}

void GLAPIENTRY glPushClientAttrib(GLbitfield) {
    refuse_feature(SPANGLE_TEXT("glPushClientAttrib: this build has no SPANGLE_FEATURE_ATTRIB_STACKS"));
}

void GLAPIENTRY glPopClientAttrib() {
    refuse_feature(SPANGLE_TEXT("glPopClientAttrib: this build has no SPANGLE_FEATURE_ATTRIB_STACKS"));
}

#endif

#if !SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetFixedvOES(GLenum, GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glGetFixedvOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

#endif

} // extern "C"
