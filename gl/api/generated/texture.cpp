// Entry points: Textures.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#include "gl/api/convert.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/api/generated/shapes.hpp"
#include "gl/api/issue.hpp"

using namespace spangle::gl;
namespace numeric = spangle::numeric;

extern "C" {

void GLAPIENTRY glTexImage2D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type, const void* pixels) {
    issue<family::TexImage2D>(target, level, internalformat, width, height, border, format, type, pixels);
}

void GLAPIENTRY glTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels) {
    issue<family::TexSubImage2D>(target, level, xoffset, yoffset, width, height, format, type, pixels);
}

void GLAPIENTRY glGenTextures(GLsizei n, GLuint* textures) {
    issue<family::GenTextures>(n, textures);
}

void GLAPIENTRY glDeleteTextures(GLsizei n, const GLuint* textures) {
    issue<family::DeleteTextures>(n, textures);
}

void GLAPIENTRY glBindTexture(GLenum target, GLuint texture) {
    issue<family::BindTexture>(target, texture);
}

void GLAPIENTRY glActiveTexture(GLenum texture) {
    issue<family::ActiveTexture>(texture);
}

GLboolean GLAPIENTRY glIsTexture(GLuint texture) {
    return ask<family::IsTexture>(texture);
}

void GLAPIENTRY glTexParameterf(GLenum target, GLenum pname, GLfloat param) {
    issue<family::TexParameter>(target, pname, convert::scalar_f(shape::TexParameter(pname), param));
}

void GLAPIENTRY glTexParameterfv(GLenum target, GLenum pname, const GLfloat* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glTexParameterfv: null pointer"));
    issue<family::TexParameter>(target, pname, convert::vector_f(shape::TexParameter(pname), params));
}

void GLAPIENTRY glTexParameteri(GLenum target, GLenum pname, GLint param) {
    issue<family::TexParameter>(target, pname, convert::scalar_i(shape::TexParameter(pname), param));
}

void GLAPIENTRY glTexParameteriv(GLenum target, GLenum pname, const GLint* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glTexParameteriv: null pointer"));
    issue<family::TexParameter>(target, pname, convert::vector_i(shape::TexParameter(pname), params));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexParameterxOES(GLenum target, GLenum pname, GLfixed param) {
    issue<family::TexParameter>(target, pname, convert::scalar_x(shape::TexParameter(pname), param));
}

void GLAPIENTRY glTexParameterxvOES(GLenum target, GLenum pname, const GLfixed* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glTexParameterxvOES: null pointer"));
    issue<family::TexParameter>(target, pname, convert::vector_x(shape::TexParameter(pname), params));
}

#endif

void GLAPIENTRY glGetTexParameterfv(GLenum target, GLenum pname, GLfloat* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glGetTexParameterfv: null pointer"));
    Params found;
    fetch<family::GetTexParameter>(found, target, pname);
    convert::store_f(shape::GetTexParameter(pname), found, params);
}

void GLAPIENTRY glGetTexParameteriv(GLenum target, GLenum pname, GLint* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glGetTexParameteriv: null pointer"));
    Params found;
    fetch<family::GetTexParameter>(found, target, pname);
    convert::store_i(shape::GetTexParameter(pname), found, params);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetTexParameterxvOES(GLenum target, GLenum pname, GLfixed* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glGetTexParameterxvOES: null pointer"));
    Params found;
    fetch<family::GetTexParameter>(found, target, pname);
    convert::store_x(shape::GetTexParameter(pname), found, params);
}

#endif

void GLAPIENTRY glTexEnvf(GLenum target, GLenum pname, GLfloat param) {
    issue<family::TexEnv>(target, pname, convert::scalar_f(shape::TexEnv(pname), param));
}

void GLAPIENTRY glTexEnvfv(GLenum target, GLenum pname, const GLfloat* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glTexEnvfv: null pointer"));
    issue<family::TexEnv>(target, pname, convert::vector_f(shape::TexEnv(pname), params));
}

void GLAPIENTRY glTexEnvi(GLenum target, GLenum pname, GLint param) {
    issue<family::TexEnv>(target, pname, convert::scalar_i(shape::TexEnv(pname), param));
}

void GLAPIENTRY glTexEnviv(GLenum target, GLenum pname, const GLint* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glTexEnviv: null pointer"));
    issue<family::TexEnv>(target, pname, convert::vector_i(shape::TexEnv(pname), params));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexEnvxOES(GLenum target, GLenum pname, GLfixed param) {
    issue<family::TexEnv>(target, pname, convert::scalar_x(shape::TexEnv(pname), param));
}

void GLAPIENTRY glTexEnvxvOES(GLenum target, GLenum pname, const GLfixed* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glTexEnvxvOES: null pointer"));
    issue<family::TexEnv>(target, pname, convert::vector_x(shape::TexEnv(pname), params));
}

#endif

void GLAPIENTRY glGetTexEnvfv(GLenum target, GLenum pname, GLfloat* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glGetTexEnvfv: null pointer"));
    Params found;
    fetch<family::GetTexEnv>(found, target, pname);
    convert::store_f(shape::GetTexEnv(pname), found, params);
}

void GLAPIENTRY glGetTexEnviv(GLenum target, GLenum pname, GLint* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glGetTexEnviv: null pointer"));
    Params found;
    fetch<family::GetTexEnv>(found, target, pname);
    convert::store_i(shape::GetTexEnv(pname), found, params);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetTexEnvxvOES(GLenum target, GLenum pname, GLfixed* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glGetTexEnvxvOES: null pointer"));
    Params found;
    fetch<family::GetTexEnv>(found, target, pname);
    convert::store_x(shape::GetTexEnv(pname), found, params);
}

#endif

void GLAPIENTRY glGetTexLevelParameterfv(GLenum target, GLint level, GLenum pname, GLfloat* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glGetTexLevelParameterfv: null pointer"));
    Params found;
    fetch<family::GetTexLevelParameter>(found, target, level, pname);
    convert::store_f(shape::GetTexLevelParameter(pname), found, params);
}

void GLAPIENTRY glGetTexLevelParameteriv(GLenum target, GLint level, GLenum pname, GLint* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glGetTexLevelParameteriv: null pointer"));
    Params found;
    fetch<family::GetTexLevelParameter>(found, target, level, pname);
    convert::store_i(shape::GetTexLevelParameter(pname), found, params);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetTexLevelParameterxvOES(GLenum target, GLint level, GLenum pname, GLfixed* params) {
    if (params == nullptr)
        return refuse_null(SPANGLE_TEXT("glGetTexLevelParameterxvOES: null pointer"));
    Params found;
    fetch<family::GetTexLevelParameter>(found, target, level, pname);
    convert::store_x(shape::GetTexLevelParameter(pname), found, params);
}

#endif

#if !SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexParameterxOES(GLenum, GLenum, GLfixed) {
    refuse_feature(SPANGLE_TEXT("glTexParameterxOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glTexParameterxvOES(GLenum, GLenum, const GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glTexParameterxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glGetTexParameterxvOES(GLenum, GLenum, GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glGetTexParameterxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glTexEnvxOES(GLenum, GLenum, GLfixed) {
    refuse_feature(SPANGLE_TEXT("glTexEnvxOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glTexEnvxvOES(GLenum, GLenum, const GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glTexEnvxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glGetTexEnvxvOES(GLenum, GLenum, GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glGetTexEnvxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glGetTexLevelParameterxvOES(GLenum, GLint, GLenum, GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glGetTexLevelParameterxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

#endif

} // extern "C"
