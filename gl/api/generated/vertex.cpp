// Entry points: Vertices, attributes, arrays.
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

void GLAPIENTRY glBegin(GLenum mode) {
    issue<family::Begin>(mode);
}

void GLAPIENTRY glEnd() {
    issue<family::End>();
}

void GLAPIENTRY glVertex2s(GLshort x, GLshort y) {
    const GLint given[] = {x, y};
    issue_components<family::Vertex>(given, convert::components(convert::Element::cast_i, 2), nullptr);
}

void GLAPIENTRY glVertex2sv(const GLshort* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_s, 2), SPANGLE_TEXT("glVertex2sv: v is a null pointer"));
}

void GLAPIENTRY glVertex2i(GLint x, GLint y) {
    const GLint given[] = {x, y};
    issue_reals<family::Vertex, convert::Element::cast_i, 2>(given, nullptr);
}

void GLAPIENTRY glVertex2iv(const GLint* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_i, 2), SPANGLE_TEXT("glVertex2iv: v is a null pointer"));
}

void GLAPIENTRY glVertex2f(GLfloat x, GLfloat y) {
    const GLfloat given[] = {x, y};
    issue_reals<family::Vertex, convert::Element::cast_f, 2>(given, nullptr);
}

void GLAPIENTRY glVertex2fv(const GLfloat* v) {
    issue_reals<family::Vertex, convert::Element::cast_f, 2>(v, SPANGLE_TEXT("glVertex2fv: v is a null pointer"));
}

void GLAPIENTRY glVertex2d(GLdouble x, GLdouble y) {
    const GLdouble given[] = {x, y};
    issue_components<family::Vertex>(given, convert::components(convert::Element::cast_d, 2), nullptr);
}

void GLAPIENTRY glVertex2dv(const GLdouble* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_d, 2), SPANGLE_TEXT("glVertex2dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glVertex2xOES(GLfixed x, GLfixed y) {
    const GLfixed given[] = {x, y};
    issue_components<family::Vertex>(given, convert::components(convert::Element::cast_x, 2), nullptr);
}

void GLAPIENTRY glVertex2xvOES(const GLfixed* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_x, 2), SPANGLE_TEXT("glVertex2xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glVertex3s(GLshort x, GLshort y, GLshort z) {
    const GLint given[] = {x, y, z};
    issue_components<family::Vertex>(given, convert::components(convert::Element::cast_i, 3), nullptr);
}

void GLAPIENTRY glVertex3sv(const GLshort* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_s, 3), SPANGLE_TEXT("glVertex3sv: v is a null pointer"));
}

void GLAPIENTRY glVertex3i(GLint x, GLint y, GLint z) {
    const GLint given[] = {x, y, z};
    issue_reals<family::Vertex, convert::Element::cast_i, 3>(given, nullptr);
}

void GLAPIENTRY glVertex3iv(const GLint* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_i, 3), SPANGLE_TEXT("glVertex3iv: v is a null pointer"));
}

void GLAPIENTRY glVertex3f(GLfloat x, GLfloat y, GLfloat z) {
    const GLfloat given[] = {x, y, z};
    issue_reals<family::Vertex, convert::Element::cast_f, 3>(given, nullptr);
}

void GLAPIENTRY glVertex3fv(const GLfloat* v) {
    issue_reals<family::Vertex, convert::Element::cast_f, 3>(v, SPANGLE_TEXT("glVertex3fv: v is a null pointer"));
}

void GLAPIENTRY glVertex3d(GLdouble x, GLdouble y, GLdouble z) {
    const GLdouble given[] = {x, y, z};
    issue_components<family::Vertex>(given, convert::components(convert::Element::cast_d, 3), nullptr);
}

void GLAPIENTRY glVertex3dv(const GLdouble* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_d, 3), SPANGLE_TEXT("glVertex3dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glVertex3xOES(GLfixed x, GLfixed y, GLfixed z) {
    const GLfixed given[] = {x, y, z};
    issue_components<family::Vertex>(given, convert::components(convert::Element::cast_x, 3), nullptr);
}

void GLAPIENTRY glVertex3xvOES(const GLfixed* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_x, 3), SPANGLE_TEXT("glVertex3xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glVertex4s(GLshort x, GLshort y, GLshort z, GLshort w) {
    const GLint given[] = {x, y, z, w};
    issue_components<family::Vertex>(given, convert::components(convert::Element::cast_i, 4), nullptr);
}

void GLAPIENTRY glVertex4sv(const GLshort* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_s, 4), SPANGLE_TEXT("glVertex4sv: v is a null pointer"));
}

void GLAPIENTRY glVertex4i(GLint x, GLint y, GLint z, GLint w) {
    const GLint given[] = {x, y, z, w};
    issue_reals<family::Vertex, convert::Element::cast_i, 4>(given, nullptr);
}

void GLAPIENTRY glVertex4iv(const GLint* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_i, 4), SPANGLE_TEXT("glVertex4iv: v is a null pointer"));
}

void GLAPIENTRY glVertex4f(GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
    const GLfloat given[] = {x, y, z, w};
    issue_reals<family::Vertex, convert::Element::cast_f, 4>(given, nullptr);
}

void GLAPIENTRY glVertex4fv(const GLfloat* v) {
    issue_reals<family::Vertex, convert::Element::cast_f, 4>(v, SPANGLE_TEXT("glVertex4fv: v is a null pointer"));
}

void GLAPIENTRY glVertex4d(GLdouble x, GLdouble y, GLdouble z, GLdouble w) {
    const GLdouble given[] = {x, y, z, w};
    issue_components<family::Vertex>(given, convert::components(convert::Element::cast_d, 4), nullptr);
}

void GLAPIENTRY glVertex4dv(const GLdouble* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_d, 4), SPANGLE_TEXT("glVertex4dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glVertex4xOES(GLfixed x, GLfixed y, GLfixed z, GLfixed w) {
    const GLfixed given[] = {x, y, z, w};
    issue_components<family::Vertex>(given, convert::components(convert::Element::cast_x, 4), nullptr);
}

void GLAPIENTRY glVertex4xvOES(const GLfixed* v) {
    issue_components<family::Vertex>(v, convert::components(convert::Element::cast_x, 4), SPANGLE_TEXT("glVertex4xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glTexCoord1s(GLshort s) {
    const GLint given[] = {s};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_i, 1), nullptr);
}

void GLAPIENTRY glTexCoord1sv(const GLshort* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_s, 1), SPANGLE_TEXT("glTexCoord1sv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord1i(GLint s) {
    const GLint given[] = {s};
    issue_reals<family::TexCoord, convert::Element::cast_i, 1>(given, nullptr);
}

void GLAPIENTRY glTexCoord1iv(const GLint* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_i, 1), SPANGLE_TEXT("glTexCoord1iv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord1f(GLfloat s) {
    const GLfloat given[] = {s};
    issue_reals<family::TexCoord, convert::Element::cast_f, 1>(given, nullptr);
}

void GLAPIENTRY glTexCoord1fv(const GLfloat* v) {
    issue_reals<family::TexCoord, convert::Element::cast_f, 1>(v, SPANGLE_TEXT("glTexCoord1fv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord1d(GLdouble s) {
    const GLdouble given[] = {s};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_d, 1), nullptr);
}

void GLAPIENTRY glTexCoord1dv(const GLdouble* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_d, 1), SPANGLE_TEXT("glTexCoord1dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexCoord1xOES(GLfixed s) {
    const GLfixed given[] = {s};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_x, 1), nullptr);
}

void GLAPIENTRY glTexCoord1xvOES(const GLfixed* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_x, 1), SPANGLE_TEXT("glTexCoord1xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glTexCoord2s(GLshort s, GLshort t) {
    const GLint given[] = {s, t};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_i, 2), nullptr);
}

void GLAPIENTRY glTexCoord2sv(const GLshort* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_s, 2), SPANGLE_TEXT("glTexCoord2sv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord2i(GLint s, GLint t) {
    const GLint given[] = {s, t};
    issue_reals<family::TexCoord, convert::Element::cast_i, 2>(given, nullptr);
}

void GLAPIENTRY glTexCoord2iv(const GLint* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_i, 2), SPANGLE_TEXT("glTexCoord2iv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord2f(GLfloat s, GLfloat t) {
    const GLfloat given[] = {s, t};
    issue_reals<family::TexCoord, convert::Element::cast_f, 2>(given, nullptr);
}

void GLAPIENTRY glTexCoord2fv(const GLfloat* v) {
    issue_reals<family::TexCoord, convert::Element::cast_f, 2>(v, SPANGLE_TEXT("glTexCoord2fv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord2d(GLdouble s, GLdouble t) {
    const GLdouble given[] = {s, t};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_d, 2), nullptr);
}

void GLAPIENTRY glTexCoord2dv(const GLdouble* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_d, 2), SPANGLE_TEXT("glTexCoord2dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexCoord2xOES(GLfixed s, GLfixed t) {
    const GLfixed given[] = {s, t};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_x, 2), nullptr);
}

void GLAPIENTRY glTexCoord2xvOES(const GLfixed* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_x, 2), SPANGLE_TEXT("glTexCoord2xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glTexCoord3s(GLshort s, GLshort t, GLshort r) {
    const GLint given[] = {s, t, r};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_i, 3), nullptr);
}

void GLAPIENTRY glTexCoord3sv(const GLshort* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_s, 3), SPANGLE_TEXT("glTexCoord3sv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord3i(GLint s, GLint t, GLint r) {
    const GLint given[] = {s, t, r};
    issue_reals<family::TexCoord, convert::Element::cast_i, 3>(given, nullptr);
}

void GLAPIENTRY glTexCoord3iv(const GLint* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_i, 3), SPANGLE_TEXT("glTexCoord3iv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord3f(GLfloat s, GLfloat t, GLfloat r) {
    const GLfloat given[] = {s, t, r};
    issue_reals<family::TexCoord, convert::Element::cast_f, 3>(given, nullptr);
}

void GLAPIENTRY glTexCoord3fv(const GLfloat* v) {
    issue_reals<family::TexCoord, convert::Element::cast_f, 3>(v, SPANGLE_TEXT("glTexCoord3fv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord3d(GLdouble s, GLdouble t, GLdouble r) {
    const GLdouble given[] = {s, t, r};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_d, 3), nullptr);
}

void GLAPIENTRY glTexCoord3dv(const GLdouble* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_d, 3), SPANGLE_TEXT("glTexCoord3dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexCoord3xOES(GLfixed s, GLfixed t, GLfixed r) {
    const GLfixed given[] = {s, t, r};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_x, 3), nullptr);
}

void GLAPIENTRY glTexCoord3xvOES(const GLfixed* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_x, 3), SPANGLE_TEXT("glTexCoord3xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glTexCoord4s(GLshort s, GLshort t, GLshort r, GLshort q) {
    const GLint given[] = {s, t, r, q};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_i, 4), nullptr);
}

void GLAPIENTRY glTexCoord4sv(const GLshort* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_s, 4), SPANGLE_TEXT("glTexCoord4sv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord4i(GLint s, GLint t, GLint r, GLint q) {
    const GLint given[] = {s, t, r, q};
    issue_reals<family::TexCoord, convert::Element::cast_i, 4>(given, nullptr);
}

void GLAPIENTRY glTexCoord4iv(const GLint* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_i, 4), SPANGLE_TEXT("glTexCoord4iv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord4f(GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
    const GLfloat given[] = {s, t, r, q};
    issue_reals<family::TexCoord, convert::Element::cast_f, 4>(given, nullptr);
}

void GLAPIENTRY glTexCoord4fv(const GLfloat* v) {
    issue_reals<family::TexCoord, convert::Element::cast_f, 4>(v, SPANGLE_TEXT("glTexCoord4fv: v is a null pointer"));
}

void GLAPIENTRY glTexCoord4d(GLdouble s, GLdouble t, GLdouble r, GLdouble q) {
    const GLdouble given[] = {s, t, r, q};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_d, 4), nullptr);
}

void GLAPIENTRY glTexCoord4dv(const GLdouble* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_d, 4), SPANGLE_TEXT("glTexCoord4dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glTexCoord4xOES(GLfixed s, GLfixed t, GLfixed r, GLfixed q) {
    const GLfixed given[] = {s, t, r, q};
    issue_components<family::TexCoord>(given, convert::components(convert::Element::cast_x, 4), nullptr);
}

void GLAPIENTRY glTexCoord4xvOES(const GLfixed* v) {
    issue_components<family::TexCoord>(v, convert::components(convert::Element::cast_x, 4), SPANGLE_TEXT("glTexCoord4xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glMultiTexCoord1s(GLenum target, GLshort s) {
    const GLint given[] = {s};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_i, 1), nullptr);
}

void GLAPIENTRY glMultiTexCoord1sv(GLenum target, const GLshort* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_s, 1), SPANGLE_TEXT("glMultiTexCoord1sv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord1i(GLenum target, GLint s) {
    const GLint given[] = {s};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_i, 1), nullptr);
}

void GLAPIENTRY glMultiTexCoord1iv(GLenum target, const GLint* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_i, 1), SPANGLE_TEXT("glMultiTexCoord1iv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord1f(GLenum target, GLfloat s) {
    const GLfloat given[] = {s};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_f, 1), nullptr);
}

void GLAPIENTRY glMultiTexCoord1fv(GLenum target, const GLfloat* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_f, 1), SPANGLE_TEXT("glMultiTexCoord1fv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord1d(GLenum target, GLdouble s) {
    const GLdouble given[] = {s};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_d, 1), nullptr);
}

void GLAPIENTRY glMultiTexCoord1dv(GLenum target, const GLdouble* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_d, 1), SPANGLE_TEXT("glMultiTexCoord1dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMultiTexCoord1xOES(GLenum target, GLfixed s) {
    const GLfixed given[] = {s};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_x, 1), nullptr);
}

void GLAPIENTRY glMultiTexCoord1xvOES(GLenum target, const GLfixed* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_x, 1), SPANGLE_TEXT("glMultiTexCoord1xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glMultiTexCoord2s(GLenum target, GLshort s, GLshort t) {
    const GLint given[] = {s, t};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_i, 2), nullptr);
}

void GLAPIENTRY glMultiTexCoord2sv(GLenum target, const GLshort* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_s, 2), SPANGLE_TEXT("glMultiTexCoord2sv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord2i(GLenum target, GLint s, GLint t) {
    const GLint given[] = {s, t};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_i, 2), nullptr);
}

void GLAPIENTRY glMultiTexCoord2iv(GLenum target, const GLint* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_i, 2), SPANGLE_TEXT("glMultiTexCoord2iv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord2f(GLenum target, GLfloat s, GLfloat t) {
    const GLfloat given[] = {s, t};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_f, 2), nullptr);
}

void GLAPIENTRY glMultiTexCoord2fv(GLenum target, const GLfloat* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_f, 2), SPANGLE_TEXT("glMultiTexCoord2fv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord2d(GLenum target, GLdouble s, GLdouble t) {
    const GLdouble given[] = {s, t};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_d, 2), nullptr);
}

void GLAPIENTRY glMultiTexCoord2dv(GLenum target, const GLdouble* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_d, 2), SPANGLE_TEXT("glMultiTexCoord2dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMultiTexCoord2xOES(GLenum target, GLfixed s, GLfixed t) {
    const GLfixed given[] = {s, t};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_x, 2), nullptr);
}

void GLAPIENTRY glMultiTexCoord2xvOES(GLenum target, const GLfixed* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_x, 2), SPANGLE_TEXT("glMultiTexCoord2xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glMultiTexCoord3s(GLenum target, GLshort s, GLshort t, GLshort r) {
    const GLint given[] = {s, t, r};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_i, 3), nullptr);
}

void GLAPIENTRY glMultiTexCoord3sv(GLenum target, const GLshort* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_s, 3), SPANGLE_TEXT("glMultiTexCoord3sv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord3i(GLenum target, GLint s, GLint t, GLint r) {
    const GLint given[] = {s, t, r};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_i, 3), nullptr);
}

void GLAPIENTRY glMultiTexCoord3iv(GLenum target, const GLint* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_i, 3), SPANGLE_TEXT("glMultiTexCoord3iv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord3f(GLenum target, GLfloat s, GLfloat t, GLfloat r) {
    const GLfloat given[] = {s, t, r};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_f, 3), nullptr);
}

void GLAPIENTRY glMultiTexCoord3fv(GLenum target, const GLfloat* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_f, 3), SPANGLE_TEXT("glMultiTexCoord3fv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord3d(GLenum target, GLdouble s, GLdouble t, GLdouble r) {
    const GLdouble given[] = {s, t, r};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_d, 3), nullptr);
}

void GLAPIENTRY glMultiTexCoord3dv(GLenum target, const GLdouble* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_d, 3), SPANGLE_TEXT("glMultiTexCoord3dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMultiTexCoord3xOES(GLenum target, GLfixed s, GLfixed t, GLfixed r) {
    const GLfixed given[] = {s, t, r};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_x, 3), nullptr);
}

void GLAPIENTRY glMultiTexCoord3xvOES(GLenum target, const GLfixed* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_x, 3), SPANGLE_TEXT("glMultiTexCoord3xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glMultiTexCoord4s(GLenum target, GLshort s, GLshort t, GLshort r, GLshort q) {
    const GLint given[] = {s, t, r, q};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_i, 4), nullptr);
}

void GLAPIENTRY glMultiTexCoord4sv(GLenum target, const GLshort* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_s, 4), SPANGLE_TEXT("glMultiTexCoord4sv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord4i(GLenum target, GLint s, GLint t, GLint r, GLint q) {
    const GLint given[] = {s, t, r, q};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_i, 4), nullptr);
}

void GLAPIENTRY glMultiTexCoord4iv(GLenum target, const GLint* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_i, 4), SPANGLE_TEXT("glMultiTexCoord4iv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord4f(GLenum target, GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
    const GLfloat given[] = {s, t, r, q};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_f, 4), nullptr);
}

void GLAPIENTRY glMultiTexCoord4fv(GLenum target, const GLfloat* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_f, 4), SPANGLE_TEXT("glMultiTexCoord4fv: v is a null pointer"));
}

void GLAPIENTRY glMultiTexCoord4d(GLenum target, GLdouble s, GLdouble t, GLdouble r, GLdouble q) {
    const GLdouble given[] = {s, t, r, q};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_d, 4), nullptr);
}

void GLAPIENTRY glMultiTexCoord4dv(GLenum target, const GLdouble* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_d, 4), SPANGLE_TEXT("glMultiTexCoord4dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMultiTexCoord4xOES(GLenum target, GLfixed s, GLfixed t, GLfixed r, GLfixed q) {
    const GLfixed given[] = {s, t, r, q};
    issue_components<family::MultiTexCoord>(target, given, convert::components(convert::Element::cast_x, 4), nullptr);
}

void GLAPIENTRY glMultiTexCoord4xvOES(GLenum target, const GLfixed* v) {
    issue_components<family::MultiTexCoord>(target, v, convert::components(convert::Element::cast_x, 4), SPANGLE_TEXT("glMultiTexCoord4xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glNormal3b(GLbyte nx, GLbyte ny, GLbyte nz) {
    const GLbyte given[] = {nx, ny, nz};
    issue_components<family::Normal>(given, convert::components(convert::Element::unit_b, 3), nullptr);
}

void GLAPIENTRY glNormal3bv(const GLbyte* v) {
    issue_components<family::Normal>(v, convert::components(convert::Element::unit_b, 3), SPANGLE_TEXT("glNormal3bv: v is a null pointer"));
}

void GLAPIENTRY glNormal3s(GLshort nx, GLshort ny, GLshort nz) {
    const GLshort given[] = {nx, ny, nz};
    issue_components<family::Normal>(given, convert::components(convert::Element::unit_s, 3), nullptr);
}

void GLAPIENTRY glNormal3sv(const GLshort* v) {
    issue_components<family::Normal>(v, convert::components(convert::Element::unit_s, 3), SPANGLE_TEXT("glNormal3sv: v is a null pointer"));
}

void GLAPIENTRY glNormal3i(GLint nx, GLint ny, GLint nz) {
    const GLint given[] = {nx, ny, nz};
    issue_reals<family::Normal, convert::Element::unit_i, 3>(given, nullptr);
}

void GLAPIENTRY glNormal3iv(const GLint* v) {
    issue_components<family::Normal>(v, convert::components(convert::Element::unit_i, 3), SPANGLE_TEXT("glNormal3iv: v is a null pointer"));
}

void GLAPIENTRY glNormal3f(GLfloat nx, GLfloat ny, GLfloat nz) {
    const GLfloat given[] = {nx, ny, nz};
    issue_reals<family::Normal, convert::Element::cast_f, 3>(given, nullptr);
}

void GLAPIENTRY glNormal3fv(const GLfloat* v) {
    issue_reals<family::Normal, convert::Element::cast_f, 3>(v, SPANGLE_TEXT("glNormal3fv: v is a null pointer"));
}

void GLAPIENTRY glNormal3d(GLdouble nx, GLdouble ny, GLdouble nz) {
    const GLdouble given[] = {nx, ny, nz};
    issue_components<family::Normal>(given, convert::components(convert::Element::cast_d, 3), nullptr);
}

void GLAPIENTRY glNormal3dv(const GLdouble* v) {
    issue_components<family::Normal>(v, convert::components(convert::Element::cast_d, 3), SPANGLE_TEXT("glNormal3dv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glNormal3xOES(GLfixed nx, GLfixed ny, GLfixed nz) {
    const GLfixed given[] = {nx, ny, nz};
    issue_components<family::Normal>(given, convert::components(convert::Element::cast_x, 3), nullptr);
}

void GLAPIENTRY glNormal3xvOES(const GLfixed* v) {
    issue_components<family::Normal>(v, convert::components(convert::Element::cast_x, 3), SPANGLE_TEXT("glNormal3xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glColor3b(GLbyte red, GLbyte green, GLbyte blue) {
    const GLbyte given[] = {red, green, blue};
    issue_components<family::Color>(given, convert::components(convert::Element::unit_b, 3), nullptr);
}

void GLAPIENTRY glColor3bv(const GLbyte* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_b, 3), SPANGLE_TEXT("glColor3bv: v is a null pointer"));
}

void GLAPIENTRY glColor3s(GLshort red, GLshort green, GLshort blue) {
    const GLshort given[] = {red, green, blue};
    issue_components<family::Color>(given, convert::components(convert::Element::unit_s, 3), nullptr);
}

void GLAPIENTRY glColor3sv(const GLshort* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_s, 3), SPANGLE_TEXT("glColor3sv: v is a null pointer"));
}

void GLAPIENTRY glColor3i(GLint red, GLint green, GLint blue) {
    const GLint given[] = {red, green, blue};
    issue_reals<family::Color, convert::Element::unit_i, 3>(given, nullptr);
}

void GLAPIENTRY glColor3iv(const GLint* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_i, 3), SPANGLE_TEXT("glColor3iv: v is a null pointer"));
}

void GLAPIENTRY glColor3f(GLfloat red, GLfloat green, GLfloat blue) {
    const GLfloat given[] = {red, green, blue};
    issue_reals<family::Color, convert::Element::cast_f, 3>(given, nullptr);
}

void GLAPIENTRY glColor3fv(const GLfloat* v) {
    issue_reals<family::Color, convert::Element::cast_f, 3>(v, SPANGLE_TEXT("glColor3fv: v is a null pointer"));
}

void GLAPIENTRY glColor3d(GLdouble red, GLdouble green, GLdouble blue) {
    const GLdouble given[] = {red, green, blue};
    issue_components<family::Color>(given, convert::components(convert::Element::cast_d, 3), nullptr);
}

void GLAPIENTRY glColor3dv(const GLdouble* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::cast_d, 3), SPANGLE_TEXT("glColor3dv: v is a null pointer"));
}

void GLAPIENTRY glColor3ub(GLubyte red, GLubyte green, GLubyte blue) {
    const GLubyte given[] = {red, green, blue};
    issue_components<family::Color>(given, convert::components(convert::Element::unit_ub, 3), nullptr);
}

void GLAPIENTRY glColor3ubv(const GLubyte* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_ub, 3), SPANGLE_TEXT("glColor3ubv: v is a null pointer"));
}

void GLAPIENTRY glColor3us(GLushort red, GLushort green, GLushort blue) {
    const GLushort given[] = {red, green, blue};
    issue_components<family::Color>(given, convert::components(convert::Element::unit_us, 3), nullptr);
}

void GLAPIENTRY glColor3usv(const GLushort* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_us, 3), SPANGLE_TEXT("glColor3usv: v is a null pointer"));
}

void GLAPIENTRY glColor3ui(GLuint red, GLuint green, GLuint blue) {
    const GLuint given[] = {red, green, blue};
    issue_components<family::Color>(given, convert::components(convert::Element::unit_ui, 3), nullptr);
}

void GLAPIENTRY glColor3uiv(const GLuint* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_ui, 3), SPANGLE_TEXT("glColor3uiv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glColor3xOES(GLfixed red, GLfixed green, GLfixed blue) {
    const GLfixed given[] = {red, green, blue};
    issue_components<family::Color>(given, convert::components(convert::Element::cast_x, 3), nullptr);
}

void GLAPIENTRY glColor3xvOES(const GLfixed* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::cast_x, 3), SPANGLE_TEXT("glColor3xvOES: v is a null pointer"));
}

#endif

void GLAPIENTRY glColor4b(GLbyte red, GLbyte green, GLbyte blue, GLbyte alpha) {
    const GLbyte given[] = {red, green, blue, alpha};
    issue_components<family::Color>(given, convert::components(convert::Element::unit_b, 4), nullptr);
}

void GLAPIENTRY glColor4bv(const GLbyte* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_b, 4), SPANGLE_TEXT("glColor4bv: v is a null pointer"));
}

void GLAPIENTRY glColor4s(GLshort red, GLshort green, GLshort blue, GLshort alpha) {
    const GLshort given[] = {red, green, blue, alpha};
    issue_components<family::Color>(given, convert::components(convert::Element::unit_s, 4), nullptr);
}

void GLAPIENTRY glColor4sv(const GLshort* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_s, 4), SPANGLE_TEXT("glColor4sv: v is a null pointer"));
}

void GLAPIENTRY glColor4i(GLint red, GLint green, GLint blue, GLint alpha) {
    const GLint given[] = {red, green, blue, alpha};
    issue_reals<family::Color, convert::Element::unit_i, 4>(given, nullptr);
}

void GLAPIENTRY glColor4iv(const GLint* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_i, 4), SPANGLE_TEXT("glColor4iv: v is a null pointer"));
}

void GLAPIENTRY glColor4f(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    const GLfloat given[] = {red, green, blue, alpha};
    issue_reals<family::Color, convert::Element::cast_f, 4>(given, nullptr);
}

void GLAPIENTRY glColor4fv(const GLfloat* v) {
    issue_reals<family::Color, convert::Element::cast_f, 4>(v, SPANGLE_TEXT("glColor4fv: v is a null pointer"));
}

void GLAPIENTRY glColor4d(GLdouble red, GLdouble green, GLdouble blue, GLdouble alpha) {
    const GLdouble given[] = {red, green, blue, alpha};
    issue_components<family::Color>(given, convert::components(convert::Element::cast_d, 4), nullptr);
}

void GLAPIENTRY glColor4dv(const GLdouble* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::cast_d, 4), SPANGLE_TEXT("glColor4dv: v is a null pointer"));
}

void GLAPIENTRY glColor4ub(GLubyte red, GLubyte green, GLubyte blue, GLubyte alpha) {
    const GLubyte given[] = {red, green, blue, alpha};
    issue_components<family::Color>(given, convert::components(convert::Element::unit_ub, 4), nullptr);
}

void GLAPIENTRY glColor4ubv(const GLubyte* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_ub, 4), SPANGLE_TEXT("glColor4ubv: v is a null pointer"));
}

void GLAPIENTRY glColor4us(GLushort red, GLushort green, GLushort blue, GLushort alpha) {
    const GLushort given[] = {red, green, blue, alpha};
    issue_components<family::Color>(given, convert::components(convert::Element::unit_us, 4), nullptr);
}

void GLAPIENTRY glColor4usv(const GLushort* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_us, 4), SPANGLE_TEXT("glColor4usv: v is a null pointer"));
}

void GLAPIENTRY glColor4ui(GLuint red, GLuint green, GLuint blue, GLuint alpha) {
    const GLuint given[] = {red, green, blue, alpha};
    issue_components<family::Color>(given, convert::components(convert::Element::unit_ui, 4), nullptr);
}

void GLAPIENTRY glColor4uiv(const GLuint* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::unit_ui, 4), SPANGLE_TEXT("glColor4uiv: v is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glColor4xOES(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha) {
    const GLfixed given[] = {red, green, blue, alpha};
    issue_components<family::Color>(given, convert::components(convert::Element::cast_x, 4), nullptr);
}

void GLAPIENTRY glColor4xvOES(const GLfixed* v) {
    issue_components<family::Color>(v, convert::components(convert::Element::cast_x, 4), SPANGLE_TEXT("glColor4xvOES: v is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_SECONDARY_COLOR

void GLAPIENTRY glSecondaryColor3b(GLbyte red, GLbyte green, GLbyte blue) {
    const GLbyte given[] = {red, green, blue};
    issue_components<family::SecondaryColor>(given, convert::components(convert::Element::unit_b, 3), nullptr);
}

void GLAPIENTRY glSecondaryColor3bv(const GLbyte* v) {
    issue_components<family::SecondaryColor>(v, convert::components(convert::Element::unit_b, 3), SPANGLE_TEXT("glSecondaryColor3bv: v is a null pointer"));
}

void GLAPIENTRY glSecondaryColor3s(GLshort red, GLshort green, GLshort blue) {
    const GLshort given[] = {red, green, blue};
    issue_components<family::SecondaryColor>(given, convert::components(convert::Element::unit_s, 3), nullptr);
}

void GLAPIENTRY glSecondaryColor3sv(const GLshort* v) {
    issue_components<family::SecondaryColor>(v, convert::components(convert::Element::unit_s, 3), SPANGLE_TEXT("glSecondaryColor3sv: v is a null pointer"));
}

void GLAPIENTRY glSecondaryColor3i(GLint red, GLint green, GLint blue) {
    const GLint given[] = {red, green, blue};
    issue_components<family::SecondaryColor>(given, convert::components(convert::Element::unit_i, 3), nullptr);
}

void GLAPIENTRY glSecondaryColor3iv(const GLint* v) {
    issue_components<family::SecondaryColor>(v, convert::components(convert::Element::unit_i, 3), SPANGLE_TEXT("glSecondaryColor3iv: v is a null pointer"));
}

void GLAPIENTRY glSecondaryColor3f(GLfloat red, GLfloat green, GLfloat blue) {
    const GLfloat given[] = {red, green, blue};
    issue_components<family::SecondaryColor>(given, convert::components(convert::Element::cast_f, 3), nullptr);
}

void GLAPIENTRY glSecondaryColor3fv(const GLfloat* v) {
    issue_components<family::SecondaryColor>(v, convert::components(convert::Element::cast_f, 3), SPANGLE_TEXT("glSecondaryColor3fv: v is a null pointer"));
}

void GLAPIENTRY glSecondaryColor3d(GLdouble red, GLdouble green, GLdouble blue) {
    const GLdouble given[] = {red, green, blue};
    issue_components<family::SecondaryColor>(given, convert::components(convert::Element::cast_d, 3), nullptr);
}

void GLAPIENTRY glSecondaryColor3dv(const GLdouble* v) {
    issue_components<family::SecondaryColor>(v, convert::components(convert::Element::cast_d, 3), SPANGLE_TEXT("glSecondaryColor3dv: v is a null pointer"));
}

void GLAPIENTRY glSecondaryColor3ub(GLubyte red, GLubyte green, GLubyte blue) {
    const GLubyte given[] = {red, green, blue};
    issue_components<family::SecondaryColor>(given, convert::components(convert::Element::unit_ub, 3), nullptr);
}

void GLAPIENTRY glSecondaryColor3ubv(const GLubyte* v) {
    issue_components<family::SecondaryColor>(v, convert::components(convert::Element::unit_ub, 3), SPANGLE_TEXT("glSecondaryColor3ubv: v is a null pointer"));
}

void GLAPIENTRY glSecondaryColor3us(GLushort red, GLushort green, GLushort blue) {
    const GLushort given[] = {red, green, blue};
    issue_components<family::SecondaryColor>(given, convert::components(convert::Element::unit_us, 3), nullptr);
}

void GLAPIENTRY glSecondaryColor3usv(const GLushort* v) {
    issue_components<family::SecondaryColor>(v, convert::components(convert::Element::unit_us, 3), SPANGLE_TEXT("glSecondaryColor3usv: v is a null pointer"));
}

void GLAPIENTRY glSecondaryColor3ui(GLuint red, GLuint green, GLuint blue) {
    const GLuint given[] = {red, green, blue};
    issue_components<family::SecondaryColor>(given, convert::components(convert::Element::unit_ui, 3), nullptr);
}

void GLAPIENTRY glSecondaryColor3uiv(const GLuint* v) {
    issue_components<family::SecondaryColor>(v, convert::components(convert::Element::unit_ui, 3), SPANGLE_TEXT("glSecondaryColor3uiv: v is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_COLOR_INDEX

void GLAPIENTRY glIndexs(GLshort index) {
    issue<family::Index>(convert::cast_s(index));
}

void GLAPIENTRY glIndexsv(const GLshort* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glIndexsv: v is a null pointer"));
    issue<family::Index>(convert::cast_s(v[0]));
}

void GLAPIENTRY glIndexi(GLint index) {
    issue<family::Index>(convert::cast_i(index));
}

void GLAPIENTRY glIndexiv(const GLint* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glIndexiv: v is a null pointer"));
    issue<family::Index>(convert::cast_i(v[0]));
}

void GLAPIENTRY glIndexf(GLfloat index) {
    issue<family::Index>(convert::cast_f(index));
}

void GLAPIENTRY glIndexfv(const GLfloat* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glIndexfv: v is a null pointer"));
    issue<family::Index>(convert::cast_f(v[0]));
}

void GLAPIENTRY glIndexd(GLdouble index) {
    issue<family::Index>(convert::cast_d(index));
}

void GLAPIENTRY glIndexdv(const GLdouble* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glIndexdv: v is a null pointer"));
    issue<family::Index>(convert::cast_d(v[0]));
}

void GLAPIENTRY glIndexub(GLubyte index) {
    issue<family::Index>(convert::cast_ub(index));
}

void GLAPIENTRY glIndexubv(const GLubyte* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glIndexubv: v is a null pointer"));
    issue<family::Index>(convert::cast_ub(v[0]));
}

#endif

#if SPANGLE_FEATURE_COLOR_INDEX && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glIndexxOES(GLfixed index) {
    issue<family::Index>(convert::cast_x(index));
}

void GLAPIENTRY glIndexxvOES(const GLfixed* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glIndexxvOES: v is a null pointer"));
    issue<family::Index>(convert::cast_x(v[0]));
}

#endif

#if SPANGLE_FEATURE_POLYGON_MODE

void GLAPIENTRY glEdgeFlag(GLboolean flag) {
    issue<family::EdgeFlag>(flag != 0);
}

void GLAPIENTRY glEdgeFlagv(const GLboolean* flag) {
    if (flag == nullptr)
        return refuse_null(SPANGLE_TEXT("glEdgeFlagv: flag is a null pointer"));
    issue<family::EdgeFlag>(*flag != 0);
}

#endif

#if SPANGLE_FEATURE_FOG

void GLAPIENTRY glFogCoordf(GLfloat coord) {
    issue<family::FogCoord>(convert::cast_f(coord));
}

void GLAPIENTRY glFogCoordfv(const GLfloat* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glFogCoordfv: v is a null pointer"));
    issue<family::FogCoord>(convert::cast_f(v[0]));
}

void GLAPIENTRY glFogCoordd(GLdouble coord) {
    issue<family::FogCoord>(convert::cast_d(coord));
}

void GLAPIENTRY glFogCoorddv(const GLdouble* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glFogCoorddv: v is a null pointer"));
    issue<family::FogCoord>(convert::cast_d(v[0]));
}

#endif

#if SPANGLE_FEATURE_RASTER_POS

void GLAPIENTRY glRasterPos2s(GLshort x, GLshort y) {
    const GLint given[] = {x, y};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_i, 2), nullptr);
}

void GLAPIENTRY glRasterPos2sv(const GLshort* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_s, 2), SPANGLE_TEXT("glRasterPos2sv: v is a null pointer"));
}

void GLAPIENTRY glRasterPos2i(GLint x, GLint y) {
    const GLint given[] = {x, y};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_i, 2), nullptr);
}

void GLAPIENTRY glRasterPos2iv(const GLint* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_i, 2), SPANGLE_TEXT("glRasterPos2iv: v is a null pointer"));
}

void GLAPIENTRY glRasterPos2f(GLfloat x, GLfloat y) {
    const GLfloat given[] = {x, y};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_f, 2), nullptr);
}

void GLAPIENTRY glRasterPos2fv(const GLfloat* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_f, 2), SPANGLE_TEXT("glRasterPos2fv: v is a null pointer"));
}

void GLAPIENTRY glRasterPos2d(GLdouble x, GLdouble y) {
    const GLdouble given[] = {x, y};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_d, 2), nullptr);
}

void GLAPIENTRY glRasterPos2dv(const GLdouble* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_d, 2), SPANGLE_TEXT("glRasterPos2dv: v is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_RASTER_POS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glRasterPos2xOES(GLfixed x, GLfixed y) {
    const GLfixed given[] = {x, y};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_x, 2), nullptr);
}

void GLAPIENTRY glRasterPos2xvOES(const GLfixed* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_x, 2), SPANGLE_TEXT("glRasterPos2xvOES: v is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_RASTER_POS

void GLAPIENTRY glRasterPos3s(GLshort x, GLshort y, GLshort z) {
    const GLint given[] = {x, y, z};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_i, 3), nullptr);
}

void GLAPIENTRY glRasterPos3sv(const GLshort* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_s, 3), SPANGLE_TEXT("glRasterPos3sv: v is a null pointer"));
}

void GLAPIENTRY glRasterPos3i(GLint x, GLint y, GLint z) {
    const GLint given[] = {x, y, z};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_i, 3), nullptr);
}

void GLAPIENTRY glRasterPos3iv(const GLint* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_i, 3), SPANGLE_TEXT("glRasterPos3iv: v is a null pointer"));
}

void GLAPIENTRY glRasterPos3f(GLfloat x, GLfloat y, GLfloat z) {
    const GLfloat given[] = {x, y, z};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_f, 3), nullptr);
}

void GLAPIENTRY glRasterPos3fv(const GLfloat* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_f, 3), SPANGLE_TEXT("glRasterPos3fv: v is a null pointer"));
}

void GLAPIENTRY glRasterPos3d(GLdouble x, GLdouble y, GLdouble z) {
    const GLdouble given[] = {x, y, z};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_d, 3), nullptr);
}

void GLAPIENTRY glRasterPos3dv(const GLdouble* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_d, 3), SPANGLE_TEXT("glRasterPos3dv: v is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_RASTER_POS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glRasterPos3xOES(GLfixed x, GLfixed y, GLfixed z) {
    const GLfixed given[] = {x, y, z};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_x, 3), nullptr);
}

void GLAPIENTRY glRasterPos3xvOES(const GLfixed* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_x, 3), SPANGLE_TEXT("glRasterPos3xvOES: v is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_RASTER_POS

void GLAPIENTRY glRasterPos4s(GLshort x, GLshort y, GLshort z, GLshort w) {
    const GLint given[] = {x, y, z, w};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_i, 4), nullptr);
}

void GLAPIENTRY glRasterPos4sv(const GLshort* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_s, 4), SPANGLE_TEXT("glRasterPos4sv: v is a null pointer"));
}

void GLAPIENTRY glRasterPos4i(GLint x, GLint y, GLint z, GLint w) {
    const GLint given[] = {x, y, z, w};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_i, 4), nullptr);
}

void GLAPIENTRY glRasterPos4iv(const GLint* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_i, 4), SPANGLE_TEXT("glRasterPos4iv: v is a null pointer"));
}

void GLAPIENTRY glRasterPos4f(GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
    const GLfloat given[] = {x, y, z, w};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_f, 4), nullptr);
}

void GLAPIENTRY glRasterPos4fv(const GLfloat* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_f, 4), SPANGLE_TEXT("glRasterPos4fv: v is a null pointer"));
}

void GLAPIENTRY glRasterPos4d(GLdouble x, GLdouble y, GLdouble z, GLdouble w) {
    const GLdouble given[] = {x, y, z, w};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_d, 4), nullptr);
}

void GLAPIENTRY glRasterPos4dv(const GLdouble* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_d, 4), SPANGLE_TEXT("glRasterPos4dv: v is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_RASTER_POS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glRasterPos4xOES(GLfixed x, GLfixed y, GLfixed z, GLfixed w) {
    const GLfixed given[] = {x, y, z, w};
    issue_components<family::RasterPos>(given, convert::components(convert::Element::cast_x, 4), nullptr);
}

void GLAPIENTRY glRasterPos4xvOES(const GLfixed* v) {
    issue_components<family::RasterPos>(v, convert::components(convert::Element::cast_x, 4), SPANGLE_TEXT("glRasterPos4xvOES: v is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_RASTER_POS

void GLAPIENTRY glWindowPos2s(GLshort x, GLshort y) {
    const GLint given[] = {x, y};
    issue_components<family::WindowPos>(given, convert::components(convert::Element::cast_i, 2), nullptr);
}

void GLAPIENTRY glWindowPos2sv(const GLshort* v) {
    issue_components<family::WindowPos>(v, convert::components(convert::Element::cast_s, 2), SPANGLE_TEXT("glWindowPos2sv: v is a null pointer"));
}

void GLAPIENTRY glWindowPos2i(GLint x, GLint y) {
    const GLint given[] = {x, y};
    issue_components<family::WindowPos>(given, convert::components(convert::Element::cast_i, 2), nullptr);
}

void GLAPIENTRY glWindowPos2iv(const GLint* v) {
    issue_components<family::WindowPos>(v, convert::components(convert::Element::cast_i, 2), SPANGLE_TEXT("glWindowPos2iv: v is a null pointer"));
}

void GLAPIENTRY glWindowPos2f(GLfloat x, GLfloat y) {
    const GLfloat given[] = {x, y};
    issue_components<family::WindowPos>(given, convert::components(convert::Element::cast_f, 2), nullptr);
}

void GLAPIENTRY glWindowPos2fv(const GLfloat* v) {
    issue_components<family::WindowPos>(v, convert::components(convert::Element::cast_f, 2), SPANGLE_TEXT("glWindowPos2fv: v is a null pointer"));
}

void GLAPIENTRY glWindowPos2d(GLdouble x, GLdouble y) {
    const GLdouble given[] = {x, y};
    issue_components<family::WindowPos>(given, convert::components(convert::Element::cast_d, 2), nullptr);
}

void GLAPIENTRY glWindowPos2dv(const GLdouble* v) {
    issue_components<family::WindowPos>(v, convert::components(convert::Element::cast_d, 2), SPANGLE_TEXT("glWindowPos2dv: v is a null pointer"));
}

void GLAPIENTRY glWindowPos3s(GLshort x, GLshort y, GLshort z) {
    const GLint given[] = {x, y, z};
    issue_components<family::WindowPos>(given, convert::components(convert::Element::cast_i, 3), nullptr);
}

void GLAPIENTRY glWindowPos3sv(const GLshort* v) {
    issue_components<family::WindowPos>(v, convert::components(convert::Element::cast_s, 3), SPANGLE_TEXT("glWindowPos3sv: v is a null pointer"));
}

void GLAPIENTRY glWindowPos3i(GLint x, GLint y, GLint z) {
    const GLint given[] = {x, y, z};
    issue_components<family::WindowPos>(given, convert::components(convert::Element::cast_i, 3), nullptr);
}

void GLAPIENTRY glWindowPos3iv(const GLint* v) {
    issue_components<family::WindowPos>(v, convert::components(convert::Element::cast_i, 3), SPANGLE_TEXT("glWindowPos3iv: v is a null pointer"));
}

void GLAPIENTRY glWindowPos3f(GLfloat x, GLfloat y, GLfloat z) {
    const GLfloat given[] = {x, y, z};
    issue_components<family::WindowPos>(given, convert::components(convert::Element::cast_f, 3), nullptr);
}

void GLAPIENTRY glWindowPos3fv(const GLfloat* v) {
    issue_components<family::WindowPos>(v, convert::components(convert::Element::cast_f, 3), SPANGLE_TEXT("glWindowPos3fv: v is a null pointer"));
}

void GLAPIENTRY glWindowPos3d(GLdouble x, GLdouble y, GLdouble z) {
    const GLdouble given[] = {x, y, z};
    issue_components<family::WindowPos>(given, convert::components(convert::Element::cast_d, 3), nullptr);
}

void GLAPIENTRY glWindowPos3dv(const GLdouble* v) {
    issue_components<family::WindowPos>(v, convert::components(convert::Element::cast_d, 3), SPANGLE_TEXT("glWindowPos3dv: v is a null pointer"));
}

#endif

void GLAPIENTRY glRects(GLshort x1, GLshort y1, GLshort x2, GLshort y2) {
    const GLint given[] = {x1, y1, x2, y2};
    issue_reals<family::Rect, convert::Element::cast_i, 4>(given, nullptr);
}

void GLAPIENTRY glRectsv(const GLshort* v1, const GLshort* v2) {
    issue_corners<family::Rect>(v1, v2, convert::components(convert::Element::cast_s, 2), SPANGLE_TEXT("glRectsv: v1 or v2 is a null pointer"));
}

void GLAPIENTRY glRecti(GLint x1, GLint y1, GLint x2, GLint y2) {
    const GLint given[] = {x1, y1, x2, y2};
    issue_reals<family::Rect, convert::Element::cast_i, 4>(given, nullptr);
}

void GLAPIENTRY glRectiv(const GLint* v1, const GLint* v2) {
    issue_corners<family::Rect>(v1, v2, convert::components(convert::Element::cast_i, 2), SPANGLE_TEXT("glRectiv: v1 or v2 is a null pointer"));
}

void GLAPIENTRY glRectf(GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
    const GLfloat given[] = {x1, y1, x2, y2};
    issue_reals<family::Rect, convert::Element::cast_f, 4>(given, nullptr);
}

void GLAPIENTRY glRectfv(const GLfloat* v1, const GLfloat* v2) {
    issue_corners<family::Rect>(v1, v2, convert::components(convert::Element::cast_f, 2), SPANGLE_TEXT("glRectfv: v1 or v2 is a null pointer"));
}

void GLAPIENTRY glRectd(GLdouble x1, GLdouble y1, GLdouble x2, GLdouble y2) {
    const GLdouble given[] = {x1, y1, x2, y2};
    issue_reals<family::Rect, convert::Element::cast_d, 4>(given, nullptr);
}

void GLAPIENTRY glRectdv(const GLdouble* v1, const GLdouble* v2) {
    issue_corners<family::Rect>(v1, v2, convert::components(convert::Element::cast_d, 2), SPANGLE_TEXT("glRectdv: v1 or v2 is a null pointer"));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glRectxOES(GLfixed x1, GLfixed y1, GLfixed x2, GLfixed y2) {
    const GLfixed given[] = {x1, y1, x2, y2};
    issue_reals<family::Rect, convert::Element::cast_x, 4>(given, nullptr);
}

void GLAPIENTRY glRectxvOES(const GLfixed* v1, const GLfixed* v2) {
    issue_corners<family::Rect>(v1, v2, convert::components(convert::Element::cast_x, 2), SPANGLE_TEXT("glRectxvOES: v1 or v2 is a null pointer"));
}

#endif

void GLAPIENTRY glVertexPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
    issue<family::VertexPointer>(size, type, stride, pointer);
}

void GLAPIENTRY glNormalPointer(GLenum type, GLsizei stride, const void* pointer) {
    issue<family::NormalPointer>(type, stride, pointer);
}

void GLAPIENTRY glColorPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
    issue<family::ColorPointer>(size, type, stride, pointer);
}

void GLAPIENTRY glTexCoordPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
    issue<family::TexCoordPointer>(size, type, stride, pointer);
}

#if SPANGLE_FEATURE_COLOR_INDEX

void GLAPIENTRY glIndexPointer(GLenum type, GLsizei stride, const void* pointer) {
    issue<family::IndexPointer>(type, stride, pointer);
}

#endif

#if SPANGLE_FEATURE_POLYGON_MODE

void GLAPIENTRY glEdgeFlagPointer(GLsizei stride, const void* pointer) {
    issue<family::EdgeFlagPointer>(stride, pointer);
}

#endif

#if SPANGLE_FEATURE_FOG

void GLAPIENTRY glFogCoordPointer(GLenum type, GLsizei stride, const void* pointer) {
    issue<family::FogCoordPointer>(type, stride, pointer);
}

#endif

#if SPANGLE_FEATURE_SECONDARY_COLOR

void GLAPIENTRY glSecondaryColorPointer(GLint size, GLenum type, GLsizei stride, const void* pointer) {
    issue<family::SecondaryColorPointer>(size, type, stride, pointer);
}

#endif

void GLAPIENTRY glClientActiveTexture(GLenum texture) {
    issue<family::ClientActiveTexture>(texture);
}

void GLAPIENTRY glEnableClientState(GLenum array) {
    issue<family::EnableClientState>(array);
}

void GLAPIENTRY glDisableClientState(GLenum array) {
    issue<family::DisableClientState>(array);
}

void GLAPIENTRY glArrayElement(GLint i) {
    issue<family::ArrayElement>(i);
}

void GLAPIENTRY glDrawArrays(GLenum mode, GLint first, GLsizei count) {
    issue<family::DrawArrays>(mode, first, count);
}

void GLAPIENTRY glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
    issue<family::DrawElements>(mode, count, type, indices);
}

void GLAPIENTRY glDrawRangeElements(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type, const void* indices) {
    issue<family::DrawRangeElements>(mode, start, end, count, type, indices);
}

void GLAPIENTRY glMultiDrawArrays(GLenum mode, const GLint* first, const GLsizei* count, GLsizei primcount) {
    issue<family::MultiDrawArrays>(mode, first, count, primcount);
}

void GLAPIENTRY glMultiDrawElements(GLenum mode, const GLsizei* count, GLenum type, const void** indices, GLsizei primcount) {
    issue<family::MultiDrawElements>(mode, count, type, indices, primcount);
}

#if SPANGLE_FEATURE_PRIMITIVE_RESTART

void GLAPIENTRY glPrimitiveRestartIndex(GLuint index) {
    issue<family::PrimitiveRestartIndex>(index);
}

#endif

#if SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS

void GLAPIENTRY glGenVertexArrays(GLsizei n, GLuint* arrays) {
    issue<family::GenVertexArrays>(n, arrays);
}

void GLAPIENTRY glDeleteVertexArrays(GLsizei n, const GLuint* arrays) {
    issue<family::DeleteVertexArrays>(n, arrays);
}

GLboolean GLAPIENTRY glIsVertexArray(GLuint array) {
    return ask<family::IsVertexArray>(array);
}

void GLAPIENTRY glBindVertexArray(GLuint array) {
    issue<family::BindVertexArray>(array);
}

#endif

#if SPANGLE_FEATURE_BUFFERS

void GLAPIENTRY glGenBuffers(GLsizei n, GLuint* buffers) {
    issue<family::GenBuffers>(n, buffers);
}

void GLAPIENTRY glDeleteBuffers(GLsizei n, const GLuint* buffers) {
    issue<family::DeleteBuffers>(n, buffers);
}

GLboolean GLAPIENTRY glIsBuffer(GLuint buffer) {
    return ask<family::IsBuffer>(buffer);
}

void GLAPIENTRY glBindBuffer(GLenum target, GLuint buffer) {
    issue<family::BindBuffer>(target, buffer);
}

void GLAPIENTRY glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    issue<family::BufferData>(target, size, data, usage);
}

void GLAPIENTRY glBufferConstantDataSPANGLE(GLenum target, GLsizeiptr size, const void* data) {
    issue<family::BufferConstantDataSPANGLE>(target, size, data);
}

void GLAPIENTRY glBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
    issue<family::BufferSubData>(target, offset, size, data);
}

void GLAPIENTRY glGetBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
    issue<family::GetBufferSubData>(target, offset, size, data);
}

void GLAPIENTRY glGetBufferParameteriv(GLenum target, GLenum pname, GLint* params) {
    issue<family::GetBufferParameteriv>(target, pname, params);
}

void* GLAPIENTRY glMapBuffer(GLenum target, GLenum access) {
    return ask<family::MapBuffer>(target, access);
}

void* GLAPIENTRY glMapBufferRange(GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access) {
    return ask<family::MapBufferRange>(target, offset, length, access);
}

void GLAPIENTRY glFlushMappedBufferRange(GLenum target, GLintptr offset, GLsizeiptr length) {
    issue<family::FlushMappedBufferRange>(target, offset, length);
}

GLboolean GLAPIENTRY glUnmapBuffer(GLenum target) {
    return ask<family::UnmapBuffer>(target);
}

void GLAPIENTRY glGetBufferPointerv(GLenum target, GLenum pname, void** params) {
    issue<family::GetBufferPointerv>(target, pname, params);
}

#endif

void GLAPIENTRY glInterleavedArrays(GLenum format, GLsizei stride, const void* pointer) {
    issue<family::InterleavedArrays>(format, stride, pointer);
}

#if !SPANGLE_FEATURE_BUFFERS

SPANGLE_REFUSED("glGenBuffers: this build has no SPANGLE_FEATURE_BUFFERS", void GLAPIENTRY glGenBuffers(GLsizei, GLuint*))

SPANGLE_REFUSED("glDeleteBuffers: this build has no SPANGLE_FEATURE_BUFFERS", void GLAPIENTRY glDeleteBuffers(GLsizei, const GLuint*))

GLboolean GLAPIENTRY glIsBuffer(GLuint) {
    refuse_feature(SPANGLE_TEXT("glIsBuffer: this build has no SPANGLE_FEATURE_BUFFERS"));
    return 0;
}

SPANGLE_REFUSED("glBindBuffer: this build has no SPANGLE_FEATURE_BUFFERS", void GLAPIENTRY glBindBuffer(GLenum, GLuint))

SPANGLE_REFUSED("glBufferData: this build has no SPANGLE_FEATURE_BUFFERS", void GLAPIENTRY glBufferData(GLenum, GLsizeiptr, const void*, GLenum))

SPANGLE_REFUSED("glBufferConstantDataSPANGLE: this build has no SPANGLE_FEATURE_BUFFERS", void GLAPIENTRY glBufferConstantDataSPANGLE(GLenum, GLsizeiptr, const void*))

SPANGLE_REFUSED("glBufferSubData: this build has no SPANGLE_FEATURE_BUFFERS", void GLAPIENTRY glBufferSubData(GLenum, GLintptr, GLsizeiptr, const void*))

SPANGLE_REFUSED("glGetBufferSubData: this build has no SPANGLE_FEATURE_BUFFERS", void GLAPIENTRY glGetBufferSubData(GLenum, GLintptr, GLsizeiptr, void*))

SPANGLE_REFUSED("glGetBufferParameteriv: this build has no SPANGLE_FEATURE_BUFFERS", void GLAPIENTRY glGetBufferParameteriv(GLenum, GLenum, GLint*))

void* GLAPIENTRY glMapBuffer(GLenum, GLenum) {
    refuse_feature(SPANGLE_TEXT("glMapBuffer: this build has no SPANGLE_FEATURE_BUFFERS"));
    return 0;
}

void* GLAPIENTRY glMapBufferRange(GLenum, GLintptr, GLsizeiptr, GLbitfield) {
    refuse_feature(SPANGLE_TEXT("glMapBufferRange: this build has no SPANGLE_FEATURE_BUFFERS"));
    return 0;
}

SPANGLE_REFUSED("glFlushMappedBufferRange: this build has no SPANGLE_FEATURE_BUFFERS", void GLAPIENTRY glFlushMappedBufferRange(GLenum, GLintptr, GLsizeiptr))

GLboolean GLAPIENTRY glUnmapBuffer(GLenum) {
    refuse_feature(SPANGLE_TEXT("glUnmapBuffer: this build has no SPANGLE_FEATURE_BUFFERS"));
    return 0;
}

SPANGLE_REFUSED("glGetBufferPointerv: this build has no SPANGLE_FEATURE_BUFFERS", void GLAPIENTRY glGetBufferPointerv(GLenum, GLenum, void**))

#endif

#if !SPANGLE_FEATURE_COLOR_INDEX

SPANGLE_REFUSED("glIndexs: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexs(GLshort))

SPANGLE_REFUSED("glIndexsv: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexsv(const GLshort*))

SPANGLE_REFUSED("glIndexi: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexi(GLint))

SPANGLE_REFUSED("glIndexiv: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexiv(const GLint*))

SPANGLE_REFUSED("glIndexf: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexf(GLfloat))

SPANGLE_REFUSED("glIndexfv: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexfv(const GLfloat*))

SPANGLE_REFUSED("glIndexd: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexd(GLdouble))

SPANGLE_REFUSED("glIndexdv: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexdv(const GLdouble*))

SPANGLE_REFUSED("glIndexub: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexub(GLubyte))

SPANGLE_REFUSED("glIndexubv: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexubv(const GLubyte*))

SPANGLE_REFUSED("glIndexPointer: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexPointer(GLenum, GLsizei, const void*))

#endif

#if !SPANGLE_FEATURE_COLOR_INDEX

SPANGLE_REFUSED("glIndexxOES: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexxOES(GLfixed))

SPANGLE_REFUSED("glIndexxvOES: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexxvOES(const GLfixed*))

#endif

#if SPANGLE_FEATURE_COLOR_INDEX && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glIndexxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glIndexxOES(GLfixed))

SPANGLE_REFUSED("glIndexxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glIndexxvOES(const GLfixed*))

#endif

#if !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glVertex2xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glVertex2xOES(GLfixed, GLfixed))

SPANGLE_REFUSED("glVertex2xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glVertex2xvOES(const GLfixed*))

SPANGLE_REFUSED("glVertex3xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glVertex3xOES(GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glVertex3xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glVertex3xvOES(const GLfixed*))

SPANGLE_REFUSED("glVertex4xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glVertex4xOES(GLfixed, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glVertex4xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glVertex4xvOES(const GLfixed*))

SPANGLE_REFUSED("glTexCoord1xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexCoord1xOES(GLfixed))

SPANGLE_REFUSED("glTexCoord1xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexCoord1xvOES(const GLfixed*))

SPANGLE_REFUSED("glTexCoord2xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexCoord2xOES(GLfixed, GLfixed))

SPANGLE_REFUSED("glTexCoord2xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexCoord2xvOES(const GLfixed*))

SPANGLE_REFUSED("glTexCoord3xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexCoord3xOES(GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glTexCoord3xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexCoord3xvOES(const GLfixed*))

SPANGLE_REFUSED("glTexCoord4xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexCoord4xOES(GLfixed, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glTexCoord4xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glTexCoord4xvOES(const GLfixed*))

SPANGLE_REFUSED("glMultiTexCoord1xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMultiTexCoord1xOES(GLenum, GLfixed))

SPANGLE_REFUSED("glMultiTexCoord1xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMultiTexCoord1xvOES(GLenum, const GLfixed*))

SPANGLE_REFUSED("glMultiTexCoord2xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMultiTexCoord2xOES(GLenum, GLfixed, GLfixed))

SPANGLE_REFUSED("glMultiTexCoord2xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMultiTexCoord2xvOES(GLenum, const GLfixed*))

SPANGLE_REFUSED("glMultiTexCoord3xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMultiTexCoord3xOES(GLenum, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glMultiTexCoord3xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMultiTexCoord3xvOES(GLenum, const GLfixed*))

SPANGLE_REFUSED("glMultiTexCoord4xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMultiTexCoord4xOES(GLenum, GLfixed, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glMultiTexCoord4xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMultiTexCoord4xvOES(GLenum, const GLfixed*))

SPANGLE_REFUSED("glNormal3xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glNormal3xOES(GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glNormal3xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glNormal3xvOES(const GLfixed*))

SPANGLE_REFUSED("glColor3xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glColor3xOES(GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glColor3xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glColor3xvOES(const GLfixed*))

SPANGLE_REFUSED("glColor4xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glColor4xOES(GLfixed, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glColor4xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glColor4xvOES(const GLfixed*))

SPANGLE_REFUSED("glRectxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glRectxOES(GLfixed, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glRectxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glRectxvOES(const GLfixed*, const GLfixed*))

#endif

#if !SPANGLE_FEATURE_FOG

SPANGLE_REFUSED("glFogCoordf: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogCoordf(GLfloat))

SPANGLE_REFUSED("glFogCoordfv: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogCoordfv(const GLfloat*))

SPANGLE_REFUSED("glFogCoordd: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogCoordd(GLdouble))

SPANGLE_REFUSED("glFogCoorddv: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogCoorddv(const GLdouble*))

SPANGLE_REFUSED("glFogCoordPointer: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogCoordPointer(GLenum, GLsizei, const void*))

#endif

#if !SPANGLE_FEATURE_POLYGON_MODE

SPANGLE_REFUSED("glEdgeFlag: this build has no SPANGLE_FEATURE_POLYGON_MODE", void GLAPIENTRY glEdgeFlag(GLboolean))

SPANGLE_REFUSED("glEdgeFlagv: this build has no SPANGLE_FEATURE_POLYGON_MODE", void GLAPIENTRY glEdgeFlagv(const GLboolean*))

SPANGLE_REFUSED("glEdgeFlagPointer: this build has no SPANGLE_FEATURE_POLYGON_MODE", void GLAPIENTRY glEdgeFlagPointer(GLsizei, const void*))

#endif

#if !SPANGLE_FEATURE_PRIMITIVE_RESTART

SPANGLE_REFUSED("glPrimitiveRestartIndex: this build has no SPANGLE_FEATURE_PRIMITIVE_RESTART", void GLAPIENTRY glPrimitiveRestartIndex(GLuint))

#endif

#if !SPANGLE_FEATURE_RASTER_POS

SPANGLE_REFUSED("glRasterPos2s: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos2s(GLshort, GLshort))

SPANGLE_REFUSED("glRasterPos2sv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos2sv(const GLshort*))

SPANGLE_REFUSED("glRasterPos2i: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos2i(GLint, GLint))

SPANGLE_REFUSED("glRasterPos2iv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos2iv(const GLint*))

SPANGLE_REFUSED("glRasterPos2f: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos2f(GLfloat, GLfloat))

SPANGLE_REFUSED("glRasterPos2fv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos2fv(const GLfloat*))

SPANGLE_REFUSED("glRasterPos2d: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos2d(GLdouble, GLdouble))

SPANGLE_REFUSED("glRasterPos2dv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos2dv(const GLdouble*))

SPANGLE_REFUSED("glRasterPos3s: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos3s(GLshort, GLshort, GLshort))

SPANGLE_REFUSED("glRasterPos3sv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos3sv(const GLshort*))

SPANGLE_REFUSED("glRasterPos3i: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos3i(GLint, GLint, GLint))

SPANGLE_REFUSED("glRasterPos3iv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos3iv(const GLint*))

SPANGLE_REFUSED("glRasterPos3f: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos3f(GLfloat, GLfloat, GLfloat))

SPANGLE_REFUSED("glRasterPos3fv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos3fv(const GLfloat*))

SPANGLE_REFUSED("glRasterPos3d: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos3d(GLdouble, GLdouble, GLdouble))

SPANGLE_REFUSED("glRasterPos3dv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos3dv(const GLdouble*))

SPANGLE_REFUSED("glRasterPos4s: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos4s(GLshort, GLshort, GLshort, GLshort))

SPANGLE_REFUSED("glRasterPos4sv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos4sv(const GLshort*))

SPANGLE_REFUSED("glRasterPos4i: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos4i(GLint, GLint, GLint, GLint))

SPANGLE_REFUSED("glRasterPos4iv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos4iv(const GLint*))

SPANGLE_REFUSED("glRasterPos4f: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos4f(GLfloat, GLfloat, GLfloat, GLfloat))

SPANGLE_REFUSED("glRasterPos4fv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos4fv(const GLfloat*))

SPANGLE_REFUSED("glRasterPos4d: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos4d(GLdouble, GLdouble, GLdouble, GLdouble))

SPANGLE_REFUSED("glRasterPos4dv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos4dv(const GLdouble*))

SPANGLE_REFUSED("glWindowPos2s: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos2s(GLshort, GLshort))

SPANGLE_REFUSED("glWindowPos2sv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos2sv(const GLshort*))

SPANGLE_REFUSED("glWindowPos2i: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos2i(GLint, GLint))

SPANGLE_REFUSED("glWindowPos2iv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos2iv(const GLint*))

SPANGLE_REFUSED("glWindowPos2f: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos2f(GLfloat, GLfloat))

SPANGLE_REFUSED("glWindowPos2fv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos2fv(const GLfloat*))

SPANGLE_REFUSED("glWindowPos2d: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos2d(GLdouble, GLdouble))

SPANGLE_REFUSED("glWindowPos2dv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos2dv(const GLdouble*))

SPANGLE_REFUSED("glWindowPos3s: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos3s(GLshort, GLshort, GLshort))

SPANGLE_REFUSED("glWindowPos3sv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos3sv(const GLshort*))

SPANGLE_REFUSED("glWindowPos3i: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos3i(GLint, GLint, GLint))

SPANGLE_REFUSED("glWindowPos3iv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos3iv(const GLint*))

SPANGLE_REFUSED("glWindowPos3f: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos3f(GLfloat, GLfloat, GLfloat))

SPANGLE_REFUSED("glWindowPos3fv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos3fv(const GLfloat*))

SPANGLE_REFUSED("glWindowPos3d: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos3d(GLdouble, GLdouble, GLdouble))

SPANGLE_REFUSED("glWindowPos3dv: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glWindowPos3dv(const GLdouble*))

#endif

#if !SPANGLE_FEATURE_RASTER_POS

SPANGLE_REFUSED("glRasterPos2xOES: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos2xOES(GLfixed, GLfixed))

SPANGLE_REFUSED("glRasterPos2xvOES: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos2xvOES(const GLfixed*))

SPANGLE_REFUSED("glRasterPos3xOES: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos3xOES(GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glRasterPos3xvOES: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos3xvOES(const GLfixed*))

SPANGLE_REFUSED("glRasterPos4xOES: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos4xOES(GLfixed, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glRasterPos4xvOES: this build has no SPANGLE_FEATURE_RASTER_POS", void GLAPIENTRY glRasterPos4xvOES(const GLfixed*))

#endif

#if SPANGLE_FEATURE_RASTER_POS && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glRasterPos2xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glRasterPos2xOES(GLfixed, GLfixed))

SPANGLE_REFUSED("glRasterPos2xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glRasterPos2xvOES(const GLfixed*))

SPANGLE_REFUSED("glRasterPos3xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glRasterPos3xOES(GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glRasterPos3xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glRasterPos3xvOES(const GLfixed*))

SPANGLE_REFUSED("glRasterPos4xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glRasterPos4xOES(GLfixed, GLfixed, GLfixed, GLfixed))

SPANGLE_REFUSED("glRasterPos4xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glRasterPos4xvOES(const GLfixed*))

#endif

#if !SPANGLE_FEATURE_SECONDARY_COLOR

SPANGLE_REFUSED("glSecondaryColor3b: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3b(GLbyte, GLbyte, GLbyte))

SPANGLE_REFUSED("glSecondaryColor3bv: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3bv(const GLbyte*))

SPANGLE_REFUSED("glSecondaryColor3s: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3s(GLshort, GLshort, GLshort))

SPANGLE_REFUSED("glSecondaryColor3sv: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3sv(const GLshort*))

SPANGLE_REFUSED("glSecondaryColor3i: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3i(GLint, GLint, GLint))

SPANGLE_REFUSED("glSecondaryColor3iv: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3iv(const GLint*))

SPANGLE_REFUSED("glSecondaryColor3f: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3f(GLfloat, GLfloat, GLfloat))

SPANGLE_REFUSED("glSecondaryColor3fv: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3fv(const GLfloat*))

SPANGLE_REFUSED("glSecondaryColor3d: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3d(GLdouble, GLdouble, GLdouble))

SPANGLE_REFUSED("glSecondaryColor3dv: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3dv(const GLdouble*))

SPANGLE_REFUSED("glSecondaryColor3ub: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3ub(GLubyte, GLubyte, GLubyte))

SPANGLE_REFUSED("glSecondaryColor3ubv: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3ubv(const GLubyte*))

SPANGLE_REFUSED("glSecondaryColor3us: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3us(GLushort, GLushort, GLushort))

SPANGLE_REFUSED("glSecondaryColor3usv: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3usv(const GLushort*))

SPANGLE_REFUSED("glSecondaryColor3ui: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3ui(GLuint, GLuint, GLuint))

SPANGLE_REFUSED("glSecondaryColor3uiv: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColor3uiv(const GLuint*))

SPANGLE_REFUSED("glSecondaryColorPointer: this build has no SPANGLE_FEATURE_SECONDARY_COLOR", void GLAPIENTRY glSecondaryColorPointer(GLint, GLenum, GLsizei, const void*))

#endif

#if !SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS

SPANGLE_REFUSED("glGenVertexArrays: this build has no SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS", void GLAPIENTRY glGenVertexArrays(GLsizei, GLuint*))

SPANGLE_REFUSED("glDeleteVertexArrays: this build has no SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS", void GLAPIENTRY glDeleteVertexArrays(GLsizei, const GLuint*))

GLboolean GLAPIENTRY glIsVertexArray(GLuint) {
    refuse_feature(SPANGLE_TEXT("glIsVertexArray: this build has no SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS"));
    return 0;
}

SPANGLE_REFUSED("glBindVertexArray: this build has no SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS", void GLAPIENTRY glBindVertexArray(GLuint))

#endif

} // extern "C"
