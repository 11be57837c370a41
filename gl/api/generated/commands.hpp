// One handwritten function per family, and what the wrappers know about it.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#pragma once

#include "gl/api/family.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {
struct Context;
}

namespace spangle::gl::cmd {

// Errors, enables, queries (GL 1.3, 2.5, 6.1).
GLenum GetError(Context& context);
void Enable(Context& context, GLenum cap);
void Disable(Context& context, GLenum cap);
GLboolean IsEnabled(Context& context, GLenum cap);
void GetBooleanv(Context& context, GLenum pname, GLboolean* params);
void GetIntegerv(Context& context, GLenum pname, GLint* params);
void GetFloatv(Context& context, GLenum pname, GLfloat* params);
void GetDoublev(Context& context, GLenum pname, GLdouble* params);
void GetFixedvOES(Context& context, GLenum pname, GLfixed* params);
void GetPointerv(Context& context, GLenum pname, void** params);
const GLubyte* GetString(Context& context, GLenum name);
void PushAttrib(Context& context, GLbitfield mask);
void PopAttrib(Context& context);
void PushClientAttrib(Context& context, GLbitfield mask);
void PopClientAttrib(Context& context);

// Vertices, attributes, arrays (GL 1.3, 2.6 to 2.9).
void Begin(Context& context, GLenum mode);
void End(Context& context);
void Vertex(Context& context, Real x, Real y, Real z, Real w);
void TexCoord(Context& context, Real s, Real t, Real r, Real q);
void MultiTexCoord(Context& context, GLenum target, Real s, Real t, Real r, Real q);
void Normal(Context& context, Real x, Real y, Real z);
void Color(Context& context, Real red, Real green, Real blue, Real alpha);
void SecondaryColor(Context& context, Real red, Real green, Real blue);
void Index(Context& context, Real index);
void EdgeFlag(Context& context, bool flag);
void FogCoord(Context& context, Real coord);
void RasterPos(Context& context, Real x, Real y, Real z, Real w);
void WindowPos(Context& context, Real x, Real y, Real z);
void Rect(Context& context, Real x1, Real y1, Real x2, Real y2);
void VertexPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer);
void NormalPointer(Context& context, GLenum type, GLsizei stride, const void* pointer);
void ColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer);
void TexCoordPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer);
void IndexPointer(Context& context, GLenum type, GLsizei stride, const void* pointer);
void EdgeFlagPointer(Context& context, GLsizei stride, const void* pointer);
void FogCoordPointer(Context& context, GLenum type, GLsizei stride, const void* pointer);
void SecondaryColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer);
void ClientActiveTexture(Context& context, GLenum texture);
void EnableClientState(Context& context, GLenum array);
void DisableClientState(Context& context, GLenum array);
void ArrayElement(Context& context, GLint i);
void DrawArrays(Context& context, GLenum mode, GLint first, GLsizei count);
void DrawElements(Context& context, GLenum mode, GLsizei count, GLenum type, const void* indices);
void DrawRangeElements(Context& context, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type, const void* indices);
void MultiDrawArrays(Context& context, GLenum mode, const GLint* first, const GLsizei* count, GLsizei primcount);
void MultiDrawElements(Context& context, GLenum mode, const GLsizei* count, GLenum type, const void** indices, GLsizei primcount);
void PrimitiveRestartIndex(Context& context, GLuint index);
void GenVertexArrays(Context& context, GLsizei n, GLuint* arrays);
void DeleteVertexArrays(Context& context, GLsizei n, const GLuint* arrays);
GLboolean IsVertexArray(Context& context, GLuint array);
void BindVertexArray(Context& context, GLuint array);
void GenBuffers(Context& context, GLsizei n, GLuint* buffers);
void DeleteBuffers(Context& context, GLsizei n, const GLuint* buffers);
GLboolean IsBuffer(Context& context, GLuint buffer);
void BindBuffer(Context& context, GLenum target, GLuint buffer);
void BufferData(Context& context, GLenum target, GLsizeiptr size, const void* data, GLenum usage);
void BufferConstantDataSPANGLE(Context& context, GLenum target, GLsizeiptr size, const void* data);
void BufferSubData(Context& context, GLenum target, GLintptr offset, GLsizeiptr size, const void* data);
void GetBufferSubData(Context& context, GLenum target, GLintptr offset, GLsizeiptr size, void* data);
void GetBufferParameteriv(Context& context, GLenum target, GLenum pname, GLint* params);
void* MapBuffer(Context& context, GLenum target, GLenum access);
void* MapBufferRange(Context& context, GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access);
void FlushMappedBufferRange(Context& context, GLenum target, GLintptr offset, GLsizeiptr length);
GLboolean UnmapBuffer(Context& context, GLenum target);
void GetBufferPointerv(Context& context, GLenum target, GLenum pname, void** params);
void InterleavedArrays(Context& context, GLenum format, GLsizei stride, const void* pointer);

// Matrices, viewport (GL 1.3, 2.10).
void MatrixMode(Context& context, GLenum mode);
void LoadIdentity(Context& context);
void LoadMatrix(Context& context, const Matrix16& matrix);
void MultMatrix(Context& context, const Matrix16& matrix);
void LoadTransposeMatrix(Context& context, const Matrix16& matrix);
void MultTransposeMatrix(Context& context, const Matrix16& matrix);
void PushMatrix(Context& context);
void PopMatrix(Context& context);
void Rotate(Context& context, Real angle, Real x, Real y, Real z);
void Translate(Context& context, Real x, Real y, Real z);
void Scale(Context& context, Real x, Real y, Real z);
void Frustum(Context& context, Real left, Real right, Real bottom, Real top, Real near_val, Real far_val);
void Ortho(Context& context, Real left, Real right, Real bottom, Real top, Real near_val, Real far_val);
void Viewport(Context& context, GLint x, GLint y, GLsizei width, GLsizei height);
void DepthRange(Context& context, Real near_val, Real far_val);
void ClipPlane(Context& context, GLenum plane, Real a, Real b, Real c, Real d);
void TexGen(Context& context, GLenum coord, GLenum pname, const Params& params);
void GetTexGen(Context& context, GLenum coord, GLenum pname, Params& params);
void GetClipPlane(Context& context, GLenum plane, GLdouble* equation);

// Lighting, shading, facing, sizes (GL 1.3, 2.13, 3.3 to 3.5).
void Light(Context& context, GLenum light, GLenum pname, const Params& params);
void GetLight(Context& context, GLenum light, GLenum pname, Params& params);
void LightModel(Context& context, GLenum pname, const Params& params);
void Material(Context& context, GLenum face, GLenum pname, const Params& params);
void GetMaterial(Context& context, GLenum face, GLenum pname, Params& params);
void ColorMaterial(Context& context, GLenum face, GLenum mode);
void ShadeModel(Context& context, GLenum mode);
void FrontFace(Context& context, GLenum mode);
void CullFace(Context& context, GLenum mode);
void PolygonMode(Context& context, GLenum face, GLenum mode);
void PointSize(Context& context, Real size);
void PointParameter(Context& context, GLenum pname, const Params& params);
void LineWidth(Context& context, Real width);
void LineStipple(Context& context, GLint factor, GLushort pattern);
void PolygonStipple(Context& context, const GLubyte* pattern);
void GetPolygonStipple(Context& context, GLubyte* pattern);
void PolygonOffset(Context& context, Real factor, Real units);

// Fragments, framebuffer, pixels, fog, hints (GL 1.3, 3.6, 3.10, 4, 5.5, 5.6).
void Scissor(Context& context, GLint x, GLint y, GLsizei width, GLsizei height);
void AlphaFunc(Context& context, GLenum func, Real ref);
void StencilFunc(Context& context, GLenum func, GLint ref, GLuint mask);
void StencilOp(Context& context, GLenum fail, GLenum zfail, GLenum zpass);
void StencilFuncSeparate(Context& context, GLenum face, GLenum func, GLint ref, GLuint mask);
void StencilOpSeparate(Context& context, GLenum face, GLenum fail, GLenum zfail, GLenum zpass);
void StencilMaskSeparate(Context& context, GLenum face, GLuint mask);
void SampleCoverage(Context& context, Real value, bool invert);
void DepthFunc(Context& context, GLenum func);
void BlendFunc(Context& context, GLenum sfactor, GLenum dfactor);
void BlendFuncSeparate(Context& context, GLenum src_rgb, GLenum dst_rgb, GLenum src_alpha, GLenum dst_alpha);
void BlendEquation(Context& context, GLenum mode);
void BlendEquationSeparate(Context& context, GLenum rgb, GLenum alpha);
void BlendColor(Context& context, Real red, Real green, Real blue, Real alpha);
void Accum(Context& context, GLenum op, Real value);
void ClearAccum(Context& context, Real red, Real green, Real blue, Real alpha);
void GenQueries(Context& context, GLsizei n, GLuint* ids);
void DeleteQueries(Context& context, GLsizei n, const GLuint* ids);
GLboolean IsQuery(Context& context, GLuint id);
void BeginQuery(Context& context, GLenum target, GLuint id);
void EndQuery(Context& context, GLenum target);
void GetQueryiv(Context& context, GLenum target, GLenum pname, GLint* params);
void GetQueryObjectiv(Context& context, GLuint id, GLenum pname, GLint* params);
void GetQueryObjectuiv(Context& context, GLuint id, GLenum pname, GLuint* params);
void LogicOp(Context& context, GLenum opcode);
void DrawBuffer(Context& context, GLenum mode);
void ReadBuffer(Context& context, GLenum mode);
void ColorMask(Context& context, bool red, bool green, bool blue, bool alpha);
void DepthMask(Context& context, bool flag);
void StencilMask(Context& context, GLuint mask);
void Clear(Context& context, GLbitfield mask);
void ClearColor(Context& context, Real red, Real green, Real blue, Real alpha);
void ClearIndex(Context& context, Real index);
void IndexMask(Context& context, GLuint mask);
void ClearDepth(Context& context, Real depth);
void ClearStencil(Context& context, GLint s);
void PixelStore(Context& context, GLenum pname, const Params& params);
void PixelTransfer(Context& context, GLenum pname, const Params& params);
void PixelMap(Context& context, GLenum map, GLsizei size, const Values& values);
void GetPixelMap(Context& context, GLenum map, const Values& values);
void PixelZoom(Context& context, Real xfactor, Real yfactor);
void DrawPixels(Context& context, GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels);
void CopyPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type);
void Bitmap(Context& context, GLsizei width, GLsizei height, Real xorig, Real yorig, Real xmove, Real ymove, const GLubyte* bitmap);
void ReadPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* pixels);
void Fog(Context& context, GLenum pname, const Params& params);
void Hint(Context& context, GLenum target, GLenum mode);
void Flush(Context& context);
void Finish(Context& context);

// Textures (GL 1.3, 3.8).
void TexImage1D(Context& context, const ImageCommand& image);
void TexImage2D(Context& context, const ImageCommand& image);
void TexConstantImage2DSPANGLE(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data);
void TexImage3D(Context& context, const ImageCommand& image);
void TexSubImage1D(Context& context, const ImageCommand& image);
void TexSubImage2D(Context& context, const ImageCommand& image);
void TexSubImage3D(Context& context, const ImageCommand& image);
void CopyTexImage1D(Context& context, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width, GLint border);
void CopyTexImage2D(Context& context, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width, GLsizei height, GLint border);
void CopyTexSubImage1D(Context& context, GLenum target, GLint level, GLint xoffset, GLint x, GLint y, GLsizei width);
void CopyTexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x, GLint y, GLsizei width, GLsizei height);
void CopyTexSubImage3D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height);
void CompressedTexImage1D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width, GLint border, GLsizei imageSize, const void* data);
void CompressedTexImage2D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data);
void CompressedTexImage3D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLsizei depth, GLint border, GLsizei imageSize, const void* data);
void CompressedTexSubImage1D(Context& context, GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format, GLsizei imageSize, const void* data);
void CompressedTexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width, GLsizei height, GLenum format, GLsizei imageSize, const void* data);
void CompressedTexSubImage3D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLsizei imageSize, const void* data);
void CompressedTexConstantImage2DSPANGLE(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data);
void GetTexImage(Context& context, GLenum target, GLint level, GLenum format, GLenum type, void* pixels);
void GetCompressedTexImage(Context& context, GLenum target, GLint level, void* data);
void GenerateMipmap(Context& context, GLenum target);
GLboolean AreTexturesResident(Context& context, GLsizei n, const GLuint* textures, GLboolean* residences);
void PrioritizeTextures(Context& context, GLsizei n, const GLuint* textures, const GLclampf* priorities);
void GenTextures(Context& context, GLsizei n, GLuint* textures);
void DeleteTextures(Context& context, GLsizei n, const GLuint* textures);
void BindTexture(Context& context, GLenum target, GLuint texture);
void ActiveTexture(Context& context, GLenum texture);
GLboolean IsTexture(Context& context, GLuint texture);
void TexParameter(Context& context, GLenum target, GLenum pname, const Params& params);
void GetTexParameter(Context& context, GLenum target, GLenum pname, Params& params);
void TexEnv(Context& context, GLenum target, GLenum pname, const Params& params);
void GetTexEnv(Context& context, GLenum target, GLenum pname, Params& params);
void GetTexLevelParameter(Context& context, GLenum target, GLint level, GLenum pname, Params& params);

// Display lists (GL 1.3, 5.4).
void NewList(Context& context, GLuint list, GLenum mode);
void EndList(Context& context);
void CallList(Context& context, GLuint list);
void CallLists(Context& context, GLsizei n, GLenum type, const void* lists);
void ListBase(Context& context, GLuint base);
GLuint GenLists(Context& context, GLsizei range);
void DeleteLists(Context& context, GLuint list, GLsizei range);
GLboolean IsList(Context& context, GLuint list);

// Selection, feedback (GL 1.3, 5.2, 5.3).
GLint RenderMode(Context& context, GLenum mode);
void SelectBuffer(Context& context, GLsizei size, GLuint* buffer);
void InitNames(Context& context);
void PushName(Context& context, GLuint name);
void PopName(Context& context);
void LoadName(Context& context, GLuint name);
void FeedbackBuffer(Context& context, GLsizei size, GLenum type, const Values& buffer);
void PassThrough(Context& context, Real token);

// Evaluators (GL 1.3, 5.1).
void Map1(Context& context, GLenum target, Real u1, Real u2, GLint stride, GLint order, const Values& points);
void Map2(Context& context, GLenum target, Real u1, Real u2, GLint ustride, GLint uorder, Real v1, Real v2, GLint vstride, GLint vorder, const Values& points);
void GetMap(Context& context, GLenum target, GLenum query, const Values& v);
void EvalCoord1(Context& context, Real u);
void EvalCoord2(Context& context, Real u, Real v);
void MapGrid1(Context& context, GLint un, Real u1, Real u2);
void MapGrid2(Context& context, GLint un, Real u1, Real u2, GLint vn, Real v1, Real v2);
void EvalMesh1(Context& context, GLenum mode, GLint i1, GLint i2);
void EvalMesh2(Context& context, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2);
void EvalPoint1(Context& context, GLint i);
void EvalPoint2(Context& context, GLint i, GLint j);

} // namespace spangle::gl::cmd

/// Handwritten encoders of display lists, in gl/list.
namespace spangle::gl::encode {

void Vertex(Context& context, Real x, Real y, Real z, Real w);
void TexCoord(Context& context, Real s, Real t, Real r, Real q);
void Normal(Context& context, Real x, Real y, Real z);
void Color(Context& context, Real red, Real green, Real blue, Real alpha);
void ArrayElement(Context& context, GLint i);
void DrawArrays(Context& context, GLenum mode, GLint first, GLsizei count);
void DrawElements(Context& context, GLenum mode, GLsizei count, GLenum type, const void* indices);
void DrawRangeElements(Context& context, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type, const void* indices);
void MultiDrawArrays(Context& context, GLenum mode, const GLint* first, const GLsizei* count, GLsizei primcount);
void MultiDrawElements(Context& context, GLenum mode, const GLsizei* count, GLenum type, const void** indices, GLsizei primcount);
void PolygonStipple(Context& context, const GLubyte* pattern);
void PixelMap(Context& context, GLenum map, GLsizei size, const Values& values);
void DrawPixels(Context& context, GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels);
void Bitmap(Context& context, GLsizei width, GLsizei height, Real xorig, Real yorig, Real xmove, Real ymove, const GLubyte* bitmap);
void TexImage1D(Context& context, const ImageCommand& image);
void TexImage2D(Context& context, const ImageCommand& image);
void TexImage3D(Context& context, const ImageCommand& image);
void TexSubImage1D(Context& context, const ImageCommand& image);
void TexSubImage2D(Context& context, const ImageCommand& image);
void TexSubImage3D(Context& context, const ImageCommand& image);
void CompressedTexImage2D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data);
void CompressedTexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width, GLsizei height, GLenum format, GLsizei imageSize, const void* data);
void PrioritizeTextures(Context& context, GLsizei n, const GLuint* textures, const GLclampf* priorities);
void CallList(Context& context, GLuint list);
void CallLists(Context& context, GLsizei n, GLenum type, const void* lists);
void Map1(Context& context, GLenum target, Real u1, Real u2, GLint stride, GLint order, const Values& points);
void Map2(Context& context, GLenum target, Real u1, Real u2, GLint ustride, GLint uorder, Real v1, Real v2, GLint vstride, GLint vorder, const Values& points);

} // namespace spangle::gl::encode

namespace spangle::gl::family {

struct GetError {
    static constexpr auto run = &cmd::GetError;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetError between glBegin and glEnd");
};
struct Enable {
    static constexpr auto run = &cmd::Enable;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glEnable between glBegin and glEnd");
};
struct Disable {
    static constexpr auto run = &cmd::Disable;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glDisable between glBegin and glEnd");
};
struct IsEnabled {
    static constexpr auto run = &cmd::IsEnabled;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glIsEnabled between glBegin and glEnd");
};
struct GetBooleanv {
    static constexpr auto run = &cmd::GetBooleanv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetBooleanv between glBegin and glEnd");
};
struct GetIntegerv {
    static constexpr auto run = &cmd::GetIntegerv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetIntegerv between glBegin and glEnd");
};
struct GetFloatv {
    static constexpr auto run = &cmd::GetFloatv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetFloatv between glBegin and glEnd");
};
struct GetDoublev {
    static constexpr auto run = &cmd::GetDoublev;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetDoublev between glBegin and glEnd");
};
struct GetFixedvOES {
    static constexpr auto run = &cmd::GetFixedvOES;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetFixedvOES between glBegin and glEnd");
};
struct GetPointerv {
    static constexpr auto run = &cmd::GetPointerv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetPointerv between glBegin and glEnd");
};
struct GetString {
    static constexpr auto run = &cmd::GetString;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetString between glBegin and glEnd");
};
struct PushAttrib {
    static constexpr auto run = sharing<&cmd::PushAttrib>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPushAttrib between glBegin and glEnd");
};
struct PopAttrib {
    static constexpr auto run = sharing<&cmd::PopAttrib>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPopAttrib between glBegin and glEnd");
};
struct PushClientAttrib {
    static constexpr auto run = sharing<&cmd::PushClientAttrib>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glPushClientAttrib between glBegin and glEnd");
};
struct PopClientAttrib {
    static constexpr auto run = sharing<&cmd::PopClientAttrib>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glPopClientAttrib between glBegin and glEnd");
};
struct Begin {
    static constexpr auto run = &cmd::Begin;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glBegin between glBegin and glEnd");
};
struct End {
    static constexpr auto run = &cmd::End;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glEnd between glBegin and glEnd");
};
struct Vertex {
    static constexpr auto run = &cmd::Vertex;
    static constexpr auto encode = &encode::Vertex;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::attribute;
    static constexpr const char* refusal = SPANGLE_TEXT("glVertex between glBegin and glEnd");
};
struct TexCoord {
    static constexpr auto run = &cmd::TexCoord;
    static constexpr auto encode = &encode::TexCoord;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::attribute;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexCoord between glBegin and glEnd");
};
struct MultiTexCoord {
    static constexpr auto run = &cmd::MultiTexCoord;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glMultiTexCoord between glBegin and glEnd");
};
struct Normal {
    static constexpr auto run = &cmd::Normal;
    static constexpr auto encode = &encode::Normal;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::attribute;
    static constexpr const char* refusal = SPANGLE_TEXT("glNormal between glBegin and glEnd");
};
struct Color {
    static constexpr auto run = &cmd::Color;
    static constexpr auto encode = &encode::Color;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::attribute;
    static constexpr const char* refusal = SPANGLE_TEXT("glColor between glBegin and glEnd");
};
struct SecondaryColor {
    static constexpr auto run = &cmd::SecondaryColor;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glSecondaryColor between glBegin and glEnd");
};
struct Index {
    static constexpr auto run = &cmd::Index;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glIndex between glBegin and glEnd");
};
struct EdgeFlag {
    static constexpr auto run = &cmd::EdgeFlag;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glEdgeFlag between glBegin and glEnd");
};
struct FogCoord {
    static constexpr auto run = &cmd::FogCoord;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glFogCoord between glBegin and glEnd");
};
struct RasterPos {
    static constexpr auto run = &cmd::RasterPos;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glRasterPos between glBegin and glEnd");
};
struct WindowPos {
    static constexpr auto run = &cmd::WindowPos;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glWindowPos between glBegin and glEnd");
};
struct Rect {
    static constexpr auto run = &cmd::Rect;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glRect between glBegin and glEnd");
};
struct VertexPointer {
    static constexpr auto run = sharing<&cmd::VertexPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glVertexPointer between glBegin and glEnd");
};
struct NormalPointer {
    static constexpr auto run = sharing<&cmd::NormalPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glNormalPointer between glBegin and glEnd");
};
struct ColorPointer {
    static constexpr auto run = sharing<&cmd::ColorPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glColorPointer between glBegin and glEnd");
};
struct TexCoordPointer {
    static constexpr auto run = sharing<&cmd::TexCoordPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexCoordPointer between glBegin and glEnd");
};
struct IndexPointer {
    static constexpr auto run = sharing<&cmd::IndexPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glIndexPointer between glBegin and glEnd");
};
struct EdgeFlagPointer {
    static constexpr auto run = sharing<&cmd::EdgeFlagPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glEdgeFlagPointer between glBegin and glEnd");
};
struct FogCoordPointer {
    static constexpr auto run = sharing<&cmd::FogCoordPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glFogCoordPointer between glBegin and glEnd");
};
struct SecondaryColorPointer {
    static constexpr auto run = sharing<&cmd::SecondaryColorPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glSecondaryColorPointer between glBegin and glEnd");
};
struct ClientActiveTexture {
    static constexpr auto run = &cmd::ClientActiveTexture;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glClientActiveTexture between glBegin and glEnd");
};
struct EnableClientState {
    static constexpr auto run = &cmd::EnableClientState;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glEnableClientState between glBegin and glEnd");
};
struct DisableClientState {
    static constexpr auto run = &cmd::DisableClientState;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glDisableClientState between glBegin and glEnd");
};
struct ArrayElement {
    static constexpr auto run = sharing<&cmd::ArrayElement>;
    static constexpr auto encode = sharing<&encode::ArrayElement>;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glArrayElement between glBegin and glEnd");
};
struct DrawArrays {
    static constexpr auto run = sharing<&cmd::DrawArrays>;
    static constexpr auto encode = sharing<&encode::DrawArrays>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glDrawArrays between glBegin and glEnd");
};
struct DrawElements {
    static constexpr auto run = sharing<&cmd::DrawElements>;
    static constexpr auto encode = sharing<&encode::DrawElements>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glDrawElements between glBegin and glEnd");
};
struct DrawRangeElements {
    static constexpr auto run = sharing<&cmd::DrawRangeElements>;
    static constexpr auto encode = sharing<&encode::DrawRangeElements>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glDrawRangeElements between glBegin and glEnd");
};
struct MultiDrawArrays {
    static constexpr auto run = sharing<&cmd::MultiDrawArrays>;
    static constexpr auto encode = sharing<&encode::MultiDrawArrays>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glMultiDrawArrays between glBegin and glEnd");
};
struct MultiDrawElements {
    static constexpr auto run = sharing<&cmd::MultiDrawElements>;
    static constexpr auto encode = sharing<&encode::MultiDrawElements>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glMultiDrawElements between glBegin and glEnd");
};
struct PrimitiveRestartIndex {
    static constexpr auto run = &cmd::PrimitiveRestartIndex;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glPrimitiveRestartIndex between glBegin and glEnd");
};
struct GenVertexArrays {
    static constexpr auto run = &cmd::GenVertexArrays;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGenVertexArrays between glBegin and glEnd");
};
struct DeleteVertexArrays {
    static constexpr auto run = sharing<&cmd::DeleteVertexArrays>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glDeleteVertexArrays between glBegin and glEnd");
};
struct IsVertexArray {
    static constexpr auto run = &cmd::IsVertexArray;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glIsVertexArray between glBegin and glEnd");
};
struct BindVertexArray {
    static constexpr auto run = &cmd::BindVertexArray;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glBindVertexArray between glBegin and glEnd");
};
struct GenBuffers {
    static constexpr auto run = sharing<&cmd::GenBuffers>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGenBuffers between glBegin and glEnd");
};
struct DeleteBuffers {
    static constexpr auto run = sharing<&cmd::DeleteBuffers>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glDeleteBuffers between glBegin and glEnd");
};
struct IsBuffer {
    static constexpr auto run = sharing<&cmd::IsBuffer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glIsBuffer between glBegin and glEnd");
};
struct BindBuffer {
    static constexpr auto run = sharing<&cmd::BindBuffer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glBindBuffer between glBegin and glEnd");
};
struct BufferData {
    static constexpr auto run = sharing<&cmd::BufferData>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glBufferData between glBegin and glEnd");
};
struct BufferConstantDataSPANGLE {
    static constexpr auto run = sharing<&cmd::BufferConstantDataSPANGLE>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glBufferConstantDataSPANGLE between glBegin and glEnd");
};
struct BufferSubData {
    static constexpr auto run = sharing<&cmd::BufferSubData>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glBufferSubData between glBegin and glEnd");
};
struct GetBufferSubData {
    static constexpr auto run = sharing<&cmd::GetBufferSubData>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetBufferSubData between glBegin and glEnd");
};
struct GetBufferParameteriv {
    static constexpr auto run = sharing<&cmd::GetBufferParameteriv>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetBufferParameteriv between glBegin and glEnd");
};
struct MapBuffer {
    static constexpr auto run = sharing<&cmd::MapBuffer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glMapBuffer between glBegin and glEnd");
};
struct MapBufferRange {
    static constexpr auto run = sharing<&cmd::MapBufferRange>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glMapBufferRange between glBegin and glEnd");
};
struct FlushMappedBufferRange {
    static constexpr auto run = sharing<&cmd::FlushMappedBufferRange>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glFlushMappedBufferRange between glBegin and glEnd");
};
struct UnmapBuffer {
    static constexpr auto run = sharing<&cmd::UnmapBuffer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glUnmapBuffer between glBegin and glEnd");
};
struct GetBufferPointerv {
    static constexpr auto run = sharing<&cmd::GetBufferPointerv>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetBufferPointerv between glBegin and glEnd");
};
struct InterleavedArrays {
    static constexpr auto run = sharing<&cmd::InterleavedArrays>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glInterleavedArrays between glBegin and glEnd");
};
struct MatrixMode {
    static constexpr auto run = &cmd::MatrixMode;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glMatrixMode between glBegin and glEnd");
};
struct LoadIdentity {
    static constexpr auto run = &cmd::LoadIdentity;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glLoadIdentity between glBegin and glEnd");
};
struct LoadMatrix {
    static constexpr auto run = &cmd::LoadMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glLoadMatrix between glBegin and glEnd");
};
struct MultMatrix {
    static constexpr auto run = &cmd::MultMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glMultMatrix between glBegin and glEnd");
};
struct LoadTransposeMatrix {
    static constexpr auto run = &cmd::LoadTransposeMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glLoadTransposeMatrix between glBegin and glEnd");
};
struct MultTransposeMatrix {
    static constexpr auto run = &cmd::MultTransposeMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glMultTransposeMatrix between glBegin and glEnd");
};
struct PushMatrix {
    static constexpr auto run = &cmd::PushMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPushMatrix between glBegin and glEnd");
};
struct PopMatrix {
    static constexpr auto run = &cmd::PopMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPopMatrix between glBegin and glEnd");
};
struct Rotate {
    static constexpr auto run = &cmd::Rotate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glRotate between glBegin and glEnd");
};
struct Translate {
    static constexpr auto run = &cmd::Translate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glTranslate between glBegin and glEnd");
};
struct Scale {
    static constexpr auto run = &cmd::Scale;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glScale between glBegin and glEnd");
};
struct Frustum {
    static constexpr auto run = &cmd::Frustum;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glFrustum between glBegin and glEnd");
};
struct Ortho {
    static constexpr auto run = &cmd::Ortho;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glOrtho between glBegin and glEnd");
};
struct Viewport {
    static constexpr auto run = &cmd::Viewport;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glViewport between glBegin and glEnd");
};
struct DepthRange {
    static constexpr auto run = &cmd::DepthRange;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glDepthRange between glBegin and glEnd");
};
struct ClipPlane {
    static constexpr auto run = &cmd::ClipPlane;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glClipPlane between glBegin and glEnd");
};
struct TexGen {
    static constexpr auto run = &cmd::TexGen;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexGen between glBegin and glEnd");
};
struct GetTexGen {
    static constexpr auto run = &cmd::GetTexGen;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetTexGen between glBegin and glEnd");
};
struct GetClipPlane {
    static constexpr auto run = &cmd::GetClipPlane;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetClipPlane between glBegin and glEnd");
};
struct Light {
    static constexpr auto run = &cmd::Light;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glLight between glBegin and glEnd");
};
struct GetLight {
    static constexpr auto run = &cmd::GetLight;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetLight between glBegin and glEnd");
};
struct LightModel {
    static constexpr auto run = &cmd::LightModel;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glLightModel between glBegin and glEnd");
};
struct Material {
    static constexpr auto run = &cmd::Material;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glMaterial between glBegin and glEnd");
};
struct GetMaterial {
    static constexpr auto run = &cmd::GetMaterial;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetMaterial between glBegin and glEnd");
};
struct ColorMaterial {
    static constexpr auto run = &cmd::ColorMaterial;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glColorMaterial between glBegin and glEnd");
};
struct ShadeModel {
    static constexpr auto run = &cmd::ShadeModel;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glShadeModel between glBegin and glEnd");
};
struct FrontFace {
    static constexpr auto run = &cmd::FrontFace;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glFrontFace between glBegin and glEnd");
};
struct CullFace {
    static constexpr auto run = &cmd::CullFace;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glCullFace between glBegin and glEnd");
};
struct PolygonMode {
    static constexpr auto run = &cmd::PolygonMode;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPolygonMode between glBegin and glEnd");
};
struct PointSize {
    static constexpr auto run = &cmd::PointSize;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPointSize between glBegin and glEnd");
};
struct PointParameter {
    static constexpr auto run = &cmd::PointParameter;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPointParameter between glBegin and glEnd");
};
struct LineWidth {
    static constexpr auto run = &cmd::LineWidth;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glLineWidth between glBegin and glEnd");
};
struct LineStipple {
    static constexpr auto run = &cmd::LineStipple;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glLineStipple between glBegin and glEnd");
};
struct PolygonStipple {
    static constexpr auto run = &cmd::PolygonStipple;
    static constexpr auto encode = &encode::PolygonStipple;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glPolygonStipple between glBegin and glEnd");
};
struct GetPolygonStipple {
    static constexpr auto run = &cmd::GetPolygonStipple;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetPolygonStipple between glBegin and glEnd");
};
struct PolygonOffset {
    static constexpr auto run = &cmd::PolygonOffset;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPolygonOffset between glBegin and glEnd");
};
struct Scissor {
    static constexpr auto run = &cmd::Scissor;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glScissor between glBegin and glEnd");
};
struct AlphaFunc {
    static constexpr auto run = &cmd::AlphaFunc;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glAlphaFunc between glBegin and glEnd");
};
struct StencilFunc {
    static constexpr auto run = &cmd::StencilFunc;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glStencilFunc between glBegin and glEnd");
};
struct StencilOp {
    static constexpr auto run = &cmd::StencilOp;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glStencilOp between glBegin and glEnd");
};
struct StencilFuncSeparate {
    static constexpr auto run = &cmd::StencilFuncSeparate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glStencilFuncSeparate between glBegin and glEnd");
};
struct StencilOpSeparate {
    static constexpr auto run = &cmd::StencilOpSeparate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glStencilOpSeparate between glBegin and glEnd");
};
struct StencilMaskSeparate {
    static constexpr auto run = &cmd::StencilMaskSeparate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glStencilMaskSeparate between glBegin and glEnd");
};
struct SampleCoverage {
    static constexpr auto run = &cmd::SampleCoverage;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glSampleCoverage between glBegin and glEnd");
};
struct DepthFunc {
    static constexpr auto run = &cmd::DepthFunc;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glDepthFunc between glBegin and glEnd");
};
struct BlendFunc {
    static constexpr auto run = &cmd::BlendFunc;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glBlendFunc between glBegin and glEnd");
};
struct BlendFuncSeparate {
    static constexpr auto run = &cmd::BlendFuncSeparate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glBlendFuncSeparate between glBegin and glEnd");
};
struct BlendEquation {
    static constexpr auto run = &cmd::BlendEquation;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glBlendEquation between glBegin and glEnd");
};
struct BlendEquationSeparate {
    static constexpr auto run = &cmd::BlendEquationSeparate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glBlendEquationSeparate between glBegin and glEnd");
};
struct BlendColor {
    static constexpr auto run = &cmd::BlendColor;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glBlendColor between glBegin and glEnd");
};
struct Accum {
    static constexpr auto run = &cmd::Accum;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glAccum between glBegin and glEnd");
};
struct ClearAccum {
    static constexpr auto run = &cmd::ClearAccum;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glClearAccum between glBegin and glEnd");
};
struct GenQueries {
    static constexpr auto run = &cmd::GenQueries;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGenQueries between glBegin and glEnd");
};
struct DeleteQueries {
    static constexpr auto run = sharing<&cmd::DeleteQueries>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glDeleteQueries between glBegin and glEnd");
};
struct IsQuery {
    static constexpr auto run = &cmd::IsQuery;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glIsQuery between glBegin and glEnd");
};
struct BeginQuery {
    static constexpr auto run = sharing<&cmd::BeginQuery>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glBeginQuery between glBegin and glEnd");
};
struct EndQuery {
    static constexpr auto run = sharing<&cmd::EndQuery>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glEndQuery between glBegin and glEnd");
};
struct GetQueryiv {
    static constexpr auto run = &cmd::GetQueryiv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetQueryiv between glBegin and glEnd");
};
struct GetQueryObjectiv {
    static constexpr auto run = sharing<&cmd::GetQueryObjectiv>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetQueryObjectiv between glBegin and glEnd");
};
struct GetQueryObjectuiv {
    static constexpr auto run = sharing<&cmd::GetQueryObjectuiv>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetQueryObjectuiv between glBegin and glEnd");
};
struct LogicOp {
    static constexpr auto run = &cmd::LogicOp;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glLogicOp between glBegin and glEnd");
};
struct DrawBuffer {
    static constexpr auto run = &cmd::DrawBuffer;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glDrawBuffer between glBegin and glEnd");
};
struct ReadBuffer {
    static constexpr auto run = &cmd::ReadBuffer;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glReadBuffer between glBegin and glEnd");
};
struct ColorMask {
    static constexpr auto run = &cmd::ColorMask;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glColorMask between glBegin and glEnd");
};
struct DepthMask {
    static constexpr auto run = &cmd::DepthMask;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glDepthMask between glBegin and glEnd");
};
struct StencilMask {
    static constexpr auto run = &cmd::StencilMask;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glStencilMask between glBegin and glEnd");
};
struct Clear {
    static constexpr auto run = &cmd::Clear;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glClear between glBegin and glEnd");
};
struct ClearColor {
    static constexpr auto run = &cmd::ClearColor;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glClearColor between glBegin and glEnd");
};
struct ClearIndex {
    static constexpr auto run = &cmd::ClearIndex;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glClearIndex between glBegin and glEnd");
};
struct IndexMask {
    static constexpr auto run = &cmd::IndexMask;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glIndexMask between glBegin and glEnd");
};
struct ClearDepth {
    static constexpr auto run = &cmd::ClearDepth;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glClearDepth between glBegin and glEnd");
};
struct ClearStencil {
    static constexpr auto run = &cmd::ClearStencil;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glClearStencil between glBegin and glEnd");
};
struct PixelStore {
    static constexpr auto run = &cmd::PixelStore;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glPixelStore between glBegin and glEnd");
};
struct PixelTransfer {
    static constexpr auto run = &cmd::PixelTransfer;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPixelTransfer between glBegin and glEnd");
};
struct PixelMap {
    static constexpr auto run = &cmd::PixelMap;
    static constexpr auto encode = &encode::PixelMap;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glPixelMap between glBegin and glEnd");
};
struct GetPixelMap {
    static constexpr auto run = &cmd::GetPixelMap;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetPixelMap between glBegin and glEnd");
};
struct PixelZoom {
    static constexpr auto run = &cmd::PixelZoom;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPixelZoom between glBegin and glEnd");
};
struct DrawPixels {
    static constexpr auto run = sharing<&cmd::DrawPixels>;
    static constexpr auto encode = sharing<&encode::DrawPixels>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glDrawPixels between glBegin and glEnd");
};
struct CopyPixels {
    static constexpr auto run = sharing<&cmd::CopyPixels>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glCopyPixels between glBegin and glEnd");
};
struct Bitmap {
    static constexpr auto run = sharing<&cmd::Bitmap>;
    static constexpr auto encode = sharing<&encode::Bitmap>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glBitmap between glBegin and glEnd");
};
struct ReadPixels {
    static constexpr auto run = sharing<&cmd::ReadPixels>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glReadPixels between glBegin and glEnd");
};
struct Fog {
    static constexpr auto run = &cmd::Fog;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glFog between glBegin and glEnd");
};
struct Hint {
    static constexpr auto run = &cmd::Hint;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glHint between glBegin and glEnd");
};
struct Flush {
    static constexpr auto run = &cmd::Flush;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glFlush between glBegin and glEnd");
};
struct Finish {
    static constexpr auto run = &cmd::Finish;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glFinish between glBegin and glEnd");
};
struct TexImage1D {
    static constexpr auto run = sharing<&cmd::TexImage1D>;
    static constexpr auto encode = sharing<&encode::TexImage1D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexImage1D between glBegin and glEnd");
};
struct TexImage2D {
    static constexpr auto run = sharing<&cmd::TexImage2D>;
    static constexpr auto encode = sharing<&encode::TexImage2D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexImage2D between glBegin and glEnd");
};
struct TexConstantImage2DSPANGLE {
    static constexpr auto run = sharing<&cmd::TexConstantImage2DSPANGLE>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexConstantImage2DSPANGLE between glBegin and glEnd");
};
struct TexImage3D {
    static constexpr auto run = sharing<&cmd::TexImage3D>;
    static constexpr auto encode = sharing<&encode::TexImage3D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexImage3D between glBegin and glEnd");
};
struct TexSubImage1D {
    static constexpr auto run = sharing<&cmd::TexSubImage1D>;
    static constexpr auto encode = sharing<&encode::TexSubImage1D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexSubImage1D between glBegin and glEnd");
};
struct TexSubImage2D {
    static constexpr auto run = sharing<&cmd::TexSubImage2D>;
    static constexpr auto encode = sharing<&encode::TexSubImage2D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexSubImage2D between glBegin and glEnd");
};
struct TexSubImage3D {
    static constexpr auto run = sharing<&cmd::TexSubImage3D>;
    static constexpr auto encode = sharing<&encode::TexSubImage3D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexSubImage3D between glBegin and glEnd");
};
struct CopyTexImage1D {
    static constexpr auto run = sharing<&cmd::CopyTexImage1D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glCopyTexImage1D between glBegin and glEnd");
};
struct CopyTexImage2D {
    static constexpr auto run = sharing<&cmd::CopyTexImage2D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glCopyTexImage2D between glBegin and glEnd");
};
struct CopyTexSubImage1D {
    static constexpr auto run = sharing<&cmd::CopyTexSubImage1D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glCopyTexSubImage1D between glBegin and glEnd");
};
struct CopyTexSubImage2D {
    static constexpr auto run = sharing<&cmd::CopyTexSubImage2D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glCopyTexSubImage2D between glBegin and glEnd");
};
struct CopyTexSubImage3D {
    static constexpr auto run = sharing<&cmd::CopyTexSubImage3D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glCopyTexSubImage3D between glBegin and glEnd");
};
struct CompressedTexImage1D {
    static constexpr auto run = sharing<&cmd::CompressedTexImage1D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glCompressedTexImage1D between glBegin and glEnd");
};
struct CompressedTexImage2D {
    static constexpr auto run = sharing<&cmd::CompressedTexImage2D>;
    static constexpr auto encode = sharing<&encode::CompressedTexImage2D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glCompressedTexImage2D between glBegin and glEnd");
};
struct CompressedTexImage3D {
    static constexpr auto run = sharing<&cmd::CompressedTexImage3D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glCompressedTexImage3D between glBegin and glEnd");
};
struct CompressedTexSubImage1D {
    static constexpr auto run = sharing<&cmd::CompressedTexSubImage1D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glCompressedTexSubImage1D between glBegin and glEnd");
};
struct CompressedTexSubImage2D {
    static constexpr auto run = sharing<&cmd::CompressedTexSubImage2D>;
    static constexpr auto encode = sharing<&encode::CompressedTexSubImage2D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glCompressedTexSubImage2D between glBegin and glEnd");
};
struct CompressedTexSubImage3D {
    static constexpr auto run = sharing<&cmd::CompressedTexSubImage3D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glCompressedTexSubImage3D between glBegin and glEnd");
};
struct CompressedTexConstantImage2DSPANGLE {
    static constexpr auto run = sharing<&cmd::CompressedTexConstantImage2DSPANGLE>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glCompressedTexConstantImage2DSPANGLE between glBegin and glEnd");
};
struct GetTexImage {
    static constexpr auto run = sharing<&cmd::GetTexImage>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetTexImage between glBegin and glEnd");
};
struct GetCompressedTexImage {
    static constexpr auto run = sharing<&cmd::GetCompressedTexImage>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetCompressedTexImage between glBegin and glEnd");
};
struct GenerateMipmap {
    static constexpr auto run = sharing<&cmd::GenerateMipmap>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glGenerateMipmap between glBegin and glEnd");
};
struct AreTexturesResident {
    static constexpr auto run = sharing<&cmd::AreTexturesResident>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glAreTexturesResident between glBegin and glEnd");
};
struct PrioritizeTextures {
    static constexpr auto run = sharing<&cmd::PrioritizeTextures>;
    static constexpr auto encode = sharing<&encode::PrioritizeTextures>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glPrioritizeTextures between glBegin and glEnd");
};
struct GenTextures {
    static constexpr auto run = sharing<&cmd::GenTextures>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGenTextures between glBegin and glEnd");
};
struct DeleteTextures {
    static constexpr auto run = sharing<&cmd::DeleteTextures>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glDeleteTextures between glBegin and glEnd");
};
struct BindTexture {
    static constexpr auto run = sharing<&cmd::BindTexture>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glBindTexture between glBegin and glEnd");
};
struct ActiveTexture {
    static constexpr auto run = &cmd::ActiveTexture;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glActiveTexture between glBegin and glEnd");
};
struct IsTexture {
    static constexpr auto run = sharing<&cmd::IsTexture>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glIsTexture between glBegin and glEnd");
};
struct TexParameter {
    static constexpr auto run = sharing<&cmd::TexParameter>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexParameter between glBegin and glEnd");
};
struct GetTexParameter {
    static constexpr auto run = sharing<&cmd::GetTexParameter>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetTexParameter between glBegin and glEnd");
};
struct TexEnv {
    static constexpr auto run = &cmd::TexEnv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glTexEnv between glBegin and glEnd");
};
struct GetTexEnv {
    static constexpr auto run = &cmd::GetTexEnv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetTexEnv between glBegin and glEnd");
};
struct GetTexLevelParameter {
    static constexpr auto run = sharing<&cmd::GetTexLevelParameter>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetTexLevelParameter between glBegin and glEnd");
};
struct NewList {
    static constexpr auto run = &cmd::NewList;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glNewList between glBegin and glEnd");
};
struct EndList {
    static constexpr auto run = sharing<&cmd::EndList>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glEndList between glBegin and glEnd");
};
struct CallList {
    static constexpr auto run = sharing<&cmd::CallList>;
    static constexpr auto encode = sharing<&encode::CallList>;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glCallList between glBegin and glEnd");
};
struct CallLists {
    static constexpr auto run = sharing<&cmd::CallLists>;
    static constexpr auto encode = sharing<&encode::CallLists>;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glCallLists between glBegin and glEnd");
};
struct ListBase {
    static constexpr auto run = &cmd::ListBase;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glListBase between glBegin and glEnd");
};
struct GenLists {
    static constexpr auto run = sharing<&cmd::GenLists>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGenLists between glBegin and glEnd");
};
struct DeleteLists {
    static constexpr auto run = sharing<&cmd::DeleteLists>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glDeleteLists between glBegin and glEnd");
};
struct IsList {
    static constexpr auto run = sharing<&cmd::IsList>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glIsList between glBegin and glEnd");
};
struct RenderMode {
    static constexpr auto run = &cmd::RenderMode;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glRenderMode between glBegin and glEnd");
};
struct SelectBuffer {
    static constexpr auto run = &cmd::SelectBuffer;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glSelectBuffer between glBegin and glEnd");
};
struct InitNames {
    static constexpr auto run = &cmd::InitNames;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glInitNames between glBegin and glEnd");
};
struct PushName {
    static constexpr auto run = &cmd::PushName;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPushName between glBegin and glEnd");
};
struct PopName {
    static constexpr auto run = &cmd::PopName;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPopName between glBegin and glEnd");
};
struct LoadName {
    static constexpr auto run = &cmd::LoadName;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glLoadName between glBegin and glEnd");
};
struct FeedbackBuffer {
    static constexpr auto run = &cmd::FeedbackBuffer;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glFeedbackBuffer between glBegin and glEnd");
};
struct PassThrough {
    static constexpr auto run = &cmd::PassThrough;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glPassThrough between glBegin and glEnd");
};
struct Map1 {
    static constexpr auto run = &cmd::Map1;
    static constexpr auto encode = &encode::Map1;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glMap1 between glBegin and glEnd");
};
struct Map2 {
    static constexpr auto run = &cmd::Map2;
    static constexpr auto encode = &encode::Map2;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const char* refusal = SPANGLE_TEXT("glMap2 between glBegin and glEnd");
};
struct GetMap {
    static constexpr auto run = &cmd::GetMap;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const char* refusal = SPANGLE_TEXT("glGetMap between glBegin and glEnd");
};
struct EvalCoord1 {
    static constexpr auto run = &cmd::EvalCoord1;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glEvalCoord1 between glBegin and glEnd");
};
struct EvalCoord2 {
    static constexpr auto run = &cmd::EvalCoord2;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glEvalCoord2 between glBegin and glEnd");
};
struct MapGrid1 {
    static constexpr auto run = &cmd::MapGrid1;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glMapGrid1 between glBegin and glEnd");
};
struct MapGrid2 {
    static constexpr auto run = &cmd::MapGrid2;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glMapGrid2 between glBegin and glEnd");
};
struct EvalMesh1 {
    static constexpr auto run = &cmd::EvalMesh1;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glEvalMesh1 between glBegin and glEnd");
};
struct EvalMesh2 {
    static constexpr auto run = &cmd::EvalMesh2;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glEvalMesh2 between glBegin and glEnd");
};
struct EvalPoint1 {
    static constexpr auto run = &cmd::EvalPoint1;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glEvalPoint1 between glBegin and glEnd");
};
struct EvalPoint2 {
    static constexpr auto run = &cmd::EvalPoint2;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const char* refusal = SPANGLE_TEXT("glEvalPoint2 between glBegin and glEnd");
};

} // namespace spangle::gl::family
