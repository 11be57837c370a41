// Entry points: Fragments, framebuffer, pixels, fog, hints.
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

void GLAPIENTRY glScissor(GLint x, GLint y, GLsizei width, GLsizei height) {
    issue<family::Scissor>(x, y, width, height);
}

void GLAPIENTRY glAlphaFunc(GLenum func, GLclampf ref) {
    issue<family::AlphaFunc>(func, convert::cast_f(ref));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glAlphaFuncxOES(GLenum func, GLclampx ref) {
    issue<family::AlphaFunc>(func, convert::cast_x(ref));
}

#endif

void GLAPIENTRY glStencilFunc(GLenum func, GLint ref, GLuint mask) {
    issue<family::StencilFunc>(func, ref, mask);
}

void GLAPIENTRY glStencilOp(GLenum fail, GLenum zfail, GLenum zpass) {
    issue<family::StencilOp>(fail, zfail, zpass);
}

#if SPANGLE_FEATURE_STENCIL_SIDES

void GLAPIENTRY glStencilFuncSeparate(GLenum face, GLenum func, GLint ref, GLuint mask) {
    issue<family::StencilFuncSeparate>(face, func, ref, mask);
}

void GLAPIENTRY glStencilOpSeparate(GLenum face, GLenum fail, GLenum zfail, GLenum zpass) {
    issue<family::StencilOpSeparate>(face, fail, zfail, zpass);
}

void GLAPIENTRY glStencilMaskSeparate(GLenum face, GLuint mask) {
    issue<family::StencilMaskSeparate>(face, mask);
}

#endif

void GLAPIENTRY glSampleCoverage(GLclampf value, GLboolean invert) {
    issue<family::SampleCoverage>(convert::cast_f(value), invert != 0);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glSampleCoveragexOES(GLclampx value, GLboolean invert) {
    issue<family::SampleCoverage>(convert::cast_x(value), invert != 0);
}

#endif

void GLAPIENTRY glDepthFunc(GLenum func) {
    issue<family::DepthFunc>(func);
}

void GLAPIENTRY glBlendFunc(GLenum sfactor, GLenum dfactor) {
    issue<family::BlendFunc>(sfactor, dfactor);
}

void GLAPIENTRY glBlendFuncSeparate(GLenum src_rgb, GLenum dst_rgb, GLenum src_alpha, GLenum dst_alpha) {
    issue<family::BlendFuncSeparate>(src_rgb, dst_rgb, src_alpha, dst_alpha);
}

void GLAPIENTRY glBlendEquation(GLenum mode) {
    issue<family::BlendEquation>(mode);
}

void GLAPIENTRY glBlendEquationSeparate(GLenum rgb, GLenum alpha) {
    issue<family::BlendEquationSeparate>(rgb, alpha);
}

void GLAPIENTRY glBlendColor(GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha) {
    const GLclampf given[] = {red, green, blue, alpha};
    issue_reals<family::BlendColor, convert::Element::cast_f, 4>(given, nullptr);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glBlendColorxOES(GLclampx red, GLclampx green, GLclampx blue, GLclampx alpha) {
    const GLclampx given[] = {red, green, blue, alpha};
    issue_reals<family::BlendColor, convert::Element::cast_x, 4>(given, nullptr);
}

#endif

#if SPANGLE_FEATURE_ACCUM

void GLAPIENTRY glAccum(GLenum op, GLfloat value) {
    issue<family::Accum>(op, convert::cast_f(value));
}

#endif

#if SPANGLE_FEATURE_ACCUM && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glAccumxOES(GLenum op, GLfixed value) {
    issue<family::Accum>(op, convert::cast_x(value));
}

#endif

#if SPANGLE_FEATURE_ACCUM

void GLAPIENTRY glClearAccum(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    const GLfloat given[] = {red, green, blue, alpha};
    issue_reals<family::ClearAccum, convert::Element::cast_f, 4>(given, nullptr);
}

#endif

#if SPANGLE_FEATURE_ACCUM && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glClearAccumxOES(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha) {
    const GLfixed given[] = {red, green, blue, alpha};
    issue_reals<family::ClearAccum, convert::Element::cast_x, 4>(given, nullptr);
}

#endif

#if SPANGLE_FEATURE_QUERIES

void GLAPIENTRY glGenQueries(GLsizei n, GLuint* ids) {
    issue<family::GenQueries>(n, ids);
}

void GLAPIENTRY glDeleteQueries(GLsizei n, const GLuint* ids) {
    issue<family::DeleteQueries>(n, ids);
}

GLboolean GLAPIENTRY glIsQuery(GLuint id) {
    return ask<family::IsQuery>(id);
}

void GLAPIENTRY glBeginQuery(GLenum target, GLuint id) {
    issue<family::BeginQuery>(target, id);
}

void GLAPIENTRY glEndQuery(GLenum target) {
    issue<family::EndQuery>(target);
}

void GLAPIENTRY glGetQueryiv(GLenum target, GLenum pname, GLint* params) {
    issue<family::GetQueryiv>(target, pname, params);
}

void GLAPIENTRY glGetQueryObjectiv(GLuint id, GLenum pname, GLint* params) {
    issue<family::GetQueryObjectiv>(id, pname, params);
}

void GLAPIENTRY glGetQueryObjectuiv(GLuint id, GLenum pname, GLuint* params) {
    issue<family::GetQueryObjectuiv>(id, pname, params);
}

#endif

void GLAPIENTRY glLogicOp(GLenum opcode) {
    issue<family::LogicOp>(opcode);
}

void GLAPIENTRY glDrawBuffer(GLenum mode) {
    issue<family::DrawBuffer>(mode);
}

void GLAPIENTRY glReadBuffer(GLenum mode) {
    issue<family::ReadBuffer>(mode);
}

void GLAPIENTRY glColorMask(GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha) {
    issue<family::ColorMask>(red != 0, green != 0, blue != 0, alpha != 0);
}

void GLAPIENTRY glDepthMask(GLboolean flag) {
    issue<family::DepthMask>(flag != 0);
}

void GLAPIENTRY glStencilMask(GLuint mask) {
    issue<family::StencilMask>(mask);
}

void GLAPIENTRY glClear(GLbitfield mask) {
    issue<family::Clear>(mask);
}

void GLAPIENTRY glClearColor(GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha) {
    const GLclampf given[] = {red, green, blue, alpha};
    issue_reals<family::ClearColor, convert::Element::cast_f, 4>(given, nullptr);
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glClearColorxOES(GLclampx red, GLclampx green, GLclampx blue, GLclampx alpha) {
    const GLclampx given[] = {red, green, blue, alpha};
    issue_reals<family::ClearColor, convert::Element::cast_x, 4>(given, nullptr);
}

#endif

#if SPANGLE_FEATURE_COLOR_INDEX

void GLAPIENTRY glClearIndex(GLfloat index) {
    issue<family::ClearIndex>(convert::cast_f(index));
}

#endif

#if SPANGLE_FEATURE_COLOR_INDEX && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glClearIndexxOES(GLfixed index) {
    issue<family::ClearIndex>(convert::cast_x(index));
}

#endif

#if SPANGLE_FEATURE_COLOR_INDEX

void GLAPIENTRY glIndexMask(GLuint mask) {
    issue<family::IndexMask>(mask);
}

#endif

void GLAPIENTRY glClearDepth(GLclampd depth) {
    issue<family::ClearDepth>(convert::cast_d(depth));
}

void GLAPIENTRY glClearDepthf(GLclampf depth) {
    issue<family::ClearDepth>(convert::cast_f(depth));
}

#if SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glClearDepthxOES(GLclampx depth) {
    issue<family::ClearDepth>(convert::cast_x(depth));
}

#endif

void GLAPIENTRY glClearStencil(GLint s) {
    issue<family::ClearStencil>(s);
}

void GLAPIENTRY glPixelStoref(GLenum pname, GLfloat param) {
    issue_param<family::PixelStore, shape::PixelStore>(pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glPixelStorei(GLenum pname, GLint param) {
    issue_param<family::PixelStore, shape::PixelStore>(pname, convert::word(param), convert::Number::i);
}

#if SPANGLE_FEATURE_PIXEL_TRANSFER

void GLAPIENTRY glPixelTransferf(GLenum pname, GLfloat param) {
    issue_param<family::PixelTransfer, shape::PixelTransfer>(pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glPixelTransferi(GLenum pname, GLint param) {
    issue_param<family::PixelTransfer, shape::PixelTransfer>(pname, convert::word(param), convert::Number::i);
}

void GLAPIENTRY glPixelMapfv(GLenum map, GLsizei size, const GLfloat* values) {
    issue_array<family::PixelMap>(map, size, values, GL_FLOAT);
}

void GLAPIENTRY glPixelMapuiv(GLenum map, GLsizei size, const GLuint* values) {
    issue_array<family::PixelMap>(map, size, values, GL_UNSIGNED_INT);
}

void GLAPIENTRY glPixelMapusv(GLenum map, GLsizei size, const GLushort* values) {
    issue_array<family::PixelMap>(map, size, values, GL_UNSIGNED_SHORT);
}

void GLAPIENTRY glGetPixelMapfv(GLenum map, GLfloat* values) {
    issue_array<family::GetPixelMap>(map, values, GL_FLOAT);
}

void GLAPIENTRY glGetPixelMapuiv(GLenum map, GLuint* values) {
    issue_array<family::GetPixelMap>(map, values, GL_UNSIGNED_INT);
}

void GLAPIENTRY glGetPixelMapusv(GLenum map, GLushort* values) {
    issue_array<family::GetPixelMap>(map, values, GL_UNSIGNED_SHORT);
}

#endif

#if SPANGLE_FEATURE_DRAW_PIXELS

void GLAPIENTRY glPixelZoom(GLfloat xfactor, GLfloat yfactor) {
    const GLfloat given[] = {xfactor, yfactor};
    issue_reals<family::PixelZoom, convert::Element::cast_f, 2>(given, nullptr);
}

void GLAPIENTRY glDrawPixels(GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels) {
    issue<family::DrawPixels>(width, height, format, type, pixels);
}

void GLAPIENTRY glCopyPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum type) {
    issue<family::CopyPixels>(x, y, width, height, type);
}

#endif

#if SPANGLE_FEATURE_BITMAPS

void GLAPIENTRY glBitmap(GLsizei width, GLsizei height, GLfloat xorig, GLfloat yorig, GLfloat xmove, GLfloat ymove, const GLubyte* bitmap) {
    issue<family::Bitmap>(width, height, convert::cast_f(xorig), convert::cast_f(yorig), convert::cast_f(xmove), convert::cast_f(ymove), bitmap);
}

#endif

void GLAPIENTRY glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* pixels) {
    issue<family::ReadPixels>(x, y, width, height, format, type, pixels);
}

#if SPANGLE_FEATURE_FOG

void GLAPIENTRY glFogf(GLenum pname, GLfloat param) {
    issue_param<family::Fog, shape::Fog>(pname, convert::word(param), convert::Number::f);
}

void GLAPIENTRY glFogfv(GLenum pname, const GLfloat* params) {
    issue_params<family::Fog, shape::Fog>(pname, params, convert::Number::f, SPANGLE_TEXT("glFogfv: params is a null pointer"));
}

void GLAPIENTRY glFogi(GLenum pname, GLint param) {
    issue_param<family::Fog, shape::Fog>(pname, convert::word(param), convert::Number::i);
}

void GLAPIENTRY glFogiv(GLenum pname, const GLint* params) {
    issue_params<family::Fog, shape::Fog>(pname, params, convert::Number::i, SPANGLE_TEXT("glFogiv: params is a null pointer"));
}

#endif

#if SPANGLE_FEATURE_FOG && SPANGLE_FEATURE_FIXED_POINT

void GLAPIENTRY glFogxOES(GLenum pname, GLfixed param) {
    issue_param<family::Fog, shape::Fog>(pname, convert::word(param), convert::Number::x);
}

void GLAPIENTRY glFogxvOES(GLenum pname, const GLfixed* params) {
    issue_params<family::Fog, shape::Fog>(pname, params, convert::Number::x, SPANGLE_TEXT("glFogxvOES: params is a null pointer"));
}

#endif

void GLAPIENTRY glHint(GLenum target, GLenum mode) {
    issue<family::Hint>(target, mode);
}

void GLAPIENTRY glFlush() {
    issue<family::Flush>();
}

void GLAPIENTRY glFinish() {
    issue<family::Finish>();
}

#if !SPANGLE_FEATURE_ACCUM

SPANGLE_REFUSED("glAccum: this build has no SPANGLE_FEATURE_ACCUM", void GLAPIENTRY glAccum(GLenum, GLfloat))

SPANGLE_REFUSED("glClearAccum: this build has no SPANGLE_FEATURE_ACCUM", void GLAPIENTRY glClearAccum(GLfloat, GLfloat, GLfloat, GLfloat))

#endif

#if !SPANGLE_FEATURE_ACCUM

SPANGLE_REFUSED("glAccumxOES: this build has no SPANGLE_FEATURE_ACCUM", void GLAPIENTRY glAccumxOES(GLenum, GLfixed))

SPANGLE_REFUSED("glClearAccumxOES: this build has no SPANGLE_FEATURE_ACCUM", void GLAPIENTRY glClearAccumxOES(GLfixed, GLfixed, GLfixed, GLfixed))

#endif

#if SPANGLE_FEATURE_ACCUM && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glAccumxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glAccumxOES(GLenum, GLfixed))

SPANGLE_REFUSED("glClearAccumxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glClearAccumxOES(GLfixed, GLfixed, GLfixed, GLfixed))

#endif

#if !SPANGLE_FEATURE_BITMAPS

SPANGLE_REFUSED("glBitmap: this build has no SPANGLE_FEATURE_BITMAPS", void GLAPIENTRY glBitmap(GLsizei, GLsizei, GLfloat, GLfloat, GLfloat, GLfloat, const GLubyte*))

#endif

#if !SPANGLE_FEATURE_COLOR_INDEX

SPANGLE_REFUSED("glClearIndex: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glClearIndex(GLfloat))

SPANGLE_REFUSED("glIndexMask: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glIndexMask(GLuint))

#endif

#if !SPANGLE_FEATURE_COLOR_INDEX

SPANGLE_REFUSED("glClearIndexxOES: this build has no SPANGLE_FEATURE_COLOR_INDEX", void GLAPIENTRY glClearIndexxOES(GLfixed))

#endif

#if SPANGLE_FEATURE_COLOR_INDEX && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glClearIndexxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glClearIndexxOES(GLfixed))

#endif

#if !SPANGLE_FEATURE_DRAW_PIXELS

SPANGLE_REFUSED("glPixelZoom: this build has no SPANGLE_FEATURE_DRAW_PIXELS", void GLAPIENTRY glPixelZoom(GLfloat, GLfloat))

SPANGLE_REFUSED("glDrawPixels: this build has no SPANGLE_FEATURE_DRAW_PIXELS", void GLAPIENTRY glDrawPixels(GLsizei, GLsizei, GLenum, GLenum, const void*))

SPANGLE_REFUSED("glCopyPixels: this build has no SPANGLE_FEATURE_DRAW_PIXELS", void GLAPIENTRY glCopyPixels(GLint, GLint, GLsizei, GLsizei, GLenum))

#endif

#if !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glAlphaFuncxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glAlphaFuncxOES(GLenum, GLclampx))

SPANGLE_REFUSED("glSampleCoveragexOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glSampleCoveragexOES(GLclampx, GLboolean))

SPANGLE_REFUSED("glBlendColorxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glBlendColorxOES(GLclampx, GLclampx, GLclampx, GLclampx))

SPANGLE_REFUSED("glClearColorxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glClearColorxOES(GLclampx, GLclampx, GLclampx, GLclampx))

SPANGLE_REFUSED("glClearDepthxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glClearDepthxOES(GLclampx))

#endif

#if !SPANGLE_FEATURE_FOG

SPANGLE_REFUSED("glFogf: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogf(GLenum, GLfloat))

SPANGLE_REFUSED("glFogfv: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogfv(GLenum, const GLfloat*))

SPANGLE_REFUSED("glFogi: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogi(GLenum, GLint))

SPANGLE_REFUSED("glFogiv: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogiv(GLenum, const GLint*))

#endif

#if !SPANGLE_FEATURE_FOG

SPANGLE_REFUSED("glFogxOES: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogxOES(GLenum, GLfixed))

SPANGLE_REFUSED("glFogxvOES: this build has no SPANGLE_FEATURE_FOG", void GLAPIENTRY glFogxvOES(GLenum, const GLfixed*))

#endif

#if SPANGLE_FEATURE_FOG && !SPANGLE_FEATURE_FIXED_POINT

SPANGLE_REFUSED("glFogxOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glFogxOES(GLenum, GLfixed))

SPANGLE_REFUSED("glFogxvOES: this build has no SPANGLE_FEATURE_FIXED_POINT", void GLAPIENTRY glFogxvOES(GLenum, const GLfixed*))

#endif

#if !SPANGLE_FEATURE_PIXEL_TRANSFER

SPANGLE_REFUSED("glPixelTransferf: this build has no SPANGLE_FEATURE_PIXEL_TRANSFER", void GLAPIENTRY glPixelTransferf(GLenum, GLfloat))

SPANGLE_REFUSED("glPixelTransferi: this build has no SPANGLE_FEATURE_PIXEL_TRANSFER", void GLAPIENTRY glPixelTransferi(GLenum, GLint))

SPANGLE_REFUSED("glPixelMapfv: this build has no SPANGLE_FEATURE_PIXEL_TRANSFER", void GLAPIENTRY glPixelMapfv(GLenum, GLsizei, const GLfloat*))

SPANGLE_REFUSED("glPixelMapuiv: this build has no SPANGLE_FEATURE_PIXEL_TRANSFER", void GLAPIENTRY glPixelMapuiv(GLenum, GLsizei, const GLuint*))

SPANGLE_REFUSED("glPixelMapusv: this build has no SPANGLE_FEATURE_PIXEL_TRANSFER", void GLAPIENTRY glPixelMapusv(GLenum, GLsizei, const GLushort*))

SPANGLE_REFUSED("glGetPixelMapfv: this build has no SPANGLE_FEATURE_PIXEL_TRANSFER", void GLAPIENTRY glGetPixelMapfv(GLenum, GLfloat*))

SPANGLE_REFUSED("glGetPixelMapuiv: this build has no SPANGLE_FEATURE_PIXEL_TRANSFER", void GLAPIENTRY glGetPixelMapuiv(GLenum, GLuint*))

SPANGLE_REFUSED("glGetPixelMapusv: this build has no SPANGLE_FEATURE_PIXEL_TRANSFER", void GLAPIENTRY glGetPixelMapusv(GLenum, GLushort*))

#endif

#if !SPANGLE_FEATURE_QUERIES

SPANGLE_REFUSED("glGenQueries: this build has no SPANGLE_FEATURE_QUERIES", void GLAPIENTRY glGenQueries(GLsizei, GLuint*))

SPANGLE_REFUSED("glDeleteQueries: this build has no SPANGLE_FEATURE_QUERIES", void GLAPIENTRY glDeleteQueries(GLsizei, const GLuint*))

GLboolean GLAPIENTRY glIsQuery(GLuint) {
    refuse_feature(SPANGLE_TEXT("glIsQuery: this build has no SPANGLE_FEATURE_QUERIES"));
    return 0;
}

SPANGLE_REFUSED("glBeginQuery: this build has no SPANGLE_FEATURE_QUERIES", void GLAPIENTRY glBeginQuery(GLenum, GLuint))

SPANGLE_REFUSED("glEndQuery: this build has no SPANGLE_FEATURE_QUERIES", void GLAPIENTRY glEndQuery(GLenum))

SPANGLE_REFUSED("glGetQueryiv: this build has no SPANGLE_FEATURE_QUERIES", void GLAPIENTRY glGetQueryiv(GLenum, GLenum, GLint*))

SPANGLE_REFUSED("glGetQueryObjectiv: this build has no SPANGLE_FEATURE_QUERIES", void GLAPIENTRY glGetQueryObjectiv(GLuint, GLenum, GLint*))

SPANGLE_REFUSED("glGetQueryObjectuiv: this build has no SPANGLE_FEATURE_QUERIES", void GLAPIENTRY glGetQueryObjectuiv(GLuint, GLenum, GLuint*))

#endif

#if !SPANGLE_FEATURE_STENCIL_SIDES

SPANGLE_REFUSED("glStencilFuncSeparate: this build has no SPANGLE_FEATURE_STENCIL_SIDES", void GLAPIENTRY glStencilFuncSeparate(GLenum, GLenum, GLint, GLuint))

SPANGLE_REFUSED("glStencilOpSeparate: this build has no SPANGLE_FEATURE_STENCIL_SIDES", void GLAPIENTRY glStencilOpSeparate(GLenum, GLenum, GLenum, GLenum))

SPANGLE_REFUSED("glStencilMaskSeparate: this build has no SPANGLE_FEATURE_STENCIL_SIDES", void GLAPIENTRY glStencilMaskSeparate(GLenum, GLuint))

#endif

} // extern "C"
