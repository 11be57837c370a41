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

#if SPANGLE_MESSAGES
namespace spangle::gl::texts {

extern const CommandText GetError;
extern const CommandText Enable;
extern const CommandText Disable;
extern const CommandText IsEnabled;
extern const CommandText GetBooleanv;
extern const CommandText GetIntegerv;
extern const CommandText GetFloatv;
extern const CommandText GetDoublev;
extern const CommandText GetFixedvOES;
extern const CommandText GetPointerv;
extern const CommandText GetString;
extern const CommandText PushAttrib;
extern const CommandText PopAttrib;
extern const CommandText PushClientAttrib;
extern const CommandText PopClientAttrib;
extern const CommandText Begin;
extern const CommandText End;
extern const CommandText Vertex;
extern const CommandText TexCoord;
extern const CommandText MultiTexCoord;
extern const CommandText Normal;
extern const CommandText Color;
extern const CommandText SecondaryColor;
extern const CommandText Index;
extern const CommandText EdgeFlag;
extern const CommandText FogCoord;
extern const CommandText RasterPos;
extern const CommandText WindowPos;
extern const CommandText Rect;
extern const CommandText VertexPointer;
extern const CommandText NormalPointer;
extern const CommandText ColorPointer;
extern const CommandText TexCoordPointer;
extern const CommandText IndexPointer;
extern const CommandText EdgeFlagPointer;
extern const CommandText FogCoordPointer;
extern const CommandText SecondaryColorPointer;
extern const CommandText ClientActiveTexture;
extern const CommandText EnableClientState;
extern const CommandText DisableClientState;
extern const CommandText ArrayElement;
extern const CommandText DrawArrays;
extern const CommandText DrawElements;
extern const CommandText DrawRangeElements;
extern const CommandText MultiDrawArrays;
extern const CommandText MultiDrawElements;
extern const CommandText PrimitiveRestartIndex;
extern const CommandText GenVertexArrays;
extern const CommandText DeleteVertexArrays;
extern const CommandText IsVertexArray;
extern const CommandText BindVertexArray;
extern const CommandText GenBuffers;
extern const CommandText DeleteBuffers;
extern const CommandText IsBuffer;
extern const CommandText BindBuffer;
extern const CommandText BufferData;
extern const CommandText BufferConstantDataSPANGLE;
extern const CommandText BufferSubData;
extern const CommandText GetBufferSubData;
extern const CommandText GetBufferParameteriv;
extern const CommandText MapBuffer;
extern const CommandText MapBufferRange;
extern const CommandText FlushMappedBufferRange;
extern const CommandText UnmapBuffer;
extern const CommandText GetBufferPointerv;
extern const CommandText InterleavedArrays;
extern const CommandText MatrixMode;
extern const CommandText LoadIdentity;
extern const CommandText LoadMatrix;
extern const CommandText MultMatrix;
extern const CommandText LoadTransposeMatrix;
extern const CommandText MultTransposeMatrix;
extern const CommandText PushMatrix;
extern const CommandText PopMatrix;
extern const CommandText Rotate;
extern const CommandText Translate;
extern const CommandText Scale;
extern const CommandText Frustum;
extern const CommandText Ortho;
extern const CommandText Viewport;
extern const CommandText DepthRange;
extern const CommandText ClipPlane;
extern const CommandText TexGen;
extern const CommandText GetTexGen;
extern const CommandText GetClipPlane;
extern const CommandText Light;
extern const CommandText GetLight;
extern const CommandText LightModel;
extern const CommandText Material;
extern const CommandText GetMaterial;
extern const CommandText ColorMaterial;
extern const CommandText ShadeModel;
extern const CommandText FrontFace;
extern const CommandText CullFace;
extern const CommandText PolygonMode;
extern const CommandText PointSize;
extern const CommandText PointParameter;
extern const CommandText LineWidth;
extern const CommandText LineStipple;
extern const CommandText PolygonStipple;
extern const CommandText GetPolygonStipple;
extern const CommandText PolygonOffset;
extern const CommandText Scissor;
extern const CommandText AlphaFunc;
extern const CommandText StencilFunc;
extern const CommandText StencilOp;
extern const CommandText StencilFuncSeparate;
extern const CommandText StencilOpSeparate;
extern const CommandText StencilMaskSeparate;
extern const CommandText SampleCoverage;
extern const CommandText DepthFunc;
extern const CommandText BlendFunc;
extern const CommandText BlendFuncSeparate;
extern const CommandText BlendEquation;
extern const CommandText BlendEquationSeparate;
extern const CommandText BlendColor;
extern const CommandText Accum;
extern const CommandText ClearAccum;
extern const CommandText GenQueries;
extern const CommandText DeleteQueries;
extern const CommandText IsQuery;
extern const CommandText BeginQuery;
extern const CommandText EndQuery;
extern const CommandText GetQueryiv;
extern const CommandText GetQueryObjectiv;
extern const CommandText GetQueryObjectuiv;
extern const CommandText LogicOp;
extern const CommandText DrawBuffer;
extern const CommandText ReadBuffer;
extern const CommandText ColorMask;
extern const CommandText DepthMask;
extern const CommandText StencilMask;
extern const CommandText Clear;
extern const CommandText ClearColor;
extern const CommandText ClearIndex;
extern const CommandText IndexMask;
extern const CommandText ClearDepth;
extern const CommandText ClearStencil;
extern const CommandText PixelStore;
extern const CommandText PixelTransfer;
extern const CommandText PixelMap;
extern const CommandText GetPixelMap;
extern const CommandText PixelZoom;
extern const CommandText DrawPixels;
extern const CommandText CopyPixels;
extern const CommandText Bitmap;
extern const CommandText ReadPixels;
extern const CommandText Fog;
extern const CommandText Hint;
extern const CommandText Flush;
extern const CommandText Finish;
extern const CommandText TexImage1D;
extern const CommandText TexImage2D;
extern const CommandText TexConstantImage2DSPANGLE;
extern const CommandText TexImage3D;
extern const CommandText TexSubImage1D;
extern const CommandText TexSubImage2D;
extern const CommandText TexSubImage3D;
extern const CommandText CopyTexImage1D;
extern const CommandText CopyTexImage2D;
extern const CommandText CopyTexSubImage1D;
extern const CommandText CopyTexSubImage2D;
extern const CommandText CopyTexSubImage3D;
extern const CommandText CompressedTexImage1D;
extern const CommandText CompressedTexImage2D;
extern const CommandText CompressedTexImage3D;
extern const CommandText CompressedTexSubImage1D;
extern const CommandText CompressedTexSubImage2D;
extern const CommandText CompressedTexSubImage3D;
extern const CommandText CompressedTexConstantImage2DSPANGLE;
extern const CommandText GetTexImage;
extern const CommandText GetCompressedTexImage;
extern const CommandText GenerateMipmap;
extern const CommandText AreTexturesResident;
extern const CommandText PrioritizeTextures;
extern const CommandText GenTextures;
extern const CommandText DeleteTextures;
extern const CommandText BindTexture;
extern const CommandText ActiveTexture;
extern const CommandText IsTexture;
extern const CommandText TexParameter;
extern const CommandText GetTexParameter;
extern const CommandText TexEnv;
extern const CommandText GetTexEnv;
extern const CommandText GetTexLevelParameter;
extern const CommandText NewList;
extern const CommandText EndList;
extern const CommandText CallList;
extern const CommandText CallLists;
extern const CommandText ListBase;
extern const CommandText GenLists;
extern const CommandText DeleteLists;
extern const CommandText IsList;
extern const CommandText RenderMode;
extern const CommandText SelectBuffer;
extern const CommandText InitNames;
extern const CommandText PushName;
extern const CommandText PopName;
extern const CommandText LoadName;
extern const CommandText FeedbackBuffer;
extern const CommandText PassThrough;
extern const CommandText Map1;
extern const CommandText Map2;
extern const CommandText GetMap;
extern const CommandText EvalCoord1;
extern const CommandText EvalCoord2;
extern const CommandText MapGrid1;
extern const CommandText MapGrid2;
extern const CommandText EvalMesh1;
extern const CommandText EvalMesh2;
extern const CommandText EvalPoint1;
extern const CommandText EvalPoint2;

} // namespace spangle::gl::texts
#define SPANGLE_COMMAND_TEXT(name) &texts::name
#else
#define SPANGLE_COMMAND_TEXT(name) nullptr
#endif

namespace spangle::gl::family {

struct GetError {
    static constexpr auto run = &cmd::GetError;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetError);
};
struct Enable {
    static constexpr auto run = &cmd::Enable;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Enable);
};
struct Disable {
    static constexpr auto run = &cmd::Disable;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Disable);
};
struct IsEnabled {
    static constexpr auto run = &cmd::IsEnabled;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(IsEnabled);
};
struct GetBooleanv {
    static constexpr auto run = &cmd::GetBooleanv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetBooleanv);
};
struct GetIntegerv {
    static constexpr auto run = &cmd::GetIntegerv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetIntegerv);
};
struct GetFloatv {
    static constexpr auto run = &cmd::GetFloatv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetFloatv);
};
struct GetDoublev {
    static constexpr auto run = &cmd::GetDoublev;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetDoublev);
};
struct GetFixedvOES {
    static constexpr auto run = &cmd::GetFixedvOES;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetFixedvOES);
};
struct GetPointerv {
    static constexpr auto run = &cmd::GetPointerv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetPointerv);
};
struct GetString {
    static constexpr auto run = &cmd::GetString;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetString);
};
struct PushAttrib {
    static constexpr auto run = sharing<&cmd::PushAttrib>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PushAttrib);
};
struct PopAttrib {
    static constexpr auto run = sharing<&cmd::PopAttrib>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PopAttrib);
};
struct PushClientAttrib {
    static constexpr auto run = sharing<&cmd::PushClientAttrib>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PushClientAttrib);
};
struct PopClientAttrib {
    static constexpr auto run = sharing<&cmd::PopClientAttrib>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PopClientAttrib);
};
struct Begin {
    static constexpr auto run = &cmd::Begin;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Begin);
};
struct End {
    static constexpr auto run = &cmd::End;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(End);
};
struct Vertex {
    static constexpr auto run = &cmd::Vertex;
    static constexpr auto encode = &encode::Vertex;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::attribute;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Vertex);
};
struct TexCoord {
    static constexpr auto run = &cmd::TexCoord;
    static constexpr auto encode = &encode::TexCoord;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::attribute;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexCoord);
};
struct MultiTexCoord {
    static constexpr auto run = &cmd::MultiTexCoord;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(MultiTexCoord);
};
struct Normal {
    static constexpr auto run = &cmd::Normal;
    static constexpr auto encode = &encode::Normal;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::attribute;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Normal);
};
struct Color {
    static constexpr auto run = &cmd::Color;
    static constexpr auto encode = &encode::Color;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::attribute;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Color);
};
struct SecondaryColor {
    static constexpr auto run = &cmd::SecondaryColor;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(SecondaryColor);
};
struct Index {
    static constexpr auto run = &cmd::Index;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Index);
};
struct EdgeFlag {
    static constexpr auto run = &cmd::EdgeFlag;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EdgeFlag);
};
struct FogCoord {
    static constexpr auto run = &cmd::FogCoord;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(FogCoord);
};
struct RasterPos {
    static constexpr auto run = &cmd::RasterPos;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(RasterPos);
};
struct WindowPos {
    static constexpr auto run = &cmd::WindowPos;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(WindowPos);
};
struct Rect {
    static constexpr auto run = &cmd::Rect;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Rect);
};
struct VertexPointer {
    static constexpr auto run = sharing<&cmd::VertexPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(VertexPointer);
};
struct NormalPointer {
    static constexpr auto run = sharing<&cmd::NormalPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(NormalPointer);
};
struct ColorPointer {
    static constexpr auto run = sharing<&cmd::ColorPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ColorPointer);
};
struct TexCoordPointer {
    static constexpr auto run = sharing<&cmd::TexCoordPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexCoordPointer);
};
struct IndexPointer {
    static constexpr auto run = sharing<&cmd::IndexPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(IndexPointer);
};
struct EdgeFlagPointer {
    static constexpr auto run = sharing<&cmd::EdgeFlagPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EdgeFlagPointer);
};
struct FogCoordPointer {
    static constexpr auto run = sharing<&cmd::FogCoordPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(FogCoordPointer);
};
struct SecondaryColorPointer {
    static constexpr auto run = sharing<&cmd::SecondaryColorPointer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(SecondaryColorPointer);
};
struct ClientActiveTexture {
    static constexpr auto run = &cmd::ClientActiveTexture;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ClientActiveTexture);
};
struct EnableClientState {
    static constexpr auto run = &cmd::EnableClientState;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EnableClientState);
};
struct DisableClientState {
    static constexpr auto run = &cmd::DisableClientState;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DisableClientState);
};
struct ArrayElement {
    static constexpr auto run = sharing<&cmd::ArrayElement>;
    static constexpr auto encode = sharing<&encode::ArrayElement>;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ArrayElement);
};
struct DrawArrays {
    static constexpr auto run = sharing<&cmd::DrawArrays>;
    static constexpr auto encode = sharing<&encode::DrawArrays>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DrawArrays);
};
struct DrawElements {
    static constexpr auto run = sharing<&cmd::DrawElements>;
    static constexpr auto encode = sharing<&encode::DrawElements>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DrawElements);
};
struct DrawRangeElements {
    static constexpr auto run = sharing<&cmd::DrawRangeElements>;
    static constexpr auto encode = sharing<&encode::DrawRangeElements>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DrawRangeElements);
};
struct MultiDrawArrays {
    static constexpr auto run = sharing<&cmd::MultiDrawArrays>;
    static constexpr auto encode = sharing<&encode::MultiDrawArrays>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(MultiDrawArrays);
};
struct MultiDrawElements {
    static constexpr auto run = sharing<&cmd::MultiDrawElements>;
    static constexpr auto encode = sharing<&encode::MultiDrawElements>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(MultiDrawElements);
};
struct PrimitiveRestartIndex {
    static constexpr auto run = &cmd::PrimitiveRestartIndex;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PrimitiveRestartIndex);
};
struct GenVertexArrays {
    static constexpr auto run = &cmd::GenVertexArrays;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GenVertexArrays);
};
struct DeleteVertexArrays {
    static constexpr auto run = sharing<&cmd::DeleteVertexArrays>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DeleteVertexArrays);
};
struct IsVertexArray {
    static constexpr auto run = &cmd::IsVertexArray;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(IsVertexArray);
};
struct BindVertexArray {
    static constexpr auto run = &cmd::BindVertexArray;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BindVertexArray);
};
struct GenBuffers {
    static constexpr auto run = sharing<&cmd::GenBuffers>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GenBuffers);
};
struct DeleteBuffers {
    static constexpr auto run = sharing<&cmd::DeleteBuffers>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DeleteBuffers);
};
struct IsBuffer {
    static constexpr auto run = sharing<&cmd::IsBuffer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(IsBuffer);
};
struct BindBuffer {
    static constexpr auto run = sharing<&cmd::BindBuffer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BindBuffer);
};
struct BufferData {
    static constexpr auto run = sharing<&cmd::BufferData>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BufferData);
};
struct BufferConstantDataSPANGLE {
    static constexpr auto run = sharing<&cmd::BufferConstantDataSPANGLE>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BufferConstantDataSPANGLE);
};
struct BufferSubData {
    static constexpr auto run = sharing<&cmd::BufferSubData>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BufferSubData);
};
struct GetBufferSubData {
    static constexpr auto run = sharing<&cmd::GetBufferSubData>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetBufferSubData);
};
struct GetBufferParameteriv {
    static constexpr auto run = sharing<&cmd::GetBufferParameteriv>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetBufferParameteriv);
};
struct MapBuffer {
    static constexpr auto run = sharing<&cmd::MapBuffer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(MapBuffer);
};
struct MapBufferRange {
    static constexpr auto run = sharing<&cmd::MapBufferRange>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(MapBufferRange);
};
struct FlushMappedBufferRange {
    static constexpr auto run = sharing<&cmd::FlushMappedBufferRange>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(FlushMappedBufferRange);
};
struct UnmapBuffer {
    static constexpr auto run = sharing<&cmd::UnmapBuffer>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(UnmapBuffer);
};
struct GetBufferPointerv {
    static constexpr auto run = sharing<&cmd::GetBufferPointerv>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetBufferPointerv);
};
struct InterleavedArrays {
    static constexpr auto run = sharing<&cmd::InterleavedArrays>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(InterleavedArrays);
};
struct MatrixMode {
    static constexpr auto run = &cmd::MatrixMode;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(MatrixMode);
};
struct LoadIdentity {
    static constexpr auto run = &cmd::LoadIdentity;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(LoadIdentity);
};
struct LoadMatrix {
    static constexpr auto run = &cmd::LoadMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(LoadMatrix);
};
struct MultMatrix {
    static constexpr auto run = &cmd::MultMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(MultMatrix);
};
struct LoadTransposeMatrix {
    static constexpr auto run = &cmd::LoadTransposeMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(LoadTransposeMatrix);
};
struct MultTransposeMatrix {
    static constexpr auto run = &cmd::MultTransposeMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(MultTransposeMatrix);
};
struct PushMatrix {
    static constexpr auto run = &cmd::PushMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PushMatrix);
};
struct PopMatrix {
    static constexpr auto run = &cmd::PopMatrix;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PopMatrix);
};
struct Rotate {
    static constexpr auto run = &cmd::Rotate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Rotate);
};
struct Translate {
    static constexpr auto run = &cmd::Translate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Translate);
};
struct Scale {
    static constexpr auto run = &cmd::Scale;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Scale);
};
struct Frustum {
    static constexpr auto run = &cmd::Frustum;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Frustum);
};
struct Ortho {
    static constexpr auto run = &cmd::Ortho;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Ortho);
};
struct Viewport {
    static constexpr auto run = &cmd::Viewport;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Viewport);
};
struct DepthRange {
    static constexpr auto run = &cmd::DepthRange;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DepthRange);
};
struct ClipPlane {
    static constexpr auto run = &cmd::ClipPlane;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ClipPlane);
};
struct TexGen {
    static constexpr auto run = &cmd::TexGen;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexGen);
};
struct GetTexGen {
    static constexpr auto run = &cmd::GetTexGen;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetTexGen);
};
struct GetClipPlane {
    static constexpr auto run = &cmd::GetClipPlane;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetClipPlane);
};
struct Light {
    static constexpr auto run = &cmd::Light;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Light);
};
struct GetLight {
    static constexpr auto run = &cmd::GetLight;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetLight);
};
struct LightModel {
    static constexpr auto run = &cmd::LightModel;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(LightModel);
};
struct Material {
    static constexpr auto run = &cmd::Material;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Material);
};
struct GetMaterial {
    static constexpr auto run = &cmd::GetMaterial;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetMaterial);
};
struct ColorMaterial {
    static constexpr auto run = &cmd::ColorMaterial;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ColorMaterial);
};
struct ShadeModel {
    static constexpr auto run = &cmd::ShadeModel;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ShadeModel);
};
struct FrontFace {
    static constexpr auto run = &cmd::FrontFace;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(FrontFace);
};
struct CullFace {
    static constexpr auto run = &cmd::CullFace;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CullFace);
};
struct PolygonMode {
    static constexpr auto run = &cmd::PolygonMode;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PolygonMode);
};
struct PointSize {
    static constexpr auto run = &cmd::PointSize;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PointSize);
};
struct PointParameter {
    static constexpr auto run = &cmd::PointParameter;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PointParameter);
};
struct LineWidth {
    static constexpr auto run = &cmd::LineWidth;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(LineWidth);
};
struct LineStipple {
    static constexpr auto run = &cmd::LineStipple;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(LineStipple);
};
struct PolygonStipple {
    static constexpr auto run = &cmd::PolygonStipple;
    static constexpr auto encode = &encode::PolygonStipple;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PolygonStipple);
};
struct GetPolygonStipple {
    static constexpr auto run = &cmd::GetPolygonStipple;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetPolygonStipple);
};
struct PolygonOffset {
    static constexpr auto run = &cmd::PolygonOffset;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PolygonOffset);
};
struct Scissor {
    static constexpr auto run = &cmd::Scissor;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Scissor);
};
struct AlphaFunc {
    static constexpr auto run = &cmd::AlphaFunc;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(AlphaFunc);
};
struct StencilFunc {
    static constexpr auto run = &cmd::StencilFunc;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(StencilFunc);
};
struct StencilOp {
    static constexpr auto run = &cmd::StencilOp;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(StencilOp);
};
struct StencilFuncSeparate {
    static constexpr auto run = &cmd::StencilFuncSeparate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(StencilFuncSeparate);
};
struct StencilOpSeparate {
    static constexpr auto run = &cmd::StencilOpSeparate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(StencilOpSeparate);
};
struct StencilMaskSeparate {
    static constexpr auto run = &cmd::StencilMaskSeparate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(StencilMaskSeparate);
};
struct SampleCoverage {
    static constexpr auto run = &cmd::SampleCoverage;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(SampleCoverage);
};
struct DepthFunc {
    static constexpr auto run = &cmd::DepthFunc;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DepthFunc);
};
struct BlendFunc {
    static constexpr auto run = &cmd::BlendFunc;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BlendFunc);
};
struct BlendFuncSeparate {
    static constexpr auto run = &cmd::BlendFuncSeparate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BlendFuncSeparate);
};
struct BlendEquation {
    static constexpr auto run = &cmd::BlendEquation;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BlendEquation);
};
struct BlendEquationSeparate {
    static constexpr auto run = &cmd::BlendEquationSeparate;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BlendEquationSeparate);
};
struct BlendColor {
    static constexpr auto run = &cmd::BlendColor;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BlendColor);
};
struct Accum {
    static constexpr auto run = &cmd::Accum;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Accum);
};
struct ClearAccum {
    static constexpr auto run = &cmd::ClearAccum;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ClearAccum);
};
struct GenQueries {
    static constexpr auto run = &cmd::GenQueries;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GenQueries);
};
struct DeleteQueries {
    static constexpr auto run = sharing<&cmd::DeleteQueries>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DeleteQueries);
};
struct IsQuery {
    static constexpr auto run = &cmd::IsQuery;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(IsQuery);
};
struct BeginQuery {
    static constexpr auto run = sharing<&cmd::BeginQuery>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BeginQuery);
};
struct EndQuery {
    static constexpr auto run = sharing<&cmd::EndQuery>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EndQuery);
};
struct GetQueryiv {
    static constexpr auto run = &cmd::GetQueryiv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetQueryiv);
};
struct GetQueryObjectiv {
    static constexpr auto run = sharing<&cmd::GetQueryObjectiv>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetQueryObjectiv);
};
struct GetQueryObjectuiv {
    static constexpr auto run = sharing<&cmd::GetQueryObjectuiv>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetQueryObjectuiv);
};
struct LogicOp {
    static constexpr auto run = &cmd::LogicOp;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(LogicOp);
};
struct DrawBuffer {
    static constexpr auto run = &cmd::DrawBuffer;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DrawBuffer);
};
struct ReadBuffer {
    static constexpr auto run = &cmd::ReadBuffer;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ReadBuffer);
};
struct ColorMask {
    static constexpr auto run = &cmd::ColorMask;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ColorMask);
};
struct DepthMask {
    static constexpr auto run = &cmd::DepthMask;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DepthMask);
};
struct StencilMask {
    static constexpr auto run = &cmd::StencilMask;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(StencilMask);
};
struct Clear {
    static constexpr auto run = &cmd::Clear;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Clear);
};
struct ClearColor {
    static constexpr auto run = &cmd::ClearColor;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ClearColor);
};
struct ClearIndex {
    static constexpr auto run = &cmd::ClearIndex;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ClearIndex);
};
struct IndexMask {
    static constexpr auto run = &cmd::IndexMask;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(IndexMask);
};
struct ClearDepth {
    static constexpr auto run = &cmd::ClearDepth;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ClearDepth);
};
struct ClearStencil {
    static constexpr auto run = &cmd::ClearStencil;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ClearStencil);
};
struct PixelStore {
    static constexpr auto run = &cmd::PixelStore;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PixelStore);
};
struct PixelTransfer {
    static constexpr auto run = &cmd::PixelTransfer;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PixelTransfer);
};
struct PixelMap {
    static constexpr auto run = &cmd::PixelMap;
    static constexpr auto encode = &encode::PixelMap;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PixelMap);
};
struct GetPixelMap {
    static constexpr auto run = &cmd::GetPixelMap;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetPixelMap);
};
struct PixelZoom {
    static constexpr auto run = &cmd::PixelZoom;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PixelZoom);
};
struct DrawPixels {
    static constexpr auto run = sharing<&cmd::DrawPixels>;
    static constexpr auto encode = sharing<&encode::DrawPixels>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DrawPixels);
};
struct CopyPixels {
    static constexpr auto run = sharing<&cmd::CopyPixels>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CopyPixels);
};
struct Bitmap {
    static constexpr auto run = sharing<&cmd::Bitmap>;
    static constexpr auto encode = sharing<&encode::Bitmap>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Bitmap);
};
struct ReadPixels {
    static constexpr auto run = sharing<&cmd::ReadPixels>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ReadPixels);
};
struct Fog {
    static constexpr auto run = &cmd::Fog;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Fog);
};
struct Hint {
    static constexpr auto run = &cmd::Hint;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Hint);
};
struct Flush {
    static constexpr auto run = &cmd::Flush;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Flush);
};
struct Finish {
    static constexpr auto run = &cmd::Finish;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Finish);
};
struct TexImage1D {
    static constexpr auto run = sharing<&cmd::TexImage1D>;
    static constexpr auto encode = sharing<&encode::TexImage1D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexImage1D);
};
struct TexImage2D {
    static constexpr auto run = sharing<&cmd::TexImage2D>;
    static constexpr auto encode = sharing<&encode::TexImage2D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexImage2D);
};
struct TexConstantImage2DSPANGLE {
    static constexpr auto run = sharing<&cmd::TexConstantImage2DSPANGLE>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexConstantImage2DSPANGLE);
};
struct TexImage3D {
    static constexpr auto run = sharing<&cmd::TexImage3D>;
    static constexpr auto encode = sharing<&encode::TexImage3D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexImage3D);
};
struct TexSubImage1D {
    static constexpr auto run = sharing<&cmd::TexSubImage1D>;
    static constexpr auto encode = sharing<&encode::TexSubImage1D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexSubImage1D);
};
struct TexSubImage2D {
    static constexpr auto run = sharing<&cmd::TexSubImage2D>;
    static constexpr auto encode = sharing<&encode::TexSubImage2D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexSubImage2D);
};
struct TexSubImage3D {
    static constexpr auto run = sharing<&cmd::TexSubImage3D>;
    static constexpr auto encode = sharing<&encode::TexSubImage3D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexSubImage3D);
};
struct CopyTexImage1D {
    static constexpr auto run = sharing<&cmd::CopyTexImage1D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CopyTexImage1D);
};
struct CopyTexImage2D {
    static constexpr auto run = sharing<&cmd::CopyTexImage2D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CopyTexImage2D);
};
struct CopyTexSubImage1D {
    static constexpr auto run = sharing<&cmd::CopyTexSubImage1D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CopyTexSubImage1D);
};
struct CopyTexSubImage2D {
    static constexpr auto run = sharing<&cmd::CopyTexSubImage2D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CopyTexSubImage2D);
};
struct CopyTexSubImage3D {
    static constexpr auto run = sharing<&cmd::CopyTexSubImage3D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CopyTexSubImage3D);
};
struct CompressedTexImage1D {
    static constexpr auto run = sharing<&cmd::CompressedTexImage1D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CompressedTexImage1D);
};
struct CompressedTexImage2D {
    static constexpr auto run = sharing<&cmd::CompressedTexImage2D>;
    static constexpr auto encode = sharing<&encode::CompressedTexImage2D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CompressedTexImage2D);
};
struct CompressedTexImage3D {
    static constexpr auto run = sharing<&cmd::CompressedTexImage3D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CompressedTexImage3D);
};
struct CompressedTexSubImage1D {
    static constexpr auto run = sharing<&cmd::CompressedTexSubImage1D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CompressedTexSubImage1D);
};
struct CompressedTexSubImage2D {
    static constexpr auto run = sharing<&cmd::CompressedTexSubImage2D>;
    static constexpr auto encode = sharing<&encode::CompressedTexSubImage2D>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CompressedTexSubImage2D);
};
struct CompressedTexSubImage3D {
    static constexpr auto run = sharing<&cmd::CompressedTexSubImage3D>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CompressedTexSubImage3D);
};
struct CompressedTexConstantImage2DSPANGLE {
    static constexpr auto run = sharing<&cmd::CompressedTexConstantImage2DSPANGLE>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CompressedTexConstantImage2DSPANGLE);
};
struct GetTexImage {
    static constexpr auto run = sharing<&cmd::GetTexImage>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetTexImage);
};
struct GetCompressedTexImage {
    static constexpr auto run = sharing<&cmd::GetCompressedTexImage>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetCompressedTexImage);
};
struct GenerateMipmap {
    static constexpr auto run = sharing<&cmd::GenerateMipmap>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GenerateMipmap);
};
struct AreTexturesResident {
    static constexpr auto run = sharing<&cmd::AreTexturesResident>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(AreTexturesResident);
};
struct PrioritizeTextures {
    static constexpr auto run = sharing<&cmd::PrioritizeTextures>;
    static constexpr auto encode = sharing<&encode::PrioritizeTextures>;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PrioritizeTextures);
};
struct GenTextures {
    static constexpr auto run = sharing<&cmd::GenTextures>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GenTextures);
};
struct DeleteTextures {
    static constexpr auto run = sharing<&cmd::DeleteTextures>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DeleteTextures);
};
struct BindTexture {
    static constexpr auto run = sharing<&cmd::BindTexture>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(BindTexture);
};
struct ActiveTexture {
    static constexpr auto run = &cmd::ActiveTexture;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ActiveTexture);
};
struct IsTexture {
    static constexpr auto run = sharing<&cmd::IsTexture>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(IsTexture);
};
struct TexParameter {
    static constexpr auto run = sharing<&cmd::TexParameter>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexParameter);
};
struct GetTexParameter {
    static constexpr auto run = sharing<&cmd::GetTexParameter>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetTexParameter);
};
struct TexEnv {
    static constexpr auto run = &cmd::TexEnv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(TexEnv);
};
struct GetTexEnv {
    static constexpr auto run = &cmd::GetTexEnv;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetTexEnv);
};
struct GetTexLevelParameter {
    static constexpr auto run = sharing<&cmd::GetTexLevelParameter>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetTexLevelParameter);
};
struct NewList {
    static constexpr auto run = &cmd::NewList;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(NewList);
};
struct EndList {
    static constexpr auto run = sharing<&cmd::EndList>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EndList);
};
struct CallList {
    static constexpr auto run = sharing<&cmd::CallList>;
    static constexpr auto encode = sharing<&encode::CallList>;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CallList);
};
struct CallLists {
    static constexpr auto run = sharing<&cmd::CallLists>;
    static constexpr auto encode = sharing<&encode::CallLists>;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(CallLists);
};
struct ListBase {
    static constexpr auto run = &cmd::ListBase;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(ListBase);
};
struct GenLists {
    static constexpr auto run = sharing<&cmd::GenLists>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GenLists);
};
struct DeleteLists {
    static constexpr auto run = sharing<&cmd::DeleteLists>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(DeleteLists);
};
struct IsList {
    static constexpr auto run = sharing<&cmd::IsList>;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(IsList);
};
struct RenderMode {
    static constexpr auto run = &cmd::RenderMode;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(RenderMode);
};
struct SelectBuffer {
    static constexpr auto run = &cmd::SelectBuffer;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(SelectBuffer);
};
struct InitNames {
    static constexpr auto run = &cmd::InitNames;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(InitNames);
};
struct PushName {
    static constexpr auto run = &cmd::PushName;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PushName);
};
struct PopName {
    static constexpr auto run = &cmd::PopName;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PopName);
};
struct LoadName {
    static constexpr auto run = &cmd::LoadName;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(LoadName);
};
struct FeedbackBuffer {
    static constexpr auto run = &cmd::FeedbackBuffer;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(FeedbackBuffer);
};
struct PassThrough {
    static constexpr auto run = &cmd::PassThrough;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(PassThrough);
};
struct Map1 {
    static constexpr auto run = &cmd::Map1;
    static constexpr auto encode = &encode::Map1;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Map1);
};
struct Map2 {
    static constexpr auto run = &cmd::Map2;
    static constexpr auto encode = &encode::Map2;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::client_data;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(Map2);
};
struct GetMap {
    static constexpr auto run = &cmd::GetMap;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::never;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(GetMap);
};
struct EvalCoord1 {
    static constexpr auto run = &cmd::EvalCoord1;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EvalCoord1);
};
struct EvalCoord2 {
    static constexpr auto run = &cmd::EvalCoord2;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EvalCoord2);
};
struct MapGrid1 {
    static constexpr auto run = &cmd::MapGrid1;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(MapGrid1);
};
struct MapGrid2 {
    static constexpr auto run = &cmd::MapGrid2;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(MapGrid2);
};
struct EvalMesh1 {
    static constexpr auto run = &cmd::EvalMesh1;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EvalMesh1);
};
struct EvalMesh2 {
    static constexpr auto run = &cmd::EvalMesh2;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = false;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EvalMesh2);
};
struct EvalPoint1 {
    static constexpr auto run = &cmd::EvalPoint1;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EvalPoint1);
};
struct EvalPoint2 {
    static constexpr auto run = &cmd::EvalPoint2;
    static constexpr auto encode = nullptr;
    static constexpr bool inside = true;
    static constexpr Listing listing = Listing::words;
    static constexpr const CommandText* text = SPANGLE_COMMAND_TEXT(EvalPoint2);
};

} // namespace spangle::gl::family
