// Tests the attribute stacks: each bit saves exactly its group (GL 1.3, 6.1.12 and the tables of 6.2).
#include <algorithm>
#include <map>
#include <string>

#include "gl/context/features.hpp"
#include "gl/context/state_table.hpp"
#include "tests/gl/api/recording_context.hpp"

namespace spangle::test {
namespace {

#if SPANGLE_FEATURE_ATTRIB_STACKS

constexpr GLbitfield client_pixel_store = 1, client_vertex_array = 2;

/// State by attribute group, as the tables of GL 1.3, 6.2 have it. State that can be enabled is in
/// ENABLE_BIT, too.
std::map<GLenum, GLbitfield> server_state() {
    std::map<GLenum, GLbitfield> groups = {
        {GL_CURRENT_COLOR, GL_CURRENT_BIT},
        {GL_CURRENT_NORMAL, GL_CURRENT_BIT},
        {GL_CURRENT_TEXTURE_COORDS, GL_CURRENT_BIT},
        {GL_POINT_SIZE, GL_POINT_BIT},
        {GL_LINE_WIDTH, GL_LINE_BIT},
        {GL_CULL_FACE, GL_POLYGON_BIT | GL_ENABLE_BIT},
        {GL_CULL_FACE_MODE, GL_POLYGON_BIT},
        {GL_FRONT_FACE, GL_POLYGON_BIT},
        {GL_READ_BUFFER, GL_PIXEL_MODE_BIT},
        {GL_SHADE_MODEL, GL_LIGHTING_BIT},
        {GL_DEPTH_TEST, GL_DEPTH_BUFFER_BIT | GL_ENABLE_BIT},
        {GL_DEPTH_FUNC, GL_DEPTH_BUFFER_BIT},
        {GL_DEPTH_WRITEMASK, GL_DEPTH_BUFFER_BIT},
        {GL_DEPTH_CLEAR_VALUE, GL_DEPTH_BUFFER_BIT},
        {GL_STENCIL_TEST, GL_STENCIL_BUFFER_BIT | GL_ENABLE_BIT},
        {GL_STENCIL_FUNC, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_VALUE_MASK, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_REF, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_FAIL, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_PASS_DEPTH_PASS, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_WRITEMASK, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_BACK_FUNC, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_BACK_VALUE_MASK, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_BACK_REF, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_BACK_FAIL, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_BACK_PASS_DEPTH_PASS, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_BACK_WRITEMASK, GL_STENCIL_BUFFER_BIT},
        {GL_STENCIL_CLEAR_VALUE, GL_STENCIL_BUFFER_BIT},
        {GL_VIEWPORT, GL_VIEWPORT_BIT},
        {GL_DEPTH_RANGE, GL_VIEWPORT_BIT},
        {GL_MATRIX_MODE, GL_TRANSFORM_BIT},
        {GL_NORMALIZE, GL_TRANSFORM_BIT | GL_ENABLE_BIT},
        {GL_RESCALE_NORMAL, GL_TRANSFORM_BIT | GL_ENABLE_BIT},
        {GL_ALPHA_TEST, GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT},
        {GL_ALPHA_TEST_FUNC, GL_COLOR_BUFFER_BIT},
        {GL_ALPHA_TEST_REF, GL_COLOR_BUFFER_BIT},
        {GL_BLEND, GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT},
        {GL_BLEND_SRC, GL_COLOR_BUFFER_BIT},
        {GL_BLEND_DST, GL_COLOR_BUFFER_BIT},
        {GL_BLEND_SRC_RGB, GL_COLOR_BUFFER_BIT},
        {GL_BLEND_DST_RGB, GL_COLOR_BUFFER_BIT},
        {GL_BLEND_SRC_ALPHA, GL_COLOR_BUFFER_BIT},
        {GL_BLEND_DST_ALPHA, GL_COLOR_BUFFER_BIT},
        {GL_BLEND_EQUATION, GL_COLOR_BUFFER_BIT},
        {GL_BLEND_EQUATION_ALPHA, GL_COLOR_BUFFER_BIT},
        {GL_BLEND_COLOR, GL_COLOR_BUFFER_BIT},
        {GL_COLOR_LOGIC_OP, GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT},
        {GL_INDEX_LOGIC_OP, GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT},
        {GL_LOGIC_OP_MODE, GL_COLOR_BUFFER_BIT},
        {GL_ACCUM_CLEAR_VALUE, GL_ACCUM_BUFFER_BIT},
        {GL_INDEX_CLEAR_VALUE, GL_COLOR_BUFFER_BIT},
        {GL_INDEX_WRITEMASK, GL_COLOR_BUFFER_BIT},
        {GL_DITHER, GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT},
        {GL_DRAW_BUFFER, GL_COLOR_BUFFER_BIT},
        {GL_COLOR_WRITEMASK, GL_COLOR_BUFFER_BIT},
        {GL_COLOR_CLEAR_VALUE, GL_COLOR_BUFFER_BIT},
        {GL_PERSPECTIVE_CORRECTION_HINT, GL_HINT_BIT},
        {GL_POINT_SMOOTH_HINT, GL_HINT_BIT},
        {GL_LINE_SMOOTH_HINT, GL_HINT_BIT},
        {GL_POLYGON_SMOOTH_HINT, GL_HINT_BIT},
        {GL_FOG_HINT, GL_HINT_BIT},
        {GL_TEXTURE_COMPRESSION_HINT, GL_HINT_BIT},
#if SPANGLE_FEATURE_MIPMAP_GENERATION
        {GL_GENERATE_MIPMAP_HINT, GL_HINT_BIT},
#endif
        {GL_TEXTURE_2D, GL_TEXTURE_BIT | GL_ENABLE_BIT},
        {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BIT},
        {GL_SCISSOR_TEST, GL_SCISSOR_BIT | GL_ENABLE_BIT},
        {GL_SCISSOR_BOX, GL_SCISSOR_BIT}
    };
    if (SPANGLE_FEATURE_LIGHTING) {
        for (GLenum cap = GL_LIGHT0; cap <= GL_LIGHT7; ++cap)
            groups[cap] = GL_LIGHTING_BIT | GL_ENABLE_BIT;
        groups[GL_LIGHTING] = groups[GL_COLOR_MATERIAL] = GL_LIGHTING_BIT | GL_ENABLE_BIT;
        for (GLenum name :
             {GL_COLOR_MATERIAL_PARAMETER, GL_COLOR_MATERIAL_FACE, GL_LIGHT_MODEL_AMBIENT,
              GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHT_MODEL_TWO_SIDE, GL_LIGHT_MODEL_COLOR_CONTROL})
            groups[name] = GL_LIGHTING_BIT;
    }
    if (SPANGLE_FEATURE_SECONDARY_COLOR) {
        groups[GL_COLOR_SUM] = GL_FOG_BIT | GL_ENABLE_BIT;
        groups[GL_CURRENT_SECONDARY_COLOR] = GL_CURRENT_BIT;
    }
    if (SPANGLE_FEATURE_FOG) {
        groups[GL_FOG] = GL_FOG_BIT | GL_ENABLE_BIT;
        for (GLenum name : {GL_FOG_COLOR, GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END, GL_FOG_MODE, GL_FOG_INDEX,
                            GL_FOG_COORDINATE_SOURCE})
            groups[name] = GL_FOG_BIT;
        groups[GL_CURRENT_FOG_COORDINATE] = GL_CURRENT_BIT;
    }
    if (SPANGLE_FEATURE_TEXTURE_1D)
        groups[GL_TEXTURE_1D] = GL_TEXTURE_BIT | GL_ENABLE_BIT,
        groups[GL_TEXTURE_BINDING_1D] = GL_TEXTURE_BIT;
    if (SPANGLE_FEATURE_TEXTURE_3D)
        groups[GL_TEXTURE_3D] = GL_TEXTURE_BIT | GL_ENABLE_BIT,
        groups[GL_TEXTURE_BINDING_3D] = GL_TEXTURE_BIT;
    if (SPANGLE_FEATURE_TEXTURE_CUBE_MAP)
        groups[GL_TEXTURE_CUBE_MAP] = GL_TEXTURE_BIT | GL_ENABLE_BIT,
        groups[GL_TEXTURE_BINDING_CUBE_MAP] = GL_TEXTURE_BIT;
    if (SPANGLE_FEATURE_LISTS)
        groups[GL_LIST_BASE] = GL_LIST_BIT;
    if (SPANGLE_FEATURE_POLYGON_MODE) {
        groups[GL_EDGE_FLAG] = GL_CURRENT_BIT;
        groups[GL_POLYGON_MODE] = GL_POLYGON_BIT;
    }
    for (GLenum cap :
         {GL_MULTISAMPLE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE})
        groups[cap] = GL_MULTISAMPLE_BIT | GL_ENABLE_BIT;
    groups[GL_SAMPLE_COVERAGE_VALUE] = groups[GL_SAMPLE_COVERAGE_INVERT] = GL_MULTISAMPLE_BIT;
    if (SPANGLE_FEATURE_ANTIALIASING) {
        groups[GL_POINT_SMOOTH] = GL_POINT_BIT | GL_ENABLE_BIT;
        groups[GL_LINE_SMOOTH] = GL_LINE_BIT | GL_ENABLE_BIT;
        groups[GL_POLYGON_SMOOTH] = GL_POLYGON_BIT | GL_ENABLE_BIT;
    }
    if (SPANGLE_FEATURE_POINT_PARAMETERS) {
        groups[GL_POINT_SPRITE] = GL_POINT_BIT | GL_ENABLE_BIT;
        for (GLenum name : {GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE,
                            GL_POINT_DISTANCE_ATTENUATION, GL_POINT_SPRITE_COORD_ORIGIN})
            groups[name] = GL_POINT_BIT;
    }
    if (SPANGLE_FEATURE_STIPPLE) {
        groups[GL_LINE_STIPPLE] = GL_LINE_BIT | GL_ENABLE_BIT;
        groups[GL_LINE_STIPPLE_PATTERN] = groups[GL_LINE_STIPPLE_REPEAT] = GL_LINE_BIT;
        groups[GL_POLYGON_STIPPLE] = GL_POLYGON_BIT | GL_ENABLE_BIT;
    }
    if (SPANGLE_FEATURE_POLYGON_OFFSET) {
        for (GLenum cap : {GL_POLYGON_OFFSET_POINT, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_FILL})
            groups[cap] = GL_POLYGON_BIT | GL_ENABLE_BIT;
        groups[GL_POLYGON_OFFSET_FACTOR] = groups[GL_POLYGON_OFFSET_UNITS] = GL_POLYGON_BIT;
    }
    if (SPANGLE_FEATURE_EVALUATORS) {
        for (GLenum cap = GL_MAP1_COLOR_4; cap <= GL_MAP1_VERTEX_4; ++cap)
            groups[cap] = groups[cap - GL_MAP1_COLOR_4 + GL_MAP2_COLOR_4] = GL_EVAL_BIT | GL_ENABLE_BIT;
        groups[GL_AUTO_NORMAL] = GL_EVAL_BIT | GL_ENABLE_BIT;
        for (GLenum name :
             {GL_MAP1_GRID_DOMAIN, GL_MAP1_GRID_SEGMENTS, GL_MAP2_GRID_DOMAIN, GL_MAP2_GRID_SEGMENTS})
            groups[name] = GL_EVAL_BIT;
    }
    if (SPANGLE_FEATURE_COLOR_INDEX)
        groups[GL_CURRENT_INDEX] = GL_CURRENT_BIT;
    if (SPANGLE_FEATURE_RASTER_POS)
        for (GLenum name = GL_CURRENT_RASTER_COLOR; name <= GL_CURRENT_RASTER_DISTANCE; ++name)
            groups[name] = GL_CURRENT_BIT;
    if (SPANGLE_FEATURE_TEXGEN)
        for (GLenum cap = GL_TEXTURE_GEN_S; cap <= GL_TEXTURE_GEN_Q; ++cap)
            groups[cap] = GL_TEXTURE_BIT | GL_ENABLE_BIT;
    if (SPANGLE_FEATURE_PIXEL_TRANSFER)
        for (GLenum name = GL_MAP_COLOR; name <= GL_DEPTH_BIAS; ++name)
            if (name != GL_ZOOM_X && name != GL_ZOOM_Y)
                groups[name] = GL_PIXEL_MODE_BIT;
    if (SPANGLE_FEATURE_DRAW_PIXELS)
        groups[GL_ZOOM_X] = groups[GL_ZOOM_Y] = GL_PIXEL_MODE_BIT;
    if (SPANGLE_FEATURE_CLIP_PLANES)
        for (GLenum cap = GL_CLIP_PLANE0; cap <= GL_CLIP_PLANE5; ++cap)
            groups[cap] = GL_TRANSFORM_BIT | GL_ENABLE_BIT;
    std::erase_if(groups, [](const auto& name_and_group) {
        const gl::StateRow* const row = gl::find_state(name_and_group.first);
        return row != nullptr && row->left_out();
    });
    return groups;
}

std::map<GLenum, GLbitfield> client_state() {
    std::map<GLenum, GLbitfield> groups;
    for (GLenum name :
         {GL_VERTEX_ARRAY, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE,
          GL_NORMAL_ARRAY, GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE, GL_COLOR_ARRAY, GL_COLOR_ARRAY_SIZE,
          GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_STRIDE, GL_TEXTURE_COORD_ARRAY, GL_TEXTURE_COORD_ARRAY_SIZE,
          GL_TEXTURE_COORD_ARRAY_TYPE, GL_TEXTURE_COORD_ARRAY_STRIDE, GL_VERTEX_ARRAY_POINTER,
          GL_NORMAL_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER, GL_TEXTURE_COORD_ARRAY_POINTER})
        groups[name] = client_vertex_array;
    if (SPANGLE_FEATURE_POLYGON_MODE)
        for (GLenum name : {GL_EDGE_FLAG_ARRAY, GL_EDGE_FLAG_ARRAY_STRIDE, GL_EDGE_FLAG_ARRAY_POINTER})
            groups[name] = client_vertex_array;
    if (SPANGLE_FEATURE_COLOR_INDEX)
        for (GLenum name :
             {GL_INDEX_ARRAY, GL_INDEX_ARRAY_TYPE, GL_INDEX_ARRAY_STRIDE, GL_INDEX_ARRAY_POINTER})
            groups[name] = client_vertex_array;
    if (SPANGLE_FEATURE_SECONDARY_COLOR)
        for (GLenum name : {GL_SECONDARY_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY_TYPE,
                            GL_SECONDARY_COLOR_ARRAY_STRIDE, GL_SECONDARY_COLOR_ARRAY_POINTER})
            groups[name] = client_vertex_array;
    if (SPANGLE_FEATURE_SECONDARY_COLOR && SPANGLE_FEATURE_BUFFERS)
        groups[GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING] = client_vertex_array;
    if (SPANGLE_FEATURE_FOG)
        for (GLenum name : {GL_FOG_COORDINATE_ARRAY, GL_FOG_COORDINATE_ARRAY_TYPE,
                            GL_FOG_COORDINATE_ARRAY_STRIDE, GL_FOG_COORDINATE_ARRAY_POINTER})
            groups[name] = client_vertex_array;
    if (SPANGLE_FEATURE_BUFFERS && SPANGLE_FEATURE_FOG)
        groups[GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING] = client_vertex_array;
    if (SPANGLE_FEATURE_BUFFERS)
        for (GLenum name : {GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING,
                            GL_VERTEX_ARRAY_BUFFER_BINDING, GL_NORMAL_ARRAY_BUFFER_BINDING,
                            GL_COLOR_ARRAY_BUFFER_BINDING, GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING})
            groups[name] = client_vertex_array;
    if (SPANGLE_FEATURE_BUFFERS && SPANGLE_FEATURE_COLOR_INDEX)
        groups[GL_INDEX_ARRAY_BUFFER_BINDING] = client_vertex_array;
    if (SPANGLE_FEATURE_BUFFERS && SPANGLE_FEATURE_POLYGON_MODE)
        groups[GL_EDGE_FLAG_ARRAY_BUFFER_BINDING] = client_vertex_array;
    for (GLenum name :
         {GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES,
          GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_ALIGNMENT,
          GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES,
          GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_ALIGNMENT})
        groups[name] = client_pixel_store;
    if (SPANGLE_FEATURE_PRIMITIVE_RESTART)
        groups[GL_PRIMITIVE_RESTART] = groups[GL_PRIMITIVE_RESTART_INDEX] = client_vertex_array;
    return groups;
}

class Attrib : public RecordingContext {
  protected:
    /// Returns all values of a name; of a pointer its address.
    std::vector<double> value(GLenum name) {
        GLdouble d[16] = {};
        glGetDoublev(name, d);
        if (glGetError() == GL_NO_ERROR)
            return {d, d + 16};
        void* pointer = nullptr;
        glGetPointerv(name, &pointer);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << std::hex << name;
        return {static_cast<double>(reinterpret_cast<std::uintptr_t>(pointer))};
    }

    /// Returns state with queries of its own, by group.
    std::map<GLbitfield, std::vector<float>> asked_otherwise() {
        std::map<GLbitfield, std::vector<float>> found;
        const auto note = [&found](GLbitfield group, auto get, std::initializer_list<GLenum> names) {
            for (const GLenum name : names) {
                GLfloat f[4] = {};
                get(name, f);
                found[group].insert(found[group].end(), f, f + 4);
            }
        };
#if SPANGLE_FEATURE_LIGHTING
        for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light)
            note(GL_LIGHTING_BIT, [light](GLenum n, GLfloat* f) { glGetLightfv(light, n, f); },
                 {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION, GL_SPOT_EXPONENT,
                  GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION});
        for (GLenum face : {GL_FRONT, GL_BACK})
            note(GL_LIGHTING_BIT, [face](GLenum n, GLfloat* f) { glGetMaterialfv(face, n, f); },
                 {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS});
#endif
#if SPANGLE_FEATURE_TEXGEN
        for (const GLenum coord : {GL_S, GL_T, GL_R, GL_Q})
            note(GL_TEXTURE_BIT, [coord](GLenum n, GLfloat* f) { glGetTexGenfv(coord, n, f); },
                 {GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE, GL_EYE_PLANE});
#endif
#if SPANGLE_FEATURE_CLIP_PLANES
        const auto equation = [](GLenum plane, GLfloat* f) {
            GLdouble d[4];
            glGetClipPlane(plane, d);
            std::copy(d, d + 4, f);
        };
        note(GL_TRANSFORM_BIT, equation, {GL_CLIP_PLANE0, GL_CLIP_PLANE3, GL_CLIP_PLANE5});
#endif
        note(GL_TEXTURE_BIT, [](GLenum n, GLfloat* f) { glGetTexEnvfv(GL_TEXTURE_ENV, n, f); },
             {GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR});
        note(GL_TEXTURE_BIT, [](GLenum n, GLfloat* f) { glGetTexParameterfv(GL_TEXTURE_2D, n, f); },
             {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T,
              GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_PRIORITY, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD,
              GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL});
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return found;
    }

    /// Sets every value that can be set; for k = 0 and k = 1 the values differ.
    void set_server(int k) {
        const auto f = [k](float v) { return v + static_cast<float>(k) * 0.25f; };
        const auto either = [k](GLenum a, GLenum b) { return k != 0 ? a : b; };
        for (const auto& [name, groups] : server_state())
            if ((groups & GL_ENABLE_BIT) != 0)
                (k != 0 ? glEnable : glDisable)(name);
        glColor4f(f(0.1f), f(0.2f), f(0.3f), f(0.4f));
#if SPANGLE_FEATURE_DRAW_PIXELS
        glPixelZoom(f(-1), f(2));
#endif
#if SPANGLE_FEATURE_PIXEL_TRANSFER
        for (GLenum name = GL_MAP_COLOR; name <= GL_DEPTH_BIAS; ++name)
            if (name != GL_ZOOM_X && name != GL_ZOOM_Y)
                glPixelTransferi(name, k);
#endif
        glNormal3f(f(0.5f), f(0.6f), f(0.7f));
        glTexCoord4f(f(1), f(2), f(3), f(4));
        glPointSize(f(2));
        glSampleCoverage(f(0.5f), k != 0);
        glLineWidth(f(3));
        glCullFace(either(GL_FRONT, GL_BACK));
        glFrontFace(either(GL_CW, GL_CCW));
        context->fragment_ops.read_buffer = either(GL_FRONT, GL_BACK); // this drawable has no front buffer
        glDrawBuffer(either(GL_NONE, GL_BACK));
        glShadeModel(either(GL_FLAT, GL_SMOOTH));
        glDepthFunc(either(GL_LEQUAL, GL_GREATER));
        glDepthMask(k != 0);
        glClearDepth(double(f(0.5f)));
        glStencilFunc(either(GL_LESS, GL_EQUAL), k + 1, k != 0 ? 3 : 7);
        k != 0 ? glStencilOp(GL_ZERO, GL_REPLACE, GL_INCR) : glStencilOp(GL_INVERT, GL_DECR, GL_ZERO);
        glStencilMask(k != 0 ? 0x55 : 0xAA);
        glClearStencil(k + 5);
        glViewport(k + 1, k + 2, k + 3, k + 4);
        glDepthRange(double(f(0.25f)), double(f(0.5f)));
        glAlphaFunc(either(GL_LESS, GL_GREATER), f(0.5f));
        k != 0 ? glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA) : glBlendFunc(GL_DST_COLOR, GL_ONE);
        glLogicOp(either(GL_XOR, GL_NOR));
        glBlendEquation(either(GL_MIN, GL_FUNC_SUBTRACT));
        glBlendColor(f(0.1f), f(0.2f), f(0.3f), f(0.4f));
#if SPANGLE_FEATURE_ACCUM
        glClearAccum(f(0.1f), f(0.2f), f(0.3f), f(0.4f));
#endif
#if SPANGLE_FEATURE_COLOR_INDEX
        glClearIndex(f(3.5f));
        glIndexMask(k != 0 ? 0x5A : 0xA5);
#endif
        k != 0 ? glColorMask(1, 0, 1, 0) : glColorMask(0, 1, 0, 1);
        glClearColor(f(0.1f), f(0.2f), f(0.3f), f(0.4f));
        for (GLenum hint : {GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT,
                            GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT, GL_TEXTURE_COMPRESSION_HINT})
            glHint(hint, either(GL_NICEST, GL_FASTEST));
#if SPANGLE_FEATURE_MIPMAP_GENERATION
        glHint(GL_GENERATE_MIPMAP_HINT, either(GL_NICEST, GL_FASTEST));
#endif
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(k) + 8);
#if SPANGLE_FEATURE_TEXTURE_1D
        glBindTexture(GL_TEXTURE_1D, static_cast<GLuint>(k) + 18);
        glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_R, k != 0 ? GL_CLAMP : GL_MIRRORED_REPEAT);
#endif
#if SPANGLE_FEATURE_TEXTURE_3D
        glBindTexture(GL_TEXTURE_3D, static_cast<GLuint>(k) + 28);
#endif
#if SPANGLE_FEATURE_TEXTURE_CUBE_MAP
        glBindTexture(GL_TEXTURE_CUBE_MAP, static_cast<GLuint>(k) + 38);
#endif
        const GLfloat four[4] = {f(0.1f), f(0.2f), f(0.3f), f(0.4f)};
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, k != 0 ? GL_DECAL : GL_REPLACE);
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, four);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, k != 0 ? GL_NEAREST : GL_LINEAR);
        glScissor(k + 1, k + 2, k + 3, k + 4);
#if SPANGLE_FEATURE_LIGHTING
        glDisable(GL_COLOR_MATERIAL); // with it enabled, materials could not be set
        for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light) {
            for (GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION})
                glLightfv(light, name, four);
            for (GLenum name : {GL_SPOT_EXPONENT, GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION,
                                GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION})
                glLightf(light, name, f(2));
        }
        for (GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION})
            glMaterialfv(GL_FRONT_AND_BACK, name, four);
        glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, f(20));
        glMaterialfv(GL_FRONT_AND_BACK, GL_COLOR_INDEXES, four);
        k != 0 ? glColorMaterial(GL_FRONT, GL_EMISSION) : glColorMaterial(GL_BACK, GL_SPECULAR);
        (k != 0 ? glEnable : glDisable)(GL_COLOR_MATERIAL);
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, four);
        glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, k);
        glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, k);
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, k != 0 ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
#endif
#if SPANGLE_FEATURE_SECONDARY_COLOR
        glSecondaryColor3f(f(7), f(8), f(9));
        (k != 0 ? glEnable : glDisable)(GL_COLOR_SUM);
#endif
#if SPANGLE_FEATURE_FOG
        glFogfv(GL_FOG_COLOR, four);
        for (GLenum name : {GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END})
            glFogf(name, f(2));
        glFogi(GL_FOG_MODE, k != 0 ? GL_LINEAR : GL_EXP2);
        glFogf(GL_FOG_INDEX, f(3));
        glFogi(GL_FOG_COORDINATE_SOURCE, k != 0 ? GL_FRAGMENT_DEPTH : GL_FOG_COORDINATE);
        glFogCoordf(f(6));
#endif
#if SPANGLE_FEATURE_TEXGEN
        for (const GLenum coord : {GL_S, GL_T, GL_R, GL_Q}) {
            glTexGeni(coord, GL_TEXTURE_GEN_MODE,
                      static_cast<GLint>(either(GL_OBJECT_LINEAR, GL_EYE_LINEAR)));
            glTexGenfv(coord, GL_OBJECT_PLANE, four);
            glTexGenfv(coord, GL_EYE_PLANE, four);
        }
#endif
#if SPANGLE_FEATURE_CLIP_PLANES
        for (GLenum plane = GL_CLIP_PLANE0; plane <= GL_CLIP_PLANE5; ++plane)
            glClipPlanefOES(plane, four);
#endif
#if SPANGLE_FEATURE_POLYGON_MODE
        glEdgeFlag(k != 0);
        glPolygonMode(GL_FRONT, either(GL_LINE, GL_POINT));
#endif
#if SPANGLE_FEATURE_STIPPLE
        glLineStipple(k + 2, static_cast<GLushort>(k + 3));
#endif
#if SPANGLE_FEATURE_POLYGON_OFFSET
        glPolygonOffset(f(1), f(2));
#endif
#if SPANGLE_FEATURE_POINT_PARAMETERS
        const GLfloat attenuation[] = {f(1), f(2), f(3)};
        glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
        glPointParameterf(GL_POINT_SIZE_MIN, f(4));
        glPointParameterf(GL_POINT_SIZE_MAX, f(5));
        glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, f(6));
        glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, either(GL_LOWER_LEFT, GL_UPPER_LEFT));
#endif
#if SPANGLE_FEATURE_EVALUATORS
        glMapGrid1f(k + 2, f(1), f(2));
        glMapGrid2f(k + 2, f(1), f(2), k + 3, f(3), f(4));
#endif
#if SPANGLE_FEATURE_COLOR_INDEX
        glIndexf(f(7));
#endif
#if SPANGLE_FEATURE_RASTER_POS
        glWindowPos3f(f(5), f(6), f(0.25f));
        context->current.raster.distance = numeric::from_i32(k); // only RasterPos changes it
        context->current.raster.index = numeric::from_i32(k);
        context->current.raster.valid = k != 0;
#endif
#if SPANGLE_FEATURE_LISTS
        glListBase(static_cast<GLuint>(k) + 3);
#endif
        glMatrixMode(either(GL_PROJECTION, GL_MODELVIEW));
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }

    void set_client(int k) {
        for (GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
            (k != 0 ? glEnableClientState : glDisableClientState)(array);
        const GLenum type = k != 0 ? GL_SHORT : GL_DOUBLE;
#if SPANGLE_FEATURE_BUFFERS
        glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(k) + 4);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(k) + 6);
#endif
#if SPANGLE_FEATURE_PRIMITIVE_RESTART
        (k != 0 ? glEnable : glDisable)(GL_PRIMITIVE_RESTART);
        glPrimitiveRestartIndex(static_cast<GLuint>(k) + 9);
#endif
        glVertexPointer(k + 2, type, k + 8, memory_ + k);
        glNormalPointer(type, k + 8, memory_ + 2 + k);
        glColorPointer(k + 3, type, k + 8, memory_ + 4 + k);
        glTexCoordPointer(k + 2, type, k + 8, memory_ + 6 + k);
#if SPANGLE_FEATURE_SECONDARY_COLOR
        (k != 0 ? glEnableClientState : glDisableClientState)(GL_SECONDARY_COLOR_ARRAY);
        glSecondaryColorPointer(3, k != 0 ? GL_FLOAT : GL_DOUBLE, k + 8, memory_ + 14 + k);
#endif
#if SPANGLE_FEATURE_FOG
        (k != 0 ? glEnableClientState : glDisableClientState)(GL_FOG_COORDINATE_ARRAY);
        glFogCoordPointer(k != 0 ? GL_FLOAT : GL_DOUBLE, k + 8, memory_ + 12 + k);
#endif
#if SPANGLE_FEATURE_POLYGON_MODE
        (k != 0 ? glEnableClientState : glDisableClientState)(GL_EDGE_FLAG_ARRAY);
        glEdgeFlagPointer(k + 8, memory_ + 8 + k);
#endif
#if SPANGLE_FEATURE_COLOR_INDEX
        (k != 0 ? glEnableClientState : glDisableClientState)(GL_INDEX_ARRAY);
        glIndexPointer(type, k + 8, memory_ + 10 + k);
#endif
        for (GLenum name : {GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST,
                            GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_ROW_LENGTH,
                            GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_PACK_IMAGE_HEIGHT,
                            GL_PACK_SKIP_IMAGES, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
            glPixelStorei(name, k);
        glPixelStorei(GL_UNPACK_ALIGNMENT, k + 1);
        glPixelStorei(GL_PACK_ALIGNMENT, k + 1);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }

    char memory_[18] = {};
};

TEST_F(Attrib, TheTestKnowsAllStateThatIsSaved) {
    const auto server = server_state(), client = client_state();
    for (const auto& part : gl::all_state())
        for (const gl::StateRow& row : part.rows)
            if (!row.left_out() && part.groups[&row - part.rows.data()] != gl::Group::none)
                for (GLenum name = row.name; name < GLenum{row.name} + row.names; ++name) {
                    EXPECT_TRUE(server.contains(name) || client.contains(name)) << std::hex << name;
                }
}

TEST_F(Attrib, EachBitSavesExactlyItsGroup) {
    for (unsigned bit = 0; bit < 32; ++bit) {
        const GLbitfield mask = 1u << bit;
        set_server(0);
        std::map<GLenum, std::vector<double>> saved, changed;
        for (const auto& [name, groups] : server_state())
            saved[name] = value(name);
        const auto saved_otherwise = asked_otherwise();
        glPushAttrib(mask);
        set_server(1);
        for (const auto& [name, groups] : server_state()) {
            changed[name] = value(name);
            ASSERT_NE(changed[name], saved[name]) << std::hex << name << ": the test changes nothing";
        }
        const auto changed_otherwise = asked_otherwise();
        glPopAttrib();
        for (const auto& [name, groups] : server_state())
            EXPECT_EQ(value(name), (groups & mask) != 0 ? saved[name] : changed[name])
                << "bit " << bit << ", state " << std::hex << name;
        const auto now = asked_otherwise();
        for (const auto& [group, values] : now) {
            if (mask == GL_CURRENT_BIT && group == GL_LIGHTING_BIT)
                continue; // the tracked material follows the colour, and is tested below
            EXPECT_EQ(values, (group & mask) != 0 ? saved_otherwise.at(group) : changed_otherwise.at(group))
                << "bit " << bit << ", group " << std::hex << group;
        }
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
}

TEST_F(Attrib, ClientBitsSaveExactlyTheirGroups) {
    for (unsigned bit = 0; bit < 32; ++bit) {
        const GLbitfield mask = 1u << bit;
        set_client(0);
        std::map<GLenum, std::vector<double>> saved, changed;
        for (const auto& [name, groups] : client_state())
            saved[name] = value(name);
        glPushClientAttrib(mask);
        set_client(1);
        for (const auto& [name, groups] : client_state()) {
            changed[name] = value(name);
            ASSERT_NE(changed[name], saved[name]) << std::hex << name << ": the test changes nothing";
        }
        glPopClientAttrib();
        for (const auto& [name, groups] : client_state())
            EXPECT_EQ(value(name), (groups & mask) != 0 ? saved[name] : changed[name])
                << "bit " << bit << ", state " << std::hex << name;
    }
}

TEST_F(Attrib, AllBitsSaveAll) {
    set_server(0);
    set_client(0);
    const auto before = snapshot();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    set_server(1);
    set_client(1);
    glPopAttrib();
    glPopClientAttrib();
    EXPECT_EQ(snapshot(), before);
}

TEST_F(Attrib, StacksAre16DeepAndSayWhenTheyAreFullOrEmpty) {
    const auto check = [this](auto push, auto pop, GLenum depth, GLenum most) {
        GLint n = 0;
        glGetIntegerv(most, &n);
        EXPECT_EQ(n, 16);
        const auto empty = snapshot();
        pop();
        EXPECT_EQ(glGetError(), GLenum{GL_STACK_UNDERFLOW});
        EXPECT_EQ(snapshot(), empty);
        for (int i = 0; i < 16; ++i) {
            glGetIntegerv(depth, &n);
            EXPECT_EQ(n, i);
            push();
            EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        }
        const auto full = snapshot();
        push();
        EXPECT_EQ(glGetError(), GLenum{GL_STACK_OVERFLOW});
        EXPECT_EQ(snapshot(), full);
        for (int i = 0; i < 16; ++i)
            pop();
        EXPECT_EQ(snapshot(), empty);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    };
    check([] { glPushAttrib(GL_POINT_BIT); }, [] { glPopAttrib(); }, GL_ATTRIB_STACK_DEPTH,
          GL_MAX_ATTRIB_STACK_DEPTH);
    check([] { glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT); }, [] { glPopClientAttrib(); },
          GL_CLIENT_ATTRIB_STACK_DEPTH, GL_MAX_CLIENT_ATTRIB_STACK_DEPTH);
}

TEST_F(Attrib, EntriesNest) {
    glPointSize(2);
    glPushAttrib(GL_POINT_BIT);
    glPointSize(3);
    glLineWidth(7);
    glPushAttrib(GL_LINE_BIT);
    glPointSize(4);
    glLineWidth(9);
    glPopAttrib();
    EXPECT_EQ(value(GL_POINT_SIZE)[0], 4);
    EXPECT_EQ(value(GL_LINE_WIDTH)[0], 7);
    glPopAttrib();
    EXPECT_EQ(value(GL_POINT_SIZE)[0], 2);
    EXPECT_EQ(value(GL_LINE_WIDTH)[0], 7);
}

TEST_F(Attrib, NoMemoryLeavesTheStackAsItWas) {
    std::vector<void*> taken;
    for (std::size_t bytes = arena_bytes; bytes >= 8; bytes /= 2)
        for (void* block = arena.allocate(bytes); block != nullptr; block = arena.allocate(bytes))
            taken.push_back(block);
    const auto before = snapshot();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    EXPECT_EQ(glGetError(), GLenum{GL_OUT_OF_MEMORY});
    EXPECT_EQ(snapshot(), before);
    for (void* block : taken)
        arena.free(block);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Attrib, AContextMayGoWithEntriesLeft) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS); // the fixture frees what is left on the stack
}

TEST_F(Attrib, ATextureDeletedMeanwhileIsMadeAnew) {
    glBindTexture(GL_TEXTURE_2D, 5);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glPushAttrib(GL_TEXTURE_BIT);
    const GLuint name = 5;
    glDeleteTextures(1, &name);
    EXPECT_FALSE(glIsTexture(5));
    glPopAttrib();
    EXPECT_TRUE(glIsTexture(5));
    EXPECT_EQ(value(GL_TEXTURE_BINDING_2D)[0], 5);
    GLint wrap = 0;
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &wrap);
    EXPECT_EQ(wrap, GL_CLAMP);
}

/// Without memory for objects that were deleted meanwhile, PopAttrib is an error without other effects (GL
/// 1.3, 2.5): nothing is popped and no object is made, whatever number of objects would fit.
TEST_F(Attrib, APopWithoutMemoryChangesNothing) {
    constexpr GLuint names[] = {5, 6, 7};
    const GLenum targets[] = {GL_TEXTURE_2D, GL_TEXTURE_2D,
                              SPANGLE_FEATURE_TEXTURE_CUBE_MAP ? GLenum{GL_TEXTURE_CUBE_MAP} : GL_TEXTURE_2D};
    for (int i = 0; i < 3; ++i) {
        glActiveTexture(i == 1 ? GL_TEXTURE1 : GL_TEXTURE0);
        glBindTexture(targets[i], names[i]);
        glTexParameteri(targets[i], GL_TEXTURE_WRAP_S, GL_CLAMP);
    }
    glLineWidth(3);
    glPushAttrib(GL_TEXTURE_BIT | GL_LINE_BIT);
    glDeleteTextures(3, names);
    glActiveTexture(GL_TEXTURE0);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glLineWidth(5);
    std::vector<void*> taken;
    for (std::size_t bytes = arena_bytes; bytes >= 8; bytes /= 2)
        for (void* block = arena.allocate(bytes); block != nullptr; block = arena.allocate(bytes))
            taken.push_back(block);
    const auto before = snapshot();
    int refused = 0;
    for (;; ++refused) {
        glPopAttrib();
        const GLenum code = std::exchange(context->error_code, GLenum{GL_NO_ERROR});
        if (code == GL_NO_ERROR)
            break;
        ASSERT_EQ(code, GLenum{GL_OUT_OF_MEMORY});
        EXPECT_EQ(snapshot(), before) << refused;
        for (const GLuint name : names)
            EXPECT_FALSE(glIsTexture(name)) << refused;
        ASSERT_FALSE(taken.empty());
        arena.free(taken.back()); // the smallest block first
        taken.pop_back();
    }
    EXPECT_GT(refused, 3);
    EXPECT_EQ(value(GL_LINE_WIDTH)[0], 3);
    EXPECT_EQ(value(GL_ATTRIB_STACK_DEPTH)[0], 0);
    glActiveTexture(GL_TEXTURE1);
    EXPECT_EQ(value(GL_TEXTURE_BINDING_2D)[0], 6);
    for (void* block : taken)
        arena.free(block);
}

/// A name that meanwhile became another kind of texture cannot be bound again. PopAttrib binds the default
/// texture instead, without an error.
TEST_F(Attrib, ANameOfAnotherKindIsNotBoundAgain) {
#if SPANGLE_FEATURE_TEXTURE_1D
    glBindTexture(GL_TEXTURE_2D, 5);
    glLineWidth(3);
    glPushAttrib(GL_TEXTURE_BIT | GL_LINE_BIT);
    const GLuint name = 5;
    glDeleteTextures(1, &name);
    glBindTexture(GL_TEXTURE_1D, 5);
    glLineWidth(5);
    glPopAttrib();
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(value(GL_TEXTURE_BINDING_2D)[0], 0);
    EXPECT_EQ(value(GL_TEXTURE_BINDING_1D)[0], 0);
    EXPECT_EQ(value(GL_LINE_WIDTH)[0], 3);
#endif
}

#if SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS
TEST_F(Attrib, AClientPopWithoutMemoryChangesNothing) {
    GLuint name, again;
    glGenVertexArrays(1, &name);
    glBindVertexArray(name);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &name);
    glGenVertexArrays(1, &again); // a name without an object
    ASSERT_EQ(name, again);
    std::vector<void*> taken;
    for (std::size_t bytes = arena_bytes; bytes >= 8; bytes /= 2)
        for (void* block = arena.allocate(bytes); block != nullptr; block = arena.allocate(bytes))
            taken.push_back(block);
    const auto before = snapshot();
    bool refused = false;
    for (;;) {
        glPopClientAttrib();
        const GLenum code = std::exchange(context->error_code, GLenum{GL_NO_ERROR});
        if (code == GL_NO_ERROR)
            break;
        refused = true;
        ASSERT_EQ(code, GLenum{GL_OUT_OF_MEMORY});
        EXPECT_EQ(snapshot(), before);
        ASSERT_FALSE(taken.empty());
        arena.free(taken.back());
        taken.pop_back();
    }
    EXPECT_TRUE(refused);
    EXPECT_EQ(value(GL_PACK_ALIGNMENT)[0], 4);
    EXPECT_EQ(value(GL_VERTEX_ARRAY_BINDING)[0], static_cast<double>(name));
    for (void* block : taken)
        arena.free(block);
}
#endif

TEST_F(Attrib, ParametersOfTexturesNotBoundStay) {
    glBindTexture(GL_TEXTURE_2D, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 2);
    glPushAttrib(GL_TEXTURE_BIT);
    glBindTexture(GL_TEXTURE_2D, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPopAttrib();
    glBindTexture(GL_TEXTURE_2D, 1);
    GLint filter = 0;
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, &filter);
    EXPECT_EQ(filter, GL_LINEAR);
}

#if SPANGLE_FEATURE_LIGHTING
TEST_F(Attrib, ATrackedMaterialFollowsThePoppedColor) {
    glColorMaterial(GL_FRONT, GL_DIFFUSE);
    glEnable(GL_COLOR_MATERIAL);
    glColor3f(0.25f, 0.5f, 0.75f);
    glPushAttrib(GL_CURRENT_BIT);
    glColor3f(1, 0, 0);
    glPopAttrib();
    GLfloat diffuse[4];
    glGetMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
    EXPECT_EQ(diffuse[0], 0.25f);
    EXPECT_EQ(diffuse[2], 0.75f);
}
#endif

#if SPANGLE_FEATURE_LISTS
TEST_F(Attrib, ServerStacksAreCompiledClientStacksAreNot) {
    glPointSize(2);
    glNewList(1, GL_COMPILE);
    glPushAttrib(GL_POINT_BIT);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    glPointSize(5);
    glPopAttrib();
    glEndList();
    EXPECT_EQ(value(GL_ATTRIB_STACK_DEPTH)[0], 0);
    EXPECT_EQ(value(GL_CLIENT_ATTRIB_STACK_DEPTH)[0], 1);
    glCallList(1);
    EXPECT_EQ(value(GL_POINT_SIZE)[0], 2);
    EXPECT_EQ(value(GL_CLIENT_ATTRIB_STACK_DEPTH)[0], 1);
}
#endif

#endif

} // namespace
} // namespace spangle::test
