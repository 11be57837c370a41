// Entry points: Evaluators.
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

#if SPANGLE_FEATURE_EVALUATORS

void GLAPIENTRY glMap1f(GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order, const GLfloat* points) {
    issue<family::Map1>(target, convert::cast_f(u1), convert::cast_f(u2), stride, order, Values{points, GL_FLOAT});
}

void GLAPIENTRY glMap1d(GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order, const GLdouble* points) {
    issue<family::Map1>(target, convert::cast_d(u1), convert::cast_d(u2), stride, order, Values{points, GL_DOUBLE});
}

#endif

#if SPANGLE_FEATURE_EVALUATORS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMap1xOES(GLenum target, GLfixed u1, GLfixed u2, GLint stride, GLint order, const GLfixed* points) {
    issue<family::Map1>(target, convert::cast_x(u1), convert::cast_x(u2), stride, order, Values{points, GL_FIXED});
}

#endif

#if SPANGLE_FEATURE_EVALUATORS

void GLAPIENTRY glMap2f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1, GLfloat v2, GLint vstride, GLint vorder, const GLfloat* points) {
    issue<family::Map2>(target, convert::cast_f(u1), convert::cast_f(u2), ustride, uorder, convert::cast_f(v1), convert::cast_f(v2), vstride, vorder, Values{points, GL_FLOAT});
}

void GLAPIENTRY glMap2d(GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder, GLdouble v1, GLdouble v2, GLint vstride, GLint vorder, const GLdouble* points) {
    issue<family::Map2>(target, convert::cast_d(u1), convert::cast_d(u2), ustride, uorder, convert::cast_d(v1), convert::cast_d(v2), vstride, vorder, Values{points, GL_DOUBLE});
}

#endif

#if SPANGLE_FEATURE_EVALUATORS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMap2xOES(GLenum target, GLfixed u1, GLfixed u2, GLint ustride, GLint uorder, GLfixed v1, GLfixed v2, GLint vstride, GLint vorder, const GLfixed* points) {
    issue<family::Map2>(target, convert::cast_x(u1), convert::cast_x(u2), ustride, uorder, convert::cast_x(v1), convert::cast_x(v2), vstride, vorder, Values{points, GL_FIXED});
}

#endif

#if SPANGLE_FEATURE_EVALUATORS

void GLAPIENTRY glGetMapiv(GLenum target, GLenum query, GLint* v) {
    issue_array<family::GetMap>(target, query, v, GL_INT);
}

void GLAPIENTRY glGetMapfv(GLenum target, GLenum query, GLfloat* v) {
    issue_array<family::GetMap>(target, query, v, GL_FLOAT);
}

void GLAPIENTRY glGetMapdv(GLenum target, GLenum query, GLdouble* v) {
    issue_array<family::GetMap>(target, query, v, GL_DOUBLE);
}

#endif

#if SPANGLE_FEATURE_EVALUATORS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetMapxvOES(GLenum target, GLenum query, GLfixed* v) {
    issue_array<family::GetMap>(target, query, v, GL_FIXED);
}

#endif

#if SPANGLE_FEATURE_EVALUATORS

void GLAPIENTRY glEvalCoord1f(GLfloat u) {
    issue<family::EvalCoord1>(convert::cast_f(u));
}

void GLAPIENTRY glEvalCoord1fv(const GLfloat* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glEvalCoord1fv: v is a null pointer"));
    issue<family::EvalCoord1>(convert::cast_f(v[0]));
}

void GLAPIENTRY glEvalCoord1d(GLdouble u) {
    issue<family::EvalCoord1>(convert::cast_d(u));
}

void GLAPIENTRY glEvalCoord1dv(const GLdouble* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glEvalCoord1dv: v is a null pointer"));
    issue<family::EvalCoord1>(convert::cast_d(v[0]));
}

#endif

#if SPANGLE_FEATURE_EVALUATORS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glEvalCoord1xOES(GLfixed u) {
    issue<family::EvalCoord1>(convert::cast_x(u));
}

void GLAPIENTRY glEvalCoord1xvOES(const GLfixed* v) {
    if (v == nullptr)
        return refuse_null(SPANGLE_TEXT("glEvalCoord1xvOES: v is a null pointer"));
    issue<family::EvalCoord1>(convert::cast_x(v[0]));
}

#endif

#if SPANGLE_FEATURE_EVALUATORS

void GLAPIENTRY glEvalCoord2f(GLfloat u, GLfloat v) {
    const GLfloat given[] = {u, v};
    issue_reals<family::EvalCoord2, convert::Element::cast_f, 2>(given, nullptr);
}

void GLAPIENTRY glEvalCoord2fv(const GLfloat* v) {
    issue_reals<family::EvalCoord2, convert::Element::cast_f, 2>(v, SPANGLE_TEXT("glEvalCoord2fv: v is a null pointer"));
}

void GLAPIENTRY glEvalCoord2d(GLdouble u, GLdouble v) {
    const GLdouble given[] = {u, v};
    issue_reals<family::EvalCoord2, convert::Element::cast_d, 2>(given, nullptr);
}

void GLAPIENTRY glEvalCoord2dv(const GLdouble* v) {
    issue_reals<family::EvalCoord2, convert::Element::cast_d, 2>(v, SPANGLE_TEXT("glEvalCoord2dv: v is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_EVALUATORS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glEvalCoord2xOES(GLfixed u, GLfixed v) {
    const GLfixed given[] = {u, v};
    issue_reals<family::EvalCoord2, convert::Element::cast_x, 2>(given, nullptr);
}

void GLAPIENTRY glEvalCoord2xvOES(const GLfixed* v) {
    issue_reals<family::EvalCoord2, convert::Element::cast_x, 2>(v, SPANGLE_TEXT("glEvalCoord2xvOES: v is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_EVALUATORS

void GLAPIENTRY glMapGrid1f(GLint un, GLfloat u1, GLfloat u2) {
    issue<family::MapGrid1>(un, convert::cast_f(u1), convert::cast_f(u2));
}

void GLAPIENTRY glMapGrid1d(GLint un, GLdouble u1, GLdouble u2) {
    issue<family::MapGrid1>(un, convert::cast_d(u1), convert::cast_d(u2));
}

#endif

#if SPANGLE_FEATURE_EVALUATORS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMapGrid1xOES(GLint un, GLfixed u1, GLfixed u2) {
    issue<family::MapGrid1>(un, convert::cast_x(u1), convert::cast_x(u2));
}

#endif

#if SPANGLE_FEATURE_EVALUATORS

void GLAPIENTRY glMapGrid2f(GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2) {
    issue<family::MapGrid2>(un, convert::cast_f(u1), convert::cast_f(u2), vn, convert::cast_f(v1), convert::cast_f(v2));
}

void GLAPIENTRY glMapGrid2d(GLint un, GLdouble u1, GLdouble u2, GLint vn, GLdouble v1, GLdouble v2) {
    issue<family::MapGrid2>(un, convert::cast_d(u1), convert::cast_d(u2), vn, convert::cast_d(v1), convert::cast_d(v2));
}

#endif

#if SPANGLE_FEATURE_EVALUATORS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMapGrid2xOES(GLint un, GLfixed u1, GLfixed u2, GLint vn, GLfixed v1, GLfixed v2) {
    issue<family::MapGrid2>(un, convert::cast_x(u1), convert::cast_x(u2), vn, convert::cast_x(v1), convert::cast_x(v2));
}

#endif

#if SPANGLE_FEATURE_EVALUATORS

void GLAPIENTRY glEvalMesh1(GLenum mode, GLint i1, GLint i2) {
    issue<family::EvalMesh1>(mode, i1, i2);
}

void GLAPIENTRY glEvalMesh2(GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2) {
    issue<family::EvalMesh2>(mode, i1, i2, j1, j2);
}

void GLAPIENTRY glEvalPoint1(GLint i) {
    issue<family::EvalPoint1>(i);
}

void GLAPIENTRY glEvalPoint2(GLint i, GLint j) {
    issue<family::EvalPoint2>(i, j);
}

#endif

#if !SPANGLE_FEATURE_EVALUATORS

SPANGLE_REFUSED("glMap1f: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMap1f(GLenum, GLfloat, GLfloat, GLint, GLint, const GLfloat*))

SPANGLE_REFUSED("glMap1d: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMap1d(GLenum, GLdouble, GLdouble, GLint, GLint, const GLdouble*))

SPANGLE_REFUSED("glMap2f: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMap2f(GLenum, GLfloat, GLfloat, GLint, GLint, GLfloat, GLfloat, GLint, GLint, const GLfloat*))

SPANGLE_REFUSED("glMap2d: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMap2d(GLenum, GLdouble, GLdouble, GLint, GLint, GLdouble, GLdouble, GLint, GLint, const GLdouble*))

SPANGLE_REFUSED("glGetMapiv: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glGetMapiv(GLenum, GLenum, GLint*))

SPANGLE_REFUSED("glGetMapfv: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glGetMapfv(GLenum, GLenum, GLfloat*))

SPANGLE_REFUSED("glGetMapdv: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glGetMapdv(GLenum, GLenum, GLdouble*))

SPANGLE_REFUSED("glEvalCoord1f: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord1f(GLfloat))

SPANGLE_REFUSED("glEvalCoord1fv: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord1fv(const GLfloat*))

SPANGLE_REFUSED("glEvalCoord1d: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord1d(GLdouble))

SPANGLE_REFUSED("glEvalCoord1dv: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord1dv(const GLdouble*))

SPANGLE_REFUSED("glEvalCoord2f: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord2f(GLfloat, GLfloat))

SPANGLE_REFUSED("glEvalCoord2fv: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord2fv(const GLfloat*))

SPANGLE_REFUSED("glEvalCoord2d: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord2d(GLdouble, GLdouble))

SPANGLE_REFUSED("glEvalCoord2dv: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord2dv(const GLdouble*))

SPANGLE_REFUSED("glMapGrid1f: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMapGrid1f(GLint, GLfloat, GLfloat))

SPANGLE_REFUSED("glMapGrid1d: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMapGrid1d(GLint, GLdouble, GLdouble))

SPANGLE_REFUSED("glMapGrid2f: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMapGrid2f(GLint, GLfloat, GLfloat, GLint, GLfloat, GLfloat))

SPANGLE_REFUSED("glMapGrid2d: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMapGrid2d(GLint, GLdouble, GLdouble, GLint, GLdouble, GLdouble))

SPANGLE_REFUSED("glEvalMesh1: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalMesh1(GLenum, GLint, GLint))

SPANGLE_REFUSED("glEvalMesh2: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalMesh2(GLenum, GLint, GLint, GLint, GLint))

SPANGLE_REFUSED("glEvalPoint1: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalPoint1(GLint))

SPANGLE_REFUSED("glEvalPoint2: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalPoint2(GLint, GLint))

#endif

#if !SPANGLE_FEATURE_EVALUATORS

SPANGLE_REFUSED("glMap1xOES: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMap1xOES(GLenum, GLfixed, GLfixed, GLint, GLint, const GLfixed*))

SPANGLE_REFUSED("glMap2xOES: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMap2xOES(GLenum, GLfixed, GLfixed, GLint, GLint, GLfixed, GLfixed, GLint, GLint, const GLfixed*))

SPANGLE_REFUSED("glGetMapxvOES: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glGetMapxvOES(GLenum, GLenum, GLfixed*))

SPANGLE_REFUSED("glEvalCoord1xOES: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord1xOES(GLfixed))

SPANGLE_REFUSED("glEvalCoord1xvOES: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord1xvOES(const GLfixed*))

SPANGLE_REFUSED("glEvalCoord2xOES: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord2xOES(GLfixed, GLfixed))

SPANGLE_REFUSED("glEvalCoord2xvOES: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glEvalCoord2xvOES(const GLfixed*))

SPANGLE_REFUSED("glMapGrid1xOES: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMapGrid1xOES(GLint, GLfixed, GLfixed))

SPANGLE_REFUSED("glMapGrid2xOES: this build has no SPANGLE_FEATURE_EVALUATORS", void GLAPIENTRY glMapGrid2xOES(GLint, GLfixed, GLfixed, GLint, GLfixed, GLfixed))

#endif

#if SPANGLE_FEATURE_EVALUATORS && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glMap1xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMap1xOES(GLenum, GLfixed, GLfixed, GLint, GLint, const GLfixed*))

SPANGLE_REFUSED("glMap2xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMap2xOES(GLenum, GLfixed, GLfixed, GLint, GLint, GLfixed, GLfixed, GLint, GLint, const GLfixed*))

SPANGLE_REFUSED("glGetMapxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glGetMapxvOES(GLenum, GLenum, GLfixed*))

SPANGLE_REFUSED("glEvalCoord1xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glEvalCoord1xOES(GLfixed))

SPANGLE_REFUSED("glEvalCoord1xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glEvalCoord1xvOES(const GLfixed*))

SPANGLE_REFUSED("glEvalCoord2xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glEvalCoord2xOES(GLfixed, GLfixed))

SPANGLE_REFUSED("glEvalCoord2xvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glEvalCoord2xvOES(const GLfixed*))

SPANGLE_REFUSED("glMapGrid1xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMapGrid1xOES(GLint, GLfixed, GLfixed))

SPANGLE_REFUSED("glMapGrid2xOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMapGrid2xOES(GLint, GLfixed, GLfixed, GLint, GLfixed, GLfixed))

#endif

} // extern "C"
