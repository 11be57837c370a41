// Every entry point with its argument kinds and a uniform way to call it.
// Written by gl/api/generate.py from gl/api/commands: change those, not this.
#include "tests/gl_api/command_table.hpp"

#include <spangle/GL/gl.h>

namespace spangle::test {

namespace {

const GLenum glenum_0[] = {GL_ALPHA_TEST, GL_BLEND, GL_COLOR_MATERIAL, GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER, GL_FOG, GL_LIGHT0, GL_LIGHT1, GL_LIGHT2, GL_LIGHT3, GL_LIGHT4, GL_LIGHT5, GL_LIGHT6, GL_LIGHT7, GL_LIGHTING, GL_NORMALIZE, GL_RESCALE_NORMAL, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_TEXTURE_2D};
const Arg arg_1[] = {{Kind::enum_, {glenum_0, 21}, INT32_MIN, INT32_MAX, GL_ALPHA_TEST, sizeof(GLenum)}};
const GLenum glenum_2[] = {GL_ALPHA_TEST, GL_BLEND, GL_COLOR_MATERIAL, GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER, GL_FOG, GL_LIGHT0, GL_LIGHT1, GL_LIGHT2, GL_LIGHT3, GL_LIGHT4, GL_LIGHT5, GL_LIGHT6, GL_LIGHT7, GL_LIGHTING, GL_NORMALIZE, GL_RESCALE_NORMAL, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_TEXTURE_2D, GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY};
const Arg arg_3[] = {{Kind::enum_, {glenum_2, 25}, INT32_MIN, INT32_MAX, GL_ALPHA_TEST, sizeof(GLenum)}};
const GLenum glenum_4[] = {GL_VIEWPORT, GL_CURRENT_COLOR, GL_MODELVIEW_MATRIX, GL_LIGHT_MODEL_AMBIENT, GL_DEPTH_RANGE, GL_MAX_LIGHTS, GL_BLEND_SRC};
const Arg arg_5[] = {{Kind::enum_, {glenum_4, 7}, INT32_MIN, INT32_MAX, GL_VIEWPORT, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLboolean)}};
const Arg arg_6[] = {{Kind::enum_, {glenum_4, 7}, INT32_MIN, INT32_MAX, GL_VIEWPORT, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_7[] = {{Kind::enum_, {glenum_4, 7}, INT32_MIN, INT32_MAX, GL_VIEWPORT, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_8[] = {{Kind::enum_, {glenum_4, 7}, INT32_MIN, INT32_MAX, GL_VIEWPORT, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}};
const Arg arg_9[] = {{Kind::enum_, {glenum_4, 7}, INT32_MIN, INT32_MAX, GL_VIEWPORT, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const GLenum glenum_10[] = {GL_VERTEX_ARRAY_POINTER, GL_NORMAL_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER, GL_TEXTURE_COORD_ARRAY_POINTER};
const Arg arg_11[] = {{Kind::enum_, {glenum_10, 4}, INT32_MIN, INT32_MAX, GL_VERTEX_ARRAY_POINTER, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const GLenum glenum_12[] = {GL_VENDOR, GL_RENDERER, GL_VERSION, GL_EXTENSIONS};
const Arg arg_13[] = {{Kind::enum_, {glenum_12, 4}, INT32_MIN, INT32_MAX, GL_VENDOR, sizeof(GLenum)}};
const GLenum glenum_14[] = {GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON};
const Arg arg_15[] = {{Kind::enum_, {glenum_14, 10}, INT32_MIN, INT32_MAX, GL_POINTS, sizeof(GLenum)}};
const Arg arg_16[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}};
const Arg arg_17[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}};
const Arg arg_18[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_19[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_20[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_21[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_22[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}};
const Arg arg_23[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}};
const Arg arg_24[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_25[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_26[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}};
const Arg arg_27[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_28[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_29[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}};
const Arg arg_30[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_31[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}};
const Arg arg_32[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_33[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_34[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}};
const Arg arg_35[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_36[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}};
const Arg arg_37[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_38[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_39[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}};
const Arg arg_40[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_41[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLbyte)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLbyte)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLbyte)}};
const Arg arg_42[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLbyte)}};
const Arg arg_43[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLubyte)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLubyte)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLubyte)}};
const Arg arg_44[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLubyte)}};
const Arg arg_45[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLushort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLushort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLushort)}};
const Arg arg_46[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLushort)}};
const Arg arg_47[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}};
const Arg arg_48[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}};
const Arg arg_49[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLbyte)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLbyte)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLbyte)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLbyte)}};
const Arg arg_50[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLubyte)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLubyte)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLubyte)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLubyte)}};
const Arg arg_51[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLushort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLushort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLushort)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLushort)}};
const Arg arg_52[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}};
const Arg arg_53[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLshort)}};
const Arg arg_54[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_55[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_56[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLdouble)}};
const Arg arg_57[] = {{Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const GLenum glenum_58[] = {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE, GL_FIXED};
const Arg arg_59[] = {{Kind::int_, {}, 2, 4, 2, sizeof(GLint)}, {Kind::enum_, {glenum_58, 5}, INT32_MIN, INT32_MAX, GL_SHORT, sizeof(GLenum)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const GLenum glenum_60[] = {GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE, GL_FIXED};
const Arg arg_61[] = {{Kind::enum_, {glenum_60, 6}, INT32_MIN, INT32_MAX, GL_BYTE, sizeof(GLenum)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const GLenum glenum_62[] = {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT, GL_DOUBLE, GL_FIXED};
const Arg arg_63[] = {{Kind::int_, {}, 3, 4, 3, sizeof(GLint)}, {Kind::enum_, {glenum_62, 9}, INT32_MIN, INT32_MAX, GL_BYTE, sizeof(GLenum)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const Arg arg_64[] = {{Kind::int_, {}, 1, 4, 1, sizeof(GLint)}, {Kind::enum_, {glenum_58, 5}, INT32_MIN, INT32_MAX, GL_SHORT, sizeof(GLenum)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const GLenum glenum_65[] = {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY};
const Arg arg_66[] = {{Kind::enum_, {glenum_65, 4}, INT32_MIN, INT32_MAX, GL_VERTEX_ARRAY, sizeof(GLenum)}};
const Arg arg_67[] = {{Kind::int_, {}, 0, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_68[] = {{Kind::enum_, {glenum_14, 10}, INT32_MIN, INT32_MAX, GL_POINTS, sizeof(GLenum)}, {Kind::int_, {}, 0, INT32_MAX, 0, sizeof(GLint)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}};
const GLenum glenum_69[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT};
const Arg arg_70[] = {{Kind::enum_, {glenum_14, 10}, INT32_MIN, INT32_MAX, GL_POINTS, sizeof(GLenum)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::enum_, {glenum_69, 3}, INT32_MIN, INT32_MAX, GL_UNSIGNED_BYTE, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const Arg arg_71[] = {{Kind::enum_, {glenum_14, 10}, INT32_MIN, INT32_MAX, GL_POINTS, sizeof(GLenum)}, {Kind::uint, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}, {Kind::uint, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::enum_, {glenum_69, 3}, INT32_MIN, INT32_MAX, GL_UNSIGNED_BYTE, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const GLenum glenum_72[] = {GL_V2F, GL_V3F, GL_C4UB_V2F, GL_C4UB_V3F, GL_C3F_V3F, GL_N3F_V3F, GL_C4F_N3F_V3F, GL_T2F_V3F, GL_T4F_V4F, GL_T2F_C4UB_V3F, GL_T2F_C3F_V3F, GL_T2F_N3F_V3F, GL_T2F_C4F_N3F_V3F, GL_T4F_C4F_N3F_V4F};
const Arg arg_73[] = {{Kind::enum_, {glenum_72, 14}, INT32_MIN, INT32_MAX, GL_V2F, sizeof(GLenum)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const GLenum glenum_74[] = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
const Arg arg_75[] = {{Kind::enum_, {glenum_74, 3}, INT32_MIN, INT32_MAX, GL_MODELVIEW, sizeof(GLenum)}};
const Arg arg_76[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, -1, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, -1, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 2, sizeof(GLdouble)}};
const Arg arg_77[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, -1, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, -1, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 2, sizeof(GLfixed)}};
const Arg arg_78[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, -1, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, -1, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, -1, sizeof(GLdouble)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLdouble)}};
const Arg arg_79[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, -1, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, -1, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, -1, sizeof(GLfixed)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLfixed)}};
const Arg arg_80[] = {{Kind::int_, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::int_, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}};
const Arg arg_81[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampd)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLclampd)}};
const Arg arg_82[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampf)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLclampf)}};
const Arg arg_83[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampx)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLclampx)}};
const Pname pname_84[] = {{GL_AMBIENT, 4, 'c', 0}, {GL_DIFFUSE, 4, 'c', 0}, {GL_SPECULAR, 4, 'c', 0}, {GL_POSITION, 4, 'r', 0}, {GL_SPOT_DIRECTION, 3, 'r', 0}, {GL_SPOT_EXPONENT, 1, 'r', 0}, {GL_SPOT_CUTOFF, 1, 'r', 0}, {GL_CONSTANT_ATTENUATION, 1, 'r', 0}, {GL_LINEAR_ATTENUATION, 1, 'r', 0}, {GL_QUADRATIC_ATTENUATION, 1, 'r', 0}};
const GLenum glenum_85[] = {GL_LIGHT0, GL_LIGHT1, GL_LIGHT2, GL_LIGHT3, GL_LIGHT4, GL_LIGHT5, GL_LIGHT6, GL_LIGHT7};
const Arg arg_86[] = {{Kind::enum_, {glenum_85, 8}, INT32_MIN, INT32_MAX, GL_LIGHT0, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_87[] = {{Kind::enum_, {glenum_85, 8}, INT32_MIN, INT32_MAX, GL_LIGHT0, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_88[] = {{Kind::enum_, {glenum_85, 8}, INT32_MIN, INT32_MAX, GL_LIGHT0, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_89[] = {{Kind::enum_, {glenum_85, 8}, INT32_MIN, INT32_MAX, GL_LIGHT0, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_90[] = {{Kind::enum_, {glenum_85, 8}, INT32_MIN, INT32_MAX, GL_LIGHT0, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_91[] = {{Kind::enum_, {glenum_85, 8}, INT32_MIN, INT32_MAX, GL_LIGHT0, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_92[] = {{Kind::enum_, {glenum_85, 8}, INT32_MIN, INT32_MAX, GL_LIGHT0, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_93[] = {{Kind::enum_, {glenum_85, 8}, INT32_MIN, INT32_MAX, GL_LIGHT0, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_94[] = {{Kind::enum_, {glenum_85, 8}, INT32_MIN, INT32_MAX, GL_LIGHT0, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Pname pname_95[] = {{GL_LIGHT_MODEL_AMBIENT, 4, 'c', 0}, {GL_LIGHT_MODEL_LOCAL_VIEWER, 1, 'i', 0}, {GL_LIGHT_MODEL_TWO_SIDE, 1, 'i', 0}, {GL_LIGHT_MODEL_COLOR_CONTROL, 1, 'i', GL_SINGLE_COLOR}};
const Arg arg_96[] = {{Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_97[] = {{Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_98[] = {{Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_99[] = {{Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_100[] = {{Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_101[] = {{Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Pname pname_102[] = {{GL_AMBIENT, 4, 'c', 0}, {GL_DIFFUSE, 4, 'c', 0}, {GL_SPECULAR, 4, 'c', 0}, {GL_EMISSION, 4, 'c', 0}, {GL_SHININESS, 1, 'r', 0}, {GL_AMBIENT_AND_DIFFUSE, 4, 'c', 0}};
const GLenum glenum_103[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
const Arg arg_104[] = {{Kind::enum_, {glenum_103, 3}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_105[] = {{Kind::enum_, {glenum_103, 3}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_106[] = {{Kind::enum_, {glenum_103, 3}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_107[] = {{Kind::enum_, {glenum_103, 3}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_108[] = {{Kind::enum_, {glenum_103, 3}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_109[] = {{Kind::enum_, {glenum_103, 3}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Pname pname_110[] = {{GL_AMBIENT, 4, 'c', 0}, {GL_DIFFUSE, 4, 'c', 0}, {GL_SPECULAR, 4, 'c', 0}, {GL_EMISSION, 4, 'c', 0}, {GL_SHININESS, 1, 'r', 0}};
const GLenum glenum_111[] = {GL_FRONT, GL_BACK};
const Arg arg_112[] = {{Kind::enum_, {glenum_111, 2}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_113[] = {{Kind::enum_, {glenum_111, 2}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_114[] = {{Kind::enum_, {glenum_111, 2}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const GLenum glenum_115[] = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE};
const Arg arg_116[] = {{Kind::enum_, {glenum_103, 3}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}, {Kind::enum_, {glenum_115, 5}, INT32_MIN, INT32_MAX, GL_EMISSION, sizeof(GLenum)}};
const GLenum glenum_117[] = {GL_FLAT, GL_SMOOTH};
const Arg arg_118[] = {{Kind::enum_, {glenum_117, 2}, INT32_MIN, INT32_MAX, GL_FLAT, sizeof(GLenum)}};
const GLenum glenum_119[] = {GL_CW, GL_CCW};
const Arg arg_120[] = {{Kind::enum_, {glenum_119, 2}, INT32_MIN, INT32_MAX, GL_CW, sizeof(GLenum)}};
const Arg arg_121[] = {{Kind::enum_, {glenum_103, 3}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}};
const Arg arg_122[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLfloat)}};
const Arg arg_123[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLfixed)}};
const GLenum glenum_124[] = {GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
const Arg arg_125[] = {{Kind::enum_, {glenum_124, 8}, INT32_MIN, INT32_MAX, GL_NEVER, sizeof(GLenum)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampf)}};
const Arg arg_126[] = {{Kind::enum_, {glenum_124, 8}, INT32_MIN, INT32_MAX, GL_NEVER, sizeof(GLenum)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampx)}};
const Arg arg_127[] = {{Kind::enum_, {glenum_124, 8}, INT32_MIN, INT32_MAX, GL_NEVER, sizeof(GLenum)}, {Kind::int_, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::uint, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}};
const GLenum glenum_128[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT};
const Arg arg_129[] = {{Kind::enum_, {glenum_128, 6}, INT32_MIN, INT32_MAX, GL_KEEP, sizeof(GLenum)}, {Kind::enum_, {glenum_128, 6}, INT32_MIN, INT32_MAX, GL_KEEP, sizeof(GLenum)}, {Kind::enum_, {glenum_128, 6}, INT32_MIN, INT32_MAX, GL_KEEP, sizeof(GLenum)}};
const Arg arg_130[] = {{Kind::enum_, {glenum_124, 8}, INT32_MIN, INT32_MAX, GL_NEVER, sizeof(GLenum)}};
const GLenum glenum_131[] = {GL_ZERO, GL_ONE, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_SRC_ALPHA_SATURATE};
const GLenum glenum_132[] = {GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA};
const Arg arg_133[] = {{Kind::enum_, {glenum_131, 9}, INT32_MIN, INT32_MAX, GL_ZERO, sizeof(GLenum)}, {Kind::enum_, {glenum_132, 8}, INT32_MIN, INT32_MAX, GL_ZERO, sizeof(GLenum)}};
const GLenum glenum_134[] = {GL_FRONT_LEFT, GL_FRONT_RIGHT, GL_BACK_LEFT, GL_BACK_RIGHT, GL_FRONT, GL_BACK, GL_LEFT, GL_RIGHT, GL_AUX0, GL_NONE, GL_FRONT_AND_BACK};
const Arg arg_135[] = {{Kind::enum_, {glenum_134, 11}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}};
const GLenum glenum_136[] = {GL_FRONT_LEFT, GL_FRONT_RIGHT, GL_BACK_LEFT, GL_BACK_RIGHT, GL_FRONT, GL_BACK, GL_LEFT, GL_RIGHT, GL_AUX0};
const Arg arg_137[] = {{Kind::enum_, {glenum_136, 9}, INT32_MIN, INT32_MAX, GL_FRONT, sizeof(GLenum)}};
const Arg arg_138[] = {{Kind::boolean, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLboolean)}, {Kind::boolean, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLboolean)}, {Kind::boolean, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLboolean)}, {Kind::boolean, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLboolean)}};
const Arg arg_139[] = {{Kind::boolean, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLboolean)}};
const Arg arg_140[] = {{Kind::uint, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}};
const GLenum glenum_141[] = {GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT, GL_ACCUM_BUFFER_BIT};
const Arg arg_142[] = {{Kind::bitfield, {glenum_141, 4}, INT32_MIN, INT32_MAX, GL_COLOR_BUFFER_BIT, sizeof(GLbitfield)}};
const Arg arg_143[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampf)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampf)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampf)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampf)}};
const Arg arg_144[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampx)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampx)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampx)}, {Kind::real, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLclampx)}};
const Arg arg_145[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLclampd)}};
const Arg arg_146[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLclampf)}};
const Arg arg_147[] = {{Kind::real, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLclampx)}};
const Arg arg_148[] = {{Kind::int_, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Pname pname_149[] = {{GL_UNPACK_SWAP_BYTES, 1, 'i', 0}, {GL_UNPACK_LSB_FIRST, 1, 'i', 0}, {GL_UNPACK_ROW_LENGTH, 1, 'i', 0}, {GL_UNPACK_SKIP_ROWS, 1, 'i', 0}, {GL_UNPACK_SKIP_PIXELS, 1, 'i', 0}, {GL_UNPACK_ALIGNMENT, 1, 'i', 4}, {GL_UNPACK_IMAGE_HEIGHT, 1, 'i', 0}, {GL_UNPACK_SKIP_IMAGES, 1, 'i', 0}, {GL_PACK_SWAP_BYTES, 1, 'i', 0}, {GL_PACK_LSB_FIRST, 1, 'i', 0}, {GL_PACK_ROW_LENGTH, 1, 'i', 0}, {GL_PACK_SKIP_ROWS, 1, 'i', 0}, {GL_PACK_SKIP_PIXELS, 1, 'i', 0}, {GL_PACK_ALIGNMENT, 1, 'i', 4}, {GL_PACK_IMAGE_HEIGHT, 1, 'i', 0}, {GL_PACK_SKIP_IMAGES, 1, 'i', 0}};
const GLenum glenum_150[] = {GL_RGB, GL_RGBA, GL_DEPTH_COMPONENT, GL_STENCIL_INDEX, GL_COLOR_INDEX};
const GLenum glenum_151[] = {GL_UNSIGNED_BYTE, GL_FLOAT, GL_UNSIGNED_SHORT_5_6_5};
const Arg arg_152[] = {{Kind::int_, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::int_, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::enum_, {glenum_150, 5}, INT32_MIN, INT32_MAX, GL_RGB, sizeof(GLenum)}, {Kind::enum_, {glenum_151, 3}, INT32_MIN, INT32_MAX, GL_UNSIGNED_BYTE, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const Pname pname_153[] = {{GL_FOG_MODE, 1, 'i', GL_EXP}, {GL_FOG_DENSITY, 1, 'r', 0}, {GL_FOG_START, 1, 'r', 0}, {GL_FOG_END, 1, 'r', 0}, {GL_FOG_COLOR, 4, 'c', 0}};
const GLenum glenum_154[] = {GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT};
const GLenum glenum_155[] = {GL_FASTEST, GL_NICEST, GL_DONT_CARE};
const Arg arg_156[] = {{Kind::enum_, {glenum_154, 5}, INT32_MIN, INT32_MAX, GL_PERSPECTIVE_CORRECTION_HINT, sizeof(GLenum)}, {Kind::enum_, {glenum_155, 3}, INT32_MIN, INT32_MAX, GL_FASTEST, sizeof(GLenum)}};
const GLenum glenum_157[] = {GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D};
const GLenum glenum_158[] = {GL_RGBA};
const GLenum glenum_159[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_BGR, GL_RGBA, GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
const GLenum glenum_160[] = {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT, GL_UNSIGNED_BYTE_3_3_2, GL_UNSIGNED_BYTE_2_3_3_REV, GL_UNSIGNED_SHORT_5_6_5, GL_UNSIGNED_SHORT_5_6_5_REV, GL_UNSIGNED_SHORT_4_4_4_4, GL_UNSIGNED_SHORT_4_4_4_4_REV, GL_UNSIGNED_SHORT_5_5_5_1, GL_UNSIGNED_SHORT_1_5_5_5_REV, GL_UNSIGNED_INT_8_8_8_8, GL_UNSIGNED_INT_8_8_8_8_REV, GL_UNSIGNED_INT_10_10_10_2, GL_UNSIGNED_INT_2_10_10_10_REV};
const Arg arg_161[] = {{Kind::enum_, {glenum_157, 2}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::int_, {}, 0, INT32_MAX, 0, sizeof(GLint)}, {Kind::int_, {glenum_158, 1}, INT32_MIN, INT32_MAX, GL_RGBA, sizeof(GLint)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::int_, {}, 0, 1, 0, sizeof(GLint)}, {Kind::enum_, {glenum_159, 10}, INT32_MIN, INT32_MAX, GL_RGBA, sizeof(GLenum)}, {Kind::enum_, {glenum_160, 19}, INT32_MIN, INT32_MAX, GL_UNSIGNED_BYTE, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const GLenum glenum_162[] = {GL_TEXTURE_2D};
const Arg arg_163[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::int_, {}, 0, INT32_MAX, 0, sizeof(GLint)}, {Kind::int_, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::int_, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::enum_, {glenum_159, 10}, INT32_MIN, INT32_MAX, GL_RGBA, sizeof(GLenum)}, {Kind::enum_, {glenum_160, 19}, INT32_MIN, INT32_MAX, GL_UNSIGNED_BYTE, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const Arg arg_164[] = {{Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}};
const Arg arg_165[] = {{Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}};
const Arg arg_166[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::uint, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}};
const Pname pname_167[] = {{GL_TEXTURE_MIN_FILTER, 1, 'i', GL_NEAREST}, {GL_TEXTURE_MAG_FILTER, 1, 'i', GL_NEAREST}, {GL_TEXTURE_WRAP_S, 1, 'i', GL_REPEAT}, {GL_TEXTURE_WRAP_T, 1, 'i', GL_REPEAT}, {GL_TEXTURE_BORDER_COLOR, 4, 'c', 0}, {GL_TEXTURE_PRIORITY, 1, 'r', 0}, {GL_TEXTURE_MIN_LOD, 1, 'r', 0}, {GL_TEXTURE_MAX_LOD, 1, 'r', 0}, {GL_TEXTURE_BASE_LEVEL, 1, 'i', 0}, {GL_TEXTURE_MAX_LEVEL, 1, 'i', 0}};
const Arg arg_168[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_169[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_170[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_171[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_172[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_173[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Pname pname_174[] = {{GL_TEXTURE_MIN_FILTER, 1, 'i', GL_NEAREST}, {GL_TEXTURE_MAG_FILTER, 1, 'i', GL_NEAREST}, {GL_TEXTURE_WRAP_S, 1, 'i', GL_REPEAT}, {GL_TEXTURE_WRAP_T, 1, 'i', GL_REPEAT}, {GL_TEXTURE_BORDER_COLOR, 4, 'c', 0}, {GL_TEXTURE_PRIORITY, 1, 'r', 0}, {GL_TEXTURE_MIN_LOD, 1, 'r', 0}, {GL_TEXTURE_MAX_LOD, 1, 'r', 0}, {GL_TEXTURE_BASE_LEVEL, 1, 'i', 0}, {GL_TEXTURE_MAX_LEVEL, 1, 'i', 0}, {GL_TEXTURE_RESIDENT, 1, 'i', 0}};
const Arg arg_175[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_176[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_177[] = {{Kind::enum_, {glenum_162, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_2D, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Pname pname_178[] = {{GL_TEXTURE_ENV_MODE, 1, 'i', GL_MODULATE}, {GL_TEXTURE_ENV_COLOR, 4, 'c', 0}};
const GLenum glenum_179[] = {GL_TEXTURE_ENV};
const Arg arg_180[] = {{Kind::enum_, {glenum_179, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_ENV, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_181[] = {{Kind::enum_, {glenum_179, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_ENV, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_182[] = {{Kind::enum_, {glenum_179, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_ENV, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_183[] = {{Kind::enum_, {glenum_179, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_ENV, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_184[] = {{Kind::enum_, {glenum_179, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_ENV, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::pvalue, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_185[] = {{Kind::enum_, {glenum_179, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_ENV, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Arg arg_186[] = {{Kind::enum_, {glenum_179, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_ENV, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_187[] = {{Kind::enum_, {glenum_179, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_ENV, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_188[] = {{Kind::enum_, {glenum_179, 1}, INT32_MIN, INT32_MAX, GL_TEXTURE_ENV, sizeof(GLenum)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const Pname pname_189[] = {{GL_TEXTURE_WIDTH, 1, 'i', 0}, {GL_TEXTURE_HEIGHT, 1, 'i', 0}, {GL_TEXTURE_BORDER, 1, 'i', 0}, {GL_TEXTURE_INTERNAL_FORMAT, 1, 'i', 0}, {GL_TEXTURE_RED_SIZE, 1, 'i', 0}, {GL_TEXTURE_GREEN_SIZE, 1, 'i', 0}, {GL_TEXTURE_BLUE_SIZE, 1, 'i', 0}, {GL_TEXTURE_ALPHA_SIZE, 1, 'i', 0}, {GL_TEXTURE_LUMINANCE_SIZE, 1, 'i', 0}, {GL_TEXTURE_INTENSITY_SIZE, 1, 'i', 0}};
const GLenum glenum_190[] = {GL_PROXY_TEXTURE_2D, GL_TEXTURE_2D};
const Arg arg_191[] = {{Kind::enum_, {glenum_190, 2}, INT32_MIN, INT32_MAX, GL_PROXY_TEXTURE_2D, sizeof(GLenum)}, {Kind::int_, {}, 0, INT32_MAX, 0, sizeof(GLint)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfloat)}};
const Arg arg_192[] = {{Kind::enum_, {glenum_190, 2}, INT32_MIN, INT32_MAX, GL_PROXY_TEXTURE_2D, sizeof(GLenum)}, {Kind::int_, {}, 0, INT32_MAX, 0, sizeof(GLint)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLint)}};
const Arg arg_193[] = {{Kind::enum_, {glenum_190, 2}, INT32_MIN, INT32_MAX, GL_PROXY_TEXTURE_2D, sizeof(GLenum)}, {Kind::int_, {}, 0, INT32_MAX, 0, sizeof(GLint)}, {Kind::pname, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLenum)}, {Kind::out, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLfixed)}};
const GLenum glenum_194[] = {GL_COMPILE, GL_COMPILE_AND_EXECUTE};
const Arg arg_195[] = {{Kind::uint, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLuint)}, {Kind::enum_, {glenum_194, 2}, INT32_MIN, INT32_MAX, GL_COMPILE, sizeof(GLenum)}};
const Arg arg_196[] = {{Kind::uint, {}, INT32_MIN, INT32_MAX, 1, sizeof(GLuint)}};
const GLenum glenum_197[] = {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT, GL_2_BYTES, GL_3_BYTES, GL_4_BYTES};
const Arg arg_198[] = {{Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}, {Kind::enum_, {glenum_197, 10}, INT32_MIN, INT32_MAX, GL_BYTE, sizeof(GLenum)}, {Kind::in, {}, INT32_MIN, INT32_MAX, 0, sizeof(char)}};
const Arg arg_199[] = {{Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}};
const Arg arg_200[] = {{Kind::uint, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLuint)}, {Kind::sizei, {}, INT32_MIN, INT32_MAX, 0, sizeof(GLsizei)}};

const Command table[] = {
    {"glGetError", "GetError", "A03", false, Listing::never, 1 != 0, {}, {},
     [](const Value* ) { glGetError(); }},
    {"glEnable", "Enable", "A04", false, Listing::words, 1 != 0, {arg_1, 1}, {},
     [](const Value* a) { glEnable(GLenum(a[0].integer)); }},
    {"glDisable", "Disable", "A04", false, Listing::words, 1 != 0, {arg_1, 1}, {},
     [](const Value* a) { glDisable(GLenum(a[0].integer)); }},
    {"glIsEnabled", "IsEnabled", "A04", false, Listing::never, 1 != 0, {arg_3, 1}, {},
     [](const Value* a) { glIsEnabled(GLenum(a[0].integer)); }},
    {"glGetBooleanv", "GetBooleanv", "H09", false, Listing::never, 1 != 0, {arg_5, 2}, {},
     [](const Value* a) { glGetBooleanv(GLenum(a[0].integer), static_cast<GLboolean*>(a[1].pointer)); }},
    {"glGetIntegerv", "GetIntegerv", "H09", false, Listing::never, 1 != 0, {arg_6, 2}, {},
     [](const Value* a) { glGetIntegerv(GLenum(a[0].integer), static_cast<GLint*>(a[1].pointer)); }},
    {"glGetFloatv", "GetFloatv", "H09", false, Listing::never, 1 != 0, {arg_7, 2}, {},
     [](const Value* a) { glGetFloatv(GLenum(a[0].integer), static_cast<GLfloat*>(a[1].pointer)); }},
    {"glGetDoublev", "GetDoublev", "H09", false, Listing::never, 1 != 0, {arg_8, 2}, {},
     [](const Value* a) { glGetDoublev(GLenum(a[0].integer), static_cast<GLdouble*>(a[1].pointer)); }},
    {"glGetFixedvOES", "GetFixedvOES", "H09", false, Listing::never, 1 != 0, {arg_9, 2}, {},
     [](const Value* a) { glGetFixedvOES(GLenum(a[0].integer), static_cast<GLfixed*>(a[1].pointer)); }},
    {"glGetPointerv", "GetPointerv", "H10", false, Listing::never, 1 != 0, {arg_11, 2}, {},
     [](const Value* a) { glGetPointerv(GLenum(a[0].integer), static_cast<void**>(a[1].pointer)); }},
    {"glGetString", "GetString", "H11", false, Listing::never, 1 != 0, {arg_13, 1}, {},
     [](const Value* a) { glGetString(GLenum(a[0].integer)); }},
    {"glBegin", "Begin", "B01", false, Listing::words, 1 != 0, {arg_15, 1}, {},
     [](const Value* a) { glBegin(GLenum(a[0].integer)); }},
    {"glEnd", "End", "B01", true, Listing::words, 1 != 0, {}, {},
     [](const Value* ) { glEnd(); }},
    {"glVertex2s", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_16, 2}, {},
     [](const Value* a) { glVertex2s(GLshort(a[0].number), GLshort(a[1].number)); }},
    {"glVertex2sv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_17, 1}, {},
     [](const Value* a) { glVertex2sv(static_cast<const GLshort*>(a[0].pointer)); }},
    {"glVertex2i", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_18, 2}, {},
     [](const Value* a) { glVertex2i(GLint(a[0].number), GLint(a[1].number)); }},
    {"glVertex2iv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_19, 1}, {},
     [](const Value* a) { glVertex2iv(static_cast<const GLint*>(a[0].pointer)); }},
    {"glVertex2f", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_20, 2}, {},
     [](const Value* a) { glVertex2f(GLfloat(a[0].number), GLfloat(a[1].number)); }},
    {"glVertex2fv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glVertex2fv(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glVertex2d", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_22, 2}, {},
     [](const Value* a) { glVertex2d(GLdouble(a[0].number), GLdouble(a[1].number)); }},
    {"glVertex2dv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glVertex2dv(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glVertex2xOES", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_24, 2}, {},
     [](const Value* a) { glVertex2xOES(GLfixed(a[0].number), GLfixed(a[1].number)); }},
    {"glVertex2xvOES", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glVertex2xvOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glVertex3s", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_26, 3}, {},
     [](const Value* a) { glVertex3s(GLshort(a[0].number), GLshort(a[1].number), GLshort(a[2].number)); }},
    {"glVertex3sv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_17, 1}, {},
     [](const Value* a) { glVertex3sv(static_cast<const GLshort*>(a[0].pointer)); }},
    {"glVertex3i", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_27, 3}, {},
     [](const Value* a) { glVertex3i(GLint(a[0].number), GLint(a[1].number), GLint(a[2].number)); }},
    {"glVertex3iv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_19, 1}, {},
     [](const Value* a) { glVertex3iv(static_cast<const GLint*>(a[0].pointer)); }},
    {"glVertex3f", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_28, 3}, {},
     [](const Value* a) { glVertex3f(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number)); }},
    {"glVertex3fv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glVertex3fv(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glVertex3d", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_29, 3}, {},
     [](const Value* a) { glVertex3d(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number)); }},
    {"glVertex3dv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glVertex3dv(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glVertex3xOES", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_30, 3}, {},
     [](const Value* a) { glVertex3xOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number)); }},
    {"glVertex3xvOES", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glVertex3xvOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glVertex4s", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_31, 4}, {},
     [](const Value* a) { glVertex4s(GLshort(a[0].number), GLshort(a[1].number), GLshort(a[2].number), GLshort(a[3].number)); }},
    {"glVertex4sv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_17, 1}, {},
     [](const Value* a) { glVertex4sv(static_cast<const GLshort*>(a[0].pointer)); }},
    {"glVertex4i", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_32, 4}, {},
     [](const Value* a) { glVertex4i(GLint(a[0].number), GLint(a[1].number), GLint(a[2].number), GLint(a[3].number)); }},
    {"glVertex4iv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_19, 1}, {},
     [](const Value* a) { glVertex4iv(static_cast<const GLint*>(a[0].pointer)); }},
    {"glVertex4f", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_33, 4}, {},
     [](const Value* a) { glVertex4f(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number), GLfloat(a[3].number)); }},
    {"glVertex4fv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glVertex4fv(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glVertex4d", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_34, 4}, {},
     [](const Value* a) { glVertex4d(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number), GLdouble(a[3].number)); }},
    {"glVertex4dv", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glVertex4dv(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glVertex4xOES", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_35, 4}, {},
     [](const Value* a) { glVertex4xOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number), GLfixed(a[3].number)); }},
    {"glVertex4xvOES", "Vertex", "B04", true, Listing::attribute, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glVertex4xvOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glTexCoord1s", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_36, 1}, {},
     [](const Value* a) { glTexCoord1s(GLshort(a[0].number)); }},
    {"glTexCoord1sv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_17, 1}, {},
     [](const Value* a) { glTexCoord1sv(static_cast<const GLshort*>(a[0].pointer)); }},
    {"glTexCoord1i", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_37, 1}, {},
     [](const Value* a) { glTexCoord1i(GLint(a[0].number)); }},
    {"glTexCoord1iv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_19, 1}, {},
     [](const Value* a) { glTexCoord1iv(static_cast<const GLint*>(a[0].pointer)); }},
    {"glTexCoord1f", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_38, 1}, {},
     [](const Value* a) { glTexCoord1f(GLfloat(a[0].number)); }},
    {"glTexCoord1fv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glTexCoord1fv(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glTexCoord1d", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_39, 1}, {},
     [](const Value* a) { glTexCoord1d(GLdouble(a[0].number)); }},
    {"glTexCoord1dv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glTexCoord1dv(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glTexCoord1xOES", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_40, 1}, {},
     [](const Value* a) { glTexCoord1xOES(GLfixed(a[0].number)); }},
    {"glTexCoord1xvOES", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glTexCoord1xvOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glTexCoord2s", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_16, 2}, {},
     [](const Value* a) { glTexCoord2s(GLshort(a[0].number), GLshort(a[1].number)); }},
    {"glTexCoord2sv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_17, 1}, {},
     [](const Value* a) { glTexCoord2sv(static_cast<const GLshort*>(a[0].pointer)); }},
    {"glTexCoord2i", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_18, 2}, {},
     [](const Value* a) { glTexCoord2i(GLint(a[0].number), GLint(a[1].number)); }},
    {"glTexCoord2iv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_19, 1}, {},
     [](const Value* a) { glTexCoord2iv(static_cast<const GLint*>(a[0].pointer)); }},
    {"glTexCoord2f", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_20, 2}, {},
     [](const Value* a) { glTexCoord2f(GLfloat(a[0].number), GLfloat(a[1].number)); }},
    {"glTexCoord2fv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glTexCoord2fv(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glTexCoord2d", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_22, 2}, {},
     [](const Value* a) { glTexCoord2d(GLdouble(a[0].number), GLdouble(a[1].number)); }},
    {"glTexCoord2dv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glTexCoord2dv(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glTexCoord2xOES", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_24, 2}, {},
     [](const Value* a) { glTexCoord2xOES(GLfixed(a[0].number), GLfixed(a[1].number)); }},
    {"glTexCoord2xvOES", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glTexCoord2xvOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glTexCoord3s", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_26, 3}, {},
     [](const Value* a) { glTexCoord3s(GLshort(a[0].number), GLshort(a[1].number), GLshort(a[2].number)); }},
    {"glTexCoord3sv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_17, 1}, {},
     [](const Value* a) { glTexCoord3sv(static_cast<const GLshort*>(a[0].pointer)); }},
    {"glTexCoord3i", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_27, 3}, {},
     [](const Value* a) { glTexCoord3i(GLint(a[0].number), GLint(a[1].number), GLint(a[2].number)); }},
    {"glTexCoord3iv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_19, 1}, {},
     [](const Value* a) { glTexCoord3iv(static_cast<const GLint*>(a[0].pointer)); }},
    {"glTexCoord3f", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_28, 3}, {},
     [](const Value* a) { glTexCoord3f(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number)); }},
    {"glTexCoord3fv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glTexCoord3fv(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glTexCoord3d", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_29, 3}, {},
     [](const Value* a) { glTexCoord3d(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number)); }},
    {"glTexCoord3dv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glTexCoord3dv(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glTexCoord3xOES", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_30, 3}, {},
     [](const Value* a) { glTexCoord3xOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number)); }},
    {"glTexCoord3xvOES", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glTexCoord3xvOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glTexCoord4s", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_31, 4}, {},
     [](const Value* a) { glTexCoord4s(GLshort(a[0].number), GLshort(a[1].number), GLshort(a[2].number), GLshort(a[3].number)); }},
    {"glTexCoord4sv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_17, 1}, {},
     [](const Value* a) { glTexCoord4sv(static_cast<const GLshort*>(a[0].pointer)); }},
    {"glTexCoord4i", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_32, 4}, {},
     [](const Value* a) { glTexCoord4i(GLint(a[0].number), GLint(a[1].number), GLint(a[2].number), GLint(a[3].number)); }},
    {"glTexCoord4iv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_19, 1}, {},
     [](const Value* a) { glTexCoord4iv(static_cast<const GLint*>(a[0].pointer)); }},
    {"glTexCoord4f", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_33, 4}, {},
     [](const Value* a) { glTexCoord4f(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number), GLfloat(a[3].number)); }},
    {"glTexCoord4fv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glTexCoord4fv(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glTexCoord4d", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_34, 4}, {},
     [](const Value* a) { glTexCoord4d(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number), GLdouble(a[3].number)); }},
    {"glTexCoord4dv", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glTexCoord4dv(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glTexCoord4xOES", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_35, 4}, {},
     [](const Value* a) { glTexCoord4xOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number), GLfixed(a[3].number)); }},
    {"glTexCoord4xvOES", "TexCoord", "B05", true, Listing::attribute, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glTexCoord4xvOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glNormal3b", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_41, 3}, {},
     [](const Value* a) { glNormal3b(GLbyte(a[0].number), GLbyte(a[1].number), GLbyte(a[2].number)); }},
    {"glNormal3bv", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_42, 1}, {},
     [](const Value* a) { glNormal3bv(static_cast<const GLbyte*>(a[0].pointer)); }},
    {"glNormal3s", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_26, 3}, {},
     [](const Value* a) { glNormal3s(GLshort(a[0].number), GLshort(a[1].number), GLshort(a[2].number)); }},
    {"glNormal3sv", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_17, 1}, {},
     [](const Value* a) { glNormal3sv(static_cast<const GLshort*>(a[0].pointer)); }},
    {"glNormal3i", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_27, 3}, {},
     [](const Value* a) { glNormal3i(GLint(a[0].number), GLint(a[1].number), GLint(a[2].number)); }},
    {"glNormal3iv", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_19, 1}, {},
     [](const Value* a) { glNormal3iv(static_cast<const GLint*>(a[0].pointer)); }},
    {"glNormal3f", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_28, 3}, {},
     [](const Value* a) { glNormal3f(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number)); }},
    {"glNormal3fv", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glNormal3fv(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glNormal3d", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_29, 3}, {},
     [](const Value* a) { glNormal3d(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number)); }},
    {"glNormal3dv", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glNormal3dv(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glNormal3xOES", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_30, 3}, {},
     [](const Value* a) { glNormal3xOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number)); }},
    {"glNormal3xvOES", "Normal", "B06", true, Listing::attribute, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glNormal3xvOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glColor3b", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_41, 3}, {},
     [](const Value* a) { glColor3b(GLbyte(a[0].number), GLbyte(a[1].number), GLbyte(a[2].number)); }},
    {"glColor3bv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_42, 1}, {},
     [](const Value* a) { glColor3bv(static_cast<const GLbyte*>(a[0].pointer)); }},
    {"glColor3s", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_26, 3}, {},
     [](const Value* a) { glColor3s(GLshort(a[0].number), GLshort(a[1].number), GLshort(a[2].number)); }},
    {"glColor3sv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_17, 1}, {},
     [](const Value* a) { glColor3sv(static_cast<const GLshort*>(a[0].pointer)); }},
    {"glColor3i", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_27, 3}, {},
     [](const Value* a) { glColor3i(GLint(a[0].number), GLint(a[1].number), GLint(a[2].number)); }},
    {"glColor3iv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_19, 1}, {},
     [](const Value* a) { glColor3iv(static_cast<const GLint*>(a[0].pointer)); }},
    {"glColor3f", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_28, 3}, {},
     [](const Value* a) { glColor3f(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number)); }},
    {"glColor3fv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glColor3fv(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glColor3d", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_29, 3}, {},
     [](const Value* a) { glColor3d(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number)); }},
    {"glColor3dv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glColor3dv(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glColor3ub", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_43, 3}, {},
     [](const Value* a) { glColor3ub(GLubyte(a[0].number), GLubyte(a[1].number), GLubyte(a[2].number)); }},
    {"glColor3ubv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_44, 1}, {},
     [](const Value* a) { glColor3ubv(static_cast<const GLubyte*>(a[0].pointer)); }},
    {"glColor3us", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_45, 3}, {},
     [](const Value* a) { glColor3us(GLushort(a[0].number), GLushort(a[1].number), GLushort(a[2].number)); }},
    {"glColor3usv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_46, 1}, {},
     [](const Value* a) { glColor3usv(static_cast<const GLushort*>(a[0].pointer)); }},
    {"glColor3ui", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_47, 3}, {},
     [](const Value* a) { glColor3ui(GLuint(a[0].number), GLuint(a[1].number), GLuint(a[2].number)); }},
    {"glColor3uiv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_48, 1}, {},
     [](const Value* a) { glColor3uiv(static_cast<const GLuint*>(a[0].pointer)); }},
    {"glColor3xOES", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_30, 3}, {},
     [](const Value* a) { glColor3xOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number)); }},
    {"glColor3xvOES", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glColor3xvOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glColor4b", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_49, 4}, {},
     [](const Value* a) { glColor4b(GLbyte(a[0].number), GLbyte(a[1].number), GLbyte(a[2].number), GLbyte(a[3].number)); }},
    {"glColor4bv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_42, 1}, {},
     [](const Value* a) { glColor4bv(static_cast<const GLbyte*>(a[0].pointer)); }},
    {"glColor4s", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_31, 4}, {},
     [](const Value* a) { glColor4s(GLshort(a[0].number), GLshort(a[1].number), GLshort(a[2].number), GLshort(a[3].number)); }},
    {"glColor4sv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_17, 1}, {},
     [](const Value* a) { glColor4sv(static_cast<const GLshort*>(a[0].pointer)); }},
    {"glColor4i", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_32, 4}, {},
     [](const Value* a) { glColor4i(GLint(a[0].number), GLint(a[1].number), GLint(a[2].number), GLint(a[3].number)); }},
    {"glColor4iv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_19, 1}, {},
     [](const Value* a) { glColor4iv(static_cast<const GLint*>(a[0].pointer)); }},
    {"glColor4f", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_33, 4}, {},
     [](const Value* a) { glColor4f(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number), GLfloat(a[3].number)); }},
    {"glColor4fv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glColor4fv(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glColor4d", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_34, 4}, {},
     [](const Value* a) { glColor4d(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number), GLdouble(a[3].number)); }},
    {"glColor4dv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glColor4dv(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glColor4ub", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_50, 4}, {},
     [](const Value* a) { glColor4ub(GLubyte(a[0].number), GLubyte(a[1].number), GLubyte(a[2].number), GLubyte(a[3].number)); }},
    {"glColor4ubv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_44, 1}, {},
     [](const Value* a) { glColor4ubv(static_cast<const GLubyte*>(a[0].pointer)); }},
    {"glColor4us", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_51, 4}, {},
     [](const Value* a) { glColor4us(GLushort(a[0].number), GLushort(a[1].number), GLushort(a[2].number), GLushort(a[3].number)); }},
    {"glColor4usv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_46, 1}, {},
     [](const Value* a) { glColor4usv(static_cast<const GLushort*>(a[0].pointer)); }},
    {"glColor4ui", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_52, 4}, {},
     [](const Value* a) { glColor4ui(GLuint(a[0].number), GLuint(a[1].number), GLuint(a[2].number), GLuint(a[3].number)); }},
    {"glColor4uiv", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_48, 1}, {},
     [](const Value* a) { glColor4uiv(static_cast<const GLuint*>(a[0].pointer)); }},
    {"glColor4xOES", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_35, 4}, {},
     [](const Value* a) { glColor4xOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number), GLfixed(a[3].number)); }},
    {"glColor4xvOES", "Color", "B07", true, Listing::attribute, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glColor4xvOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glRects", "Rect", "B19", false, Listing::words, 1 != 0, {arg_31, 4}, {},
     [](const Value* a) { glRects(GLshort(a[0].number), GLshort(a[1].number), GLshort(a[2].number), GLshort(a[3].number)); }},
    {"glRectsv", "Rect", "B19", false, Listing::words, 1 != 0, {arg_53, 2}, {},
     [](const Value* a) { glRectsv(static_cast<const GLshort*>(a[0].pointer), static_cast<const GLshort*>(a[1].pointer)); }},
    {"glRecti", "Rect", "B19", false, Listing::words, 1 != 0, {arg_32, 4}, {},
     [](const Value* a) { glRecti(GLint(a[0].number), GLint(a[1].number), GLint(a[2].number), GLint(a[3].number)); }},
    {"glRectiv", "Rect", "B19", false, Listing::words, 1 != 0, {arg_54, 2}, {},
     [](const Value* a) { glRectiv(static_cast<const GLint*>(a[0].pointer), static_cast<const GLint*>(a[1].pointer)); }},
    {"glRectf", "Rect", "B19", false, Listing::words, 1 != 0, {arg_33, 4}, {},
     [](const Value* a) { glRectf(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number), GLfloat(a[3].number)); }},
    {"glRectfv", "Rect", "B19", false, Listing::words, 1 != 0, {arg_55, 2}, {},
     [](const Value* a) { glRectfv(static_cast<const GLfloat*>(a[0].pointer), static_cast<const GLfloat*>(a[1].pointer)); }},
    {"glRectd", "Rect", "B19", false, Listing::words, 1 != 0, {arg_34, 4}, {},
     [](const Value* a) { glRectd(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number), GLdouble(a[3].number)); }},
    {"glRectdv", "Rect", "B19", false, Listing::words, 1 != 0, {arg_56, 2}, {},
     [](const Value* a) { glRectdv(static_cast<const GLdouble*>(a[0].pointer), static_cast<const GLdouble*>(a[1].pointer)); }},
    {"glRectxOES", "Rect", "B19", false, Listing::words, 1 != 0, {arg_35, 4}, {},
     [](const Value* a) { glRectxOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number), GLfixed(a[3].number)); }},
    {"glRectxvOES", "Rect", "B19", false, Listing::words, 1 != 0, {arg_57, 2}, {},
     [](const Value* a) { glRectxvOES(static_cast<const GLfixed*>(a[0].pointer), static_cast<const GLfixed*>(a[1].pointer)); }},
    {"glVertexPointer", "VertexPointer", "B12", false, Listing::never, 1 != 0, {arg_59, 4}, {},
     [](const Value* a) { glVertexPointer(GLint(a[0].integer), GLenum(a[1].integer), GLsizei(a[2].integer), static_cast<const void*>(a[3].pointer)); }},
    {"glNormalPointer", "NormalPointer", "B12", false, Listing::never, 1 != 0, {arg_61, 3}, {},
     [](const Value* a) { glNormalPointer(GLenum(a[0].integer), GLsizei(a[1].integer), static_cast<const void*>(a[2].pointer)); }},
    {"glColorPointer", "ColorPointer", "B12", false, Listing::never, 1 != 0, {arg_63, 4}, {},
     [](const Value* a) { glColorPointer(GLint(a[0].integer), GLenum(a[1].integer), GLsizei(a[2].integer), static_cast<const void*>(a[3].pointer)); }},
    {"glTexCoordPointer", "TexCoordPointer", "B12", false, Listing::never, 1 != 0, {arg_64, 4}, {},
     [](const Value* a) { glTexCoordPointer(GLint(a[0].integer), GLenum(a[1].integer), GLsizei(a[2].integer), static_cast<const void*>(a[3].pointer)); }},
    {"glEnableClientState", "EnableClientState", "B12", false, Listing::never, 1 != 0, {arg_66, 1}, {},
     [](const Value* a) { glEnableClientState(GLenum(a[0].integer)); }},
    {"glDisableClientState", "DisableClientState", "B12", false, Listing::never, 1 != 0, {arg_66, 1}, {},
     [](const Value* a) { glDisableClientState(GLenum(a[0].integer)); }},
    {"glArrayElement", "ArrayElement", "B13", true, Listing::client_data, 1 != 0, {arg_67, 1}, {},
     [](const Value* a) { glArrayElement(GLint(a[0].integer)); }},
    {"glDrawArrays", "DrawArrays", "B13", false, Listing::client_data, 1 != 0, {arg_68, 3}, {},
     [](const Value* a) { glDrawArrays(GLenum(a[0].integer), GLint(a[1].integer), GLsizei(a[2].integer)); }},
    {"glDrawElements", "DrawElements", "B13", false, Listing::client_data, 1 != 0, {arg_70, 4}, {},
     [](const Value* a) { glDrawElements(GLenum(a[0].integer), GLsizei(a[1].integer), GLenum(a[2].integer), static_cast<const void*>(a[3].pointer)); }},
    {"glDrawRangeElements", "DrawRangeElements", "B13", false, Listing::client_data, 1 != 0, {arg_71, 6}, {},
     [](const Value* a) { glDrawRangeElements(GLenum(a[0].integer), GLuint(a[1].integer), GLuint(a[2].integer), GLsizei(a[3].integer), GLenum(a[4].integer), static_cast<const void*>(a[5].pointer)); }},
    {"glInterleavedArrays", "InterleavedArrays", "B14", false, Listing::never, 1 != 0, {arg_73, 3}, {},
     [](const Value* a) { glInterleavedArrays(GLenum(a[0].integer), GLsizei(a[1].integer), static_cast<const void*>(a[2].pointer)); }},
    {"glMatrixMode", "MatrixMode", "C01", false, Listing::words, 1 != 0, {arg_75, 1}, {},
     [](const Value* a) { glMatrixMode(GLenum(a[0].integer)); }},
    {"glLoadIdentity", "LoadIdentity", "C01", false, Listing::words, 1 != 0, {}, {},
     [](const Value* ) { glLoadIdentity(); }},
    {"glLoadMatrixf", "LoadMatrix", "C01", false, Listing::words, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glLoadMatrixf(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glLoadMatrixd", "LoadMatrix", "C01", false, Listing::words, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glLoadMatrixd(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glLoadMatrixxOES", "LoadMatrix", "C01", false, Listing::words, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glLoadMatrixxOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glMultMatrixf", "MultMatrix", "C01", false, Listing::words, 1 != 0, {arg_21, 1}, {},
     [](const Value* a) { glMultMatrixf(static_cast<const GLfloat*>(a[0].pointer)); }},
    {"glMultMatrixd", "MultMatrix", "C01", false, Listing::words, 1 != 0, {arg_23, 1}, {},
     [](const Value* a) { glMultMatrixd(static_cast<const GLdouble*>(a[0].pointer)); }},
    {"glMultMatrixxOES", "MultMatrix", "C01", false, Listing::words, 1 != 0, {arg_25, 1}, {},
     [](const Value* a) { glMultMatrixxOES(static_cast<const GLfixed*>(a[0].pointer)); }},
    {"glPushMatrix", "PushMatrix", "C01", false, Listing::words, 1 != 0, {}, {},
     [](const Value* ) { glPushMatrix(); }},
    {"glPopMatrix", "PopMatrix", "C01", false, Listing::words, 1 != 0, {}, {},
     [](const Value* ) { glPopMatrix(); }},
    {"glRotatef", "Rotate", "C01", false, Listing::words, 1 != 0, {arg_33, 4}, {},
     [](const Value* a) { glRotatef(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number), GLfloat(a[3].number)); }},
    {"glRotated", "Rotate", "C01", false, Listing::words, 1 != 0, {arg_34, 4}, {},
     [](const Value* a) { glRotated(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number), GLdouble(a[3].number)); }},
    {"glRotatexOES", "Rotate", "C01", false, Listing::words, 1 != 0, {arg_35, 4}, {},
     [](const Value* a) { glRotatexOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number), GLfixed(a[3].number)); }},
    {"glTranslatef", "Translate", "C01", false, Listing::words, 1 != 0, {arg_28, 3}, {},
     [](const Value* a) { glTranslatef(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number)); }},
    {"glTranslated", "Translate", "C01", false, Listing::words, 1 != 0, {arg_29, 3}, {},
     [](const Value* a) { glTranslated(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number)); }},
    {"glTranslatexOES", "Translate", "C01", false, Listing::words, 1 != 0, {arg_30, 3}, {},
     [](const Value* a) { glTranslatexOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number)); }},
    {"glScalef", "Scale", "C01", false, Listing::words, 1 != 0, {arg_28, 3}, {},
     [](const Value* a) { glScalef(GLfloat(a[0].number), GLfloat(a[1].number), GLfloat(a[2].number)); }},
    {"glScaled", "Scale", "C01", false, Listing::words, 1 != 0, {arg_29, 3}, {},
     [](const Value* a) { glScaled(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number)); }},
    {"glScalexOES", "Scale", "C01", false, Listing::words, 1 != 0, {arg_30, 3}, {},
     [](const Value* a) { glScalexOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number)); }},
    {"glFrustum", "Frustum", "C01", false, Listing::words, 1 != 0, {arg_76, 6}, {},
     [](const Value* a) { glFrustum(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number), GLdouble(a[3].number), GLdouble(a[4].number), GLdouble(a[5].number)); }},
    {"glFrustumxOES", "Frustum", "C01", false, Listing::words, 1 != 0, {arg_77, 6}, {},
     [](const Value* a) { glFrustumxOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number), GLfixed(a[3].number), GLfixed(a[4].number), GLfixed(a[5].number)); }},
    {"glOrtho", "Ortho", "C01", false, Listing::words, 1 != 0, {arg_78, 6}, {},
     [](const Value* a) { glOrtho(GLdouble(a[0].number), GLdouble(a[1].number), GLdouble(a[2].number), GLdouble(a[3].number), GLdouble(a[4].number), GLdouble(a[5].number)); }},
    {"glOrthoxOES", "Ortho", "C01", false, Listing::words, 1 != 0, {arg_79, 6}, {},
     [](const Value* a) { glOrthoxOES(GLfixed(a[0].number), GLfixed(a[1].number), GLfixed(a[2].number), GLfixed(a[3].number), GLfixed(a[4].number), GLfixed(a[5].number)); }},
    {"glViewport", "Viewport", "C03", false, Listing::words, 1 != 0, {arg_80, 4}, {},
     [](const Value* a) { glViewport(GLint(a[0].integer), GLint(a[1].integer), GLsizei(a[2].integer), GLsizei(a[3].integer)); }},
    {"glDepthRange", "DepthRange", "C03", false, Listing::words, 1 != 0, {arg_81, 2}, {},
     [](const Value* a) { glDepthRange(GLclampd(a[0].number), GLclampd(a[1].number)); }},
    {"glDepthRangef", "DepthRange", "C03", false, Listing::words, 1 != 0, {arg_82, 2}, {},
     [](const Value* a) { glDepthRangef(GLclampf(a[0].number), GLclampf(a[1].number)); }},
    {"glDepthRangexOES", "DepthRange", "C03", false, Listing::words, 1 != 0, {arg_83, 2}, {},
     [](const Value* a) { glDepthRangexOES(GLclampx(a[0].number), GLclampx(a[1].number)); }},
    {"glLightf", "Light", "C07", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_86, 3}, {pname_84, 10},
     [](const Value* a) { glLightf(GLenum(a[0].integer), GLenum(a[1].integer), GLfloat(a[2].number)); }},
    {"glLightfv", "Light", "C07", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_87, 3}, {pname_84, 10},
     [](const Value* a) { glLightfv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLfloat*>(a[2].pointer)); }},
    {"glLighti", "Light", "C07", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_88, 3}, {pname_84, 10},
     [](const Value* a) { glLighti(GLenum(a[0].integer), GLenum(a[1].integer), GLint(a[2].number)); }},
    {"glLightiv", "Light", "C07", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_89, 3}, {pname_84, 10},
     [](const Value* a) { glLightiv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLint*>(a[2].pointer)); }},
    {"glLightxOES", "Light", "C07", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_90, 3}, {pname_84, 10},
     [](const Value* a) { glLightxOES(GLenum(a[0].integer), GLenum(a[1].integer), GLfixed(a[2].number)); }},
    {"glLightxvOES", "Light", "C07", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_91, 3}, {pname_84, 10},
     [](const Value* a) { glLightxvOES(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLfixed*>(a[2].pointer)); }},
    {"glGetLightfv", "GetLight", "H10", false, Listing::never, SPANGLE_FEATURE_LIGHTING != 0, {arg_92, 3}, {pname_84, 10},
     [](const Value* a) { glGetLightfv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLfloat*>(a[2].pointer)); }},
    {"glGetLightiv", "GetLight", "H10", false, Listing::never, SPANGLE_FEATURE_LIGHTING != 0, {arg_93, 3}, {pname_84, 10},
     [](const Value* a) { glGetLightiv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLint*>(a[2].pointer)); }},
    {"glGetLightxvOES", "GetLight", "H10", false, Listing::never, SPANGLE_FEATURE_LIGHTING != 0, {arg_94, 3}, {pname_84, 10},
     [](const Value* a) { glGetLightxvOES(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLfixed*>(a[2].pointer)); }},
    {"glLightModelf", "LightModel", "C08", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_96, 2}, {pname_95, 4},
     [](const Value* a) { glLightModelf(GLenum(a[0].integer), GLfloat(a[1].number)); }},
    {"glLightModelfv", "LightModel", "C08", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_97, 2}, {pname_95, 4},
     [](const Value* a) { glLightModelfv(GLenum(a[0].integer), static_cast<const GLfloat*>(a[1].pointer)); }},
    {"glLightModeli", "LightModel", "C08", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_98, 2}, {pname_95, 4},
     [](const Value* a) { glLightModeli(GLenum(a[0].integer), GLint(a[1].number)); }},
    {"glLightModeliv", "LightModel", "C08", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_99, 2}, {pname_95, 4},
     [](const Value* a) { glLightModeliv(GLenum(a[0].integer), static_cast<const GLint*>(a[1].pointer)); }},
    {"glLightModelxOES", "LightModel", "C08", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_100, 2}, {pname_95, 4},
     [](const Value* a) { glLightModelxOES(GLenum(a[0].integer), GLfixed(a[1].number)); }},
    {"glLightModelxvOES", "LightModel", "C08", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_101, 2}, {pname_95, 4},
     [](const Value* a) { glLightModelxvOES(GLenum(a[0].integer), static_cast<const GLfixed*>(a[1].pointer)); }},
    {"glMaterialf", "Material", "C08", true, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_104, 3}, {pname_102, 6},
     [](const Value* a) { glMaterialf(GLenum(a[0].integer), GLenum(a[1].integer), GLfloat(a[2].number)); }},
    {"glMaterialfv", "Material", "C08", true, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_105, 3}, {pname_102, 6},
     [](const Value* a) { glMaterialfv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLfloat*>(a[2].pointer)); }},
    {"glMateriali", "Material", "C08", true, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_106, 3}, {pname_102, 6},
     [](const Value* a) { glMateriali(GLenum(a[0].integer), GLenum(a[1].integer), GLint(a[2].number)); }},
    {"glMaterialiv", "Material", "C08", true, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_107, 3}, {pname_102, 6},
     [](const Value* a) { glMaterialiv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLint*>(a[2].pointer)); }},
    {"glMaterialxOES", "Material", "C08", true, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_108, 3}, {pname_102, 6},
     [](const Value* a) { glMaterialxOES(GLenum(a[0].integer), GLenum(a[1].integer), GLfixed(a[2].number)); }},
    {"glMaterialxvOES", "Material", "C08", true, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_109, 3}, {pname_102, 6},
     [](const Value* a) { glMaterialxvOES(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLfixed*>(a[2].pointer)); }},
    {"glGetMaterialfv", "GetMaterial", "H10", false, Listing::never, SPANGLE_FEATURE_LIGHTING != 0, {arg_112, 3}, {pname_110, 5},
     [](const Value* a) { glGetMaterialfv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLfloat*>(a[2].pointer)); }},
    {"glGetMaterialiv", "GetMaterial", "H10", false, Listing::never, SPANGLE_FEATURE_LIGHTING != 0, {arg_113, 3}, {pname_110, 5},
     [](const Value* a) { glGetMaterialiv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLint*>(a[2].pointer)); }},
    {"glGetMaterialxvOES", "GetMaterial", "H10", false, Listing::never, SPANGLE_FEATURE_LIGHTING != 0, {arg_114, 3}, {pname_110, 5},
     [](const Value* a) { glGetMaterialxvOES(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLfixed*>(a[2].pointer)); }},
    {"glColorMaterial", "ColorMaterial", "C10", false, Listing::words, SPANGLE_FEATURE_LIGHTING != 0, {arg_116, 2}, {},
     [](const Value* a) { glColorMaterial(GLenum(a[0].integer), GLenum(a[1].integer)); }},
    {"glShadeModel", "ShadeModel", "C12", false, Listing::words, 1 != 0, {arg_118, 1}, {},
     [](const Value* a) { glShadeModel(GLenum(a[0].integer)); }},
    {"glFrontFace", "FrontFace", "D09", false, Listing::words, 1 != 0, {arg_120, 1}, {},
     [](const Value* a) { glFrontFace(GLenum(a[0].integer)); }},
    {"glCullFace", "CullFace", "D09", false, Listing::words, 1 != 0, {arg_121, 1}, {},
     [](const Value* a) { glCullFace(GLenum(a[0].integer)); }},
    {"glPointSize", "PointSize", "D01", false, Listing::words, 1 != 0, {arg_122, 1}, {},
     [](const Value* a) { glPointSize(GLfloat(a[0].number)); }},
    {"glPointSizexOES", "PointSize", "D01", false, Listing::words, 1 != 0, {arg_123, 1}, {},
     [](const Value* a) { glPointSizexOES(GLfixed(a[0].number)); }},
    {"glLineWidth", "LineWidth", "D05", false, Listing::words, 1 != 0, {arg_122, 1}, {},
     [](const Value* a) { glLineWidth(GLfloat(a[0].number)); }},
    {"glLineWidthxOES", "LineWidth", "D05", false, Listing::words, 1 != 0, {arg_123, 1}, {},
     [](const Value* a) { glLineWidthxOES(GLfixed(a[0].number)); }},
    {"glScissor", "Scissor", "G04", false, Listing::words, 1 != 0, {arg_80, 4}, {},
     [](const Value* a) { glScissor(GLint(a[0].integer), GLint(a[1].integer), GLsizei(a[2].integer), GLsizei(a[3].integer)); }},
    {"glAlphaFunc", "AlphaFunc", "G06", false, Listing::words, 1 != 0, {arg_125, 2}, {},
     [](const Value* a) { glAlphaFunc(GLenum(a[0].integer), GLclampf(a[1].number)); }},
    {"glAlphaFuncxOES", "AlphaFunc", "G06", false, Listing::words, 1 != 0, {arg_126, 2}, {},
     [](const Value* a) { glAlphaFuncxOES(GLenum(a[0].integer), GLclampx(a[1].number)); }},
    {"glStencilFunc", "StencilFunc", "G07", false, Listing::words, 1 != 0, {arg_127, 3}, {},
     [](const Value* a) { glStencilFunc(GLenum(a[0].integer), GLint(a[1].integer), GLuint(a[2].integer)); }},
    {"glStencilOp", "StencilOp", "G07", false, Listing::words, 1 != 0, {arg_129, 3}, {},
     [](const Value* a) { glStencilOp(GLenum(a[0].integer), GLenum(a[1].integer), GLenum(a[2].integer)); }},
    {"glDepthFunc", "DepthFunc", "G09", false, Listing::words, 1 != 0, {arg_130, 1}, {},
     [](const Value* a) { glDepthFunc(GLenum(a[0].integer)); }},
    {"glBlendFunc", "BlendFunc", "G10", false, Listing::words, 1 != 0, {arg_133, 2}, {},
     [](const Value* a) { glBlendFunc(GLenum(a[0].integer), GLenum(a[1].integer)); }},
    {"glDrawBuffer", "DrawBuffer", "G17", false, Listing::words, 1 != 0, {arg_135, 1}, {},
     [](const Value* a) { glDrawBuffer(GLenum(a[0].integer)); }},
    {"glReadBuffer", "ReadBuffer", "E07", false, Listing::words, 1 != 0, {arg_137, 1}, {},
     [](const Value* a) { glReadBuffer(GLenum(a[0].integer)); }},
    {"glColorMask", "ColorMask", "G19", false, Listing::words, 1 != 0, {arg_138, 4}, {},
     [](const Value* a) { glColorMask(GLboolean(a[0].integer), GLboolean(a[1].integer), GLboolean(a[2].integer), GLboolean(a[3].integer)); }},
    {"glDepthMask", "DepthMask", "G19", false, Listing::words, 1 != 0, {arg_139, 1}, {},
     [](const Value* a) { glDepthMask(GLboolean(a[0].integer)); }},
    {"glStencilMask", "StencilMask", "G19", false, Listing::words, 1 != 0, {arg_140, 1}, {},
     [](const Value* a) { glStencilMask(GLuint(a[0].integer)); }},
    {"glClear", "Clear", "G20", false, Listing::words, 1 != 0, {arg_142, 1}, {},
     [](const Value* a) { glClear(GLbitfield(a[0].integer)); }},
    {"glClearColor", "ClearColor", "G20", false, Listing::words, 1 != 0, {arg_143, 4}, {},
     [](const Value* a) { glClearColor(GLclampf(a[0].number), GLclampf(a[1].number), GLclampf(a[2].number), GLclampf(a[3].number)); }},
    {"glClearColorxOES", "ClearColor", "G20", false, Listing::words, 1 != 0, {arg_144, 4}, {},
     [](const Value* a) { glClearColorxOES(GLclampx(a[0].number), GLclampx(a[1].number), GLclampx(a[2].number), GLclampx(a[3].number)); }},
    {"glClearDepth", "ClearDepth", "G20", false, Listing::words, 1 != 0, {arg_145, 1}, {},
     [](const Value* a) { glClearDepth(GLclampd(a[0].number)); }},
    {"glClearDepthf", "ClearDepth", "G20", false, Listing::words, 1 != 0, {arg_146, 1}, {},
     [](const Value* a) { glClearDepthf(GLclampf(a[0].number)); }},
    {"glClearDepthxOES", "ClearDepth", "G20", false, Listing::words, 1 != 0, {arg_147, 1}, {},
     [](const Value* a) { glClearDepthxOES(GLclampx(a[0].number)); }},
    {"glClearStencil", "ClearStencil", "G20", false, Listing::words, 1 != 0, {arg_148, 1}, {},
     [](const Value* a) { glClearStencil(GLint(a[0].integer)); }},
    {"glPixelStoref", "PixelStore", "E01", false, Listing::never, 1 != 0, {arg_96, 2}, {pname_149, 16},
     [](const Value* a) { glPixelStoref(GLenum(a[0].integer), GLfloat(a[1].number)); }},
    {"glPixelStorei", "PixelStore", "E01", false, Listing::never, 1 != 0, {arg_98, 2}, {pname_149, 16},
     [](const Value* a) { glPixelStorei(GLenum(a[0].integer), GLint(a[1].number)); }},
    {"glReadPixels", "ReadPixels", "E07", false, Listing::never, 1 != 0, {arg_152, 7}, {},
     [](const Value* a) { glReadPixels(GLint(a[0].integer), GLint(a[1].integer), GLsizei(a[2].integer), GLsizei(a[3].integer), GLenum(a[4].integer), GLenum(a[5].integer), static_cast<void*>(a[6].pointer)); }},
    {"glFogf", "Fog", "G02", false, Listing::words, SPANGLE_FEATURE_FOG != 0, {arg_96, 2}, {pname_153, 5},
     [](const Value* a) { glFogf(GLenum(a[0].integer), GLfloat(a[1].number)); }},
    {"glFogfv", "Fog", "G02", false, Listing::words, SPANGLE_FEATURE_FOG != 0, {arg_97, 2}, {pname_153, 5},
     [](const Value* a) { glFogfv(GLenum(a[0].integer), static_cast<const GLfloat*>(a[1].pointer)); }},
    {"glFogi", "Fog", "G02", false, Listing::words, SPANGLE_FEATURE_FOG != 0, {arg_98, 2}, {pname_153, 5},
     [](const Value* a) { glFogi(GLenum(a[0].integer), GLint(a[1].number)); }},
    {"glFogiv", "Fog", "G02", false, Listing::words, SPANGLE_FEATURE_FOG != 0, {arg_99, 2}, {pname_153, 5},
     [](const Value* a) { glFogiv(GLenum(a[0].integer), static_cast<const GLint*>(a[1].pointer)); }},
    {"glFogxOES", "Fog", "G02", false, Listing::words, SPANGLE_FEATURE_FOG != 0, {arg_100, 2}, {pname_153, 5},
     [](const Value* a) { glFogxOES(GLenum(a[0].integer), GLfixed(a[1].number)); }},
    {"glFogxvOES", "Fog", "G02", false, Listing::words, SPANGLE_FEATURE_FOG != 0, {arg_101, 2}, {pname_153, 5},
     [](const Value* a) { glFogxvOES(GLenum(a[0].integer), static_cast<const GLfixed*>(a[1].pointer)); }},
    {"glHint", "Hint", "H08", false, Listing::words, 1 != 0, {arg_156, 2}, {},
     [](const Value* a) { glHint(GLenum(a[0].integer), GLenum(a[1].integer)); }},
    {"glFlush", "Flush", "H06", false, Listing::never, 1 != 0, {}, {},
     [](const Value* ) { glFlush(); }},
    {"glFinish", "Finish", "H06", false, Listing::never, 1 != 0, {}, {},
     [](const Value* ) { glFinish(); }},
    {"glTexImage2D", "TexImage2D", "F01", false, Listing::client_data, 1 != 0, {arg_161, 9}, {},
     [](const Value* a) { glTexImage2D(GLenum(a[0].integer), GLint(a[1].integer), GLint(a[2].integer), GLsizei(a[3].integer), GLsizei(a[4].integer), GLint(a[5].integer), GLenum(a[6].integer), GLenum(a[7].integer), static_cast<const void*>(a[8].pointer)); }},
    {"glTexSubImage2D", "TexSubImage2D", "F05", false, Listing::client_data, 1 != 0, {arg_163, 9}, {},
     [](const Value* a) { glTexSubImage2D(GLenum(a[0].integer), GLint(a[1].integer), GLint(a[2].integer), GLint(a[3].integer), GLsizei(a[4].integer), GLsizei(a[5].integer), GLenum(a[6].integer), GLenum(a[7].integer), static_cast<const void*>(a[8].pointer)); }},
    {"glGenTextures", "GenTextures", "F16", false, Listing::never, 1 != 0, {arg_164, 2}, {},
     [](const Value* a) { glGenTextures(GLsizei(a[0].integer), static_cast<GLuint*>(a[1].pointer)); }},
    {"glDeleteTextures", "DeleteTextures", "F16", false, Listing::never, 1 != 0, {arg_165, 2}, {},
     [](const Value* a) { glDeleteTextures(GLsizei(a[0].integer), static_cast<const GLuint*>(a[1].pointer)); }},
    {"glBindTexture", "BindTexture", "F16", false, Listing::words, 1 != 0, {arg_166, 2}, {},
     [](const Value* a) { glBindTexture(GLenum(a[0].integer), GLuint(a[1].integer)); }},
    {"glIsTexture", "IsTexture", "F16", false, Listing::never, 1 != 0, {arg_140, 1}, {},
     [](const Value* a) { glIsTexture(GLuint(a[0].integer)); }},
    {"glTexParameterf", "TexParameter", "F09", false, Listing::words, 1 != 0, {arg_168, 3}, {pname_167, 10},
     [](const Value* a) { glTexParameterf(GLenum(a[0].integer), GLenum(a[1].integer), GLfloat(a[2].number)); }},
    {"glTexParameterfv", "TexParameter", "F09", false, Listing::words, 1 != 0, {arg_169, 3}, {pname_167, 10},
     [](const Value* a) { glTexParameterfv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLfloat*>(a[2].pointer)); }},
    {"glTexParameteri", "TexParameter", "F09", false, Listing::words, 1 != 0, {arg_170, 3}, {pname_167, 10},
     [](const Value* a) { glTexParameteri(GLenum(a[0].integer), GLenum(a[1].integer), GLint(a[2].number)); }},
    {"glTexParameteriv", "TexParameter", "F09", false, Listing::words, 1 != 0, {arg_171, 3}, {pname_167, 10},
     [](const Value* a) { glTexParameteriv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLint*>(a[2].pointer)); }},
    {"glTexParameterxOES", "TexParameter", "F09", false, Listing::words, 1 != 0, {arg_172, 3}, {pname_167, 10},
     [](const Value* a) { glTexParameterxOES(GLenum(a[0].integer), GLenum(a[1].integer), GLfixed(a[2].number)); }},
    {"glTexParameterxvOES", "TexParameter", "F09", false, Listing::words, 1 != 0, {arg_173, 3}, {pname_167, 10},
     [](const Value* a) { glTexParameterxvOES(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLfixed*>(a[2].pointer)); }},
    {"glGetTexParameterfv", "GetTexParameter", "F09", false, Listing::never, 1 != 0, {arg_175, 3}, {pname_174, 11},
     [](const Value* a) { glGetTexParameterfv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLfloat*>(a[2].pointer)); }},
    {"glGetTexParameteriv", "GetTexParameter", "F09", false, Listing::never, 1 != 0, {arg_176, 3}, {pname_174, 11},
     [](const Value* a) { glGetTexParameteriv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLint*>(a[2].pointer)); }},
    {"glGetTexParameterxvOES", "GetTexParameter", "F09", false, Listing::never, 1 != 0, {arg_177, 3}, {pname_174, 11},
     [](const Value* a) { glGetTexParameterxvOES(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLfixed*>(a[2].pointer)); }},
    {"glTexEnvf", "TexEnv", "F18", false, Listing::words, 1 != 0, {arg_180, 3}, {pname_178, 2},
     [](const Value* a) { glTexEnvf(GLenum(a[0].integer), GLenum(a[1].integer), GLfloat(a[2].number)); }},
    {"glTexEnvfv", "TexEnv", "F18", false, Listing::words, 1 != 0, {arg_181, 3}, {pname_178, 2},
     [](const Value* a) { glTexEnvfv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLfloat*>(a[2].pointer)); }},
    {"glTexEnvi", "TexEnv", "F18", false, Listing::words, 1 != 0, {arg_182, 3}, {pname_178, 2},
     [](const Value* a) { glTexEnvi(GLenum(a[0].integer), GLenum(a[1].integer), GLint(a[2].number)); }},
    {"glTexEnviv", "TexEnv", "F18", false, Listing::words, 1 != 0, {arg_183, 3}, {pname_178, 2},
     [](const Value* a) { glTexEnviv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLint*>(a[2].pointer)); }},
    {"glTexEnvxOES", "TexEnv", "F18", false, Listing::words, 1 != 0, {arg_184, 3}, {pname_178, 2},
     [](const Value* a) { glTexEnvxOES(GLenum(a[0].integer), GLenum(a[1].integer), GLfixed(a[2].number)); }},
    {"glTexEnvxvOES", "TexEnv", "F18", false, Listing::words, 1 != 0, {arg_185, 3}, {pname_178, 2},
     [](const Value* a) { glTexEnvxvOES(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<const GLfixed*>(a[2].pointer)); }},
    {"glGetTexEnvfv", "GetTexEnv", "F18", false, Listing::never, 1 != 0, {arg_186, 3}, {pname_178, 2},
     [](const Value* a) { glGetTexEnvfv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLfloat*>(a[2].pointer)); }},
    {"glGetTexEnviv", "GetTexEnv", "F18", false, Listing::never, 1 != 0, {arg_187, 3}, {pname_178, 2},
     [](const Value* a) { glGetTexEnviv(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLint*>(a[2].pointer)); }},
    {"glGetTexEnvxvOES", "GetTexEnv", "F18", false, Listing::never, 1 != 0, {arg_188, 3}, {pname_178, 2},
     [](const Value* a) { glGetTexEnvxvOES(GLenum(a[0].integer), GLenum(a[1].integer), static_cast<GLfixed*>(a[2].pointer)); }},
    {"glGetTexLevelParameterfv", "GetTexLevelParameter", "F29", false, Listing::never, 1 != 0, {arg_191, 4}, {pname_189, 10},
     [](const Value* a) { glGetTexLevelParameterfv(GLenum(a[0].integer), GLint(a[1].integer), GLenum(a[2].integer), static_cast<GLfloat*>(a[3].pointer)); }},
    {"glGetTexLevelParameteriv", "GetTexLevelParameter", "F29", false, Listing::never, 1 != 0, {arg_192, 4}, {pname_189, 10},
     [](const Value* a) { glGetTexLevelParameteriv(GLenum(a[0].integer), GLint(a[1].integer), GLenum(a[2].integer), static_cast<GLint*>(a[3].pointer)); }},
    {"glGetTexLevelParameterxvOES", "GetTexLevelParameter", "F29", false, Listing::never, 1 != 0, {arg_193, 4}, {pname_189, 10},
     [](const Value* a) { glGetTexLevelParameterxvOES(GLenum(a[0].integer), GLint(a[1].integer), GLenum(a[2].integer), static_cast<GLfixed*>(a[3].pointer)); }},
    {"glNewList", "NewList", "H05", false, Listing::never, SPANGLE_FEATURE_LISTS != 0, {arg_195, 2}, {},
     [](const Value* a) { glNewList(GLuint(a[0].integer), GLenum(a[1].integer)); }},
    {"glEndList", "EndList", "H05", false, Listing::never, SPANGLE_FEATURE_LISTS != 0, {}, {},
     [](const Value* ) { glEndList(); }},
    {"glCallList", "CallList", "H05", true, Listing::client_data, SPANGLE_FEATURE_LISTS != 0, {arg_196, 1}, {},
     [](const Value* a) { glCallList(GLuint(a[0].integer)); }},
    {"glCallLists", "CallLists", "H05", true, Listing::client_data, SPANGLE_FEATURE_LISTS != 0, {arg_198, 3}, {},
     [](const Value* a) { glCallLists(GLsizei(a[0].integer), GLenum(a[1].integer), static_cast<const void*>(a[2].pointer)); }},
    {"glListBase", "ListBase", "H05", false, Listing::words, SPANGLE_FEATURE_LISTS != 0, {arg_140, 1}, {},
     [](const Value* a) { glListBase(GLuint(a[0].integer)); }},
    {"glGenLists", "GenLists", "H05", false, Listing::never, SPANGLE_FEATURE_LISTS != 0, {arg_199, 1}, {},
     [](const Value* a) { glGenLists(GLsizei(a[0].integer)); }},
    {"glDeleteLists", "DeleteLists", "H05", false, Listing::never, SPANGLE_FEATURE_LISTS != 0, {arg_200, 2}, {},
     [](const Value* a) { glDeleteLists(GLuint(a[0].integer), GLsizei(a[1].integer)); }},
    {"glIsList", "IsList", "H05", false, Listing::never, SPANGLE_FEATURE_LISTS != 0, {arg_140, 1}, {},
     [](const Value* a) { glIsList(GLuint(a[0].integer)); }},
};

} // namespace

std::span<const Command> commands() { return table; }

} // namespace spangle::test
