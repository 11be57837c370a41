// Entry points: Matrices, viewport.
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

void GLAPIENTRY glMatrixMode(GLenum mode) {
    issue<family::MatrixMode>(mode);
}

void GLAPIENTRY glLoadIdentity() {
    issue<family::LoadIdentity>();
}

void GLAPIENTRY glLoadMatrixf(const GLfloat* m) {
    issue_matrix<family::LoadMatrix, convert::Element::cast_f>(m, SPANGLE_TEXT("glLoadMatrixf: m is a null pointer"));
}

void GLAPIENTRY glLoadMatrixd(const GLdouble* m) {
    issue_matrix<family::LoadMatrix, convert::Element::cast_d>(m, SPANGLE_TEXT("glLoadMatrixd: m is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glLoadMatrixxOES(const GLfixed* m) {
    issue_matrix<family::LoadMatrix, convert::Element::cast_x>(m, SPANGLE_TEXT("glLoadMatrixxOES: m is a null pointer"));
}

#endif

void GLAPIENTRY glMultMatrixf(const GLfloat* m) {
    issue_matrix<family::MultMatrix, convert::Element::cast_f>(m, SPANGLE_TEXT("glMultMatrixf: m is a null pointer"));
}

void GLAPIENTRY glMultMatrixd(const GLdouble* m) {
    issue_matrix<family::MultMatrix, convert::Element::cast_d>(m, SPANGLE_TEXT("glMultMatrixd: m is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMultMatrixxOES(const GLfixed* m) {
    issue_matrix<family::MultMatrix, convert::Element::cast_x>(m, SPANGLE_TEXT("glMultMatrixxOES: m is a null pointer"));
}

#endif

void GLAPIENTRY glLoadTransposeMatrixf(const GLfloat* m) {
    issue_matrix<family::LoadTransposeMatrix, convert::Element::cast_f>(m, SPANGLE_TEXT("glLoadTransposeMatrixf: m is a null pointer"));
}

void GLAPIENTRY glLoadTransposeMatrixd(const GLdouble* m) {
    issue_matrix<family::LoadTransposeMatrix, convert::Element::cast_d>(m, SPANGLE_TEXT("glLoadTransposeMatrixd: m is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glLoadTransposeMatrixxOES(const GLfixed* m) {
    issue_matrix<family::LoadTransposeMatrix, convert::Element::cast_x>(m, SPANGLE_TEXT("glLoadTransposeMatrixxOES: m is a null pointer"));
}

#endif

void GLAPIENTRY glMultTransposeMatrixf(const GLfloat* m) {
    issue_matrix<family::MultTransposeMatrix, convert::Element::cast_f>(m, SPANGLE_TEXT("glMultTransposeMatrixf: m is a null pointer"));
}

void GLAPIENTRY glMultTransposeMatrixd(const GLdouble* m) {
    issue_matrix<family::MultTransposeMatrix, convert::Element::cast_d>(m, SPANGLE_TEXT("glMultTransposeMatrixd: m is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMultTransposeMatrixxOES(const GLfixed* m) {
    issue_matrix<family::MultTransposeMatrix, convert::Element::cast_x>(m, SPANGLE_TEXT("glMultTransposeMatrixxOES: m is a null pointer"));
}

#endif

void GLAPIENTRY glPushMatrix() {
    issue<family::PushMatrix>();
}

void GLAPIENTRY glPopMatrix() {
    issue<family::PopMatrix>();
}

void GLAPIENTRY glRotatef(GLfloat angle, GLfloat x, GLfloat y, GLfloat z) {
    const GLfloat given[] = {angle, x, y, z};
    issue_reals<family::Rotate, convert::Element::cast_f, 4>(given, nullptr);
}

void GLAPIENTRY glRotated(GLdouble angle, GLdouble x, GLdouble y, GLdouble z) {
    const GLdouble given[] = {angle, x, y, z};
    issue_reals<family::Rotate, convert::Element::cast_d, 4>(given, nullptr);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glRotatexOES(GLfixed angle, GLfixed x, GLfixed y, GLfixed z) {
    const GLfixed given[] = {angle, x, y, z};
    issue_reals<family::Rotate, convert::Element::cast_x, 4>(given, nullptr);
}

#endif

void GLAPIENTRY glTranslatef(GLfloat x, GLfloat y, GLfloat z) {
    const GLfloat given[] = {x, y, z};
    issue_reals<family::Translate, convert::Element::cast_f, 3>(given, nullptr);
}

void GLAPIENTRY glTranslated(GLdouble x, GLdouble y, GLdouble z) {
    const GLdouble given[] = {x, y, z};
    issue_reals<family::Translate, convert::Element::cast_d, 3>(given, nullptr);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTranslatexOES(GLfixed x, GLfixed y, GLfixed z) {
    const GLfixed given[] = {x, y, z};
    issue_reals<family::Translate, convert::Element::cast_x, 3>(given, nullptr);
}

#endif

void GLAPIENTRY glScalef(GLfloat x, GLfloat y, GLfloat z) {
    const GLfloat given[] = {x, y, z};
    issue_reals<family::Scale, convert::Element::cast_f, 3>(given, nullptr);
}

void GLAPIENTRY glScaled(GLdouble x, GLdouble y, GLdouble z) {
    const GLdouble given[] = {x, y, z};
    issue_reals<family::Scale, convert::Element::cast_d, 3>(given, nullptr);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glScalexOES(GLfixed x, GLfixed y, GLfixed z) {
    const GLfixed given[] = {x, y, z};
    issue_reals<family::Scale, convert::Element::cast_x, 3>(given, nullptr);
}

#endif

void GLAPIENTRY glFrustum(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble near_val, GLdouble far_val) {
    const GLdouble given[] = {left, right, bottom, top, near_val, far_val};
    issue_reals<family::Frustum, convert::Element::cast_d, 6>(given, nullptr);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glFrustumxOES(GLfixed left, GLfixed right, GLfixed bottom, GLfixed top, GLfixed near_val, GLfixed far_val) {
    const GLfixed given[] = {left, right, bottom, top, near_val, far_val};
    issue_reals<family::Frustum, convert::Element::cast_x, 6>(given, nullptr);
}

#endif

void GLAPIENTRY glOrtho(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble near_val, GLdouble far_val) {
    const GLdouble given[] = {left, right, bottom, top, near_val, far_val};
    issue_reals<family::Ortho, convert::Element::cast_d, 6>(given, nullptr);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glOrthoxOES(GLfixed left, GLfixed right, GLfixed bottom, GLfixed top, GLfixed near_val, GLfixed far_val) {
    const GLfixed given[] = {left, right, bottom, top, near_val, far_val};
    issue_reals<family::Ortho, convert::Element::cast_x, 6>(given, nullptr);
}

#endif

void GLAPIENTRY glViewport(GLint x, GLint y, GLsizei width, GLsizei height) {
    issue<family::Viewport>(x, y, width, height);
}

void GLAPIENTRY glDepthRange(GLclampd near_val, GLclampd far_val) {
    const GLclampd given[] = {near_val, far_val};
    issue_reals<family::DepthRange, convert::Element::cast_d, 2>(given, nullptr);
}

void GLAPIENTRY glDepthRangef(GLclampf near_val, GLclampf far_val) {
    const GLclampf given[] = {near_val, far_val};
    issue_reals<family::DepthRange, convert::Element::cast_f, 2>(given, nullptr);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glDepthRangexOES(GLclampx near_val, GLclampx far_val) {
    const GLclampx given[] = {near_val, far_val};
    issue_reals<family::DepthRange, convert::Element::cast_x, 2>(given, nullptr);
}

#endif

#if SPANGLE_FEATURE_CLIP_PLANES

void GLAPIENTRY glClipPlane(GLenum plane, const GLdouble* equation) {
    issue_components<family::ClipPlane>(plane, equation, convert::components(convert::Element::cast_d, 4), SPANGLE_TEXT("glClipPlane: equation is a null pointer"));
}

void GLAPIENTRY glClipPlanefOES(GLenum plane, const GLfloat* equation) {
    issue_components<family::ClipPlane>(plane, equation, convert::components(convert::Element::cast_f, 4), SPANGLE_TEXT("glClipPlanefOES: equation is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_CLIP_PLANES && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glClipPlanexOES(GLenum plane, const GLfixed* equation) {
    issue_components<family::ClipPlane>(plane, equation, convert::components(convert::Element::cast_x, 4), SPANGLE_TEXT("glClipPlanexOES: equation is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_TEXGEN

void GLAPIENTRY glTexGenf(GLenum coord, GLenum pname, GLfloat param) {
    issue_param<family::TexGen, shape::TexGen>(coord, pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glTexGenfv(GLenum coord, GLenum pname, const GLfloat* params) {
    issue_params<family::TexGen, shape::TexGen>(coord, pname, params, convert::Number::f, SPANGLE_TEXT("glTexGenfv: params is a null pointer"));
}

void GLAPIENTRY glTexGeni(GLenum coord, GLenum pname, GLint param) {
    issue_param<family::TexGen, shape::TexGen>(coord, pname, convert::word(param), convert::Number::i);
}

void GLAPIENTRY glTexGeniv(GLenum coord, GLenum pname, const GLint* params) {
    issue_params<family::TexGen, shape::TexGen>(coord, pname, params, convert::Number::i, SPANGLE_TEXT("glTexGeniv: params is a null pointer"));
}

void GLAPIENTRY glTexGend(GLenum coord, GLenum pname, GLdouble param) {
    issue_param<family::TexGen, shape::TexGen>(coord, pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glTexGendv(GLenum coord, GLenum pname, const GLdouble* params) {
    issue_params<family::TexGen, shape::TexGen>(coord, pname, params, convert::Number::d, SPANGLE_TEXT("glTexGendv: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_TEXGEN && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexGenxOES(GLenum coord, GLenum pname, GLfixed param) {
    issue_param<family::TexGen, shape::TexGen>(coord, pname, convert::word(param), convert::Number::x);
}

void GLAPIENTRY glTexGenxvOES(GLenum coord, GLenum pname, const GLfixed* params) {
    issue_params<family::TexGen, shape::TexGen>(coord, pname, params, convert::Number::x, SPANGLE_TEXT("glTexGenxvOES: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_TEXGEN

void GLAPIENTRY glGetTexGenfv(GLenum coord, GLenum pname, GLfloat* params) {
    fetch_params<family::GetTexGen, shape::GetTexGen>(coord, pname, params, convert::Number::f, SPANGLE_TEXT("glGetTexGenfv: params is a null pointer"));
}

void GLAPIENTRY glGetTexGeniv(GLenum coord, GLenum pname, GLint* params) {
    fetch_params<family::GetTexGen, shape::GetTexGen>(coord, pname, params, convert::Number::i, SPANGLE_TEXT("glGetTexGeniv: params is a null pointer"));
}

void GLAPIENTRY glGetTexGendv(GLenum coord, GLenum pname, GLdouble* params) {
    fetch_params<family::GetTexGen, shape::GetTexGen>(coord, pname, params, convert::Number::d, SPANGLE_TEXT("glGetTexGendv: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_TEXGEN && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetTexGenxvOES(GLenum coord, GLenum pname, GLfixed* params) {
    fetch_params<family::GetTexGen, shape::GetTexGen>(coord, pname, params, convert::Number::x, SPANGLE_TEXT("glGetTexGenxvOES: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_CLIP_PLANES

void GLAPIENTRY glGetClipPlane(GLenum plane, GLdouble* equation) {
    issue<family::GetClipPlane>(plane, equation);
}

#endif

#if !SPANGLE_FEATURE_CLIP_PLANES

SPANGLE_REFUSED("glClipPlane: this build has no SPANGLE_FEATURE_CLIP_PLANES", void GLAPIENTRY glClipPlane(GLenum, const GLdouble*))

SPANGLE_REFUSED("glClipPlanefOES: this build has no SPANGLE_FEATURE_CLIP_PLANES", void GLAPIENTRY glClipPlanefOES(GLenum, const GLfloat*))

SPANGLE_REFUSED("glGetClipPlane: this build has no SPANGLE_FEATURE_CLIP_PLANES", void GLAPIENTRY glGetClipPlane(GLenum, GLdouble*))

#endif

#if !SPANGLE_FEATURE_CLIP_PLANES

SPANGLE_REFUSED("glClipPlanexOES: this build has no SPANGLE_FEATURE_CLIP_PLANES", void GLAPIENTRY glClipPlanexOES(GLenum, const GLfixed*))

#endif

#if SPANGLE_FEATURE_CLIP_PLANES && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glClipPlanexOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glClipPlanexOES(GLenum, const GLfixed*))

#endif

#if !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glLoadMatrixxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glLoadMatrixxOES(const GLfixed*))

SPANGLE_REFUSED("glMultMatrixxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMultMatrixxOES(const GLfixed*))

SPANGLE_REFUSED("glLoadTransposeMatrixxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glLoadTransposeMatrixxOES(const GLfixed*))

SPANGLE_REFUSED("glMultTransposeMatrixxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMultTransposeMatrixxOES(const GLfixed*))

SPANGLE_REFUSED("glRotatexOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glRotatexOES(GLfixed, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glTranslatexOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTranslatexOES(GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glScalexOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glScalexOES(GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glFrustumxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glFrustumxOES(GLfixed, GLfixed, GLfixed, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glOrthoxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glOrthoxOES(GLfixed, GLfixed, GLfixed, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glDepthRangexOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glDepthRangexOES(GLclampx, GLclampx))

#endif

#if !SPANGLE_FEATURE_TEXGEN

SPANGLE_REFUSED("glTexGenf: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glTexGenf(GLenum, GLenum, GLfloat))

SPANGLE_REFUSED("glTexGenfv: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glTexGenfv(GLenum, GLenum, const GLfloat*))

SPANGLE_REFUSED("glTexGeni: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glTexGeni(GLenum, GLenum, GLint))

SPANGLE_REFUSED("glTexGeniv: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glTexGeniv(GLenum, GLenum, const GLint*))

SPANGLE_REFUSED("glTexGend: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glTexGend(GLenum, GLenum, GLdouble))

SPANGLE_REFUSED("glTexGendv: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glTexGendv(GLenum, GLenum, const GLdouble*))

SPANGLE_REFUSED("glGetTexGenfv: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glGetTexGenfv(GLenum, GLenum, GLfloat*))

SPANGLE_REFUSED("glGetTexGeniv: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glGetTexGeniv(GLenum, GLenum, GLint*))

SPANGLE_REFUSED("glGetTexGendv: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glGetTexGendv(GLenum, GLenum, GLdouble*))

#endif

#if !SPANGLE_FEATURE_TEXGEN

SPANGLE_REFUSED("glTexGenxOES: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glTexGenxOES(GLenum, GLenum, GLfixed))

SPANGLE_REFUSED("glTexGenxvOES: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glTexGenxvOES(GLenum, GLenum, const GLfixed*))

SPANGLE_REFUSED("glGetTexGenxvOES: this build has no SPANGLE_FEATURE_TEXGEN", void GLAPIENTRY glGetTexGenxvOES(GLenum, GLenum, GLfixed*))

#endif

#if SPANGLE_FEATURE_TEXGEN && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glTexGenxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexGenxOES(GLenum, GLenum, GLfixed))

SPANGLE_REFUSED("glTexGenxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexGenxvOES(GLenum, GLenum, const GLfixed*))

SPANGLE_REFUSED("glGetTexGenxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glGetTexGenxvOES(GLenum, GLenum, GLfixed*))

#endif

} // extern "C"
