// Entry points: Matrices, viewport.
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

void GLAPIENTRY glMatrixMode(GLenum mode) {
    issue<family::MatrixMode>(mode);
}

void GLAPIENTRY glLoadIdentity() {
    issue<family::LoadIdentity>();
}

void GLAPIENTRY glLoadMatrixf(const GLfloat* m) {
    issue_matrix<family::LoadMatrix, convert::Element::cast_f>(m, SPANGLE_TEXT("glLoadMatrixf: null pointer"));
}

void GLAPIENTRY glLoadMatrixd(const GLdouble* m) {
    issue_matrix<family::LoadMatrix, convert::Element::cast_d>(m, SPANGLE_TEXT("glLoadMatrixd: null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glLoadMatrixxOES(const GLfixed* m) {
    issue_matrix<family::LoadMatrix, convert::Element::cast_x>(m, SPANGLE_TEXT("glLoadMatrixxOES: null pointer"));
}

#endif

void GLAPIENTRY glMultMatrixf(const GLfloat* m) {
    issue_matrix<family::MultMatrix, convert::Element::cast_f>(m, SPANGLE_TEXT("glMultMatrixf: null pointer"));
}

void GLAPIENTRY glMultMatrixd(const GLdouble* m) {
    issue_matrix<family::MultMatrix, convert::Element::cast_d>(m, SPANGLE_TEXT("glMultMatrixd: null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMultMatrixxOES(const GLfixed* m) {
    issue_matrix<family::MultMatrix, convert::Element::cast_x>(m, SPANGLE_TEXT("glMultMatrixxOES: null pointer"));
}

#endif

void GLAPIENTRY glLoadTransposeMatrixf(const GLfloat* m) {
    issue_matrix<family::LoadTransposeMatrix, convert::Element::cast_f>(m, SPANGLE_TEXT("glLoadTransposeMatrixf: null pointer"));
}

void GLAPIENTRY glLoadTransposeMatrixd(const GLdouble* m) {
    issue_matrix<family::LoadTransposeMatrix, convert::Element::cast_d>(m, SPANGLE_TEXT("glLoadTransposeMatrixd: null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glLoadTransposeMatrixxOES(const GLfixed* m) {
    issue_matrix<family::LoadTransposeMatrix, convert::Element::cast_x>(m, SPANGLE_TEXT("glLoadTransposeMatrixxOES: null pointer"));
}

#endif

void GLAPIENTRY glMultTransposeMatrixf(const GLfloat* m) {
    issue_matrix<family::MultTransposeMatrix, convert::Element::cast_f>(m, SPANGLE_TEXT("glMultTransposeMatrixf: null pointer"));
}

void GLAPIENTRY glMultTransposeMatrixd(const GLdouble* m) {
    issue_matrix<family::MultTransposeMatrix, convert::Element::cast_d>(m, SPANGLE_TEXT("glMultTransposeMatrixd: null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMultTransposeMatrixxOES(const GLfixed* m) {
    issue_matrix<family::MultTransposeMatrix, convert::Element::cast_x>(m, SPANGLE_TEXT("glMultTransposeMatrixxOES: null pointer"));
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
    if (equation == nullptr)
        return refuse_null(SPANGLE_TEXT("glClipPlane: null pointer"));
    issue<family::ClipPlane>(plane, convert::cast_d(equation[0]), convert::cast_d(equation[1]), convert::cast_d(equation[2]), convert::cast_d(equation[3]));
}

void GLAPIENTRY glClipPlanefOES(GLenum plane, const GLfloat* equation) {
    if (equation == nullptr)
        return refuse_null(SPANGLE_TEXT("glClipPlanefOES: null pointer"));
    issue<family::ClipPlane>(plane, convert::cast_f(equation[0]), convert::cast_f(equation[1]), convert::cast_f(equation[2]), convert::cast_f(equation[3]));
}

#endif

#if SPANGLE_FEATURE_CLIP_PLANES && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glClipPlanexOES(GLenum plane, const GLfixed* equation) {
    if (equation == nullptr)
        return refuse_null(SPANGLE_TEXT("glClipPlanexOES: null pointer"));
    issue<family::ClipPlane>(plane, convert::cast_x(equation[0]), convert::cast_x(equation[1]), convert::cast_x(equation[2]), convert::cast_x(equation[3]));
}

#endif

#if SPANGLE_FEATURE_TEXGEN

void GLAPIENTRY glTexGenf(GLenum coord, GLenum pname, GLfloat param) {
    issue_param<family::TexGen, shape::TexGen>(coord, pname, &param, convert::Number::f);
}

void GLAPIENTRY glTexGenfv(GLenum coord, GLenum pname, const GLfloat* params) {
    issue_params<family::TexGen, shape::TexGen>(coord, pname, params, convert::Number::f, SPANGLE_TEXT("glTexGenfv: null pointer"));
}

void GLAPIENTRY glTexGeni(GLenum coord, GLenum pname, GLint param) {
    issue_param<family::TexGen, shape::TexGen>(coord, pname, &param, convert::Number::i);
}

void GLAPIENTRY glTexGeniv(GLenum coord, GLenum pname, const GLint* params) {
    issue_params<family::TexGen, shape::TexGen>(coord, pname, params, convert::Number::i, SPANGLE_TEXT("glTexGeniv: null pointer"));
}

void GLAPIENTRY glTexGend(GLenum coord, GLenum pname, GLdouble param) {
    issue_param<family::TexGen, shape::TexGen>(coord, pname, &param, convert::Number::d);
}

void GLAPIENTRY glTexGendv(GLenum coord, GLenum pname, const GLdouble* params) {
    issue_params<family::TexGen, shape::TexGen>(coord, pname, params, convert::Number::d, SPANGLE_TEXT("glTexGendv: null pointer"));
}

#endif

#if SPANGLE_FEATURE_TEXGEN && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexGenxOES(GLenum coord, GLenum pname, GLfixed param) {
    issue_param<family::TexGen, shape::TexGen>(coord, pname, &param, convert::Number::x);
}

void GLAPIENTRY glTexGenxvOES(GLenum coord, GLenum pname, const GLfixed* params) {
    issue_params<family::TexGen, shape::TexGen>(coord, pname, params, convert::Number::x, SPANGLE_TEXT("glTexGenxvOES: null pointer"));
}

#endif

#if SPANGLE_FEATURE_TEXGEN

void GLAPIENTRY glGetTexGenfv(GLenum coord, GLenum pname, GLfloat* params) {
    fetch_params<family::GetTexGen, shape::GetTexGen>(coord, pname, params, convert::Number::f, SPANGLE_TEXT("glGetTexGenfv: null pointer"));
}

void GLAPIENTRY glGetTexGeniv(GLenum coord, GLenum pname, GLint* params) {
    fetch_params<family::GetTexGen, shape::GetTexGen>(coord, pname, params, convert::Number::i, SPANGLE_TEXT("glGetTexGeniv: null pointer"));
}

void GLAPIENTRY glGetTexGendv(GLenum coord, GLenum pname, GLdouble* params) {
    fetch_params<family::GetTexGen, shape::GetTexGen>(coord, pname, params, convert::Number::d, SPANGLE_TEXT("glGetTexGendv: null pointer"));
}

#endif

#if SPANGLE_FEATURE_TEXGEN && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetTexGenxvOES(GLenum coord, GLenum pname, GLfixed* params) {
    fetch_params<family::GetTexGen, shape::GetTexGen>(coord, pname, params, convert::Number::x, SPANGLE_TEXT("glGetTexGenxvOES: null pointer"));
}

#endif

#if SPANGLE_FEATURE_CLIP_PLANES

void GLAPIENTRY glGetClipPlane(GLenum plane, GLdouble* equation) {
    issue<family::GetClipPlane>(plane, equation);
}

#endif

#if !SPANGLE_FEATURE_CLIP_PLANES

void GLAPIENTRY glClipPlane(GLenum, const GLdouble*) {
    refuse_feature(SPANGLE_TEXT("glClipPlane: this build has no SPANGLE_FEATURE_CLIP_PLANES"));
}

void GLAPIENTRY glClipPlanefOES(GLenum, const GLfloat*) {
    refuse_feature(SPANGLE_TEXT("glClipPlanefOES: this build has no SPANGLE_FEATURE_CLIP_PLANES"));
}

void GLAPIENTRY glGetClipPlane(GLenum, GLdouble*) {
    refuse_feature(SPANGLE_TEXT("glGetClipPlane: this build has no SPANGLE_FEATURE_CLIP_PLANES"));
}

#endif

#if !SPANGLE_FEATURE_CLIP_PLANES

void GLAPIENTRY glClipPlanexOES(GLenum, const GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glClipPlanexOES: this build has no SPANGLE_FEATURE_CLIP_PLANES"));
}

#endif

#if SPANGLE_FEATURE_CLIP_PLANES && !SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glClipPlanexOES(GLenum, const GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glClipPlanexOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

#endif

#if !SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glLoadMatrixxOES(const GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glLoadMatrixxOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glMultMatrixxOES(const GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glMultMatrixxOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glLoadTransposeMatrixxOES(const GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glLoadTransposeMatrixxOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glMultTransposeMatrixxOES(const GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glMultTransposeMatrixxOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glRotatexOES(GLfixed, GLfixed, GLfixed, GLfixed) {
    refuse_feature(SPANGLE_TEXT("glRotatexOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glTranslatexOES(GLfixed, GLfixed, GLfixed) {
    refuse_feature(SPANGLE_TEXT("glTranslatexOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glScalexOES(GLfixed, GLfixed, GLfixed) {
    refuse_feature(SPANGLE_TEXT("glScalexOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glFrustumxOES(GLfixed, GLfixed, GLfixed, GLfixed, GLfixed, GLfixed) {
    refuse_feature(SPANGLE_TEXT("glFrustumxOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glOrthoxOES(GLfixed, GLfixed, GLfixed, GLfixed, GLfixed, GLfixed) {
    refuse_feature(SPANGLE_TEXT("glOrthoxOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glDepthRangexOES(GLclampx, GLclampx) {
    refuse_feature(SPANGLE_TEXT("glDepthRangexOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

#endif

#if !SPANGLE_FEATURE_TEXGEN

void GLAPIENTRY glTexGenf(GLenum, GLenum, GLfloat) {
    refuse_feature(SPANGLE_TEXT("glTexGenf: this build has no SPANGLE_FEATURE_TEXGEN"));
}

void GLAPIENTRY glTexGenfv(GLenum, GLenum, const GLfloat*) {
    refuse_feature(SPANGLE_TEXT("glTexGenfv: this build has no SPANGLE_FEATURE_TEXGEN"));
}

void GLAPIENTRY glTexGeni(GLenum, GLenum, GLint) {
    refuse_feature(SPANGLE_TEXT("glTexGeni: this build has no SPANGLE_FEATURE_TEXGEN"));
}

void GLAPIENTRY glTexGeniv(GLenum, GLenum, const GLint*) {
    refuse_feature(SPANGLE_TEXT("glTexGeniv: this build has no SPANGLE_FEATURE_TEXGEN"));
}

void GLAPIENTRY glTexGend(GLenum, GLenum, GLdouble) {
    refuse_feature(SPANGLE_TEXT("glTexGend: this build has no SPANGLE_FEATURE_TEXGEN"));
}

void GLAPIENTRY glTexGendv(GLenum, GLenum, const GLdouble*) {
    refuse_feature(SPANGLE_TEXT("glTexGendv: this build has no SPANGLE_FEATURE_TEXGEN"));
}

void GLAPIENTRY glGetTexGenfv(GLenum, GLenum, GLfloat*) {
    refuse_feature(SPANGLE_TEXT("glGetTexGenfv: this build has no SPANGLE_FEATURE_TEXGEN"));
}

void GLAPIENTRY glGetTexGeniv(GLenum, GLenum, GLint*) {
    refuse_feature(SPANGLE_TEXT("glGetTexGeniv: this build has no SPANGLE_FEATURE_TEXGEN"));
}

void GLAPIENTRY glGetTexGendv(GLenum, GLenum, GLdouble*) {
    refuse_feature(SPANGLE_TEXT("glGetTexGendv: this build has no SPANGLE_FEATURE_TEXGEN"));
}

#endif

#if !SPANGLE_FEATURE_TEXGEN

void GLAPIENTRY glTexGenxOES(GLenum, GLenum, GLfixed) {
    refuse_feature(SPANGLE_TEXT("glTexGenxOES: this build has no SPANGLE_FEATURE_TEXGEN"));
}

void GLAPIENTRY glTexGenxvOES(GLenum, GLenum, const GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glTexGenxvOES: this build has no SPANGLE_FEATURE_TEXGEN"));
}

void GLAPIENTRY glGetTexGenxvOES(GLenum, GLenum, GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glGetTexGenxvOES: this build has no SPANGLE_FEATURE_TEXGEN"));
}

#endif

#if SPANGLE_FEATURE_TEXGEN && !SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexGenxOES(GLenum, GLenum, GLfixed) {
    refuse_feature(SPANGLE_TEXT("glTexGenxOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glTexGenxvOES(GLenum, GLenum, const GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glTexGenxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

void GLAPIENTRY glGetTexGenxvOES(GLenum, GLenum, GLfixed*) {
    refuse_feature(SPANGLE_TEXT("glGetTexGenxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT"));
}

#endif

} // extern "C"
