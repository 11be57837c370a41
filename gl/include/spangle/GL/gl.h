/* OpenGL as Spangle has it: exactly the commands that exist. For C89 and up, and C++.
   Written by gl/api/generate.py from gl/api/commands: change those, not this.

   A comment holds for all commands and tokens below it, up to the next one. A command that raises an error does nothing else (GL 1.3,
   2.5). It raises GL_INVALID_ENUM for a token that it does not take, GL_INVALID_VALUE for a number outside of its range, a negative size
   or a null pointer, and GL_INVALID_OPERATION where its optional system is left out of the build, or between glBegin and glEnd unless its
   comment allows that. What a pointer of a command refers to is read or written before the command returns, except where a comment says
   that it must stay. Vertex arrays are read when they are drawn; the arrays of glSelectBuffer and glFeedbackBuffer are written until
   their mode ends. */
#ifndef SPANGLE_GL_GL_H
#define SPANGLE_GL_GL_H

/* How functions are declared and called; a build may define them. */
#ifndef GLAPI
#define GLAPI extern
#endif
#ifndef APIENTRY
#define APIENTRY
#endif
#ifndef GLAPIENTRY
#define GLAPIENTRY APIENTRY
#endif

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* This GL is Spangle, and has these versions. */
#define SPANGLE_GL 1
#define GL_VERSION_1_0 1
#define GL_VERSION_1_1 1
#define GL_VERSION_1_2 1
#define GL_VERSION_1_3 1
#define GL_VERSION_1_4 1
#define GL_VERSION_1_5 1

/* Types (GL 1.3, 2.4, table 2.2; GL 1.5, 2.4) */
typedef unsigned int GLenum;
typedef unsigned char GLboolean;
typedef unsigned int GLbitfield;
typedef void GLvoid;
typedef ptrdiff_t GLintptr;
typedef ptrdiff_t GLsizeiptr;
typedef signed char GLbyte;
typedef short GLshort;
typedef int GLint;
typedef unsigned char GLubyte;
typedef unsigned short GLushort;
typedef unsigned int GLuint;
typedef int GLsizei;
typedef float GLfloat;
typedef float GLclampf;
typedef double GLdouble;
typedef double GLclampd;
typedef int GLfixed;  /* S15.16, GL_OES_fixed_point */
typedef int GLclampx; /* S15.16, clamped to [0, 1] */

/* Errors, enables, queries (GL 1.3, 2.5, 6.1) */
#define GL_FALSE 0
#define GL_TRUE 1
#define GL_NO_ERROR 0
#define GL_INVALID_ENUM 0x0500
#define GL_INVALID_VALUE 0x0501
#define GL_INVALID_OPERATION 0x0502
#define GL_STACK_OVERFLOW 0x0503
#define GL_STACK_UNDERFLOW 0x0504
#define GL_OUT_OF_MEMORY 0x0505
#define GL_CURRENT_BIT 1
#define GL_POINT_BIT 0x0002
#define GL_LINE_BIT 0x0004
#define GL_POLYGON_BIT 0x0008
#define GL_POLYGON_STIPPLE_BIT 0x0010
#define GL_PIXEL_MODE_BIT 0x0020
#define GL_LIGHTING_BIT 0x0040
#define GL_FOG_BIT 0x0080
#define GL_VIEWPORT_BIT 0x0800
#define GL_TRANSFORM_BIT 0x1000
#define GL_ENABLE_BIT 0x2000
#define GL_HINT_BIT 0x8000
#define GL_EVAL_BIT 0x10000
#define GL_LIST_BIT 0x20000
#define GL_TEXTURE_BIT 0x40000
#define GL_SCISSOR_BIT 0x80000
#define GL_MULTISAMPLE_BIT 0x20000000
#define GL_ALL_ATTRIB_BITS 0xFFFFFFFF
#define GL_CLIENT_PIXEL_STORE_BIT 1
#define GL_CLIENT_VERTEX_ARRAY_BIT 0x0002
#define GL_CLIENT_ALL_ATTRIB_BITS 0xFFFFFFFF
#define GL_ATTRIB_STACK_DEPTH 0x0BB0
#define GL_CLIENT_ATTRIB_STACK_DEPTH 0x0BB1
#define GL_MAX_ATTRIB_STACK_DEPTH 0x0D35
#define GL_MAX_CLIENT_ATTRIB_STACK_DEPTH 0x0D3B
#define GL_VENDOR 0x1F00
#define GL_RENDERER 0x1F01
#define GL_VERSION 0x1F02
#define GL_EXTENSIONS 0x1F03
/* Returns the oldest error that was not asked for yet, and forgets it; GL_NO_ERROR: there is none (GL 1.3, 2.5). */
GLAPI GLenum GLAPIENTRY glGetError(void);
/* Turns a capability on (GL 1.3, 6.1.1). */
GLAPI void GLAPIENTRY glEnable(GLenum cap);
/* Turns a capability off (GL 1.3, 6.1.1). */
GLAPI void GLAPIENTRY glDisable(GLenum cap);
/* Tells whether a capability is on (GL 1.3, 6.1.1). */
GLAPI GLboolean GLAPIENTRY glIsEnabled(GLenum cap);
/* Writes values of state to params as booleans: GL_FALSE for 0 (GL 1.3, 6.1.1). Not compiled into display lists. */
GLAPI void GLAPIENTRY glGetBooleanv(GLenum pname, GLboolean* params);
/* Writes values of state to params as integers, rounded; colours and normals are scaled to the range of an int (GL 1.3, 6.1.1). Not
   compiled into display lists. */
GLAPI void GLAPIENTRY glGetIntegerv(GLenum pname, GLint* params);
/* Writes values of state to params as floats (GL 1.3, 6.1.1). Not compiled into display lists. */
GLAPI void GLAPIENTRY glGetFloatv(GLenum pname, GLfloat* params);
/* Writes values of state to params as doubles (GL 1.3, 6.1.1). Not compiled into display lists. */
GLAPI void GLAPIENTRY glGetDoublev(GLenum pname, GLdouble* params);
/* Writes values of state to params as S15.16 numbers (GL 1.3, 6.1.1). Not compiled into display lists. Optional system: FIXED_POINT. */
GLAPI void GLAPIENTRY glGetFixedvOES(GLenum pname, GLfixed* params);
/* Writes a pointer that the program gave to params (GL 1.3, 6.1.3). Not compiled into display lists. */
GLAPI void GLAPIENTRY glGetPointerv(GLenum pname, void** params);
/* Returns a static string about this GL; null after an error (GL 1.3, 6.1.11). name: GL_VENDOR, GL_RENDERER, GL_VERSION, GL_EXTENSIONS. */
GLAPI const GLubyte* GLAPIENTRY glGetString(GLenum name);
/* Pushes groups of server state, a bit each in mask (GL 1.3, 6.1.12). Optional system: ATTRIB_STACKS. */
GLAPI void GLAPIENTRY glPushAttrib(GLbitfield mask);
/* Pops the groups that the last glPushAttrib pushed (GL 1.3, 6.1.12). Optional system: ATTRIB_STACKS. */
GLAPI void GLAPIENTRY glPopAttrib(void);
/* Pushes groups of client state, a bit each in mask (GL 1.3, 6.1.12). Not compiled into display lists. Optional system: ATTRIB_STACKS. */
GLAPI void GLAPIENTRY glPushClientAttrib(GLbitfield mask);
/* Pops the groups that the last glPushClientAttrib pushed (GL 1.3, 6.1.12). Not compiled into display lists. Optional system:
   ATTRIB_STACKS. */
GLAPI void GLAPIENTRY glPopClientAttrib(void);

/* Vertices, attributes, arrays (GL 1.3, 2.6 to 2.9) */
#define GL_POINTS 0
#define GL_LINES 1
#define GL_LINE_LOOP 0x0002
#define GL_LINE_STRIP 0x0003
#define GL_TRIANGLES 0x0004
#define GL_TRIANGLE_STRIP 0x0005
#define GL_TRIANGLE_FAN 0x0006
#define GL_QUADS 0x0007
#define GL_QUAD_STRIP 0x0008
#define GL_POLYGON 0x0009
#define GL_BYTE 0x1400
#define GL_UNSIGNED_BYTE 0x1401
#define GL_SHORT 0x1402
#define GL_UNSIGNED_SHORT 0x1403
#define GL_INT 0x1404
#define GL_UNSIGNED_INT 0x1405
#define GL_FLOAT 0x1406
#define GL_2_BYTES 0x1407
#define GL_3_BYTES 0x1408
#define GL_4_BYTES 0x1409
#define GL_DOUBLE 0x140A
#define GL_FIXED 0x140C
#define GL_FIXED_OES 0x140C
#define GL_VERTEX_ARRAY 0x8074
#define GL_NORMAL_ARRAY 0x8075
#define GL_COLOR_ARRAY 0x8076
#define GL_TEXTURE_COORD_ARRAY 0x8078
#define GL_INDEX_ARRAY 0x8077
#define GL_INDEX_ARRAY_TYPE 0x8085
#define GL_INDEX_ARRAY_STRIDE 0x8086
#define GL_INDEX_ARRAY_POINTER 0x8091
#define GL_EDGE_FLAG_ARRAY 0x8079
#define GL_EDGE_FLAG_ARRAY_STRIDE 0x808C
#define GL_EDGE_FLAG_ARRAY_POINTER 0x8093
#define GL_VERTEX_ARRAY_SIZE 0x807A
#define GL_VERTEX_ARRAY_TYPE 0x807B
#define GL_VERTEX_ARRAY_STRIDE 0x807C
#define GL_NORMAL_ARRAY_TYPE 0x807E
#define GL_NORMAL_ARRAY_STRIDE 0x807F
#define GL_COLOR_ARRAY_SIZE 0x8081
#define GL_COLOR_ARRAY_TYPE 0x8082
#define GL_COLOR_ARRAY_STRIDE 0x8083
#define GL_TEXTURE_COORD_ARRAY_SIZE 0x8088
#define GL_TEXTURE_COORD_ARRAY_TYPE 0x8089
#define GL_TEXTURE_COORD_ARRAY_STRIDE 0x808A
#define GL_VERTEX_ARRAY_POINTER 0x808E
#define GL_NORMAL_ARRAY_POINTER 0x808F
#define GL_COLOR_ARRAY_POINTER 0x8090
#define GL_TEXTURE_COORD_ARRAY_POINTER 0x8092
#define GL_V2F 0x2A20
#define GL_V3F 0x2A21
#define GL_C4UB_V2F 0x2A22
#define GL_C4UB_V3F 0x2A23
#define GL_C3F_V3F 0x2A24
#define GL_N3F_V3F 0x2A25
#define GL_C4F_N3F_V3F 0x2A26
#define GL_T2F_V3F 0x2A27
#define GL_T4F_V4F 0x2A28
#define GL_T2F_C4UB_V3F 0x2A29
#define GL_T2F_C3F_V3F 0x2A2A
#define GL_T2F_N3F_V3F 0x2A2B
#define GL_T2F_C4F_N3F_V3F 0x2A2C
#define GL_T4F_C4F_N3F_V4F 0x2A2D
#define GL_CURRENT_COLOR 0x0B00
#define GL_CURRENT_INDEX 0x0B01
#define GL_EDGE_FLAG 0x0B43
#define GL_CURRENT_NORMAL 0x0B02
#define GL_CURRENT_TEXTURE_COORDS 0x0B03
#define GL_ARRAY_BUFFER 0x8892
#define GL_ELEMENT_ARRAY_BUFFER 0x8893
#define GL_ARRAY_BUFFER_BINDING 0x8894
#define GL_ELEMENT_ARRAY_BUFFER_BINDING 0x8895
#define GL_VERTEX_ARRAY_BUFFER_BINDING 0x8896
#define GL_NORMAL_ARRAY_BUFFER_BINDING 0x8897
#define GL_COLOR_ARRAY_BUFFER_BINDING 0x8898
#define GL_INDEX_ARRAY_BUFFER_BINDING 0x8899
#define GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING 0x889A
#define GL_EDGE_FLAG_ARRAY_BUFFER_BINDING 0x889B
#define GL_STREAM_DRAW 0x88E0
#define GL_STREAM_READ 0x88E1
#define GL_STREAM_COPY 0x88E2
#define GL_STATIC_DRAW 0x88E4
#define GL_STATIC_READ 0x88E5
#define GL_STATIC_COPY 0x88E6
#define GL_DYNAMIC_DRAW 0x88E8
#define GL_DYNAMIC_READ 0x88E9
#define GL_DYNAMIC_COPY 0x88EA
#define GL_READ_ONLY 0x88B8
#define GL_WRITE_ONLY 0x88B9
#define GL_READ_WRITE 0x88BA
#define GL_BUFFER_SIZE 0x8764
#define GL_BUFFER_USAGE 0x8765
#define GL_BUFFER_ACCESS 0x88BB
#define GL_BUFFER_MAPPED 0x88BC
#define GL_BUFFER_MAP_POINTER 0x88BD
#define GL_BUFFER_ACCESS_FLAGS 0x911F
#define GL_BUFFER_MAP_LENGTH 0x9120
#define GL_BUFFER_MAP_OFFSET 0x9121
#define GL_MAP_READ_BIT 1
#define GL_MAP_WRITE_BIT 0x0002
#define GL_MAP_INVALIDATE_RANGE_BIT 0x0004
#define GL_MAP_INVALIDATE_BUFFER_BIT 0x0008
#define GL_MAP_FLUSH_EXPLICIT_BIT 0x0010
#define GL_MAP_UNSYNCHRONIZED_BIT 0x0020
#define GL_CLIENT_ACTIVE_TEXTURE 0x84E1
#define GL_PRIMITIVE_RESTART 0x8F9D
#define GL_PRIMITIVE_RESTART_INDEX 0x8F9E
#define GL_VERTEX_ARRAY_BINDING 0x85B5
#define GL_COLOR_SUM 0x8458
#define GL_CURRENT_SECONDARY_COLOR 0x8459
#define GL_SECONDARY_COLOR_ARRAY_SIZE 0x845A
#define GL_SECONDARY_COLOR_ARRAY_TYPE 0x845B
#define GL_SECONDARY_COLOR_ARRAY_STRIDE 0x845C
#define GL_SECONDARY_COLOR_ARRAY_POINTER 0x845D
#define GL_SECONDARY_COLOR_ARRAY 0x845E
#define GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING 0x889C
#define GL_CURRENT_FOG_COORDINATE 0x8453
#define GL_FOG_COORDINATE_ARRAY_TYPE 0x8454
#define GL_FOG_COORDINATE_ARRAY_STRIDE 0x8455
#define GL_FOG_COORDINATE_ARRAY_POINTER 0x8456
#define GL_FOG_COORDINATE_ARRAY 0x8457
#define GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING 0x889D
#define GL_CURRENT_FOG_COORD 0x8453
#define GL_FOG_COORD_ARRAY_TYPE 0x8454
#define GL_FOG_COORD_ARRAY_STRIDE 0x8455
#define GL_FOG_COORD_ARRAY_POINTER 0x8456
#define GL_FOG_COORD_ARRAY 0x8457
#define GL_FOG_COORD_ARRAY_BUFFER_BINDING 0x889D
#define GL_CURRENT_RASTER_COLOR 0x0B04
#define GL_CURRENT_RASTER_INDEX 0x0B05
#define GL_CURRENT_RASTER_TEXTURE_COORDS 0x0B06
#define GL_CURRENT_RASTER_POSITION 0x0B07
#define GL_CURRENT_RASTER_POSITION_VALID 0x0B08
#define GL_CURRENT_RASTER_DISTANCE 0x0B09
#define GL_MAX_ELEMENTS_VERTICES 0x80E8
#define GL_MAX_ELEMENTS_INDICES 0x80E9
/* Begins primitives: the vertices up to glEnd make them (GL 1.3, 2.6.1). mode: GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP,
   GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON. */
GLAPI void GLAPIENTRY glBegin(GLenum mode);
/* Ends the primitives that glBegin began (GL 1.3, 2.6.1). Also between glBegin and glEnd. */
GLAPI void GLAPIENTRY glEnd(void);
/* Gives a vertex in object space, with the current attributes; z is 0 and w is 1 where they are not given (GL 1.3, 2.7). Also between
   glBegin and glEnd. */
GLAPI void GLAPIENTRY glVertex2s(GLshort x, GLshort y);
GLAPI void GLAPIENTRY glVertex2sv(const GLshort* v);
GLAPI void GLAPIENTRY glVertex2i(GLint x, GLint y);
GLAPI void GLAPIENTRY glVertex2iv(const GLint* v);
GLAPI void GLAPIENTRY glVertex2f(GLfloat x, GLfloat y);
GLAPI void GLAPIENTRY glVertex2fv(const GLfloat* v);
GLAPI void GLAPIENTRY glVertex2d(GLdouble x, GLdouble y);
GLAPI void GLAPIENTRY glVertex2dv(const GLdouble* v);
GLAPI void GLAPIENTRY glVertex2xOES(GLfixed x, GLfixed y);
GLAPI void GLAPIENTRY glVertex2xvOES(const GLfixed* v);
GLAPI void GLAPIENTRY glVertex3s(GLshort x, GLshort y, GLshort z);
GLAPI void GLAPIENTRY glVertex3sv(const GLshort* v);
GLAPI void GLAPIENTRY glVertex3i(GLint x, GLint y, GLint z);
GLAPI void GLAPIENTRY glVertex3iv(const GLint* v);
GLAPI void GLAPIENTRY glVertex3f(GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glVertex3fv(const GLfloat* v);
GLAPI void GLAPIENTRY glVertex3d(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glVertex3dv(const GLdouble* v);
GLAPI void GLAPIENTRY glVertex3xOES(GLfixed x, GLfixed y, GLfixed z);
GLAPI void GLAPIENTRY glVertex3xvOES(const GLfixed* v);
GLAPI void GLAPIENTRY glVertex4s(GLshort x, GLshort y, GLshort z, GLshort w);
GLAPI void GLAPIENTRY glVertex4sv(const GLshort* v);
GLAPI void GLAPIENTRY glVertex4i(GLint x, GLint y, GLint z, GLint w);
GLAPI void GLAPIENTRY glVertex4iv(const GLint* v);
GLAPI void GLAPIENTRY glVertex4f(GLfloat x, GLfloat y, GLfloat z, GLfloat w);
GLAPI void GLAPIENTRY glVertex4fv(const GLfloat* v);
GLAPI void GLAPIENTRY glVertex4d(GLdouble x, GLdouble y, GLdouble z, GLdouble w);
GLAPI void GLAPIENTRY glVertex4dv(const GLdouble* v);
GLAPI void GLAPIENTRY glVertex4xOES(GLfixed x, GLfixed y, GLfixed z, GLfixed w);
GLAPI void GLAPIENTRY glVertex4xvOES(const GLfixed* v);
/* Sets the current texture coordinates of unit 0 (GL 1.3, 2.7). Also between glBegin and glEnd. */
GLAPI void GLAPIENTRY glTexCoord1s(GLshort s);
GLAPI void GLAPIENTRY glTexCoord1sv(const GLshort* v);
GLAPI void GLAPIENTRY glTexCoord1i(GLint s);
GLAPI void GLAPIENTRY glTexCoord1iv(const GLint* v);
GLAPI void GLAPIENTRY glTexCoord1f(GLfloat s);
GLAPI void GLAPIENTRY glTexCoord1fv(const GLfloat* v);
GLAPI void GLAPIENTRY glTexCoord1d(GLdouble s);
GLAPI void GLAPIENTRY glTexCoord1dv(const GLdouble* v);
GLAPI void GLAPIENTRY glTexCoord1xOES(GLfixed s);
GLAPI void GLAPIENTRY glTexCoord1xvOES(const GLfixed* v);
GLAPI void GLAPIENTRY glTexCoord2s(GLshort s, GLshort t);
GLAPI void GLAPIENTRY glTexCoord2sv(const GLshort* v);
GLAPI void GLAPIENTRY glTexCoord2i(GLint s, GLint t);
GLAPI void GLAPIENTRY glTexCoord2iv(const GLint* v);
GLAPI void GLAPIENTRY glTexCoord2f(GLfloat s, GLfloat t);
GLAPI void GLAPIENTRY glTexCoord2fv(const GLfloat* v);
GLAPI void GLAPIENTRY glTexCoord2d(GLdouble s, GLdouble t);
GLAPI void GLAPIENTRY glTexCoord2dv(const GLdouble* v);
GLAPI void GLAPIENTRY glTexCoord2xOES(GLfixed s, GLfixed t);
GLAPI void GLAPIENTRY glTexCoord2xvOES(const GLfixed* v);
GLAPI void GLAPIENTRY glTexCoord3s(GLshort s, GLshort t, GLshort r);
GLAPI void GLAPIENTRY glTexCoord3sv(const GLshort* v);
GLAPI void GLAPIENTRY glTexCoord3i(GLint s, GLint t, GLint r);
GLAPI void GLAPIENTRY glTexCoord3iv(const GLint* v);
GLAPI void GLAPIENTRY glTexCoord3f(GLfloat s, GLfloat t, GLfloat r);
GLAPI void GLAPIENTRY glTexCoord3fv(const GLfloat* v);
GLAPI void GLAPIENTRY glTexCoord3d(GLdouble s, GLdouble t, GLdouble r);
GLAPI void GLAPIENTRY glTexCoord3dv(const GLdouble* v);
GLAPI void GLAPIENTRY glTexCoord3xOES(GLfixed s, GLfixed t, GLfixed r);
GLAPI void GLAPIENTRY glTexCoord3xvOES(const GLfixed* v);
GLAPI void GLAPIENTRY glTexCoord4s(GLshort s, GLshort t, GLshort r, GLshort q);
GLAPI void GLAPIENTRY glTexCoord4sv(const GLshort* v);
GLAPI void GLAPIENTRY glTexCoord4i(GLint s, GLint t, GLint r, GLint q);
GLAPI void GLAPIENTRY glTexCoord4iv(const GLint* v);
GLAPI void GLAPIENTRY glTexCoord4f(GLfloat s, GLfloat t, GLfloat r, GLfloat q);
GLAPI void GLAPIENTRY glTexCoord4fv(const GLfloat* v);
GLAPI void GLAPIENTRY glTexCoord4d(GLdouble s, GLdouble t, GLdouble r, GLdouble q);
GLAPI void GLAPIENTRY glTexCoord4dv(const GLdouble* v);
GLAPI void GLAPIENTRY glTexCoord4xOES(GLfixed s, GLfixed t, GLfixed r, GLfixed q);
GLAPI void GLAPIENTRY glTexCoord4xvOES(const GLfixed* v);
/* Sets the current texture coordinates of a unit (GL 1.3, 2.7). target: GL_TEXTURE0, GL_TEXTURE1. Also between glBegin and glEnd. */
GLAPI void GLAPIENTRY glMultiTexCoord1s(GLenum target, GLshort s);
GLAPI void GLAPIENTRY glMultiTexCoord1sv(GLenum target, const GLshort* v);
GLAPI void GLAPIENTRY glMultiTexCoord1i(GLenum target, GLint s);
GLAPI void GLAPIENTRY glMultiTexCoord1iv(GLenum target, const GLint* v);
GLAPI void GLAPIENTRY glMultiTexCoord1f(GLenum target, GLfloat s);
GLAPI void GLAPIENTRY glMultiTexCoord1fv(GLenum target, const GLfloat* v);
GLAPI void GLAPIENTRY glMultiTexCoord1d(GLenum target, GLdouble s);
GLAPI void GLAPIENTRY glMultiTexCoord1dv(GLenum target, const GLdouble* v);
GLAPI void GLAPIENTRY glMultiTexCoord1xOES(GLenum target, GLfixed s);
GLAPI void GLAPIENTRY glMultiTexCoord1xvOES(GLenum target, const GLfixed* v);
GLAPI void GLAPIENTRY glMultiTexCoord2s(GLenum target, GLshort s, GLshort t);
GLAPI void GLAPIENTRY glMultiTexCoord2sv(GLenum target, const GLshort* v);
GLAPI void GLAPIENTRY glMultiTexCoord2i(GLenum target, GLint s, GLint t);
GLAPI void GLAPIENTRY glMultiTexCoord2iv(GLenum target, const GLint* v);
GLAPI void GLAPIENTRY glMultiTexCoord2f(GLenum target, GLfloat s, GLfloat t);
GLAPI void GLAPIENTRY glMultiTexCoord2fv(GLenum target, const GLfloat* v);
GLAPI void GLAPIENTRY glMultiTexCoord2d(GLenum target, GLdouble s, GLdouble t);
GLAPI void GLAPIENTRY glMultiTexCoord2dv(GLenum target, const GLdouble* v);
GLAPI void GLAPIENTRY glMultiTexCoord2xOES(GLenum target, GLfixed s, GLfixed t);
GLAPI void GLAPIENTRY glMultiTexCoord2xvOES(GLenum target, const GLfixed* v);
GLAPI void GLAPIENTRY glMultiTexCoord3s(GLenum target, GLshort s, GLshort t, GLshort r);
GLAPI void GLAPIENTRY glMultiTexCoord3sv(GLenum target, const GLshort* v);
GLAPI void GLAPIENTRY glMultiTexCoord3i(GLenum target, GLint s, GLint t, GLint r);
GLAPI void GLAPIENTRY glMultiTexCoord3iv(GLenum target, const GLint* v);
GLAPI void GLAPIENTRY glMultiTexCoord3f(GLenum target, GLfloat s, GLfloat t, GLfloat r);
GLAPI void GLAPIENTRY glMultiTexCoord3fv(GLenum target, const GLfloat* v);
GLAPI void GLAPIENTRY glMultiTexCoord3d(GLenum target, GLdouble s, GLdouble t, GLdouble r);
GLAPI void GLAPIENTRY glMultiTexCoord3dv(GLenum target, const GLdouble* v);
GLAPI void GLAPIENTRY glMultiTexCoord3xOES(GLenum target, GLfixed s, GLfixed t, GLfixed r);
GLAPI void GLAPIENTRY glMultiTexCoord3xvOES(GLenum target, const GLfixed* v);
GLAPI void GLAPIENTRY glMultiTexCoord4s(GLenum target, GLshort s, GLshort t, GLshort r, GLshort q);
GLAPI void GLAPIENTRY glMultiTexCoord4sv(GLenum target, const GLshort* v);
GLAPI void GLAPIENTRY glMultiTexCoord4i(GLenum target, GLint s, GLint t, GLint r, GLint q);
GLAPI void GLAPIENTRY glMultiTexCoord4iv(GLenum target, const GLint* v);
GLAPI void GLAPIENTRY glMultiTexCoord4f(GLenum target, GLfloat s, GLfloat t, GLfloat r, GLfloat q);
GLAPI void GLAPIENTRY glMultiTexCoord4fv(GLenum target, const GLfloat* v);
GLAPI void GLAPIENTRY glMultiTexCoord4d(GLenum target, GLdouble s, GLdouble t, GLdouble r, GLdouble q);
GLAPI void GLAPIENTRY glMultiTexCoord4dv(GLenum target, const GLdouble* v);
GLAPI void GLAPIENTRY glMultiTexCoord4xOES(GLenum target, GLfixed s, GLfixed t, GLfixed r, GLfixed q);
GLAPI void GLAPIENTRY glMultiTexCoord4xvOES(GLenum target, const GLfixed* v);
/* Sets the current normal; integers are scaled to [-1, 1] (GL 1.3, 2.7). Also between glBegin and glEnd. */
GLAPI void GLAPIENTRY glNormal3b(GLbyte nx, GLbyte ny, GLbyte nz);
GLAPI void GLAPIENTRY glNormal3bv(const GLbyte* v);
GLAPI void GLAPIENTRY glNormal3s(GLshort nx, GLshort ny, GLshort nz);
GLAPI void GLAPIENTRY glNormal3sv(const GLshort* v);
GLAPI void GLAPIENTRY glNormal3i(GLint nx, GLint ny, GLint nz);
GLAPI void GLAPIENTRY glNormal3iv(const GLint* v);
GLAPI void GLAPIENTRY glNormal3f(GLfloat nx, GLfloat ny, GLfloat nz);
GLAPI void GLAPIENTRY glNormal3fv(const GLfloat* v);
GLAPI void GLAPIENTRY glNormal3d(GLdouble nx, GLdouble ny, GLdouble nz);
GLAPI void GLAPIENTRY glNormal3dv(const GLdouble* v);
GLAPI void GLAPIENTRY glNormal3xOES(GLfixed nx, GLfixed ny, GLfixed nz);
GLAPI void GLAPIENTRY glNormal3xvOES(const GLfixed* v);
/* Sets the current colour; integers are scaled to [0, 1] or [-1, 1], and alpha is 1 where it is not given (GL 1.3, 2.7). Also between
   glBegin and glEnd. */
GLAPI void GLAPIENTRY glColor3b(GLbyte red, GLbyte green, GLbyte blue);
GLAPI void GLAPIENTRY glColor3bv(const GLbyte* v);
GLAPI void GLAPIENTRY glColor3s(GLshort red, GLshort green, GLshort blue);
GLAPI void GLAPIENTRY glColor3sv(const GLshort* v);
GLAPI void GLAPIENTRY glColor3i(GLint red, GLint green, GLint blue);
GLAPI void GLAPIENTRY glColor3iv(const GLint* v);
GLAPI void GLAPIENTRY glColor3f(GLfloat red, GLfloat green, GLfloat blue);
GLAPI void GLAPIENTRY glColor3fv(const GLfloat* v);
GLAPI void GLAPIENTRY glColor3d(GLdouble red, GLdouble green, GLdouble blue);
GLAPI void GLAPIENTRY glColor3dv(const GLdouble* v);
GLAPI void GLAPIENTRY glColor3ub(GLubyte red, GLubyte green, GLubyte blue);
GLAPI void GLAPIENTRY glColor3ubv(const GLubyte* v);
GLAPI void GLAPIENTRY glColor3us(GLushort red, GLushort green, GLushort blue);
GLAPI void GLAPIENTRY glColor3usv(const GLushort* v);
GLAPI void GLAPIENTRY glColor3ui(GLuint red, GLuint green, GLuint blue);
GLAPI void GLAPIENTRY glColor3uiv(const GLuint* v);
GLAPI void GLAPIENTRY glColor3xOES(GLfixed red, GLfixed green, GLfixed blue);
GLAPI void GLAPIENTRY glColor3xvOES(const GLfixed* v);
GLAPI void GLAPIENTRY glColor4b(GLbyte red, GLbyte green, GLbyte blue, GLbyte alpha);
GLAPI void GLAPIENTRY glColor4bv(const GLbyte* v);
GLAPI void GLAPIENTRY glColor4s(GLshort red, GLshort green, GLshort blue, GLshort alpha);
GLAPI void GLAPIENTRY glColor4sv(const GLshort* v);
GLAPI void GLAPIENTRY glColor4i(GLint red, GLint green, GLint blue, GLint alpha);
GLAPI void GLAPIENTRY glColor4iv(const GLint* v);
GLAPI void GLAPIENTRY glColor4f(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
GLAPI void GLAPIENTRY glColor4fv(const GLfloat* v);
GLAPI void GLAPIENTRY glColor4d(GLdouble red, GLdouble green, GLdouble blue, GLdouble alpha);
GLAPI void GLAPIENTRY glColor4dv(const GLdouble* v);
GLAPI void GLAPIENTRY glColor4ub(GLubyte red, GLubyte green, GLubyte blue, GLubyte alpha);
GLAPI void GLAPIENTRY glColor4ubv(const GLubyte* v);
GLAPI void GLAPIENTRY glColor4us(GLushort red, GLushort green, GLushort blue, GLushort alpha);
GLAPI void GLAPIENTRY glColor4usv(const GLushort* v);
GLAPI void GLAPIENTRY glColor4ui(GLuint red, GLuint green, GLuint blue, GLuint alpha);
GLAPI void GLAPIENTRY glColor4uiv(const GLuint* v);
GLAPI void GLAPIENTRY glColor4xOES(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha);
GLAPI void GLAPIENTRY glColor4xvOES(const GLfixed* v);
/* Sets the current secondary colour, which is added after texturing (GL 1.4, 2.7). Also between glBegin and glEnd. Optional system:
   SECONDARY_COLOR. */
GLAPI void GLAPIENTRY glSecondaryColor3b(GLbyte red, GLbyte green, GLbyte blue);
GLAPI void GLAPIENTRY glSecondaryColor3bv(const GLbyte* v);
GLAPI void GLAPIENTRY glSecondaryColor3s(GLshort red, GLshort green, GLshort blue);
GLAPI void GLAPIENTRY glSecondaryColor3sv(const GLshort* v);
GLAPI void GLAPIENTRY glSecondaryColor3i(GLint red, GLint green, GLint blue);
GLAPI void GLAPIENTRY glSecondaryColor3iv(const GLint* v);
GLAPI void GLAPIENTRY glSecondaryColor3f(GLfloat red, GLfloat green, GLfloat blue);
GLAPI void GLAPIENTRY glSecondaryColor3fv(const GLfloat* v);
GLAPI void GLAPIENTRY glSecondaryColor3d(GLdouble red, GLdouble green, GLdouble blue);
GLAPI void GLAPIENTRY glSecondaryColor3dv(const GLdouble* v);
GLAPI void GLAPIENTRY glSecondaryColor3ub(GLubyte red, GLubyte green, GLubyte blue);
GLAPI void GLAPIENTRY glSecondaryColor3ubv(const GLubyte* v);
GLAPI void GLAPIENTRY glSecondaryColor3us(GLushort red, GLushort green, GLushort blue);
GLAPI void GLAPIENTRY glSecondaryColor3usv(const GLushort* v);
GLAPI void GLAPIENTRY glSecondaryColor3ui(GLuint red, GLuint green, GLuint blue);
GLAPI void GLAPIENTRY glSecondaryColor3uiv(const GLuint* v);
/* Sets the current colour index (GL 1.3, 2.7). Also between glBegin and glEnd. Optional system: COLOR_INDEX. */
GLAPI void GLAPIENTRY glIndexs(GLshort index);
GLAPI void GLAPIENTRY glIndexsv(const GLshort* v);
GLAPI void GLAPIENTRY glIndexi(GLint index);
GLAPI void GLAPIENTRY glIndexiv(const GLint* v);
GLAPI void GLAPIENTRY glIndexf(GLfloat index);
GLAPI void GLAPIENTRY glIndexfv(const GLfloat* v);
GLAPI void GLAPIENTRY glIndexd(GLdouble index);
GLAPI void GLAPIENTRY glIndexdv(const GLdouble* v);
GLAPI void GLAPIENTRY glIndexub(GLubyte index);
GLAPI void GLAPIENTRY glIndexubv(const GLubyte* v);
GLAPI void GLAPIENTRY glIndexxOES(GLfixed index);
GLAPI void GLAPIENTRY glIndexxvOES(const GLfixed* v);
/* Says whether the edge that begins at the next vertex is a boundary of its polygon (GL 1.3, 2.6.2). Also between glBegin and glEnd.
   Optional system: POLYGON_MODE. */
GLAPI void GLAPIENTRY glEdgeFlag(GLboolean flag);
GLAPI void GLAPIENTRY glEdgeFlagv(const GLboolean* flag);
/* Sets the current fog coordinate (GL 1.4, 2.7). Also between glBegin and glEnd. Optional system: FOG. */
GLAPI void GLAPIENTRY glFogCoordf(GLfloat coord);
GLAPI void GLAPIENTRY glFogCoordfv(const GLfloat* v);
GLAPI void GLAPIENTRY glFogCoordd(GLdouble coord);
GLAPI void GLAPIENTRY glFogCoorddv(const GLdouble* v);
/* Sets the current raster position from object coordinates, which are transformed and clipped as a vertex is (GL 1.3, 2.12). Optional
   system: RASTER_POS. */
GLAPI void GLAPIENTRY glRasterPos2s(GLshort x, GLshort y);
GLAPI void GLAPIENTRY glRasterPos2sv(const GLshort* v);
GLAPI void GLAPIENTRY glRasterPos2i(GLint x, GLint y);
GLAPI void GLAPIENTRY glRasterPos2iv(const GLint* v);
GLAPI void GLAPIENTRY glRasterPos2f(GLfloat x, GLfloat y);
GLAPI void GLAPIENTRY glRasterPos2fv(const GLfloat* v);
GLAPI void GLAPIENTRY glRasterPos2d(GLdouble x, GLdouble y);
GLAPI void GLAPIENTRY glRasterPos2dv(const GLdouble* v);
GLAPI void GLAPIENTRY glRasterPos2xOES(GLfixed x, GLfixed y);
GLAPI void GLAPIENTRY glRasterPos2xvOES(const GLfixed* v);
GLAPI void GLAPIENTRY glRasterPos3s(GLshort x, GLshort y, GLshort z);
GLAPI void GLAPIENTRY glRasterPos3sv(const GLshort* v);
GLAPI void GLAPIENTRY glRasterPos3i(GLint x, GLint y, GLint z);
GLAPI void GLAPIENTRY glRasterPos3iv(const GLint* v);
GLAPI void GLAPIENTRY glRasterPos3f(GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glRasterPos3fv(const GLfloat* v);
GLAPI void GLAPIENTRY glRasterPos3d(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glRasterPos3dv(const GLdouble* v);
GLAPI void GLAPIENTRY glRasterPos3xOES(GLfixed x, GLfixed y, GLfixed z);
GLAPI void GLAPIENTRY glRasterPos3xvOES(const GLfixed* v);
GLAPI void GLAPIENTRY glRasterPos4s(GLshort x, GLshort y, GLshort z, GLshort w);
GLAPI void GLAPIENTRY glRasterPos4sv(const GLshort* v);
GLAPI void GLAPIENTRY glRasterPos4i(GLint x, GLint y, GLint z, GLint w);
GLAPI void GLAPIENTRY glRasterPos4iv(const GLint* v);
GLAPI void GLAPIENTRY glRasterPos4f(GLfloat x, GLfloat y, GLfloat z, GLfloat w);
GLAPI void GLAPIENTRY glRasterPos4fv(const GLfloat* v);
GLAPI void GLAPIENTRY glRasterPos4d(GLdouble x, GLdouble y, GLdouble z, GLdouble w);
GLAPI void GLAPIENTRY glRasterPos4dv(const GLdouble* v);
GLAPI void GLAPIENTRY glRasterPos4xOES(GLfixed x, GLfixed y, GLfixed z, GLfixed w);
GLAPI void GLAPIENTRY glRasterPos4xvOES(const GLfixed* v);
/* Sets the current raster position in window coordinates (GL 1.4, 2.13). Optional system: RASTER_POS. */
GLAPI void GLAPIENTRY glWindowPos2s(GLshort x, GLshort y);
GLAPI void GLAPIENTRY glWindowPos2sv(const GLshort* v);
GLAPI void GLAPIENTRY glWindowPos2i(GLint x, GLint y);
GLAPI void GLAPIENTRY glWindowPos2iv(const GLint* v);
GLAPI void GLAPIENTRY glWindowPos2f(GLfloat x, GLfloat y);
GLAPI void GLAPIENTRY glWindowPos2fv(const GLfloat* v);
GLAPI void GLAPIENTRY glWindowPos2d(GLdouble x, GLdouble y);
GLAPI void GLAPIENTRY glWindowPos2dv(const GLdouble* v);
GLAPI void GLAPIENTRY glWindowPos3s(GLshort x, GLshort y, GLshort z);
GLAPI void GLAPIENTRY glWindowPos3sv(const GLshort* v);
GLAPI void GLAPIENTRY glWindowPos3i(GLint x, GLint y, GLint z);
GLAPI void GLAPIENTRY glWindowPos3iv(const GLint* v);
GLAPI void GLAPIENTRY glWindowPos3f(GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glWindowPos3fv(const GLfloat* v);
GLAPI void GLAPIENTRY glWindowPos3d(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glWindowPos3dv(const GLdouble* v);
/* Draws the rectangle of two corners in the plane z = 0 (GL 1.3, 2.9). */
GLAPI void GLAPIENTRY glRects(GLshort x1, GLshort y1, GLshort x2, GLshort y2);
GLAPI void GLAPIENTRY glRectsv(const GLshort* v1, const GLshort* v2);
GLAPI void GLAPIENTRY glRecti(GLint x1, GLint y1, GLint x2, GLint y2);
GLAPI void GLAPIENTRY glRectiv(const GLint* v1, const GLint* v2);
GLAPI void GLAPIENTRY glRectf(GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2);
GLAPI void GLAPIENTRY glRectfv(const GLfloat* v1, const GLfloat* v2);
GLAPI void GLAPIENTRY glRectd(GLdouble x1, GLdouble y1, GLdouble x2, GLdouble y2);
GLAPI void GLAPIENTRY glRectdv(const GLdouble* v1, const GLdouble* v2);
GLAPI void GLAPIENTRY glRectxOES(GLfixed x1, GLfixed y1, GLfixed x2, GLfixed y2);
GLAPI void GLAPIENTRY glRectxvOES(const GLfixed* v1, const GLfixed* v2);
/* Names the array of vertices; stride is in bytes, 0 where elements have no gaps (GL 1.3, 2.8). size: 2 to 4. type: GL_BYTE, GL_SHORT,
   GL_INT, GL_FLOAT, GL_DOUBLE, GL_FIXED. Not compiled into display lists. */
GLAPI void GLAPIENTRY glVertexPointer(GLint size, GLenum type, GLsizei stride, const void* pointer);
/* Names the array of normals; stride is in bytes, 0 where elements have no gaps (GL 1.3, 2.8). type: GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT,
   GL_DOUBLE, GL_FIXED. Not compiled into display lists. */
GLAPI void GLAPIENTRY glNormalPointer(GLenum type, GLsizei stride, const void* pointer);
/* Names the array of colours; stride is in bytes, 0 where elements have no gaps (GL 1.3, 2.8). size: 3 to 4. type: GL_BYTE,
   GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT, GL_DOUBLE, GL_FIXED. Not compiled into display lists.
   */
GLAPI void GLAPIENTRY glColorPointer(GLint size, GLenum type, GLsizei stride, const void* pointer);
/* Names the array of texture coordinates of the active client unit (GL 1.3, 2.8). size: 1 to 4. type: GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT,
   GL_DOUBLE, GL_FIXED. Not compiled into display lists. */
GLAPI void GLAPIENTRY glTexCoordPointer(GLint size, GLenum type, GLsizei stride, const void* pointer);
/* Names the array of colour indices (GL 1.3, 2.8). type: GL_UNSIGNED_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE, GL_FIXED. Not compiled
   into display lists. Optional system: COLOR_INDEX. */
GLAPI void GLAPIENTRY glIndexPointer(GLenum type, GLsizei stride, const void* pointer);
/* Names the array of edge flags (GL 1.3, 2.8). Not compiled into display lists. Optional system: POLYGON_MODE. */
GLAPI void GLAPIENTRY glEdgeFlagPointer(GLsizei stride, const void* pointer);
/* Names the array of fog coordinates (GL 1.4, 2.7). type: GL_FLOAT, GL_DOUBLE. Not compiled into display lists. Optional system: FOG. */
GLAPI void GLAPIENTRY glFogCoordPointer(GLenum type, GLsizei stride, const void* pointer);
/* Names the array of secondary colours (GL 1.4, 2.7). size: 3. type: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT,
   GL_UNSIGNED_INT, GL_FLOAT, GL_DOUBLE. Not compiled into display lists. Optional system: SECONDARY_COLOR. */
GLAPI void GLAPIENTRY glSecondaryColorPointer(GLint size, GLenum type, GLsizei stride, const void* pointer);
/* Selects the unit whose coordinate array client commands change (GL 1.3, 2.8). texture: GL_TEXTURE0, GL_TEXTURE1. Not compiled into
   display lists. */
GLAPI void GLAPIENTRY glClientActiveTexture(GLenum texture);
/* Turns an array on (GL 1.3, 2.8). array: GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_INDEX_ARRAY,
   GL_EDGE_FLAG_ARRAY, GL_FOG_COORDINATE_ARRAY, GL_SECONDARY_COLOR_ARRAY. Not compiled into display lists. */
GLAPI void GLAPIENTRY glEnableClientState(GLenum array);
/* Turns an array off (GL 1.3, 2.8). array: GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_INDEX_ARRAY,
   GL_EDGE_FLAG_ARRAY, GL_FOG_COORDINATE_ARRAY, GL_SECONDARY_COLOR_ARRAY. Not compiled into display lists. */
GLAPI void GLAPIENTRY glDisableClientState(GLenum array);
/* Gives the vertex of element i of the arrays that are on (GL 1.3, 2.8). i: at least 0. Also between glBegin and glEnd. */
GLAPI void GLAPIENTRY glArrayElement(GLint i);
/* Draws primitives of count elements from first on (GL 1.3, 2.8). mode: GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES,
   GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON. first: at least 0. */
GLAPI void GLAPIENTRY glDrawArrays(GLenum mode, GLint first, GLsizei count);
/* Draws primitives of the elements that count indices name (GL 1.3, 2.8). mode: GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP,
   GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON. type: GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT,
   GL_UNSIGNED_INT. */
GLAPI void GLAPIENTRY glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices);
/* Does what glDrawElements does; all indices lie in [start, end] (GL 1.3, 2.8). mode: GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP,
   GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON. type: GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT,
   GL_UNSIGNED_INT. */
GLAPI void GLAPIENTRY glDrawRangeElements(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type, const void* indices);
/* Does what as many calls of glDrawArrays do (GL 1.4, 2.8). mode: GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES,
   GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON. */
GLAPI void GLAPIENTRY glMultiDrawArrays(GLenum mode, const GLint* first, const GLsizei* count, GLsizei primcount);
/* Does what as many calls of glDrawElements do (GL 1.4, 2.8). mode: GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES,
   GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON. type: GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT. */
GLAPI void GLAPIENTRY glMultiDrawElements(GLenum mode, const GLsizei* count, GLenum type, const void** indices, GLsizei primcount);
/* Sets the index that begins a new primitive where GL_PRIMITIVE_RESTART is on (GL 3.1, 2.8). Not compiled into display lists. Optional
   system: PRIMITIVE_RESTART. */
GLAPI void GLAPIENTRY glPrimitiveRestartIndex(GLuint index);
/* Writes n unused names of vertex array objects to the array (GL 3.0, 2.10). Not compiled into display lists. Optional system:
   VERTEX_ARRAY_OBJECTS. */
GLAPI void GLAPIENTRY glGenVertexArrays(GLsizei n, GLuint* arrays);
/* Deletes vertex array objects; unused names are ignored (GL 3.0, 2.10). Not compiled into display lists. Optional system:
   VERTEX_ARRAY_OBJECTS. */
GLAPI void GLAPIENTRY glDeleteVertexArrays(GLsizei n, const GLuint* arrays);
/* Tells whether a name is that of a vertex array object (GL 3.0, 2.10). Optional system: VERTEX_ARRAY_OBJECTS. */
GLAPI GLboolean GLAPIENTRY glIsVertexArray(GLuint array);
/* Makes a vertex array object current; 0 is the default one (GL 3.0, 2.10). Not compiled into display lists. Optional system:
   VERTEX_ARRAY_OBJECTS. */
GLAPI void GLAPIENTRY glBindVertexArray(GLuint array);
/* Writes n unused names of buffer objects to the array (GL 1.5, 2.9). Not compiled into display lists. Optional system: BUFFERS. */
GLAPI void GLAPIENTRY glGenBuffers(GLsizei n, GLuint* buffers);
/* Deletes buffer objects; unused names are ignored (GL 1.5, 2.9). Not compiled into display lists. Optional system: BUFFERS. */
GLAPI void GLAPIENTRY glDeleteBuffers(GLsizei n, const GLuint* buffers);
/* Tells whether a name is that of a buffer object (GL 1.5, 2.9). Optional system: BUFFERS. */
GLAPI GLboolean GLAPIENTRY glIsBuffer(GLuint buffer);
/* Binds a buffer object to a target; 0: client memory (GL 1.5, 2.9). target: GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER. Not compiled into
   display lists. Optional system: BUFFERS. */
GLAPI void GLAPIENTRY glBindBuffer(GLenum target, GLuint buffer);
/* Makes the bound buffer anew with size bytes, which are copied from data where that is not null (GL 1.5, 2.9). target: GL_ARRAY_BUFFER,
   GL_ELEMENT_ARRAY_BUFFER. usage: GL_STREAM_DRAW, GL_STREAM_READ, GL_STREAM_COPY, GL_STATIC_DRAW, GL_STATIC_READ, GL_STATIC_COPY,
   GL_DYNAMIC_DRAW, GL_DYNAMIC_READ, GL_DYNAMIC_COPY. Not compiled into display lists. Optional system: BUFFERS. */
GLAPI void GLAPIENTRY glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage);
/* Makes the bound buffer one of size constant bytes at data, which are not copied and must stay (GL 1.5, 2.9). target: GL_ARRAY_BUFFER,
   GL_ELEMENT_ARRAY_BUFFER. Not compiled into display lists. Optional system: BUFFERS. */
GLAPI void GLAPIENTRY glBufferConstantDataSPANGLE(GLenum target, GLsizeiptr size, const void* data);
/* Replaces bytes of the bound buffer (GL 1.5, 2.9). target: GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER. Not compiled into display lists.
   Optional system: BUFFERS. */
GLAPI void GLAPIENTRY glBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, const void* data);
/* Copies bytes of the bound buffer to data (GL 1.5, 2.9). target: GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER. Not compiled into display
   lists. Optional system: BUFFERS. */
GLAPI void GLAPIENTRY glGetBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, void* data);
/* Writes a value of the bound buffer to params (GL 1.5, 2.9). target: GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER. pname: GL_BUFFER_SIZE,
   GL_BUFFER_USAGE, GL_BUFFER_ACCESS, GL_BUFFER_MAPPED, GL_BUFFER_ACCESS_FLAGS, GL_BUFFER_MAP_LENGTH, GL_BUFFER_MAP_OFFSET. Not compiled
   into display lists. Optional system: BUFFERS. */
GLAPI void GLAPIENTRY glGetBufferParameteriv(GLenum target, GLenum pname, GLint* params);
/* Returns the address of the bound buffer's bytes, which is valid until glUnmapBuffer; null after an error (GL 1.5, 2.9). target:
   GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER. access: GL_READ_ONLY, GL_WRITE_ONLY, GL_READ_WRITE. Optional system: BUFFERS. */
GLAPI void* GLAPIENTRY glMapBuffer(GLenum target, GLenum access);
/* Returns the address of a part of the bound buffer, which is valid until glUnmapBuffer; null after an error (GL 1.5, 2.9). target:
   GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER. Optional system: BUFFERS. */
GLAPI void* GLAPIENTRY glMapBufferRange(GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access);
/* Says which bytes of a mapping were changed (GL 1.5, 2.9). target: GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER. Not compiled into display
   lists. Optional system: BUFFERS. */
GLAPI void GLAPIENTRY glFlushMappedBufferRange(GLenum target, GLintptr offset, GLsizeiptr length);
/* Ends the mapping of the bound buffer; GL_FALSE: its contents were lost (GL 1.5, 2.9). target: GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER.
   Optional system: BUFFERS. */
GLAPI GLboolean GLAPIENTRY glUnmapBuffer(GLenum target);
/* Writes the address of the bound buffer's mapping to params; null where it is not mapped (GL 1.5, 2.9). target: GL_ARRAY_BUFFER,
   GL_ELEMENT_ARRAY_BUFFER. pname: GL_BUFFER_MAP_POINTER. Not compiled into display lists. Optional system: BUFFERS. */
GLAPI void GLAPIENTRY glGetBufferPointerv(GLenum target, GLenum pname, void** params);
/* Sets and enables arrays that lie in one memory, in one of fourteen formats (GL 1.3, 2.8). Not compiled into display lists. */
GLAPI void GLAPIENTRY glInterleavedArrays(GLenum format, GLsizei stride, const void* pointer);

/* Matrices, viewport (GL 1.3, 2.10) */
#define GL_MATRIX_MODE 0x0BA0
#define GL_MODELVIEW 0x1700
#define GL_PROJECTION 0x1701
#define GL_TEXTURE 0x1702
#define GL_MODELVIEW_STACK_DEPTH 0x0BA3
#define GL_PROJECTION_STACK_DEPTH 0x0BA4
#define GL_TEXTURE_STACK_DEPTH 0x0BA5
#define GL_MODELVIEW_MATRIX 0x0BA6
#define GL_PROJECTION_MATRIX 0x0BA7
#define GL_TEXTURE_MATRIX 0x0BA8
#define GL_TRANSPOSE_MODELVIEW_MATRIX 0x84E3
#define GL_TRANSPOSE_PROJECTION_MATRIX 0x84E4
#define GL_TRANSPOSE_TEXTURE_MATRIX 0x84E5
#define GL_MAX_MODELVIEW_STACK_DEPTH 0x0D36
#define GL_MAX_PROJECTION_STACK_DEPTH 0x0D38
#define GL_MAX_TEXTURE_STACK_DEPTH 0x0D39
#define GL_VIEWPORT 0x0BA2
#define GL_MAX_VIEWPORT_DIMS 0x0D3A
#define GL_DEPTH_RANGE 0x0B70
#define GL_SUBPIXEL_BITS 0x0D50
#define GL_S 0x2000
#define GL_T 0x2001
#define GL_R 0x2002
#define GL_Q 0x2003
#define GL_TEXTURE_GEN_S 0x0C60
#define GL_TEXTURE_GEN_T 0x0C61
#define GL_TEXTURE_GEN_R 0x0C62
#define GL_TEXTURE_GEN_Q 0x0C63
#define GL_TEXTURE_GEN_MODE 0x2500
#define GL_OBJECT_PLANE 0x2501
#define GL_EYE_PLANE 0x2502
#define GL_EYE_LINEAR 0x2400
#define GL_OBJECT_LINEAR 0x2401
#define GL_SPHERE_MAP 0x2402
#define GL_NORMAL_MAP 0x8511
#define GL_REFLECTION_MAP 0x8512
#define GL_CLIP_PLANE0 0x3000
#define GL_CLIP_PLANE1 0x3001
#define GL_CLIP_PLANE2 0x3002
#define GL_CLIP_PLANE3 0x3003
#define GL_CLIP_PLANE4 0x3004
#define GL_CLIP_PLANE5 0x3005
#define GL_MAX_CLIP_PLANES 0x0D32
#define GL_NORMALIZE 0x0BA1
#define GL_RESCALE_NORMAL 0x803A
/* Selects the matrix stack that matrix commands change (GL 1.3, 2.10). mode: GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE. */
GLAPI void GLAPIENTRY glMatrixMode(GLenum mode);
/* Makes the current matrix the identity (GL 1.3, 2.10). */
GLAPI void GLAPIENTRY glLoadIdentity(void);
/* Replaces the current matrix by sixteen numbers, column by column (GL 1.3, 2.10). */
GLAPI void GLAPIENTRY glLoadMatrixf(const GLfloat* m);
GLAPI void GLAPIENTRY glLoadMatrixd(const GLdouble* m);
GLAPI void GLAPIENTRY glLoadMatrixxOES(const GLfixed* m);
/* Multiplies the current matrix from the right by sixteen numbers, column by column (GL 1.3, 2.10). */
GLAPI void GLAPIENTRY glMultMatrixf(const GLfloat* m);
GLAPI void GLAPIENTRY glMultMatrixd(const GLdouble* m);
GLAPI void GLAPIENTRY glMultMatrixxOES(const GLfixed* m);
/* Replaces the current matrix by sixteen numbers, row by row (GL 1.3, 2.10.2). */
GLAPI void GLAPIENTRY glLoadTransposeMatrixf(const GLfloat* m);
GLAPI void GLAPIENTRY glLoadTransposeMatrixd(const GLdouble* m);
GLAPI void GLAPIENTRY glLoadTransposeMatrixxOES(const GLfixed* m);
/* Multiplies the current matrix from the right by sixteen numbers, row by row (GL 1.3, 2.10.2). */
GLAPI void GLAPIENTRY glMultTransposeMatrixf(const GLfloat* m);
GLAPI void GLAPIENTRY glMultTransposeMatrixd(const GLdouble* m);
GLAPI void GLAPIENTRY glMultTransposeMatrixxOES(const GLfixed* m);
/* Pushes a copy of the current matrix (GL 1.3, 2.10). */
GLAPI void GLAPIENTRY glPushMatrix(void);
/* Pops the current matrix (GL 1.3, 2.10). */
GLAPI void GLAPIENTRY glPopMatrix(void);
/* Multiplies the current matrix by a rotation by angle degrees about (x, y, z) (GL 1.3, 2.10). */
GLAPI void GLAPIENTRY glRotatef(GLfloat angle, GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glRotated(GLdouble angle, GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glRotatexOES(GLfixed angle, GLfixed x, GLfixed y, GLfixed z);
/* Multiplies the current matrix by a translation (GL 1.3, 2.10). */
GLAPI void GLAPIENTRY glTranslatef(GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glTranslated(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glTranslatexOES(GLfixed x, GLfixed y, GLfixed z);
/* Multiplies the current matrix by a scaling along the axes (GL 1.3, 2.10). */
GLAPI void GLAPIENTRY glScalef(GLfloat x, GLfloat y, GLfloat z);
GLAPI void GLAPIENTRY glScaled(GLdouble x, GLdouble y, GLdouble z);
GLAPI void GLAPIENTRY glScalexOES(GLfixed x, GLfixed y, GLfixed z);
/* Multiplies the current matrix by a perspective projection; near and far planes have positive distances (GL 1.3, 2.10). */
GLAPI void GLAPIENTRY glFrustum(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble near_val, GLdouble far_val);
GLAPI void GLAPIENTRY glFrustumxOES(GLfixed left, GLfixed right, GLfixed bottom, GLfixed top, GLfixed near_val, GLfixed far_val);
/* Multiplies the current matrix by a parallel projection (GL 1.3, 2.10). */
GLAPI void GLAPIENTRY glOrtho(GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble near_val, GLdouble far_val);
GLAPI void GLAPIENTRY glOrthoxOES(GLfixed left, GLfixed right, GLfixed bottom, GLfixed top, GLfixed near_val, GLfixed far_val);
/* Sets the rectangle of the window, in pixels from its lower left corner, to which the view volume is mapped (GL 1.3, 2.10.1). */
GLAPI void GLAPIENTRY glViewport(GLint x, GLint y, GLsizei width, GLsizei height);
/* Sets the depths to which the near and the far plane are mapped, clamped to [0, 1] (GL 1.3, 2.10.1). */
GLAPI void GLAPIENTRY glDepthRange(GLclampd near_val, GLclampd far_val);
GLAPI void GLAPIENTRY glDepthRangef(GLclampf near_val, GLclampf far_val);
GLAPI void GLAPIENTRY glDepthRangexOES(GLclampx near_val, GLclampx far_val);
/* Sets a clip plane by four coefficients in object space; what lies on its positive side stays (GL 1.3, 2.11). plane: GL_CLIP_PLANE0,
   GL_CLIP_PLANE1, GL_CLIP_PLANE2, GL_CLIP_PLANE3, GL_CLIP_PLANE4, GL_CLIP_PLANE5. Optional system: CLIP_PLANES. */
GLAPI void GLAPIENTRY glClipPlane(GLenum plane, const GLdouble* equation);
GLAPI void GLAPIENTRY glClipPlanefOES(GLenum plane, const GLfloat* equation);
GLAPI void GLAPIENTRY glClipPlanexOES(GLenum plane, const GLfixed* equation);
/* Sets how a texture coordinate is generated (GL 1.3, 2.10.4). coord: GL_S, GL_T, GL_R, GL_Q. pname: GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE,
   GL_EYE_PLANE. Optional system: TEXGEN. */
GLAPI void GLAPIENTRY glTexGenf(GLenum coord, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glTexGenfv(GLenum coord, GLenum pname, const GLfloat* params);
GLAPI void GLAPIENTRY glTexGeni(GLenum coord, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glTexGeniv(GLenum coord, GLenum pname, const GLint* params);
GLAPI void GLAPIENTRY glTexGend(GLenum coord, GLenum pname, GLdouble param);
GLAPI void GLAPIENTRY glTexGendv(GLenum coord, GLenum pname, const GLdouble* params);
GLAPI void GLAPIENTRY glTexGenxOES(GLenum coord, GLenum pname, GLfixed param);
GLAPI void GLAPIENTRY glTexGenxvOES(GLenum coord, GLenum pname, const GLfixed* params);
/* Writes how a texture coordinate is generated to params (GL 1.3, 6.1.3). coord: GL_S, GL_T, GL_R, GL_Q. pname: GL_TEXTURE_GEN_MODE,
   GL_OBJECT_PLANE, GL_EYE_PLANE. Not compiled into display lists. Optional system: TEXGEN. */
GLAPI void GLAPIENTRY glGetTexGenfv(GLenum coord, GLenum pname, GLfloat* params);
GLAPI void GLAPIENTRY glGetTexGeniv(GLenum coord, GLenum pname, GLint* params);
GLAPI void GLAPIENTRY glGetTexGendv(GLenum coord, GLenum pname, GLdouble* params);
GLAPI void GLAPIENTRY glGetTexGenxvOES(GLenum coord, GLenum pname, GLfixed* params);
/* Writes the four coefficients of a clip plane in eye space to the array (GL 1.3, 6.1.3). plane: GL_CLIP_PLANE0, GL_CLIP_PLANE1,
   GL_CLIP_PLANE2, GL_CLIP_PLANE3, GL_CLIP_PLANE4, GL_CLIP_PLANE5. Not compiled into display lists. Optional system: CLIP_PLANES. */
GLAPI void GLAPIENTRY glGetClipPlane(GLenum plane, GLdouble* equation);

/* Lighting, shading, facing, sizes (GL 1.3, 2.13, 3.3 to 3.5) */
#define GL_FRONT 0x0404
#define GL_BACK 0x0405
#define GL_FRONT_AND_BACK 0x0408
#define GL_CW 0x0900
#define GL_CCW 0x0901
#define GL_CULL_FACE 0x0B44
#define GL_CULL_FACE_MODE 0x0B45
#define GL_FRONT_FACE 0x0B46
#define GL_LIGHTING 0x0B50
#define GL_LIGHT_MODEL_LOCAL_VIEWER 0x0B51
#define GL_LIGHT_MODEL_TWO_SIDE 0x0B52
#define GL_LIGHT_MODEL_AMBIENT 0x0B53
#define GL_SHADE_MODEL 0x0B54
#define GL_COLOR_MATERIAL_FACE 0x0B55
#define GL_COLOR_MATERIAL_PARAMETER 0x0B56
#define GL_COLOR_MATERIAL 0x0B57
#define GL_LIGHT_MODEL_COLOR_CONTROL 0x81F8
#define GL_SINGLE_COLOR 0x81F9
#define GL_SEPARATE_SPECULAR_COLOR 0x81FA
#define GL_MAX_LIGHTS 0x0D31
#define GL_AMBIENT 0x1200
#define GL_DIFFUSE 0x1201
#define GL_SPECULAR 0x1202
#define GL_POSITION 0x1203
#define GL_SPOT_DIRECTION 0x1204
#define GL_SPOT_EXPONENT 0x1205
#define GL_SPOT_CUTOFF 0x1206
#define GL_CONSTANT_ATTENUATION 0x1207
#define GL_LINEAR_ATTENUATION 0x1208
#define GL_QUADRATIC_ATTENUATION 0x1209
#define GL_EMISSION 0x1600
#define GL_SHININESS 0x1601
#define GL_AMBIENT_AND_DIFFUSE 0x1602
#define GL_COLOR_INDEXES 0x1603
#define GL_POLYGON_MODE 0x0B40
#define GL_POINT 0x1B00
#define GL_LINE 0x1B01
#define GL_FILL 0x1B02
#define GL_FLAT 0x1D00
#define GL_SMOOTH 0x1D01
#define GL_LIGHT0 0x4000
#define GL_LIGHT1 0x4001
#define GL_LIGHT2 0x4002
#define GL_LIGHT3 0x4003
#define GL_LIGHT4 0x4004
#define GL_LIGHT5 0x4005
#define GL_LIGHT6 0x4006
#define GL_LIGHT7 0x4007
#define GL_POINT_SIZE_MIN 0x8126
#define GL_POINT_SIZE_MAX 0x8127
#define GL_POINT_FADE_THRESHOLD_SIZE 0x8128
#define GL_POINT_DISTANCE_ATTENUATION 0x8129
#define GL_POINT_SPRITE 0x8861
#define GL_COORD_REPLACE 0x8862
#define GL_POINT_SPRITE_COORD_ORIGIN 0x8CA0
#define GL_LOWER_LEFT 0x8CA1
#define GL_UPPER_LEFT 0x8CA2
#define GL_POINT_SIZE 0x0B11
#define GL_POINT_SIZE_RANGE 0x0B12
#define GL_POINT_SIZE_GRANULARITY 0x0B13
#define GL_SMOOTH_POINT_SIZE_RANGE 0x0B12
#define GL_SMOOTH_POINT_SIZE_GRANULARITY 0x0B13
#define GL_SMOOTH_LINE_WIDTH_RANGE 0x0B22
#define GL_SMOOTH_LINE_WIDTH_GRANULARITY 0x0B23
#define GL_LINE_WIDTH 0x0B21
#define GL_LINE_WIDTH_RANGE 0x0B22
#define GL_LINE_WIDTH_GRANULARITY 0x0B23
#define GL_POINT_SMOOTH 0x0B10
#define GL_LINE_SMOOTH 0x0B20
#define GL_POLYGON_SMOOTH 0x0B41
#define GL_LINE_STIPPLE 0x0B24
#define GL_LINE_STIPPLE_PATTERN 0x0B25
#define GL_LINE_STIPPLE_REPEAT 0x0B26
#define GL_POLYGON_STIPPLE 0x0B42
#define GL_POLYGON_OFFSET_UNITS 0x2A00
#define GL_POLYGON_OFFSET_POINT 0x2A01
#define GL_POLYGON_OFFSET_LINE 0x2A02
#define GL_POLYGON_OFFSET_FILL 0x8037
#define GL_POLYGON_OFFSET_FACTOR 0x8038
#define GL_ALIASED_POINT_SIZE_RANGE 0x846D
#define GL_ALIASED_LINE_WIDTH_RANGE 0x846E
/* Sets a parameter of a light; positions and directions are transformed by the modelview matrix at once (GL 1.3, 2.13.1). light: GL_LIGHT0,
   GL_LIGHT1, GL_LIGHT2, GL_LIGHT3, GL_LIGHT4, GL_LIGHT5, GL_LIGHT6, GL_LIGHT7. pname: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION,
   GL_SPOT_DIRECTION, GL_SPOT_EXPONENT, GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION. Optional
   system: LIGHTING. */
GLAPI void GLAPIENTRY glLightf(GLenum light, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glLightfv(GLenum light, GLenum pname, const GLfloat* params);
GLAPI void GLAPIENTRY glLighti(GLenum light, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glLightiv(GLenum light, GLenum pname, const GLint* params);
GLAPI void GLAPIENTRY glLightxOES(GLenum light, GLenum pname, GLfixed param);
GLAPI void GLAPIENTRY glLightxvOES(GLenum light, GLenum pname, const GLfixed* params);
/* Writes a parameter of a light to params (GL 1.3, 6.1.3). light: GL_LIGHT0, GL_LIGHT1, GL_LIGHT2, GL_LIGHT3, GL_LIGHT4, GL_LIGHT5,
   GL_LIGHT6, GL_LIGHT7. pname: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION, GL_SPOT_EXPONENT, GL_SPOT_CUTOFF,
   GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION. Not compiled into display lists. Optional system: LIGHTING. */
GLAPI void GLAPIENTRY glGetLightfv(GLenum light, GLenum pname, GLfloat* params);
GLAPI void GLAPIENTRY glGetLightiv(GLenum light, GLenum pname, GLint* params);
GLAPI void GLAPIENTRY glGetLightxvOES(GLenum light, GLenum pname, GLfixed* params);
/* Sets a parameter of the lighting model (GL 1.3, 2.13.2). pname: GL_LIGHT_MODEL_AMBIENT, GL_LIGHT_MODEL_LOCAL_VIEWER,
   GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_COLOR_CONTROL. Optional system: LIGHTING. */
GLAPI void GLAPIENTRY glLightModelf(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glLightModelfv(GLenum pname, const GLfloat* params);
GLAPI void GLAPIENTRY glLightModeli(GLenum pname, GLint param);
GLAPI void GLAPIENTRY glLightModeliv(GLenum pname, const GLint* params);
GLAPI void GLAPIENTRY glLightModelxOES(GLenum pname, GLfixed param);
GLAPI void GLAPIENTRY glLightModelxvOES(GLenum pname, const GLfixed* params);
/* Sets a parameter of the material of one face or both (GL 1.3, 2.13.2). face: GL_FRONT, GL_BACK, GL_FRONT_AND_BACK. pname: GL_AMBIENT,
   GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_AMBIENT_AND_DIFFUSE, GL_COLOR_INDEXES. Also between glBegin and glEnd. Optional
   system: LIGHTING. */
GLAPI void GLAPIENTRY glMaterialf(GLenum face, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glMaterialfv(GLenum face, GLenum pname, const GLfloat* params);
GLAPI void GLAPIENTRY glMateriali(GLenum face, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glMaterialiv(GLenum face, GLenum pname, const GLint* params);
GLAPI void GLAPIENTRY glMaterialxOES(GLenum face, GLenum pname, GLfixed param);
GLAPI void GLAPIENTRY glMaterialxvOES(GLenum face, GLenum pname, const GLfixed* params);
/* Writes a parameter of a face's material to params (GL 1.3, 6.1.3). face: GL_FRONT, GL_BACK. pname: GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR,
   GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES. Not compiled into display lists. Optional system: LIGHTING. */
GLAPI void GLAPIENTRY glGetMaterialfv(GLenum face, GLenum pname, GLfloat* params);
GLAPI void GLAPIENTRY glGetMaterialiv(GLenum face, GLenum pname, GLint* params);
GLAPI void GLAPIENTRY glGetMaterialxvOES(GLenum face, GLenum pname, GLfixed* params);
/* Selects the parameters of the material that follow the current colour where GL_COLOR_MATERIAL is on (GL 1.3, 2.13.3). face: GL_FRONT,
   GL_BACK, GL_FRONT_AND_BACK. mode: GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE. Optional system: LIGHTING. */
GLAPI void GLAPIENTRY glColorMaterial(GLenum face, GLenum mode);
/* Selects whether colours are interpolated or those of the provoking vertex (GL 1.3, 2.13.7). mode: GL_FLAT, GL_SMOOTH. */
GLAPI void GLAPIENTRY glShadeModel(GLenum mode);
/* Selects the order of vertices, in the window, that makes a polygon a front face (GL 1.3, 3.5.1). mode: GL_CW, GL_CCW. */
GLAPI void GLAPIENTRY glFrontFace(GLenum mode);
/* Selects the faces that are not drawn where GL_CULL_FACE is on (GL 1.3, 3.5.1). mode: GL_FRONT, GL_BACK, GL_FRONT_AND_BACK. */
GLAPI void GLAPIENTRY glCullFace(GLenum mode);
/* Selects whether polygons of a face are filled or drawn as lines or points (GL 1.3, 3.5.4). face: GL_FRONT, GL_BACK, GL_FRONT_AND_BACK.
   mode: GL_POINT, GL_LINE, GL_FILL. Optional system: POLYGON_MODE. */
GLAPI void GLAPIENTRY glPolygonMode(GLenum face, GLenum mode);
/* Sets the diameter of points, in pixels (GL 1.3, 3.3). */
GLAPI void GLAPIENTRY glPointSize(GLfloat size);
GLAPI void GLAPIENTRY glPointSizexOES(GLfixed size);
/* Sets how points shrink with the distance (GL 1.4, 3.3). pname: GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE,
   GL_POINT_DISTANCE_ATTENUATION, GL_POINT_SPRITE_COORD_ORIGIN. Optional system: POINT_PARAMETERS. */
GLAPI void GLAPIENTRY glPointParameterf(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glPointParameterfv(GLenum pname, const GLfloat* params);
GLAPI void GLAPIENTRY glPointParameteri(GLenum pname, GLint param);
GLAPI void GLAPIENTRY glPointParameteriv(GLenum pname, const GLint* params);
GLAPI void GLAPIENTRY glPointParameterxOES(GLenum pname, GLfixed param);
GLAPI void GLAPIENTRY glPointParameterxvOES(GLenum pname, const GLfixed* params);
/* Sets the width of lines, in pixels (GL 1.3, 3.4). */
GLAPI void GLAPIENTRY glLineWidth(GLfloat width);
GLAPI void GLAPIENTRY glLineWidthxOES(GLfixed width);
/* Sets which of 16 repeated pieces of a line are drawn, each factor pixels long (GL 1.3, 3.4.2). Optional system: STIPPLE. */
GLAPI void GLAPIENTRY glLineStipple(GLint factor, GLushort pattern);
/* Sets which pixels of polygons are drawn: a bitmap of 32 x 32 (GL 1.3, 3.5.2). Optional system: STIPPLE. */
GLAPI void GLAPIENTRY glPolygonStipple(const GLubyte* pattern);
/* Writes the polygon stipple to mask (GL 1.3, 3.5.2). Not compiled into display lists. Optional system: STIPPLE. */
GLAPI void GLAPIENTRY glGetPolygonStipple(GLubyte* pattern);
/* Sets the offset of polygons' depths: factor times the largest slope, and units steps (GL 1.3, 3.5.5). Optional system: POLYGON_OFFSET. */
GLAPI void GLAPIENTRY glPolygonOffset(GLfloat factor, GLfloat units);
GLAPI void GLAPIENTRY glPolygonOffsetxOES(GLfixed factor, GLfixed units);

/* Fragments, framebuffer, pixels, fog, hints (GL 1.3, 3.6, 3.10, 4, 5.5, 5.6) */
#define GL_NONE 0
#define GL_ZERO 0
#define GL_ONE 1
#define GL_CONSTANT_COLOR 0x8001
#define GL_ONE_MINUS_CONSTANT_COLOR 0x8002
#define GL_CONSTANT_ALPHA 0x8003
#define GL_ONE_MINUS_CONSTANT_ALPHA 0x8004
#define GL_BLEND_COLOR 0x8005
#define GL_FUNC_ADD 0x8006
#define GL_MIN 0x8007
#define GL_MAX 0x8008
#define GL_BLEND_EQUATION 0x8009
#define GL_BLEND_EQUATION_RGB 0x8009
#define GL_FUNC_SUBTRACT 0x800A
#define GL_FUNC_REVERSE_SUBTRACT 0x800B
#define GL_BLEND_DST_RGB 0x80C8
#define GL_BLEND_SRC_RGB 0x80C9
#define GL_BLEND_DST_ALPHA 0x80CA
#define GL_BLEND_SRC_ALPHA 0x80CB
#define GL_BLEND_EQUATION_ALPHA 0x883D
#define GL_CLEAR 0x1500
#define GL_AND 0x1501
#define GL_AND_REVERSE 0x1502
#define GL_COPY 0x1503
#define GL_AND_INVERTED 0x1504
#define GL_NOOP 0x1505
#define GL_XOR 0x1506
#define GL_OR 0x1507
#define GL_NOR 0x1508
#define GL_EQUIV 0x1509
#define GL_OR_REVERSE 0x150B
#define GL_COPY_INVERTED 0x150C
#define GL_OR_INVERTED 0x150D
#define GL_NAND 0x150E
#define GL_SET 0x150F
#define GL_ACCUM 0x0100
#define GL_LOAD 0x0101
#define GL_RETURN 0x0102
#define GL_MULT 0x0103
#define GL_ADD 0x0104
#define GL_ACCUM_CLEAR_VALUE 0x0B80
#define GL_QUERY_COUNTER_BITS 0x8864
#define GL_CURRENT_QUERY 0x8865
#define GL_QUERY_RESULT 0x8866
#define GL_QUERY_RESULT_AVAILABLE 0x8867
#define GL_SAMPLES_PASSED 0x8914
#define GL_INDEX_CLEAR_VALUE 0x0C20
#define GL_INDEX_WRITEMASK 0x0C21
#define GL_LOGIC_OP_MODE 0x0BF0
#define GL_LOGIC_OP 0x0BF1
#define GL_INDEX_LOGIC_OP 0x0BF1
#define GL_COLOR_LOGIC_OP 0x0BF2
#define GL_INCR_WRAP 0x8507
#define GL_DECR_WRAP 0x8508
#define GL_STENCIL_BACK_FUNC 0x8800
#define GL_STENCIL_BACK_FAIL 0x8801
#define GL_STENCIL_BACK_PASS_DEPTH_FAIL 0x8802
#define GL_STENCIL_BACK_PASS_DEPTH_PASS 0x8803
#define GL_STENCIL_BACK_REF 0x8CA3
#define GL_STENCIL_BACK_VALUE_MASK 0x8CA4
#define GL_STENCIL_BACK_WRITEMASK 0x8CA5
#define GL_NEVER 0x0200
#define GL_LESS 0x0201
#define GL_EQUAL 0x0202
#define GL_LEQUAL 0x0203
#define GL_GREATER 0x0204
#define GL_NOTEQUAL 0x0205
#define GL_GEQUAL 0x0206
#define GL_ALWAYS 0x0207
#define GL_SRC_COLOR 0x0300
#define GL_ONE_MINUS_SRC_COLOR 0x0301
#define GL_SRC_ALPHA 0x0302
#define GL_ONE_MINUS_SRC_ALPHA 0x0303
#define GL_DST_ALPHA 0x0304
#define GL_ONE_MINUS_DST_ALPHA 0x0305
#define GL_DST_COLOR 0x0306
#define GL_ONE_MINUS_DST_COLOR 0x0307
#define GL_SRC_ALPHA_SATURATE 0x0308
#define GL_FRONT_LEFT 0x0400
#define GL_FRONT_RIGHT 0x0401
#define GL_BACK_LEFT 0x0402
#define GL_BACK_RIGHT 0x0403
#define GL_LEFT 0x0406
#define GL_RIGHT 0x0407
#define GL_AUX0 0x0409
#define GL_DRAW_BUFFER 0x0C01
#define GL_READ_BUFFER 0x0C02
#define GL_AUX_BUFFERS 0x0C00
#define GL_DOUBLEBUFFER 0x0C32
#define GL_STEREO 0x0C33
#define GL_RGBA_MODE 0x0C31
#define GL_INDEX_MODE 0x0C30
#define GL_INDEX_BITS 0x0D51
#define GL_RED_BITS 0x0D52
#define GL_GREEN_BITS 0x0D53
#define GL_BLUE_BITS 0x0D54
#define GL_ALPHA_BITS 0x0D55
#define GL_DEPTH_BITS 0x0D56
#define GL_STENCIL_BITS 0x0D57
#define GL_ACCUM_RED_BITS 0x0D58
#define GL_ACCUM_GREEN_BITS 0x0D59
#define GL_ACCUM_BLUE_BITS 0x0D5A
#define GL_ACCUM_ALPHA_BITS 0x0D5B
#define GL_MULTISAMPLE 0x809D
#define GL_SAMPLE_ALPHA_TO_COVERAGE 0x809E
#define GL_SAMPLE_ALPHA_TO_ONE 0x809F
#define GL_SAMPLE_COVERAGE 0x80A0
#define GL_SAMPLE_BUFFERS 0x80A8
#define GL_SAMPLES 0x80A9
#define GL_SAMPLE_COVERAGE_VALUE 0x80AA
#define GL_SAMPLE_COVERAGE_INVERT 0x80AB
#define GL_KEEP 0x1E00
#define GL_INCR 0x1E02
#define GL_DECR 0x1E03
#define GL_INVERT 0x150A
#define GL_SCISSOR_BOX 0x0C10
#define GL_SCISSOR_TEST 0x0C11
#define GL_ALPHA_TEST 0x0BC0
#define GL_ALPHA_TEST_FUNC 0x0BC1
#define GL_ALPHA_TEST_REF 0x0BC2
#define GL_STENCIL_TEST 0x0B90
#define GL_STENCIL_CLEAR_VALUE 0x0B91
#define GL_STENCIL_FUNC 0x0B92
#define GL_STENCIL_VALUE_MASK 0x0B93
#define GL_STENCIL_FAIL 0x0B94
#define GL_STENCIL_PASS_DEPTH_FAIL 0x0B95
#define GL_STENCIL_PASS_DEPTH_PASS 0x0B96
#define GL_STENCIL_REF 0x0B97
#define GL_STENCIL_WRITEMASK 0x0B98
#define GL_DEPTH_TEST 0x0B71
#define GL_DEPTH_WRITEMASK 0x0B72
#define GL_DEPTH_CLEAR_VALUE 0x0B73
#define GL_DEPTH_FUNC 0x0B74
#define GL_BLEND 0x0BE2
#define GL_BLEND_SRC 0x0BE1
#define GL_BLEND_DST 0x0BE0
#define GL_DITHER 0x0BD0
#define GL_COLOR_CLEAR_VALUE 0x0C22
#define GL_COLOR_WRITEMASK 0x0C23
#define GL_DEPTH_BUFFER_BIT 0x0100
#define GL_ACCUM_BUFFER_BIT 0x0200
#define GL_STENCIL_BUFFER_BIT 0x0400
#define GL_COLOR_BUFFER_BIT 0x4000
#define GL_COLOR 0x1800
#define GL_DEPTH 0x1801
#define GL_STENCIL 0x1802
#define GL_COLOR_INDEX 0x1900
#define GL_STENCIL_INDEX 0x1901
#define GL_DEPTH_COMPONENT 0x1902
#define GL_BITMAP 0x1A00
#define GL_UNPACK_SWAP_BYTES 0x0CF0
#define GL_UNPACK_LSB_FIRST 0x0CF1
#define GL_UNPACK_ROW_LENGTH 0x0CF2
#define GL_UNPACK_SKIP_ROWS 0x0CF3
#define GL_UNPACK_SKIP_PIXELS 0x0CF4
#define GL_UNPACK_ALIGNMENT 0x0CF5
#define GL_PACK_SWAP_BYTES 0x0D00
#define GL_PACK_LSB_FIRST 0x0D01
#define GL_PACK_ROW_LENGTH 0x0D02
#define GL_PACK_SKIP_ROWS 0x0D03
#define GL_PACK_SKIP_PIXELS 0x0D04
#define GL_PACK_ALIGNMENT 0x0D05
#define GL_PACK_SKIP_IMAGES 0x806B
#define GL_PACK_IMAGE_HEIGHT 0x806C
#define GL_UNPACK_SKIP_IMAGES 0x806D
#define GL_UNPACK_IMAGE_HEIGHT 0x806E
#define GL_PIXEL_MAP_I_TO_I 0x0C70
#define GL_PIXEL_MAP_S_TO_S 0x0C71
#define GL_PIXEL_MAP_I_TO_R 0x0C72
#define GL_PIXEL_MAP_I_TO_G 0x0C73
#define GL_PIXEL_MAP_I_TO_B 0x0C74
#define GL_PIXEL_MAP_I_TO_A 0x0C75
#define GL_PIXEL_MAP_R_TO_R 0x0C76
#define GL_PIXEL_MAP_G_TO_G 0x0C77
#define GL_PIXEL_MAP_B_TO_B 0x0C78
#define GL_PIXEL_MAP_A_TO_A 0x0C79
#define GL_PIXEL_MAP_I_TO_I_SIZE 0x0CB0
#define GL_PIXEL_MAP_S_TO_S_SIZE 0x0CB1
#define GL_PIXEL_MAP_I_TO_R_SIZE 0x0CB2
#define GL_PIXEL_MAP_I_TO_G_SIZE 0x0CB3
#define GL_PIXEL_MAP_I_TO_B_SIZE 0x0CB4
#define GL_PIXEL_MAP_I_TO_A_SIZE 0x0CB5
#define GL_PIXEL_MAP_R_TO_R_SIZE 0x0CB6
#define GL_PIXEL_MAP_G_TO_G_SIZE 0x0CB7
#define GL_PIXEL_MAP_B_TO_B_SIZE 0x0CB8
#define GL_PIXEL_MAP_A_TO_A_SIZE 0x0CB9
#define GL_MAP_COLOR 0x0D10
#define GL_MAP_STENCIL 0x0D11
#define GL_INDEX_SHIFT 0x0D12
#define GL_INDEX_OFFSET 0x0D13
#define GL_RED_SCALE 0x0D14
#define GL_RED_BIAS 0x0D15
#define GL_ZOOM_X 0x0D16
#define GL_ZOOM_Y 0x0D17
#define GL_GREEN_SCALE 0x0D18
#define GL_GREEN_BIAS 0x0D19
#define GL_BLUE_SCALE 0x0D1A
#define GL_BLUE_BIAS 0x0D1B
#define GL_ALPHA_SCALE 0x0D1C
#define GL_ALPHA_BIAS 0x0D1D
#define GL_DEPTH_SCALE 0x0D1E
#define GL_DEPTH_BIAS 0x0D1F
#define GL_MAX_PIXEL_MAP_TABLE 0x0D34
#define GL_FOG 0x0B60
#define GL_FOG_DENSITY 0x0B62
#define GL_FOG_START 0x0B63
#define GL_FOG_END 0x0B64
#define GL_FOG_MODE 0x0B65
#define GL_FOG_COLOR 0x0B66
#define GL_FOG_INDEX 0x0B61
#define GL_FOG_COORDINATE_SOURCE 0x8450
#define GL_FOG_COORDINATE 0x8451
#define GL_FRAGMENT_DEPTH 0x8452
#define GL_FOG_COORD_SRC 0x8450
#define GL_FOG_COORD 0x8451
#define GL_EXP 0x0800
#define GL_EXP2 0x0801
#define GL_PERSPECTIVE_CORRECTION_HINT 0x0C50
#define GL_POINT_SMOOTH_HINT 0x0C51
#define GL_LINE_SMOOTH_HINT 0x0C52
#define GL_POLYGON_SMOOTH_HINT 0x0C53
#define GL_FOG_HINT 0x0C54
#define GL_TEXTURE_COMPRESSION_HINT 0x84EF
#define GL_GENERATE_MIPMAP_HINT 0x8192
#define GL_DONT_CARE 0x1100
#define GL_FASTEST 0x1101
#define GL_NICEST 0x1102
/* Sets the rectangle of the window outside of which nothing is drawn where GL_SCISSOR_TEST is on (GL 1.3, 4.1.2). */
GLAPI void GLAPIENTRY glScissor(GLint x, GLint y, GLsizei width, GLsizei height);
/* Sets the comparison of the alpha test; ref is clamped to [0, 1] (GL 1.3, 4.1.4). func: GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL,
   GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS. */
GLAPI void GLAPIENTRY glAlphaFunc(GLenum func, GLclampf ref);
GLAPI void GLAPIENTRY glAlphaFuncxOES(GLenum func, GLclampx ref);
/* Sets comparison, reference value and mask of the stencil test (GL 1.3, 4.1.5). func: GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER,
   GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS. */
GLAPI void GLAPIENTRY glStencilFunc(GLenum func, GLint ref, GLuint mask);
/* Sets what happens to the stencil value where the stencil test fails, the depth test fails, and both pass (GL 1.3, 4.1.5). fail: GL_KEEP,
   GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP. zfail: GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR,
   GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP. zpass: GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP. */
GLAPI void GLAPIENTRY glStencilOp(GLenum fail, GLenum zfail, GLenum zpass);
/* Does what glStencilFunc does, for one face or both (GL 2.0, 4.1.4). face: GL_FRONT, GL_BACK, GL_FRONT_AND_BACK. func: GL_NEVER, GL_LESS,
   GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS. Optional system: STENCIL_SIDES. */
GLAPI void GLAPIENTRY glStencilFuncSeparate(GLenum face, GLenum func, GLint ref, GLuint mask);
/* Does what glStencilOp does, for one face or both (GL 2.0, 4.1.4). face: GL_FRONT, GL_BACK, GL_FRONT_AND_BACK. fail: GL_KEEP, GL_ZERO,
   GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP. zfail: GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT,
   GL_INCR_WRAP, GL_DECR_WRAP. zpass: GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP. Optional
   system: STENCIL_SIDES. */
GLAPI void GLAPIENTRY glStencilOpSeparate(GLenum face, GLenum fail, GLenum zfail, GLenum zpass);
/* Does what glStencilMask does, for one face or both (GL 2.0, 4.1.4). face: GL_FRONT, GL_BACK, GL_FRONT_AND_BACK. Optional system:
   STENCIL_SIDES. */
GLAPI void GLAPIENTRY glStencilMaskSeparate(GLenum face, GLuint mask);
/* Sets which samples of a pixel are drawn where GL_SAMPLE_COVERAGE is on (GL 1.3, 4.1.3). */
GLAPI void GLAPIENTRY glSampleCoverage(GLclampf value, GLboolean invert);
GLAPI void GLAPIENTRY glSampleCoveragexOES(GLclampx value, GLboolean invert);
/* Sets the comparison of the depth test (GL 1.3, 4.1.6). func: GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL,
   GL_ALWAYS. */
GLAPI void GLAPIENTRY glDepthFunc(GLenum func);
/* Sets what the fragment's colour and the stored one are multiplied with in blending (GL 1.3, 4.1.7). */
GLAPI void GLAPIENTRY glBlendFunc(GLenum sfactor, GLenum dfactor);
/* Does what glBlendFunc does, with factors of their own for alpha (GL 1.4, 4.1.7). */
GLAPI void GLAPIENTRY glBlendFuncSeparate(GLenum src_rgb, GLenum dst_rgb, GLenum src_alpha, GLenum dst_alpha);
/* Sets how the two products of blending are joined (GL 1.4, 4.1.7). mode: GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN,
   GL_MAX. */
GLAPI void GLAPIENTRY glBlendEquation(GLenum mode);
/* Does what glBlendEquation does, with one for alpha (GL 1.4, 4.1.7). rgb: GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN,
   GL_MAX. alpha: GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX. */
GLAPI void GLAPIENTRY glBlendEquationSeparate(GLenum rgb, GLenum alpha);
/* Sets the constant colour of blending, clamped to [0, 1] (GL 1.4, 4.1.7). */
GLAPI void GLAPIENTRY glBlendColor(GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha);
GLAPI void GLAPIENTRY glBlendColorxOES(GLclampx red, GLclampx green, GLclampx blue, GLclampx alpha);
/* Works on the accumulation buffer, all pixels inside the scissor box (GL 1.3, 4.2.4). op: GL_ACCUM, GL_LOAD, GL_RETURN, GL_MULT, GL_ADD.
   Optional system: ACCUM. */
GLAPI void GLAPIENTRY glAccum(GLenum op, GLfloat value);
GLAPI void GLAPIENTRY glAccumxOES(GLenum op, GLfixed value);
/* Sets the value to which glClear sets the accumulation buffer, clamped to [-1, 1] (GL 1.3, 4.2.3). Optional system: ACCUM. */
GLAPI void GLAPIENTRY glClearAccum(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
GLAPI void GLAPIENTRY glClearAccumxOES(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha);
/* Writes n unused names of queries to the array (GL 1.5, 4.1.7). Not compiled into display lists. Optional system: QUERIES. */
GLAPI void GLAPIENTRY glGenQueries(GLsizei n, GLuint* ids);
/* Deletes queries; unused names are ignored (GL 1.5, 4.1.7). Not compiled into display lists. Optional system: QUERIES. */
GLAPI void GLAPIENTRY glDeleteQueries(GLsizei n, const GLuint* ids);
/* Tells whether a name is that of a query (GL 1.5, 4.1.7). Optional system: QUERIES. */
GLAPI GLboolean GLAPIENTRY glIsQuery(GLuint id);
/* Begins to count the samples that pass (GL 1.5, 4.1.7). target: GL_SAMPLES_PASSED. Optional system: QUERIES. */
GLAPI void GLAPIENTRY glBeginQuery(GLenum target, GLuint id);
/* Ends the count (GL 1.5, 4.1.7). target: GL_SAMPLES_PASSED. Optional system: QUERIES. */
GLAPI void GLAPIENTRY glEndQuery(GLenum target);
/* Writes a parameter of a query target to params (GL 1.5, 4.1.7). target: GL_SAMPLES_PASSED. pname: GL_CURRENT_QUERY,
   GL_QUERY_COUNTER_BITS. Not compiled into display lists. Optional system: QUERIES. */
GLAPI void GLAPIENTRY glGetQueryiv(GLenum target, GLenum pname, GLint* params);
/* Writes the result of a query, or whether it is there, to params (GL 1.5, 4.1.7). pname: GL_QUERY_RESULT, GL_QUERY_RESULT_AVAILABLE. Not
   compiled into display lists. Optional system: QUERIES. */
GLAPI void GLAPIENTRY glGetQueryObjectiv(GLuint id, GLenum pname, GLint* params);
/* Writes the result of a query, or whether it is there, to params (GL 1.5, 4.1.7). pname: GL_QUERY_RESULT, GL_QUERY_RESULT_AVAILABLE. Not
   compiled into display lists. Optional system: QUERIES. */
GLAPI void GLAPIENTRY glGetQueryObjectuiv(GLuint id, GLenum pname, GLuint* params);
/* Selects the logical operation of fragments with stored pixels (GL 1.3, 4.1.9). */
GLAPI void GLAPIENTRY glLogicOp(GLenum opcode);
/* Selects the buffer that is drawn to (GL 1.3, 4.2.1). mode: GL_FRONT_LEFT, GL_FRONT_RIGHT, GL_BACK_LEFT, GL_BACK_RIGHT, GL_FRONT, GL_BACK,
   GL_LEFT, GL_RIGHT, GL_AUX0, GL_NONE, GL_FRONT_AND_BACK. */
GLAPI void GLAPIENTRY glDrawBuffer(GLenum mode);
/* Selects the buffer that pixels are read from (GL 1.3, 4.3.2). mode: GL_FRONT_LEFT, GL_FRONT_RIGHT, GL_BACK_LEFT, GL_BACK_RIGHT, GL_FRONT,
   GL_BACK, GL_LEFT, GL_RIGHT, GL_AUX0. */
GLAPI void GLAPIENTRY glReadBuffer(GLenum mode);
/* Says which components of colours are written (GL 1.3, 4.2.2). */
GLAPI void GLAPIENTRY glColorMask(GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha);
/* Says whether depths are written (GL 1.3, 4.2.2). */
GLAPI void GLAPIENTRY glDepthMask(GLboolean flag);
/* Says which bits of stencil values are written (GL 1.3, 4.2.2). */
GLAPI void GLAPIENTRY glStencilMask(GLuint mask);
/* Sets all pixels inside the scissor box to the clear values; mask has a bit for each buffer (GL 1.3, 4.2.3). mask: GL_COLOR_BUFFER_BIT,
   GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT, GL_ACCUM_BUFFER_BIT. */
GLAPI void GLAPIENTRY glClear(GLbitfield mask);
/* Sets the colour to which glClear sets the colour buffer, clamped to [0, 1] (GL 1.3, 4.2.3). */
GLAPI void GLAPIENTRY glClearColor(GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha);
GLAPI void GLAPIENTRY glClearColorxOES(GLclampx red, GLclampx green, GLclampx blue, GLclampx alpha);
/* Sets the index to which glClear sets a buffer of indices (GL 1.3, 4.2.3). Optional system: COLOR_INDEX. */
GLAPI void GLAPIENTRY glClearIndex(GLfloat index);
GLAPI void GLAPIENTRY glClearIndexxOES(GLfixed index);
/* Says which bits of colour indices are written (GL 1.3, 4.2.2). Optional system: COLOR_INDEX. */
GLAPI void GLAPIENTRY glIndexMask(GLuint mask);
/* Sets the depth to which glClear sets the depth buffer, clamped to [0, 1] (GL 1.3, 4.2.3). */
GLAPI void GLAPIENTRY glClearDepth(GLclampd depth);
GLAPI void GLAPIENTRY glClearDepthf(GLclampf depth);
GLAPI void GLAPIENTRY glClearDepthxOES(GLclampx depth);
/* Sets the value to which glClear sets the stencil buffer (GL 1.3, 4.2.3). */
GLAPI void GLAPIENTRY glClearStencil(GLint s);
/* Sets how images lie in client memory or in a bound buffer (GL 1.3, 3.6.1). Not compiled into display lists. */
GLAPI void GLAPIENTRY glPixelStoref(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glPixelStorei(GLenum pname, GLint param);
/* Sets how components change while images are transferred (GL 1.3, 3.6.3). Optional system: PIXEL_TRANSFER. */
GLAPI void GLAPIENTRY glPixelTransferf(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glPixelTransferi(GLenum pname, GLint param);
/* Sets a table by which components are looked up while images are transferred (GL 1.3, 3.6.3). map: GL_PIXEL_MAP_I_TO_I,
   GL_PIXEL_MAP_S_TO_S, GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_G, GL_PIXEL_MAP_I_TO_B, GL_PIXEL_MAP_I_TO_A, GL_PIXEL_MAP_R_TO_R,
   GL_PIXEL_MAP_G_TO_G, GL_PIXEL_MAP_B_TO_B, GL_PIXEL_MAP_A_TO_A. size: 1 to 256. Optional system: PIXEL_TRANSFER. */
GLAPI void GLAPIENTRY glPixelMapfv(GLenum map, GLsizei size, const GLfloat* values);
GLAPI void GLAPIENTRY glPixelMapuiv(GLenum map, GLsizei size, const GLuint* values);
GLAPI void GLAPIENTRY glPixelMapusv(GLenum map, GLsizei size, const GLushort* values);
/* Writes such a table to the array (GL 1.3, 3.6.3). map: GL_PIXEL_MAP_I_TO_I, GL_PIXEL_MAP_S_TO_S, GL_PIXEL_MAP_I_TO_R,
   GL_PIXEL_MAP_I_TO_G, GL_PIXEL_MAP_I_TO_B, GL_PIXEL_MAP_I_TO_A, GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_G_TO_G, GL_PIXEL_MAP_B_TO_B,
   GL_PIXEL_MAP_A_TO_A. Not compiled into display lists. Optional system: PIXEL_TRANSFER. */
GLAPI void GLAPIENTRY glGetPixelMapfv(GLenum map, GLfloat* values);
GLAPI void GLAPIENTRY glGetPixelMapuiv(GLenum map, GLuint* values);
GLAPI void GLAPIENTRY glGetPixelMapusv(GLenum map, GLushort* values);
/* Sets the size of an image's pixels in the window (GL 1.3, 3.6.4). Optional system: DRAW_PIXELS. */
GLAPI void GLAPIENTRY glPixelZoom(GLfloat xfactor, GLfloat yfactor);
/* Draws an image at the current raster position (GL 1.3, 3.6.4). Optional system: DRAW_PIXELS. */
GLAPI void GLAPIENTRY glDrawPixels(GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels);
/* Draws a copy of a rectangle of the window at the current raster position (GL 1.3, 4.3.3). type: GL_COLOR, GL_DEPTH, GL_STENCIL. Optional
   system: DRAW_PIXELS. */
GLAPI void GLAPIENTRY glCopyPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum type);
/* Draws a bitmap at the current raster position, and moves that (GL 1.3, 3.7). Optional system: BITMAPS. */
GLAPI void GLAPIENTRY glBitmap(GLsizei width, GLsizei height, GLfloat xorig, GLfloat yorig, GLfloat xmove, GLfloat ymove, const GLubyte* bitmap);
/* Reads a rectangle of the window into memory, row by row from the bottom (GL 1.3, 4.3.2). Not compiled into display lists. */
GLAPI void GLAPIENTRY glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* pixels);
/* Sets a parameter of fog (GL 1.3, 3.10). pname: GL_FOG_MODE, GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END, GL_FOG_COLOR, GL_FOG_INDEX,
   GL_FOG_COORDINATE_SOURCE. Optional system: FOG. */
GLAPI void GLAPIENTRY glFogf(GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glFogfv(GLenum pname, const GLfloat* params);
GLAPI void GLAPIENTRY glFogi(GLenum pname, GLint param);
GLAPI void GLAPIENTRY glFogiv(GLenum pname, const GLint* params);
GLAPI void GLAPIENTRY glFogxOES(GLenum pname, GLfixed param);
GLAPI void GLAPIENTRY glFogxvOES(GLenum pname, const GLfixed* params);
/* Asks for speed or quality; GL_PERSPECTIVE_CORRECTION_HINT and GL_FOG_HINT choose the [tier](docs/glossary.md#tier) (GL 1.3, 5.6). target:
   GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT,
   GL_TEXTURE_COMPRESSION_HINT, GL_GENERATE_MIPMAP_HINT. mode: GL_FASTEST, GL_NICEST, GL_DONT_CARE. */
GLAPI void GLAPIENTRY glHint(GLenum target, GLenum mode);
/* Says that commands so far are to be done in finite time (GL 1.3, 5.5). Not compiled into display lists. */
GLAPI void GLAPIENTRY glFlush(void);
/* Returns when all commands so far are done (GL 1.3, 5.5). Not compiled into display lists. */
GLAPI void GLAPIENTRY glFinish(void);

/* Textures (GL 1.3, 3.8) */
#define GL_TEXTURE_2D 0x0DE1
#define GL_PROXY_TEXTURE_2D 0x8064
#define GL_TEXTURE_BINDING_2D 0x8069
#define GL_MAX_TEXTURE_SIZE 0x0D33
#define GL_ACTIVE_TEXTURE 0x84E0
#define GL_MAX_TEXTURE_UNITS 0x84E2
#define GL_TEXTURE0 0x84C0
#define GL_TEXTURE1 0x84C1
#define GL_TEXTURE2 0x84C2
#define GL_TEXTURE3 0x84C3
#define GL_TEXTURE4 0x84C4
#define GL_TEXTURE5 0x84C5
#define GL_TEXTURE6 0x84C6
#define GL_TEXTURE7 0x84C7
#define GL_TEXTURE8 0x84C8
#define GL_TEXTURE9 0x84C9
#define GL_TEXTURE10 0x84CA
#define GL_TEXTURE11 0x84CB
#define GL_TEXTURE12 0x84CC
#define GL_TEXTURE13 0x84CD
#define GL_TEXTURE14 0x84CE
#define GL_TEXTURE15 0x84CF
#define GL_TEXTURE16 0x84D0
#define GL_TEXTURE17 0x84D1
#define GL_TEXTURE18 0x84D2
#define GL_TEXTURE19 0x84D3
#define GL_TEXTURE20 0x84D4
#define GL_TEXTURE21 0x84D5
#define GL_TEXTURE22 0x84D6
#define GL_TEXTURE23 0x84D7
#define GL_TEXTURE24 0x84D8
#define GL_TEXTURE25 0x84D9
#define GL_TEXTURE26 0x84DA
#define GL_TEXTURE27 0x84DB
#define GL_TEXTURE28 0x84DC
#define GL_TEXTURE29 0x84DD
#define GL_TEXTURE30 0x84DE
#define GL_TEXTURE31 0x84DF
#define GL_TEXTURE_WIDTH 0x1000
#define GL_TEXTURE_HEIGHT 0x1001
#define GL_TEXTURE_COMPONENTS 0x1003
#define GL_TEXTURE_INTERNAL_FORMAT 0x1003
#define GL_TEXTURE_BORDER_COLOR 0x1004
#define GL_TEXTURE_BORDER 0x1005
#define GL_TEXTURE_RED_SIZE 0x805C
#define GL_TEXTURE_GREEN_SIZE 0x805D
#define GL_TEXTURE_BLUE_SIZE 0x805E
#define GL_TEXTURE_ALPHA_SIZE 0x805F
#define GL_TEXTURE_LUMINANCE_SIZE 0x8060
#define GL_TEXTURE_INTENSITY_SIZE 0x8061
#define GL_TEXTURE_PRIORITY 0x8066
#define GL_TEXTURE_RESIDENT 0x8067
#define GL_TEXTURE_MIN_LOD 0x813A
#define GL_TEXTURE_MAX_LOD 0x813B
#define GL_TEXTURE_BASE_LEVEL 0x813C
#define GL_TEXTURE_MAX_LEVEL 0x813D
#define GL_TEXTURE_MAG_FILTER 0x2800
#define GL_TEXTURE_MIN_FILTER 0x2801
#define GL_TEXTURE_WRAP_S 0x2802
#define GL_TEXTURE_WRAP_T 0x2803
#define GL_NEAREST 0x2600
#define GL_LINEAR 0x2601
#define GL_NEAREST_MIPMAP_NEAREST 0x2700
#define GL_LINEAR_MIPMAP_NEAREST 0x2701
#define GL_NEAREST_MIPMAP_LINEAR 0x2702
#define GL_LINEAR_MIPMAP_LINEAR 0x2703
#define GL_CLAMP 0x2900
#define GL_REPEAT 0x2901
#define GL_CLAMP_TO_BORDER 0x812D
#define GL_CLAMP_TO_EDGE 0x812F
#define GL_TEXTURE_ENV 0x2300
#define GL_TEXTURE_ENV_MODE 0x2200
#define GL_TEXTURE_ENV_COLOR 0x2201
#define GL_MODULATE 0x2100
#define GL_TEXTURE_1D 0x0DE0
#define GL_PROXY_TEXTURE_1D 0x8063
#define GL_TEXTURE_3D 0x806F
#define GL_PROXY_TEXTURE_3D 0x8070
#define GL_TEXTURE_CUBE_MAP 0x8513
#define GL_PROXY_TEXTURE_CUBE_MAP 0x851B
#define GL_TEXTURE_BINDING_1D 0x8068
#define GL_TEXTURE_BINDING_3D 0x806A
#define GL_TEXTURE_BINDING_CUBE_MAP 0x8514
#define GL_MAX_3D_TEXTURE_SIZE 0x8073
#define GL_MAX_CUBE_MAP_TEXTURE_SIZE 0x851C
#define GL_NUM_COMPRESSED_TEXTURE_FORMATS 0x86A2
#define GL_COMPRESSED_TEXTURE_FORMATS 0x86A3
#define GL_TEXTURE_WRAP_R 0x8072
#define GL_MIRRORED_REPEAT 0x8370
#define GL_GENERATE_MIPMAP 0x8191
#define GL_DEPTH_TEXTURE_MODE 0x884B
#define GL_TEXTURE_COMPARE_MODE 0x884C
#define GL_TEXTURE_COMPARE_FUNC 0x884D
#define GL_COMPARE_R_TO_TEXTURE 0x884E
#define GL_TEXTURE_DEPTH 0x8071
#define GL_TEXTURE_DEPTH_SIZE 0x884A
#define GL_TEXTURE_COMPRESSED 0x86A1
#define GL_TEXTURE_COMPRESSED_IMAGE_SIZE 0x86A0
#define GL_DEPTH_COMPONENT16 0x81A5
#define GL_DEPTH_COMPONENT24 0x81A6
#define GL_DEPTH_COMPONENT32 0x81A7
#define GL_COMPRESSED_ALPHA 0x84E9
#define GL_COMPRESSED_LUMINANCE 0x84EA
#define GL_COMPRESSED_LUMINANCE_ALPHA 0x84EB
#define GL_COMPRESSED_INTENSITY 0x84EC
#define GL_COMPRESSED_RGB 0x84ED
#define GL_COMPRESSED_RGBA 0x84EE
#define GL_ETC1_RGB8_OES 0x8D64
#define GL_TEXTURE_CUBE_MAP_POSITIVE_X 0x8515
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_X 0x8516
#define GL_TEXTURE_CUBE_MAP_POSITIVE_Y 0x8517
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_Y 0x8518
#define GL_TEXTURE_CUBE_MAP_POSITIVE_Z 0x8519
#define GL_TEXTURE_CUBE_MAP_NEGATIVE_Z 0x851A
#define GL_PALETTE4_RGB8_OES 0x8B90
#define GL_PALETTE4_RGBA8_OES 0x8B91
#define GL_PALETTE4_R5_G6_B5_OES 0x8B92
#define GL_PALETTE4_RGBA4_OES 0x8B93
#define GL_PALETTE4_RGB5_A1_OES 0x8B94
#define GL_PALETTE8_RGB8_OES 0x8B95
#define GL_PALETTE8_RGBA8_OES 0x8B96
#define GL_PALETTE8_R5_G6_B5_OES 0x8B97
#define GL_PALETTE8_RGBA4_OES 0x8B98
#define GL_PALETTE8_RGB5_A1_OES 0x8B99
#define GL_TEXTURE_FILTER_CONTROL 0x8500
#define GL_TEXTURE_LOD_BIAS 0x8501
#define GL_MAX_TEXTURE_LOD_BIAS 0x84FD
#define GL_COMBINE 0x8570
#define GL_COMBINE_RGB 0x8571
#define GL_COMBINE_ALPHA 0x8572
#define GL_RGB_SCALE 0x8573
#define GL_ALPHA_SCALE 0x0D1C
#define GL_ADD_SIGNED 0x8574
#define GL_INTERPOLATE 0x8575
#define GL_CONSTANT 0x8576
#define GL_PRIMARY_COLOR 0x8577
#define GL_PREVIOUS 0x8578
#define GL_SUBTRACT 0x84E7
#define GL_DOT3_RGB 0x86AE
#define GL_DOT3_RGBA 0x86AF
#define GL_SRC0_RGB 0x8580
#define GL_SRC1_RGB 0x8581
#define GL_SRC2_RGB 0x8582
#define GL_SRC0_ALPHA 0x8588
#define GL_SRC1_ALPHA 0x8589
#define GL_SRC2_ALPHA 0x858A
#define GL_SOURCE0_RGB 0x8580
#define GL_SOURCE1_RGB 0x8581
#define GL_SOURCE2_RGB 0x8582
#define GL_SOURCE0_ALPHA 0x8588
#define GL_SOURCE1_ALPHA 0x8589
#define GL_SOURCE2_ALPHA 0x858A
#define GL_OPERAND0_RGB 0x8590
#define GL_OPERAND1_RGB 0x8591
#define GL_OPERAND2_RGB 0x8592
#define GL_OPERAND0_ALPHA 0x8598
#define GL_OPERAND1_ALPHA 0x8599
#define GL_OPERAND2_ALPHA 0x859A
#define GL_DECAL 0x2101
#define GL_ADD 0x0104
#define GL_REPLACE 0x1E01
#define GL_RED 0x1903
#define GL_GREEN 0x1904
#define GL_BLUE 0x1905
#define GL_ALPHA 0x1906
#define GL_RGB 0x1907
#define GL_RGBA 0x1908
#define GL_LUMINANCE 0x1909
#define GL_LUMINANCE_ALPHA 0x190A
#define GL_BGR 0x80E0
#define GL_BGRA 0x80E1
#define GL_INTENSITY 0x8049
#define GL_R3_G3_B2 0x2A10
#define GL_ALPHA4 0x803B
#define GL_ALPHA8 0x803C
#define GL_ALPHA12 0x803D
#define GL_ALPHA16 0x803E
#define GL_LUMINANCE4 0x803F
#define GL_LUMINANCE8 0x8040
#define GL_LUMINANCE12 0x8041
#define GL_LUMINANCE16 0x8042
#define GL_LUMINANCE4_ALPHA4 0x8043
#define GL_LUMINANCE6_ALPHA2 0x8044
#define GL_LUMINANCE8_ALPHA8 0x8045
#define GL_LUMINANCE12_ALPHA4 0x8046
#define GL_LUMINANCE12_ALPHA12 0x8047
#define GL_LUMINANCE16_ALPHA16 0x8048
#define GL_INTENSITY4 0x804A
#define GL_INTENSITY8 0x804B
#define GL_INTENSITY12 0x804C
#define GL_INTENSITY16 0x804D
#define GL_RGB4 0x804F
#define GL_RGB5 0x8050
#define GL_RGB565 0x8D62
#define GL_RGB8 0x8051
#define GL_RGB10 0x8052
#define GL_RGB12 0x8053
#define GL_RGB16 0x8054
#define GL_RGBA2 0x8055
#define GL_RGBA4 0x8056
#define GL_RGB5_A1 0x8057
#define GL_RGBA8 0x8058
#define GL_RGB10_A2 0x8059
#define GL_RGBA12 0x805A
#define GL_RGBA16 0x805B
#define GL_UNSIGNED_BYTE_3_3_2 0x8032
#define GL_UNSIGNED_SHORT_4_4_4_4 0x8033
#define GL_UNSIGNED_SHORT_5_5_5_1 0x8034
#define GL_UNSIGNED_INT_8_8_8_8 0x8035
#define GL_UNSIGNED_INT_10_10_10_2 0x8036
#define GL_UNSIGNED_BYTE_2_3_3_REV 0x8362
#define GL_UNSIGNED_SHORT_5_6_5 0x8363
#define GL_UNSIGNED_SHORT_5_6_5_REV 0x8364
#define GL_UNSIGNED_SHORT_4_4_4_4_REV 0x8365
#define GL_UNSIGNED_SHORT_1_5_5_5_REV 0x8366
#define GL_UNSIGNED_INT_8_8_8_8_REV 0x8367
#define GL_UNSIGNED_INT_2_10_10_10_REV 0x8368
/* Makes an image of a one-dimensional texture anew; pixels may be null (GL 1.3, 3.8.1). target: GL_TEXTURE_1D, GL_PROXY_TEXTURE_1D. level:
   at least 0. internalformat: GL_RGBA. border: 0 to 1. format: GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_BGR, GL_RGBA, GL_BGRA,
   GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_COLOR_INDEX, GL_DEPTH_COMPONENT. Optional system: TEXTURE_1D. */
GLAPI void GLAPIENTRY glTexImage1D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLint border, GLenum format, GLenum type, const void* pixels);
/* Makes an image of a texture or of a cube map's face anew; pixels may be null (GL 1.3, 3.8.1). target: GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D,
   GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_CUBE_MAP_NEGATIVE_X, GL_TEXTURE_CUBE_MAP_POSITIVE_Y, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
   GL_TEXTURE_CUBE_MAP_POSITIVE_Z, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, GL_PROXY_TEXTURE_CUBE_MAP. level: at least 0. internalformat: GL_RGBA.
   border: 0 to 1. format: GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_BGR, GL_RGBA, GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA,
   GL_COLOR_INDEX, GL_DEPTH_COMPONENT. */
GLAPI void GLAPIENTRY glTexImage2D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type, const void* pixels);
/* Does what glTexImage2D does with constant texels, which are not copied and must stay (GL 1.3, 3.8.1). target: GL_TEXTURE_2D,
   GL_PROXY_TEXTURE_2D, GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_CUBE_MAP_NEGATIVE_X, GL_TEXTURE_CUBE_MAP_POSITIVE_Y,
   GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, GL_TEXTURE_CUBE_MAP_POSITIVE_Z, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, GL_PROXY_TEXTURE_CUBE_MAP. level: at
   least 0. internalformat: GL_RGB565, GL_RGB5, GL_R3_G3_B2, GL_RGB8, GL_RGBA4, GL_RGB5_A1, GL_RGBA8, GL_ALPHA8, GL_LUMINANCE8,
   GL_INTENSITY8, GL_LUMINANCE8_ALPHA8. border: 0. Not compiled into display lists. */
GLAPI void GLAPIENTRY glTexConstantImage2DSPANGLE(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data);
/* Makes an image of a three-dimensional texture anew; pixels may be null (GL 1.3, 3.8.1). target: GL_TEXTURE_3D, GL_PROXY_TEXTURE_3D.
   level: at least 0. internalformat: GL_RGBA. border: 0 to 1. format: GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_BGR, GL_RGBA,
   GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_COLOR_INDEX, GL_DEPTH_COMPONENT. Optional system: TEXTURE_3D. */
GLAPI void GLAPIENTRY glTexImage3D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels);
/* Replaces a part of an image of a one-dimensional texture (GL 1.3, 3.8.2). target: GL_TEXTURE_1D. level: at least 0. format: GL_RED,
   GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_BGR, GL_RGBA, GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_COLOR_INDEX, GL_DEPTH_COMPONENT.
   Optional system: TEXTURE_1D. */
GLAPI void GLAPIENTRY glTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format, GLenum type, const void* pixels);
/* Replaces a rectangle of an image of a texture (GL 1.3, 3.8.2). target: GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP_POSITIVE_X,
   GL_TEXTURE_CUBE_MAP_NEGATIVE_X, GL_TEXTURE_CUBE_MAP_POSITIVE_Y, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, GL_TEXTURE_CUBE_MAP_POSITIVE_Z,
   GL_TEXTURE_CUBE_MAP_NEGATIVE_Z. level: at least 0. format: GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_BGR, GL_RGBA, GL_BGRA,
   GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_COLOR_INDEX, GL_DEPTH_COMPONENT. */
GLAPI void GLAPIENTRY glTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels);
/* Replaces a box of an image of a three-dimensional texture (GL 1.3, 3.8.1). target: GL_TEXTURE_3D. level: at least 0. format: GL_RED,
   GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_BGR, GL_RGBA, GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_COLOR_INDEX, GL_DEPTH_COMPONENT.
   Optional system: TEXTURE_3D. */
GLAPI void GLAPIENTRY glTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type, const void* pixels);
/* Makes an image anew from a row of the window (GL 1.3, 3.8.2). target: GL_TEXTURE_1D. level: at least 0. border: 0 to 1. Optional system:
   COPY_TEXTURE. */
GLAPI void GLAPIENTRY glCopyTexImage1D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width, GLint border);
/* Makes an image anew from a rectangle of the window (GL 1.3, 3.8.2). target: GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP_POSITIVE_X,
   GL_TEXTURE_CUBE_MAP_NEGATIVE_X, GL_TEXTURE_CUBE_MAP_POSITIVE_Y, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, GL_TEXTURE_CUBE_MAP_POSITIVE_Z,
   GL_TEXTURE_CUBE_MAP_NEGATIVE_Z. level: at least 0. border: 0 to 1. Optional system: COPY_TEXTURE. */
GLAPI void GLAPIENTRY glCopyTexImage2D(GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width, GLsizei height, GLint border);
/* Replaces a part of an image by a row of the window (GL 1.3, 3.8.2). target: GL_TEXTURE_1D. level: at least 0. Optional system:
   COPY_TEXTURE. */
GLAPI void GLAPIENTRY glCopyTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLint x, GLint y, GLsizei width);
/* Replaces a rectangle of an image by one of the window (GL 1.3, 3.8.2). target: GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP_POSITIVE_X,
   GL_TEXTURE_CUBE_MAP_NEGATIVE_X, GL_TEXTURE_CUBE_MAP_POSITIVE_Y, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, GL_TEXTURE_CUBE_MAP_POSITIVE_Z,
   GL_TEXTURE_CUBE_MAP_NEGATIVE_Z. level: at least 0. Optional system: COPY_TEXTURE. */
GLAPI void GLAPIENTRY glCopyTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x, GLint y, GLsizei width, GLsizei height);
/* Replaces a rectangle of a layer by one of the window (GL 1.3, 3.8.1). target: GL_TEXTURE_3D. level: at least 0. Optional system:
   COPY_TEXTURE. */
GLAPI void GLAPIENTRY glCopyTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height);
/* Makes an image anew from compressed data: there is no such format of one dimension (GL 1.3, 3.8.3). Always GL_INVALID_ENUM. Not compiled
   into display lists. Optional system: COMPRESSED_TEXTURES. */
GLAPI void GLAPIENTRY glCompressedTexImage1D(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLint border, GLsizei imageSize, const void* data);
/* Makes an image anew from image_size bytes of compressed data (GL 1.3, 3.8.3). target: GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D,
   GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_CUBE_MAP_NEGATIVE_X, GL_TEXTURE_CUBE_MAP_POSITIVE_Y, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
   GL_TEXTURE_CUBE_MAP_POSITIVE_Z, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, GL_PROXY_TEXTURE_CUBE_MAP. level: at least 0. internalformat:
   GL_ETC1_RGB8_OES, GL_PALETTE4_RGB8_OES, GL_PALETTE4_RGBA8_OES, GL_PALETTE4_R5_G6_B5_OES, GL_PALETTE4_RGBA4_OES, GL_PALETTE4_RGB5_A1_OES,
   GL_PALETTE8_RGB8_OES, GL_PALETTE8_RGBA8_OES, GL_PALETTE8_R5_G6_B5_OES, GL_PALETTE8_RGBA4_OES, GL_PALETTE8_RGB5_A1_OES. border: 0.
   Optional system: COMPRESSED_TEXTURES. */
GLAPI void GLAPIENTRY glCompressedTexImage2D(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data);
/* Makes an image anew from compressed data: there is no such format of three dimensions (GL 1.3, 3.8.3). Always GL_INVALID_ENUM. Not
   compiled into display lists. Optional system: COMPRESSED_TEXTURES. */
GLAPI void GLAPIENTRY glCompressedTexImage3D(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLsizei depth, GLint border, GLsizei imageSize, const void* data);
/* Replaces a part of a compressed image: there is no such format of one dimension (GL 1.3, 3.8.3). Always GL_INVALID_ENUM. Not compiled
   into display lists. Optional system: COMPRESSED_TEXTURES. */
GLAPI void GLAPIENTRY glCompressedTexSubImage1D(GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format, GLsizei imageSize, const void* data);
/* Replaces a rectangle of a compressed image (GL 1.3, 3.8.3). target: GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP_POSITIVE_X,
   GL_TEXTURE_CUBE_MAP_NEGATIVE_X, GL_TEXTURE_CUBE_MAP_POSITIVE_Y, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, GL_TEXTURE_CUBE_MAP_POSITIVE_Z,
   GL_TEXTURE_CUBE_MAP_NEGATIVE_Z. level: at least 0. format: GL_ETC1_RGB8_OES, GL_PALETTE4_RGB8_OES, GL_PALETTE4_RGBA8_OES,
   GL_PALETTE4_R5_G6_B5_OES, GL_PALETTE4_RGBA4_OES, GL_PALETTE4_RGB5_A1_OES, GL_PALETTE8_RGB8_OES, GL_PALETTE8_RGBA8_OES,
   GL_PALETTE8_R5_G6_B5_OES, GL_PALETTE8_RGBA4_OES, GL_PALETTE8_RGB5_A1_OES. Optional system: COMPRESSED_TEXTURES. */
GLAPI void GLAPIENTRY glCompressedTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width, GLsizei height, GLenum format, GLsizei imageSize, const void* data);
/* Replaces a box of a compressed image: there is no such format of three dimensions (GL 1.3, 3.8.3). Always GL_INVALID_ENUM. Not compiled
   into display lists. Optional system: COMPRESSED_TEXTURES. */
GLAPI void GLAPIENTRY glCompressedTexSubImage3D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLsizei imageSize, const void* data);
/* Does what glCompressedTexImage2D does with constant data, which are not copied and must stay (GL 1.3, 3.8.3). target: GL_TEXTURE_2D,
   GL_PROXY_TEXTURE_2D, GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_CUBE_MAP_NEGATIVE_X, GL_TEXTURE_CUBE_MAP_POSITIVE_Y,
   GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, GL_TEXTURE_CUBE_MAP_POSITIVE_Z, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, GL_PROXY_TEXTURE_CUBE_MAP. level: at
   least 0. internalformat: GL_ETC1_RGB8_OES, GL_PALETTE4_RGB8_OES, GL_PALETTE4_RGBA8_OES, GL_PALETTE4_R5_G6_B5_OES, GL_PALETTE4_RGBA4_OES,
   GL_PALETTE4_RGB5_A1_OES, GL_PALETTE8_RGB8_OES, GL_PALETTE8_RGBA8_OES, GL_PALETTE8_R5_G6_B5_OES, GL_PALETTE8_RGBA4_OES,
   GL_PALETTE8_RGB5_A1_OES. border: 0. Not compiled into display lists. Optional system: COMPRESSED_TEXTURES. */
GLAPI void GLAPIENTRY glCompressedTexConstantImage2DSPANGLE(GLenum target, GLint level, GLenum internalformat, GLsizei width, GLsizei height, GLint border, GLsizei imageSize, const void* data);
/* Writes an image of a texture to memory (GL 1.3, 6.1.3). target: GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D,
   GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_CUBE_MAP_NEGATIVE_X, GL_TEXTURE_CUBE_MAP_POSITIVE_Y, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
   GL_TEXTURE_CUBE_MAP_POSITIVE_Z, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z. level: at least 0. format: GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB,
   GL_BGR, GL_RGBA, GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_DEPTH_COMPONENT. Not compiled into display lists. */
GLAPI void GLAPIENTRY glGetTexImage(GLenum target, GLint level, GLenum format, GLenum type, void* pixels);
/* Writes the compressed data of an image to memory (GL 1.3, 3.8.3). target: GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D,
   GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_TEXTURE_CUBE_MAP_NEGATIVE_X, GL_TEXTURE_CUBE_MAP_POSITIVE_Y, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
   GL_TEXTURE_CUBE_MAP_POSITIVE_Z, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z. level: at least 0. Not compiled into display lists. Optional system:
   COMPRESSED_TEXTURES. */
GLAPI void GLAPIENTRY glGetCompressedTexImage(GLenum target, GLint level, void* data);
/* Makes the images of all smaller levels from the base level (GL 3.0, 3.9.7). target: GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D,
   GL_TEXTURE_CUBE_MAP. Optional system: MIPMAP_GENERATION. */
GLAPI void GLAPIENTRY glGenerateMipmap(GLenum target);
/* Tells whether all textures are in memory, and writes one answer for each where they are not (GL 1.3, 3.8.11). */
GLAPI GLboolean GLAPIENTRY glAreTexturesResident(GLsizei n, const GLuint* textures, GLboolean* residences);
/* Sets the priorities of textures, clamped to [0, 1] (GL 1.3, 3.8.11). */
GLAPI void GLAPIENTRY glPrioritizeTextures(GLsizei n, const GLuint* textures, const GLclampf* priorities);
/* Writes n unused names of textures to the array (GL 1.3, 3.8.11). Not compiled into display lists. */
GLAPI void GLAPIENTRY glGenTextures(GLsizei n, GLuint* textures);
/* Deletes textures; unused names are ignored (GL 1.3, 3.8.11). Not compiled into display lists. */
GLAPI void GLAPIENTRY glDeleteTextures(GLsizei n, const GLuint* textures);
/* Binds a texture to a target of the active unit; 0 is the default one (GL 1.3, 3.8.11). target: GL_TEXTURE_2D, GL_TEXTURE_1D,
   GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP. */
GLAPI void GLAPIENTRY glBindTexture(GLenum target, GLuint texture);
/* Selects the unit that texture commands change (GL 1.3, 3.8.13). texture: GL_TEXTURE0, GL_TEXTURE1. */
GLAPI void GLAPIENTRY glActiveTexture(GLenum texture);
/* Tells whether a name is that of a texture (GL 1.3, 3.8.11). */
GLAPI GLboolean GLAPIENTRY glIsTexture(GLuint texture);
/* Sets a parameter of the bound texture (GL 1.3, 3.8.4). target: GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP. */
GLAPI void GLAPIENTRY glTexParameterf(GLenum target, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glTexParameterfv(GLenum target, GLenum pname, const GLfloat* params);
GLAPI void GLAPIENTRY glTexParameteri(GLenum target, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glTexParameteriv(GLenum target, GLenum pname, const GLint* params);
GLAPI void GLAPIENTRY glTexParameterxOES(GLenum target, GLenum pname, GLfixed param);
GLAPI void GLAPIENTRY glTexParameterxvOES(GLenum target, GLenum pname, const GLfixed* params);
/* Writes a parameter of the bound texture to params (GL 1.3, 3.8.4). target: GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D,
   GL_TEXTURE_CUBE_MAP. Not compiled into display lists. */
GLAPI void GLAPIENTRY glGetTexParameterfv(GLenum target, GLenum pname, GLfloat* params);
GLAPI void GLAPIENTRY glGetTexParameteriv(GLenum target, GLenum pname, GLint* params);
GLAPI void GLAPIENTRY glGetTexParameterxvOES(GLenum target, GLenum pname, GLfixed* params);
/* Sets a parameter of the active unit's environment (GL 1.3, 3.8.12). target: GL_TEXTURE_ENV, GL_TEXTURE_FILTER_CONTROL, GL_POINT_SPRITE.
   */
GLAPI void GLAPIENTRY glTexEnvf(GLenum target, GLenum pname, GLfloat param);
GLAPI void GLAPIENTRY glTexEnvfv(GLenum target, GLenum pname, const GLfloat* params);
GLAPI void GLAPIENTRY glTexEnvi(GLenum target, GLenum pname, GLint param);
GLAPI void GLAPIENTRY glTexEnviv(GLenum target, GLenum pname, const GLint* params);
GLAPI void GLAPIENTRY glTexEnvxOES(GLenum target, GLenum pname, GLfixed param);
GLAPI void GLAPIENTRY glTexEnvxvOES(GLenum target, GLenum pname, const GLfixed* params);
/* Writes a parameter of the active unit's environment to params (GL 1.3, 3.8.12). target: GL_TEXTURE_ENV, GL_TEXTURE_FILTER_CONTROL,
   GL_POINT_SPRITE. Not compiled into display lists. */
GLAPI void GLAPIENTRY glGetTexEnvfv(GLenum target, GLenum pname, GLfloat* params);
GLAPI void GLAPIENTRY glGetTexEnviv(GLenum target, GLenum pname, GLint* params);
GLAPI void GLAPIENTRY glGetTexEnvxvOES(GLenum target, GLenum pname, GLfixed* params);
/* Writes a parameter of an image of the bound texture to params (GL 1.3, 6.1.3). level: at least 0. Not compiled into display lists. */
GLAPI void GLAPIENTRY glGetTexLevelParameterfv(GLenum target, GLint level, GLenum pname, GLfloat* params);
GLAPI void GLAPIENTRY glGetTexLevelParameteriv(GLenum target, GLint level, GLenum pname, GLint* params);
GLAPI void GLAPIENTRY glGetTexLevelParameterxvOES(GLenum target, GLint level, GLenum pname, GLfixed* params);

/* Display lists (GL 1.3, 5.4) */
#define GL_LIST_MODE 0x0B30
#define GL_MAX_LIST_NESTING 0x0B31
#define GL_LIST_BASE 0x0B32
#define GL_LIST_INDEX 0x0B33
#define GL_COMPILE 0x1300
#define GL_COMPILE_AND_EXECUTE 0x1301
/* Begins a display list, into which commands are compiled up to glEndList (GL 1.3, 5.4). mode: GL_COMPILE, GL_COMPILE_AND_EXECUTE. Not
   compiled into display lists. Optional system: LISTS. */
GLAPI void GLAPIENTRY glNewList(GLuint list, GLenum mode);
/* Ends the display list, which replaces the one of its name (GL 1.3, 5.4). Not compiled into display lists. Optional system: LISTS. */
GLAPI void GLAPIENTRY glEndList(void);
/* Runs a display list; unused names are ignored (GL 1.3, 5.4). Also between glBegin and glEnd. Optional system: LISTS. */
GLAPI void GLAPIENTRY glCallList(GLuint list);
/* Runs n display lists, whose numbers are added to the list base (GL 1.3, 5.4). type: GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT,
   GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT, GL_2_BYTES, GL_3_BYTES, GL_4_BYTES. Also between glBegin and glEnd. Optional
   system: LISTS. */
GLAPI void GLAPIENTRY glCallLists(GLsizei n, GLenum type, const void* lists);
/* Sets the number that is added to those of glCallLists (GL 1.3, 5.4). Optional system: LISTS. */
GLAPI void GLAPIENTRY glListBase(GLuint base);
/* Makes range empty display lists with consecutive names, and returns the first name; 0: there are none (GL 1.3, 5.4). Optional system:
   LISTS. */
GLAPI GLuint GLAPIENTRY glGenLists(GLsizei range);
/* Deletes range display lists from the name list on (GL 1.3, 5.4). Not compiled into display lists. Optional system: LISTS. */
GLAPI void GLAPIENTRY glDeleteLists(GLuint list, GLsizei range);
/* Tells whether a name is that of a display list (GL 1.3, 5.4). Optional system: LISTS. */
GLAPI GLboolean GLAPIENTRY glIsList(GLuint list);

/* Selection, feedback (GL 1.3, 5.2, 5.3) */
#define GL_RENDER_MODE 0x0C40
#define GL_RENDER 0x1C00
#define GL_FEEDBACK 0x1C01
#define GL_SELECT 0x1C02
#define GL_NAME_STACK_DEPTH 0x0D70
#define GL_MAX_NAME_STACK_DEPTH 0x0D37
#define GL_SELECTION_BUFFER_POINTER 0x0DF3
#define GL_SELECTION_BUFFER_SIZE 0x0DF4
#define GL_FEEDBACK_BUFFER_POINTER 0x0DF0
#define GL_FEEDBACK_BUFFER_SIZE 0x0DF1
#define GL_FEEDBACK_BUFFER_TYPE 0x0DF2
#define GL_2D 0x0600
#define GL_3D 0x0601
#define GL_3D_COLOR 0x0602
#define GL_3D_COLOR_TEXTURE 0x0603
#define GL_4D_COLOR_TEXTURE 0x0604
#define GL_PASS_THROUGH_TOKEN 0x0700
#define GL_POINT_TOKEN 0x0701
#define GL_LINE_TOKEN 0x0702
#define GL_POLYGON_TOKEN 0x0703
#define GL_BITMAP_TOKEN 0x0704
#define GL_DRAW_PIXEL_TOKEN 0x0705
#define GL_COPY_PIXEL_TOKEN 0x0706
#define GL_LINE_RESET_TOKEN 0x0707
/* Switches between drawing, selection and feedback, and returns the hits or values of the mode that ends (GL 1.3, 5.2). mode: GL_RENDER,
   GL_SELECT, GL_FEEDBACK. Optional system: SELECTION or FEEDBACK. */
GLAPI GLint GLAPIENTRY glRenderMode(GLenum mode);
/* Names the array of size elements for the hits of selection (GL 1.3, 5.2). Not compiled into display lists. Optional system: SELECTION. */
GLAPI void GLAPIENTRY glSelectBuffer(GLsizei size, GLuint* buffer);
/* Empties the name stack (GL 1.3, 5.2). Optional system: SELECTION. */
GLAPI void GLAPIENTRY glInitNames(void);
/* Pushes a name (GL 1.3, 5.2). Optional system: SELECTION. */
GLAPI void GLAPIENTRY glPushName(GLuint name);
/* Pops a name (GL 1.3, 5.2). Optional system: SELECTION. */
GLAPI void GLAPIENTRY glPopName(void);
/* Replaces the top of the name stack (GL 1.3, 5.2). Optional system: SELECTION. */
GLAPI void GLAPIENTRY glLoadName(GLuint name);
/* Names the array of size elements for the values of feedback (GL 1.3, 5.3). type: GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE,
   GL_4D_COLOR_TEXTURE. Not compiled into display lists. Optional system: FEEDBACK. */
GLAPI void GLAPIENTRY glFeedbackBuffer(GLsizei size, GLenum type, GLfloat* buffer);
GLAPI void GLAPIENTRY glFeedbackBufferxOES(GLsizei size, GLenum type, GLfixed* buffer);
/* Puts a token among the values of feedback (GL 1.3, 5.3). Optional system: FEEDBACK. */
GLAPI void GLAPIENTRY glPassThrough(GLfloat token);
GLAPI void GLAPIENTRY glPassThroughxOES(GLfixed token);

/* Evaluators (GL 1.3, 5.1) */
#define GL_AUTO_NORMAL 0x0D80
#define GL_MAX_EVAL_ORDER 0x0D30
#define GL_COEFF 0x0A00
#define GL_ORDER 0x0A01
#define GL_DOMAIN 0x0A02
#define GL_MAP1_COLOR_4 0x0D90
#define GL_MAP1_INDEX 0x0D91
#define GL_MAP1_NORMAL 0x0D92
#define GL_MAP1_TEXTURE_COORD_1 0x0D93
#define GL_MAP1_TEXTURE_COORD_2 0x0D94
#define GL_MAP1_TEXTURE_COORD_3 0x0D95
#define GL_MAP1_TEXTURE_COORD_4 0x0D96
#define GL_MAP1_VERTEX_3 0x0D97
#define GL_MAP1_VERTEX_4 0x0D98
#define GL_MAP2_COLOR_4 0x0DB0
#define GL_MAP2_INDEX 0x0DB1
#define GL_MAP2_NORMAL 0x0DB2
#define GL_MAP2_TEXTURE_COORD_1 0x0DB3
#define GL_MAP2_TEXTURE_COORD_2 0x0DB4
#define GL_MAP2_TEXTURE_COORD_3 0x0DB5
#define GL_MAP2_TEXTURE_COORD_4 0x0DB6
#define GL_MAP2_VERTEX_3 0x0DB7
#define GL_MAP2_VERTEX_4 0x0DB8
#define GL_MAP1_GRID_DOMAIN 0x0DD0
#define GL_MAP1_GRID_SEGMENTS 0x0DD1
#define GL_MAP2_GRID_DOMAIN 0x0DD2
#define GL_MAP2_GRID_SEGMENTS 0x0DD3
/* Sets an evaluator of one variable: order control points, stride components apart, over [u1, u2] (GL 1.3, 5.1). target: GL_MAP1_VERTEX_4,
   GL_MAP1_VERTEX_3, GL_MAP1_COLOR_4, GL_MAP1_INDEX, GL_MAP1_NORMAL, GL_MAP1_TEXTURE_COORD_1, GL_MAP1_TEXTURE_COORD_2,
   GL_MAP1_TEXTURE_COORD_3, GL_MAP1_TEXTURE_COORD_4. stride: at least 4. order: 1 to 8. Optional system: EVALUATORS. */
GLAPI void GLAPIENTRY glMap1f(GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order, const GLfloat* points);
GLAPI void GLAPIENTRY glMap1d(GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order, const GLdouble* points);
GLAPI void GLAPIENTRY glMap1xOES(GLenum target, GLfixed u1, GLfixed u2, GLint stride, GLint order, const GLfixed* points);
/* Sets an evaluator of two variables: a net of control points over [u1, u2] x [v1, v2] (GL 1.3, 5.1). target: GL_MAP2_VERTEX_4,
   GL_MAP2_VERTEX_3, GL_MAP2_COLOR_4, GL_MAP2_INDEX, GL_MAP2_NORMAL, GL_MAP2_TEXTURE_COORD_1, GL_MAP2_TEXTURE_COORD_2,
   GL_MAP2_TEXTURE_COORD_3, GL_MAP2_TEXTURE_COORD_4. ustride: at least 4. uorder: 1 to 8. vstride: at least 4. vorder: 1 to 8. Optional
   system: EVALUATORS. */
GLAPI void GLAPIENTRY glMap2f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1, GLfloat v2, GLint vstride, GLint vorder, const GLfloat* points);
GLAPI void GLAPIENTRY glMap2d(GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder, GLdouble v1, GLdouble v2, GLint vstride, GLint vorder, const GLdouble* points);
GLAPI void GLAPIENTRY glMap2xOES(GLenum target, GLfixed u1, GLfixed u2, GLint ustride, GLint uorder, GLfixed v1, GLfixed v2, GLint vstride, GLint vorder, const GLfixed* points);
/* Writes order, domain or control points of an evaluator to the array (GL 1.3, 5.1). query: GL_COEFF, GL_ORDER, GL_DOMAIN. Not compiled
   into display lists. Optional system: EVALUATORS. */
GLAPI void GLAPIENTRY glGetMapiv(GLenum target, GLenum query, GLint* v);
GLAPI void GLAPIENTRY glGetMapfv(GLenum target, GLenum query, GLfloat* v);
GLAPI void GLAPIENTRY glGetMapdv(GLenum target, GLenum query, GLdouble* v);
GLAPI void GLAPIENTRY glGetMapxvOES(GLenum target, GLenum query, GLfixed* v);
/* Evaluates the maps of one variable that are on, and gives the vertex (GL 1.3, 5.1). Also between glBegin and glEnd. Optional system:
   EVALUATORS. */
GLAPI void GLAPIENTRY glEvalCoord1f(GLfloat u);
GLAPI void GLAPIENTRY glEvalCoord1fv(const GLfloat* v);
GLAPI void GLAPIENTRY glEvalCoord1d(GLdouble u);
GLAPI void GLAPIENTRY glEvalCoord1dv(const GLdouble* v);
GLAPI void GLAPIENTRY glEvalCoord1xOES(GLfixed u);
GLAPI void GLAPIENTRY glEvalCoord1xvOES(const GLfixed* v);
/* Evaluates the maps of two variables that are on, and gives the vertex (GL 1.3, 5.1). Also between glBegin and glEnd. Optional system:
   EVALUATORS. */
GLAPI void GLAPIENTRY glEvalCoord2f(GLfloat u, GLfloat v);
GLAPI void GLAPIENTRY glEvalCoord2fv(const GLfloat* v);
GLAPI void GLAPIENTRY glEvalCoord2d(GLdouble u, GLdouble v);
GLAPI void GLAPIENTRY glEvalCoord2dv(const GLdouble* v);
GLAPI void GLAPIENTRY glEvalCoord2xOES(GLfixed u, GLfixed v);
GLAPI void GLAPIENTRY glEvalCoord2xvOES(const GLfixed* v);
/* Divides [u1, u2] into un steps (GL 1.3, 5.1). un: at least 1. Optional system: EVALUATORS. */
GLAPI void GLAPIENTRY glMapGrid1f(GLint un, GLfloat u1, GLfloat u2);
GLAPI void GLAPIENTRY glMapGrid1d(GLint un, GLdouble u1, GLdouble u2);
GLAPI void GLAPIENTRY glMapGrid1xOES(GLint un, GLfixed u1, GLfixed u2);
/* Divides [u1, u2] into un steps, and [v1, v2] into vn (GL 1.3, 5.1). un: at least 1. vn: at least 1. Optional system: EVALUATORS. */
GLAPI void GLAPIENTRY glMapGrid2f(GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2);
GLAPI void GLAPIENTRY glMapGrid2d(GLint un, GLdouble u1, GLdouble u2, GLint vn, GLdouble v1, GLdouble v2);
GLAPI void GLAPIENTRY glMapGrid2xOES(GLint un, GLfixed u1, GLfixed u2, GLint vn, GLfixed v1, GLfixed v2);
/* Draws the points or the lines of the grid of one variable from i1 to i2 (GL 1.3, 5.1). mode: GL_POINT, GL_LINE. Optional system:
   EVALUATORS. */
GLAPI void GLAPIENTRY glEvalMesh1(GLenum mode, GLint i1, GLint i2);
/* Draws points, lines or quadrilaterals of the grid of two variables (GL 1.3, 5.1). mode: GL_FILL, GL_LINE, GL_POINT. Optional system:
   EVALUATORS. */
GLAPI void GLAPIENTRY glEvalMesh2(GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2);
/* Evaluates at point i of the grid of one variable (GL 1.3, 5.1). Also between glBegin and glEnd. Optional system: EVALUATORS. */
GLAPI void GLAPIENTRY glEvalPoint1(GLint i);
/* Evaluates at point (i, j) of the grid of two variables (GL 1.3, 5.1). Also between glBegin and glEnd. Optional system: EVALUATORS. */
GLAPI void GLAPIENTRY glEvalPoint2(GLint i, GLint j);

#ifdef __cplusplus
}
#endif

#endif
