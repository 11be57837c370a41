// Entry points: Textures.
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

#if SPANGLE_FEATURE_TEXTURE_1D

void GLAPIENTRY glTexImage1D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLint border, GLenum format, GLenum type, const void* pixels) {
    issue<family::TexImage1D>(ImageCommand{{static_cast<GLint>(target), level, internalformat, border, 0}, {width, 1, 1}, format, type, pixels, false});
}

#endif

void GLAPIENTRY glTexImage2D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type, const void* pixels) {
    issue<family::TexImage2D>(ImageCommand{{static_cast<GLint>(target), level, internalformat, border, 0}, {width, height, 1}, format, type, pixels, false});
}

void GLAPIENTRY glTexConstantImage2DSPANGLE(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data) {
    issue<family::TexConstantImage2DSPANGLE>(target, level, internalformat, width, height, border, imageSize, data);
}

#if SPANGLE_FEATURE_TEXTURE_3D

void GLAPIENTRY glTexImage3D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels) {
    issue<family::TexImage3D>(ImageCommand{{static_cast<GLint>(target), level, internalformat, border, 0}, {width, height, depth}, format, type, pixels, true});
}

#endif

#if SPANGLE_FEATURE_TEXTURE_1D

void GLAPIENTRY glTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format, GLenum type, const void* pixels) {
    issue<family::TexSubImage1D>(ImageCommand{{static_cast<GLint>(target), level, xoffset, 0, 0}, {width, 1, 1}, format, type, pixels, false});
}

#endif

void GLAPIENTRY glTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels) {
    issue<family::TexSubImage2D>(ImageCommand{{static_cast<GLint>(target), level, xoffset, yoffset, 0}, {width, height, 1}, format, type, pixels, false});
}

#if SPANGLE_FEATURE_TEXTURE_3D

void GLAPIENTRY glTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type, const void* pixels) {
    issue<family::TexSubImage3D>(ImageCommand{{static_cast<GLint>(target), level, xoffset, yoffset, zoffset}, {width, height, depth}, format, type, pixels, true});
}

#endif

#if SPANGLE_FEATURE_COPY_TEXTURE && SPANGLE_FEATURE_TEXTURE_1D

void GLAPIENTRY glCopyTexImage1D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width, GLint border) {
    issue<family::CopyTexImage1D>(target, level, internalformat, x, y, width, border);
}

#endif

#if SPANGLE_FEATURE_COPY_TEXTURE

void GLAPIENTRY glCopyTexImage2D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width, GLsizei height, GLint border) {
    issue<family::CopyTexImage2D>(target, level, internalformat, x, y, width, height, border);
}

#endif

#if SPANGLE_FEATURE_COPY_TEXTURE && SPANGLE_FEATURE_TEXTURE_1D

void GLAPIENTRY glCopyTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLint x, GLint y, GLsizei width) {
    issue<family::CopyTexSubImage1D>(target, level, xoffset, x, y, width);
}

#endif

#if SPANGLE_FEATURE_COPY_TEXTURE

void GLAPIENTRY glCopyTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x, GLint y, GLsizei width, GLsizei height) {
    issue<family::CopyTexSubImage2D>(target, level, xoffset, yoffset, x, y, width, height);
}

#endif

#if SPANGLE_FEATURE_COPY_TEXTURE && SPANGLE_FEATURE_TEXTURE_3D

void GLAPIENTRY glCopyTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height) {
    issue<family::CopyTexSubImage3D>(target, level, xoffset, yoffset, zoffset, x, y, width, height);
}

#endif

#if SPANGLE_FEATURE_COMPRESSED_TEXTURES

void GLAPIENTRY glCompressedTexImage1D(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLint border, GLsizei imageSize, const void* data) {
    issue<family::CompressedTexImage1D>(target, level, internalformat, width, border, imageSize, data);
}

void GLAPIENTRY glCompressedTexImage2D(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data) {
    issue<family::CompressedTexImage2D>(target, level, internalformat, width, height, border, imageSize, data);
}

void GLAPIENTRY glCompressedTexImage3D(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLsizei depth, GLint border, GLsizei imageSize, const void* data) {
    issue<family::CompressedTexImage3D>(target, level, internalformat, width, height, depth, border, imageSize, data);
}

void GLAPIENTRY glCompressedTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format, GLsizei imageSize, const void* data) {
    issue<family::CompressedTexSubImage1D>(target, level, xoffset, width, format, imageSize, data);
}

void GLAPIENTRY glCompressedTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width, GLsizei height, GLenum format, GLsizei imageSize, const void* data) {
    issue<family::CompressedTexSubImage2D>(target, level, xoffset, yoffset, width, height, format, imageSize, data);
}

void GLAPIENTRY glCompressedTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLsizei imageSize, const void* data) {
    issue<family::CompressedTexSubImage3D>(target, level, xoffset, yoffset, zoffset, width, height, depth, format, imageSize, data);
}

void GLAPIENTRY glCompressedTexConstantImage2DSPANGLE(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data) {
    issue<family::CompressedTexConstantImage2DSPANGLE>(target, level, internalformat, width, height, border, imageSize, data);
}

#endif

void GLAPIENTRY glGetTexImage(GLenum target, GLint level, GLenum format, GLenum type, void* pixels) {
    issue<family::GetTexImage>(target, level, format, type, pixels);
}

#if SPANGLE_FEATURE_COMPRESSED_TEXTURES

void GLAPIENTRY glGetCompressedTexImage(GLenum target, GLint level, void* data) {
    issue<family::GetCompressedTexImage>(target, level, data);
}

#endif

#if SPANGLE_FEATURE_MIPMAP_GENERATION

void GLAPIENTRY glGenerateMipmap(GLenum target) {
    issue<family::GenerateMipmap>(target);
}

#endif

GLboolean GLAPIENTRY glAreTexturesResident(GLsizei n, const GLuint* textures, GLboolean* residences) {
    return ask<family::AreTexturesResident>(n, textures, residences);
}

void GLAPIENTRY glPrioritizeTextures(GLsizei n, const GLuint* textures, const GLclampf* priorities) {
    issue<family::PrioritizeTextures>(n, textures, priorities);
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
    issue_param<family::TexParameter, shape::TexParameter>(target, pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glTexParameterfv(GLenum target, GLenum pname, const GLfloat* params) {
    issue_params<family::TexParameter, shape::TexParameter>(target, pname, params, convert::Number::f, SPANGLE_TEXT("glTexParameterfv: params is a null pointer"));
}

void GLAPIENTRY glTexParameteri(GLenum target, GLenum pname, GLint param) {
    issue_param<family::TexParameter, shape::TexParameter>(target, pname, convert::word(param), convert::Number::i);
}

void GLAPIENTRY glTexParameteriv(GLenum target, GLenum pname, const GLint* params) {
    issue_params<family::TexParameter, shape::TexParameter>(target, pname, params, convert::Number::i, SPANGLE_TEXT("glTexParameteriv: params is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexParameterxOES(GLenum target, GLenum pname, GLfixed param) {
    issue_param<family::TexParameter, shape::TexParameter>(target, pname, convert::word(param), convert::Number::x);
}

void GLAPIENTRY glTexParameterxvOES(GLenum target, GLenum pname, const GLfixed* params) {
    issue_params<family::TexParameter, shape::TexParameter>(target, pname, params, convert::Number::x, SPANGLE_TEXT("glTexParameterxvOES: params is a null pointer"));
}

#endif

void GLAPIENTRY glGetTexParameterfv(GLenum target, GLenum pname, GLfloat* params) {
    fetch_params<family::GetTexParameter, shape::GetTexParameter>(target, pname, params, convert::Number::f, SPANGLE_TEXT("glGetTexParameterfv: params is a null pointer"));
}

void GLAPIENTRY glGetTexParameteriv(GLenum target, GLenum pname, GLint* params) {
    fetch_params<family::GetTexParameter, shape::GetTexParameter>(target, pname, params, convert::Number::i, SPANGLE_TEXT("glGetTexParameteriv: params is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetTexParameterxvOES(GLenum target, GLenum pname, GLfixed* params) {
    fetch_params<family::GetTexParameter, shape::GetTexParameter>(target, pname, params, convert::Number::x, SPANGLE_TEXT("glGetTexParameterxvOES: params is a null pointer"));
}

#endif

void GLAPIENTRY glTexEnvf(GLenum target, GLenum pname, GLfloat param) {
    issue_param<family::TexEnv, shape::TexEnv>(target, pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glTexEnvfv(GLenum target, GLenum pname, const GLfloat* params) {
    issue_params<family::TexEnv, shape::TexEnv>(target, pname, params, convert::Number::f, SPANGLE_TEXT("glTexEnvfv: params is a null pointer"));
}

void GLAPIENTRY glTexEnvi(GLenum target, GLenum pname, GLint param) {
    issue_param<family::TexEnv, shape::TexEnv>(target, pname, convert::word(param), convert::Number::i);
}

void GLAPIENTRY glTexEnviv(GLenum target, GLenum pname, const GLint* params) {
    issue_params<family::TexEnv, shape::TexEnv>(target, pname, params, convert::Number::i, SPANGLE_TEXT("glTexEnviv: params is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexEnvxOES(GLenum target, GLenum pname, GLfixed param) {
    issue_param<family::TexEnv, shape::TexEnv>(target, pname, convert::word(param), convert::Number::x);
}

void GLAPIENTRY glTexEnvxvOES(GLenum target, GLenum pname, const GLfixed* params) {
    issue_params<family::TexEnv, shape::TexEnv>(target, pname, params, convert::Number::x, SPANGLE_TEXT("glTexEnvxvOES: params is a null pointer"));
}

#endif

void GLAPIENTRY glGetTexEnvfv(GLenum target, GLenum pname, GLfloat* params) {
    fetch_params<family::GetTexEnv, shape::GetTexEnv>(target, pname, params, convert::Number::f, SPANGLE_TEXT("glGetTexEnvfv: params is a null pointer"));
}

void GLAPIENTRY glGetTexEnviv(GLenum target, GLenum pname, GLint* params) {
    fetch_params<family::GetTexEnv, shape::GetTexEnv>(target, pname, params, convert::Number::i, SPANGLE_TEXT("glGetTexEnviv: params is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetTexEnvxvOES(GLenum target, GLenum pname, GLfixed* params) {
    fetch_params<family::GetTexEnv, shape::GetTexEnv>(target, pname, params, convert::Number::x, SPANGLE_TEXT("glGetTexEnvxvOES: params is a null pointer"));
}

#endif

void GLAPIENTRY glGetTexLevelParameterfv(GLenum target, GLint level, GLenum pname, GLfloat* params) {
    fetch_params<family::GetTexLevelParameter, shape::GetTexLevelParameter>(target, level, pname, params, convert::Number::f, SPANGLE_TEXT("glGetTexLevelParameterfv: params is a null pointer"));
}

void GLAPIENTRY glGetTexLevelParameteriv(GLenum target, GLint level, GLenum pname, GLint* params) {
    fetch_params<family::GetTexLevelParameter, shape::GetTexLevelParameter>(target, level, pname, params, convert::Number::i, SPANGLE_TEXT("glGetTexLevelParameteriv: params is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetTexLevelParameterxvOES(GLenum target, GLint level, GLenum pname, GLfixed* params) {
    fetch_params<family::GetTexLevelParameter, shape::GetTexLevelParameter>(target, level, pname, params, convert::Number::x, SPANGLE_TEXT("glGetTexLevelParameterxvOES: params is a null pointer"));
}

#endif

#if !SPANGLE_FEATURE_COMPRESSED_TEXTURES

SPANGLE_REFUSED("glCompressedTexImage1D: this build has no SPANGLE_FEATURE_COMPRESSED_TEXTURES", void GLAPIENTRY glCompressedTexImage1D(GLenum, GLint, GLenum, GLsizei, GLint, GLsizei, const void*))

SPANGLE_REFUSED("glCompressedTexImage2D: this build has no SPANGLE_FEATURE_COMPRESSED_TEXTURES", void GLAPIENTRY glCompressedTexImage2D(GLenum, GLint, GLenum, GLsizei, GLsizei, GLint, GLsizei, const void*))

SPANGLE_REFUSED("glCompressedTexImage3D: this build has no SPANGLE_FEATURE_COMPRESSED_TEXTURES", void GLAPIENTRY glCompressedTexImage3D(GLenum, GLint, GLenum, GLsizei, GLsizei, GLsizei, GLint, GLsizei, const void*))

SPANGLE_REFUSED("glCompressedTexSubImage1D: this build has no SPANGLE_FEATURE_COMPRESSED_TEXTURES", void GLAPIENTRY glCompressedTexSubImage1D(GLenum, GLint, GLint, GLsizei, GLenum, GLsizei, const void*))

SPANGLE_REFUSED("glCompressedTexSubImage2D: this build has no SPANGLE_FEATURE_COMPRESSED_TEXTURES", void GLAPIENTRY glCompressedTexSubImage2D(GLenum, GLint, GLint, GLint, GLsizei, GLsizei, GLenum, GLsizei, const void*))

SPANGLE_REFUSED("glCompressedTexSubImage3D: this build has no SPANGLE_FEATURE_COMPRESSED_TEXTURES", void GLAPIENTRY glCompressedTexSubImage3D(GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei, GLenum, GLsizei, const void*))

SPANGLE_REFUSED("glCompressedTexConstantImage2DSPANGLE: this build has no SPANGLE_FEATURE_COMPRESSED_TEXTURES", void GLAPIENTRY glCompressedTexConstantImage2DSPANGLE(GLenum, GLint, GLenum, GLsizei, GLsizei, GLint, GLsizei, const void*))

SPANGLE_REFUSED("glGetCompressedTexImage: this build has no SPANGLE_FEATURE_COMPRESSED_TEXTURES", void GLAPIENTRY glGetCompressedTexImage(GLenum, GLint, void*))

#endif

#if !SPANGLE_FEATURE_COPY_TEXTURE

SPANGLE_REFUSED("glCopyTexImage2D: this build has no SPANGLE_FEATURE_COPY_TEXTURE", void GLAPIENTRY glCopyTexImage2D(GLenum, GLint, GLenum, GLint, GLint, GLsizei, GLsizei, GLint))

SPANGLE_REFUSED("glCopyTexSubImage2D: this build has no SPANGLE_FEATURE_COPY_TEXTURE", void GLAPIENTRY glCopyTexSubImage2D(GLenum, GLint, GLint, GLint, GLint, GLint, GLsizei, GLsizei))

#endif

#if !SPANGLE_FEATURE_COPY_TEXTURE

SPANGLE_REFUSED("glCopyTexImage1D: this build has no SPANGLE_FEATURE_COPY_TEXTURE", void GLAPIENTRY glCopyTexImage1D(GLenum, GLint, GLenum, GLint, GLint, GLsizei, GLint))

SPANGLE_REFUSED("glCopyTexSubImage1D: this build has no SPANGLE_FEATURE_COPY_TEXTURE", void GLAPIENTRY glCopyTexSubImage1D(GLenum, GLint, GLint, GLint, GLint, GLsizei))

#endif

#if SPANGLE_FEATURE_COPY_TEXTURE && !SPANGLE_FEATURE_TEXTURE_1D

SPANGLE_REFUSED("glCopyTexImage1D: this build has no SPANGLE_FEATURE_TEXTURE_1D", void GLAPIENTRY glCopyTexImage1D(GLenum, GLint, GLenum, GLint, GLint, GLsizei, GLint))

SPANGLE_REFUSED("glCopyTexSubImage1D: this build has no SPANGLE_FEATURE_TEXTURE_1D", void GLAPIENTRY glCopyTexSubImage1D(GLenum, GLint, GLint, GLint, GLint, GLsizei))

#endif

#if !SPANGLE_FEATURE_COPY_TEXTURE

SPANGLE_REFUSED("glCopyTexSubImage3D: this build has no SPANGLE_FEATURE_COPY_TEXTURE", void GLAPIENTRY glCopyTexSubImage3D(GLenum, GLint, GLint, GLint, GLint, GLint, GLint, GLsizei, GLsizei))

#endif

#if SPANGLE_FEATURE_COPY_TEXTURE && !SPANGLE_FEATURE_TEXTURE_3D

SPANGLE_REFUSED("glCopyTexSubImage3D: this build has no SPANGLE_FEATURE_TEXTURE_3D", void GLAPIENTRY glCopyTexSubImage3D(GLenum, GLint, GLint, GLint, GLint, GLint, GLint, GLsizei, GLsizei))

#endif

#if !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glTexParameterxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexParameterxOES(GLenum, GLenum, GLfixed))

SPANGLE_REFUSED("glTexParameterxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexParameterxvOES(GLenum, GLenum, const GLfixed*))

SPANGLE_REFUSED("glGetTexParameterxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glGetTexParameterxvOES(GLenum, GLenum, GLfixed*))

SPANGLE_REFUSED("glTexEnvxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexEnvxOES(GLenum, GLenum, GLfixed))

SPANGLE_REFUSED("glTexEnvxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexEnvxvOES(GLenum, GLenum, const GLfixed*))

SPANGLE_REFUSED("glGetTexEnvxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glGetTexEnvxvOES(GLenum, GLenum, GLfixed*))

SPANGLE_REFUSED("glGetTexLevelParameterxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glGetTexLevelParameterxvOES(GLenum, GLint, GLenum, GLfixed*))

#endif

#if !SPANGLE_FEATURE_MIPMAP_GENERATION

SPANGLE_REFUSED("glGenerateMipmap: this build has no SPANGLE_FEATURE_MIPMAP_GENERATION", void GLAPIENTRY glGenerateMipmap(GLenum))

#endif

#if !SPANGLE_FEATURE_TEXTURE_1D

SPANGLE_REFUSED("glTexImage1D: this build has no SPANGLE_FEATURE_TEXTURE_1D", void GLAPIENTRY glTexImage1D(GLenum, GLint, GLint, GLsizei, GLint, GLenum, GLenum, const void*))

SPANGLE_REFUSED("glTexSubImage1D: this build has no SPANGLE_FEATURE_TEXTURE_1D", void GLAPIENTRY glTexSubImage1D(GLenum, GLint, GLint, GLsizei, GLenum, GLenum, const void*))

#endif

#if !SPANGLE_FEATURE_TEXTURE_3D

SPANGLE_REFUSED("glTexImage3D: this build has no SPANGLE_FEATURE_TEXTURE_3D", void GLAPIENTRY glTexImage3D(GLenum, GLint, GLint, GLsizei, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*))

SPANGLE_REFUSED("glTexSubImage3D: this build has no SPANGLE_FEATURE_TEXTURE_3D", void GLAPIENTRY glTexSubImage3D(GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei, GLenum, GLenum, const void*))

#endif

} // extern "C"
