// Entry points: Lighting, shading, facing, sizes.
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

#if SPANGLE_FEATURE_LIGHTING

void GLAPIENTRY glLightf(GLenum light, GLenum pname, GLfloat param) {
    issue_param<family::Light, shape::Light>(light, pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glLightfv(GLenum light, GLenum pname, const GLfloat* params) {
    issue_params<family::Light, shape::Light>(light, pname, params, convert::Number::f, SPANGLE_TEXT("glLightfv: params is a null pointer"));
}

void GLAPIENTRY glLighti(GLenum light, GLenum pname, GLint param) {
    issue_param<family::Light, shape::Light>(light, pname, convert::word(param), convert::Number::i);
}

void GLAPIENTRY glLightiv(GLenum light, GLenum pname, const GLint* params) {
    issue_params<family::Light, shape::Light>(light, pname, params, convert::Number::i, SPANGLE_TEXT("glLightiv: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_LIGHTING && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glLightxOES(GLenum light, GLenum pname, GLfixed param) {
    issue_param<family::Light, shape::Light>(light, pname, convert::word(param), convert::Number::x);
}

void GLAPIENTRY glLightxvOES(GLenum light, GLenum pname, const GLfixed* params) {
    issue_params<family::Light, shape::Light>(light, pname, params, convert::Number::x, SPANGLE_TEXT("glLightxvOES: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_LIGHTING

void GLAPIENTRY glGetLightfv(GLenum light, GLenum pname, GLfloat* params) {
    fetch_params<family::GetLight, shape::GetLight>(light, pname, params, convert::Number::f, SPANGLE_TEXT("glGetLightfv: params is a null pointer"));
}

void GLAPIENTRY glGetLightiv(GLenum light, GLenum pname, GLint* params) {
    fetch_params<family::GetLight, shape::GetLight>(light, pname, params, convert::Number::i, SPANGLE_TEXT("glGetLightiv: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_LIGHTING && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetLightxvOES(GLenum light, GLenum pname, GLfixed* params) {
    fetch_params<family::GetLight, shape::GetLight>(light, pname, params, convert::Number::x, SPANGLE_TEXT("glGetLightxvOES: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_LIGHTING

void GLAPIENTRY glLightModelf(GLenum pname, GLfloat param) {
    issue_param<family::LightModel, shape::LightModel>(pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glLightModelfv(GLenum pname, const GLfloat* params) {
    issue_params<family::LightModel, shape::LightModel>(pname, params, convert::Number::f, SPANGLE_TEXT("glLightModelfv: params is a null pointer"));
}

void GLAPIENTRY glLightModeli(GLenum pname, GLint param) {
    issue_param<family::LightModel, shape::LightModel>(pname, convert::word(param), convert::Number::i);
}

void GLAPIENTRY glLightModeliv(GLenum pname, const GLint* params) {
    issue_params<family::LightModel, shape::LightModel>(pname, params, convert::Number::i, SPANGLE_TEXT("glLightModeliv: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_LIGHTING && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glLightModelxOES(GLenum pname, GLfixed param) {
    issue_param<family::LightModel, shape::LightModel>(pname, convert::word(param), convert::Number::x);
}

void GLAPIENTRY glLightModelxvOES(GLenum pname, const GLfixed* params) {
    issue_params<family::LightModel, shape::LightModel>(pname, params, convert::Number::x, SPANGLE_TEXT("glLightModelxvOES: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_LIGHTING

void GLAPIENTRY glMaterialf(GLenum face, GLenum pname, GLfloat param) {
    issue_param<family::Material, shape::Material>(face, pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glMaterialfv(GLenum face, GLenum pname, const GLfloat* params) {
    issue_params<family::Material, shape::Material>(face, pname, params, convert::Number::f, SPANGLE_TEXT("glMaterialfv: params is a null pointer"));
}

void GLAPIENTRY glMateriali(GLenum face, GLenum pname, GLint param) {
    issue_param<family::Material, shape::Material>(face, pname, convert::word(param), convert::Number::i);
}

void GLAPIENTRY glMaterialiv(GLenum face, GLenum pname, const GLint* params) {
    issue_params<family::Material, shape::Material>(face, pname, params, convert::Number::i, SPANGLE_TEXT("glMaterialiv: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_LIGHTING && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glMaterialxOES(GLenum face, GLenum pname, GLfixed param) {
    issue_param<family::Material, shape::Material>(face, pname, convert::word(param), convert::Number::x);
}

void GLAPIENTRY glMaterialxvOES(GLenum face, GLenum pname, const GLfixed* params) {
    issue_params<family::Material, shape::Material>(face, pname, params, convert::Number::x, SPANGLE_TEXT("glMaterialxvOES: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_LIGHTING

void GLAPIENTRY glGetMaterialfv(GLenum face, GLenum pname, GLfloat* params) {
    fetch_params<family::GetMaterial, shape::GetMaterial>(face, pname, params, convert::Number::f, SPANGLE_TEXT("glGetMaterialfv: params is a null pointer"));
}

void GLAPIENTRY glGetMaterialiv(GLenum face, GLenum pname, GLint* params) {
    fetch_params<family::GetMaterial, shape::GetMaterial>(face, pname, params, convert::Number::i, SPANGLE_TEXT("glGetMaterialiv: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_LIGHTING && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glGetMaterialxvOES(GLenum face, GLenum pname, GLfixed* params) {
    fetch_params<family::GetMaterial, shape::GetMaterial>(face, pname, params, convert::Number::x, SPANGLE_TEXT("glGetMaterialxvOES: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_LIGHTING

void GLAPIENTRY glColorMaterial(GLenum face, GLenum mode) {
    issue<family::ColorMaterial>(face, mode);
}

#endif

void GLAPIENTRY glShadeModel(GLenum mode) {
    issue<family::ShadeModel>(mode);
}

void GLAPIENTRY glFrontFace(GLenum mode) {
    issue<family::FrontFace>(mode);
}

void GLAPIENTRY glCullFace(GLenum mode) {
    issue<family::CullFace>(mode);
}

#if SPANGLE_FEATURE_POLYGON_MODE

void GLAPIENTRY glPolygonMode(GLenum face, GLenum mode) {
    issue<family::PolygonMode>(face, mode);
}

#endif

void GLAPIENTRY glPointSize(GLfloat size) {
    issue<family::PointSize>(convert::cast_f(size));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glPointSizexOES(GLfixed size) {
    issue<family::PointSize>(convert::cast_x(size));
}

#endif

#if SPANGLE_FEATURE_POINT_PARAMETERS

void GLAPIENTRY glPointParameterf(GLenum pname, GLfloat param) {
    issue_param<family::PointParameter, shape::PointParameter>(pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glPointParameterfv(GLenum pname, const GLfloat* params) {
    issue_params<family::PointParameter, shape::PointParameter>(pname, params, convert::Number::f, SPANGLE_TEXT("glPointParameterfv: params is a null pointer"));
}

void GLAPIENTRY glPointParameteri(GLenum pname, GLint param) {
    issue_param<family::PointParameter, shape::PointParameter>(pname, convert::word(param), convert::Number::i);
}

void GLAPIENTRY glPointParameteriv(GLenum pname, const GLint* params) {
    issue_params<family::PointParameter, shape::PointParameter>(pname, params, convert::Number::i, SPANGLE_TEXT("glPointParameteriv: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_POINT_PARAMETERS && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glPointParameterxOES(GLenum pname, GLfixed param) {
    issue_param<family::PointParameter, shape::PointParameter>(pname, convert::word(param), convert::Number::x);
}

void GLAPIENTRY glPointParameterxvOES(GLenum pname, const GLfixed* params) {
    issue_params<family::PointParameter, shape::PointParameter>(pname, params, convert::Number::x, SPANGLE_TEXT("glPointParameterxvOES: params is a null pointer"));
}

#endif

void GLAPIENTRY glLineWidth(GLfloat width) {
    issue<family::LineWidth>(convert::cast_f(width));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glLineWidthxOES(GLfixed width) {
    issue<family::LineWidth>(convert::cast_x(width));
}

#endif

#if SPANGLE_FEATURE_STIPPLE

void GLAPIENTRY glLineStipple(GLint factor, GLushort pattern) {
    issue<family::LineStipple>(factor, pattern);
}

void GLAPIENTRY glPolygonStipple(const GLubyte* pattern) {
    issue<family::PolygonStipple>(pattern);
}

void GLAPIENTRY glGetPolygonStipple(GLubyte* pattern) {
    issue<family::GetPolygonStipple>(pattern);
}

#endif

#if SPANGLE_FEATURE_POLYGON_OFFSET

void GLAPIENTRY glPolygonOffset(GLfloat factor, GLfloat units) {
    const GLfloat given[] = {factor, units};
    issue_reals<family::PolygonOffset, convert::Element::cast_f, 2>(given, nullptr);
}

#endif

#if SPANGLE_FEATURE_POLYGON_OFFSET && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glPolygonOffsetxOES(GLfixed factor, GLfixed units) {
    const GLfixed given[] = {factor, units};
    issue_reals<family::PolygonOffset, convert::Element::cast_x, 2>(given, nullptr);
}

#endif

#if !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glPointSizexOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glPointSizexOES(GLfixed))

SPANGLE_REFUSED("glLineWidthxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glLineWidthxOES(GLfixed))

#endif

#if !SPANGLE_FEATURE_LIGHTING

SPANGLE_REFUSED("glLightf: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightf(GLenum, GLenum, GLfloat))

SPANGLE_REFUSED("glLightfv: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightfv(GLenum, GLenum, const GLfloat*))

SPANGLE_REFUSED("glLighti: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLighti(GLenum, GLenum, GLint))

SPANGLE_REFUSED("glLightiv: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightiv(GLenum, GLenum, const GLint*))

SPANGLE_REFUSED("glGetLightfv: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glGetLightfv(GLenum, GLenum, GLfloat*))

SPANGLE_REFUSED("glGetLightiv: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glGetLightiv(GLenum, GLenum, GLint*))

SPANGLE_REFUSED("glLightModelf: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightModelf(GLenum, GLfloat))

SPANGLE_REFUSED("glLightModelfv: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightModelfv(GLenum, const GLfloat*))

SPANGLE_REFUSED("glLightModeli: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightModeli(GLenum, GLint))

SPANGLE_REFUSED("glLightModeliv: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightModeliv(GLenum, const GLint*))

SPANGLE_REFUSED("glMaterialf: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glMaterialf(GLenum, GLenum, GLfloat))

SPANGLE_REFUSED("glMaterialfv: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glMaterialfv(GLenum, GLenum, const GLfloat*))

SPANGLE_REFUSED("glMateriali: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glMateriali(GLenum, GLenum, GLint))

SPANGLE_REFUSED("glMaterialiv: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glMaterialiv(GLenum, GLenum, const GLint*))

SPANGLE_REFUSED("glGetMaterialfv: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glGetMaterialfv(GLenum, GLenum, GLfloat*))

SPANGLE_REFUSED("glGetMaterialiv: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glGetMaterialiv(GLenum, GLenum, GLint*))

SPANGLE_REFUSED("glColorMaterial: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glColorMaterial(GLenum, GLenum))

#endif

#if !SPANGLE_FEATURE_LIGHTING

SPANGLE_REFUSED("glLightxOES: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightxOES(GLenum, GLenum, GLfixed))

SPANGLE_REFUSED("glLightxvOES: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightxvOES(GLenum, GLenum, const GLfixed*))

SPANGLE_REFUSED("glGetLightxvOES: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glGetLightxvOES(GLenum, GLenum, GLfixed*))

SPANGLE_REFUSED("glLightModelxOES: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightModelxOES(GLenum, GLfixed))

SPANGLE_REFUSED("glLightModelxvOES: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glLightModelxvOES(GLenum, const GLfixed*))

SPANGLE_REFUSED("glMaterialxOES: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glMaterialxOES(GLenum, GLenum, GLfixed))

SPANGLE_REFUSED("glMaterialxvOES: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glMaterialxvOES(GLenum, GLenum, const GLfixed*))

SPANGLE_REFUSED("glGetMaterialxvOES: this build has no SPANGLE_FEATURE_LIGHTING", void GLAPIENTRY glGetMaterialxvOES(GLenum, GLenum, GLfixed*))

#endif

#if SPANGLE_FEATURE_LIGHTING && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glLightxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glLightxOES(GLenum, GLenum, GLfixed))

SPANGLE_REFUSED("glLightxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glLightxvOES(GLenum, GLenum, const GLfixed*))

SPANGLE_REFUSED("glGetLightxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glGetLightxvOES(GLenum, GLenum, GLfixed*))

SPANGLE_REFUSED("glLightModelxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glLightModelxOES(GLenum, GLfixed))

SPANGLE_REFUSED("glLightModelxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glLightModelxvOES(GLenum, const GLfixed*))

SPANGLE_REFUSED("glMaterialxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMaterialxOES(GLenum, GLenum, GLfixed))

SPANGLE_REFUSED("glMaterialxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glMaterialxvOES(GLenum, GLenum, const GLfixed*))

SPANGLE_REFUSED("glGetMaterialxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glGetMaterialxvOES(GLenum, GLenum, GLfixed*))

#endif

#if !SPANGLE_FEATURE_POINT_PARAMETERS

SPANGLE_REFUSED("glPointParameterf: this build has no SPANGLE_FEATURE_POINT_PARAMETERS", void GLAPIENTRY glPointParameterf(GLenum, GLfloat))

SPANGLE_REFUSED("glPointParameterfv: this build has no SPANGLE_FEATURE_POINT_PARAMETERS", void GLAPIENTRY glPointParameterfv(GLenum, const GLfloat*))

SPANGLE_REFUSED("glPointParameteri: this build has no SPANGLE_FEATURE_POINT_PARAMETERS", void GLAPIENTRY glPointParameteri(GLenum, GLint))

SPANGLE_REFUSED("glPointParameteriv: this build has no SPANGLE_FEATURE_POINT_PARAMETERS", void GLAPIENTRY glPointParameteriv(GLenum, const GLint*))

#endif

#if !SPANGLE_FEATURE_POINT_PARAMETERS

SPANGLE_REFUSED("glPointParameterxOES: this build has no SPANGLE_FEATURE_POINT_PARAMETERS", void GLAPIENTRY glPointParameterxOES(GLenum, GLfixed))

SPANGLE_REFUSED("glPointParameterxvOES: this build has no SPANGLE_FEATURE_POINT_PARAMETERS", void GLAPIENTRY glPointParameterxvOES(GLenum, const GLfixed*))

#endif

#if SPANGLE_FEATURE_POINT_PARAMETERS && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glPointParameterxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glPointParameterxOES(GLenum, GLfixed))

SPANGLE_REFUSED("glPointParameterxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glPointParameterxvOES(GLenum, const GLfixed*))

#endif

#if !SPANGLE_FEATURE_POLYGON_MODE

SPANGLE_REFUSED("glPolygonMode: this build has no SPANGLE_FEATURE_POLYGON_MODE", void GLAPIENTRY glPolygonMode(GLenum, GLenum))

#endif

#if !SPANGLE_FEATURE_POLYGON_OFFSET

SPANGLE_REFUSED("glPolygonOffset: this build has no SPANGLE_FEATURE_POLYGON_OFFSET", void GLAPIENTRY glPolygonOffset(GLfloat, GLfloat))

#endif

#if !SPANGLE_FEATURE_POLYGON_OFFSET

SPANGLE_REFUSED("glPolygonOffsetxOES: this build has no SPANGLE_FEATURE_POLYGON_OFFSET", void GLAPIENTRY glPolygonOffsetxOES(GLfixed, GLfixed))

#endif

#if SPANGLE_FEATURE_POLYGON_OFFSET && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glPolygonOffsetxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glPolygonOffsetxOES(GLfixed, GLfixed))

#endif

#if !SPANGLE_FEATURE_STIPPLE

SPANGLE_REFUSED("glLineStipple: this build has no SPANGLE_FEATURE_STIPPLE", void GLAPIENTRY glLineStipple(GLint, GLushort))

SPANGLE_REFUSED("glPolygonStipple: this build has no SPANGLE_FEATURE_STIPPLE", void GLAPIENTRY glPolygonStipple(const GLubyte*))

SPANGLE_REFUSED("glGetPolygonStipple: this build has no SPANGLE_FEATURE_STIPPLE", void GLAPIENTRY glGetPolygonStipple(GLubyte*))

#endif

} // extern "C"
