#include "tests/oracle/answers.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>

#include "boards/scenes/gl.hpp"

namespace spangle::oracle {

namespace {

class Asker {
  public:
    Answers answers;

    void note(std::string question, std::vector<double> values) {
        answers.push_back({std::move(question), std::move(values)});
    }
    void error(const std::string& question) {
        note(question + " error", {static_cast<double>(glGetError())});
    }

    /// In all four types, `count` values. Mesa scales matrices as if they were colours when asked for
    /// integers; GL 1.3, 6.1.2 does not.
    void state(GLenum name, int count) {
        GLdouble d[16] = {};
        GLfloat f[16] = {};
        GLint i[16] = {};
        GLboolean b[16] = {};
        glGetDoublev(name, d);
        glGetFloatv(name, f);
        glGetIntegerv(name, i);
        glGetBooleanv(name, b);
        std::vector<double> values(d, d + count);
        values.insert(values.end(), f, f + count);
        if (count != 16)
            values.insert(values.end(), i, i + count);
        values.insert(values.end(), b, b + count);
        note("state " + std::to_string(name), std::move(values));
    }

    /// What `draw` feeds back.
    void feedback(const std::string& question, GLenum type, const std::function<void()>& draw,
                  std::size_t size = 8192) {
        std::vector<GLfloat> buffer(size);
        glFeedbackBuffer(static_cast<GLsizei>(size), type, buffer.data());
        glRenderMode(GL_FEEDBACK);
        draw();
        const GLint count = glRenderMode(GL_RENDER);
        std::vector<double> values = {static_cast<double>(count)};
        for (GLint i = 0; i < count; ++i) { // without a stipple Mesa never says that it starts anew
            const GLfloat v = buffer[static_cast<std::size_t>(i)];
            values.push_back(v == GL_LINE_RESET_TOKEN ? GL_LINE_TOKEN : static_cast<double>(v));
        }
        note(question, std::move(values));
    }

    void selection(const std::string& question, const std::function<void()>& draw, std::size_t size = 256) {
        std::vector<GLuint> buffer(size);
        glSelectBuffer(static_cast<GLsizei>(size), buffer.data());
        glRenderMode(GL_SELECT);
        glInitNames();
        draw();
        const GLint hits = glRenderMode(GL_RENDER);
        std::vector<double> values = {static_cast<double>(hits)};
        for (std::size_t at = 0, hit = 0; hit < static_cast<std::size_t>(std::max(hits, 0)); ++hit) {
            const GLuint names = buffer[at];
            values.push_back(names);
            for (int z = 1; z <= 2; ++z) // a depth of 0 to 1
                values.push_back(buffer[at + static_cast<std::size_t>(z)] / 4294967295.0);
            for (GLuint n = 0; n < names; ++n)
                values.push_back(buffer[at + 3 + n]);
            at += 3 + names;
        }
        note(question, std::move(values));
    }
};

struct Name {
    GLenum name;
    int count;
};

/// Everything of the state tables that both have and that no implementation chooses.
constexpr Name names[] = {{GL_CURRENT_COLOR, 4},
                          {GL_CURRENT_NORMAL, 3},
                          {GL_CURRENT_TEXTURE_COORDS, 4},
                          {GL_CURRENT_INDEX, 1},
                          {GL_EDGE_FLAG, 1},
                          {GL_VERTEX_ARRAY, 1},
                          {GL_VERTEX_ARRAY_SIZE, 1},
                          {GL_VERTEX_ARRAY_TYPE, 1},
                          {GL_VERTEX_ARRAY_STRIDE, 1},
                          {GL_NORMAL_ARRAY, 1},
                          {GL_NORMAL_ARRAY_TYPE, 1},
                          {GL_NORMAL_ARRAY_STRIDE, 1},
                          {GL_COLOR_ARRAY, 1},
                          {GL_COLOR_ARRAY_SIZE, 1},
                          {GL_COLOR_ARRAY_TYPE, 1},
                          {GL_COLOR_ARRAY_STRIDE, 1},
                          {GL_TEXTURE_COORD_ARRAY, 1},
                          {GL_TEXTURE_COORD_ARRAY_SIZE, 1},
                          {GL_TEXTURE_COORD_ARRAY_TYPE, 1},
                          {GL_TEXTURE_COORD_ARRAY_STRIDE, 1},
                          {GL_MODELVIEW_MATRIX, 16},
                          {GL_PROJECTION_MATRIX, 16},
                          {GL_TEXTURE_MATRIX, 16},
                          {GL_MODELVIEW_STACK_DEPTH, 1},
                          {GL_PROJECTION_STACK_DEPTH, 1},
                          {GL_TEXTURE_STACK_DEPTH, 1},
                          {GL_MATRIX_MODE, 1},
                          {GL_VIEWPORT, 4},
                          {GL_DEPTH_RANGE, 2},
                          {GL_NORMALIZE, 1},
                          {GL_RESCALE_NORMAL, 1},
                          {GL_FOG_COLOR, 4},
                          {GL_FOG_DENSITY, 1},
                          {GL_FOG_START, 1},
                          {GL_FOG_END, 1},
                          {GL_FOG_MODE, 1},
                          {GL_FOG, 1},
                          {GL_SHADE_MODEL, 1},
                          {GL_LIGHTING, 1},
                          {GL_COLOR_MATERIAL, 1},
                          {GL_COLOR_MATERIAL_PARAMETER, 1},
                          {GL_COLOR_MATERIAL_FACE, 1},
                          {GL_LIGHT_MODEL_AMBIENT, 4},
                          {GL_LIGHT_MODEL_LOCAL_VIEWER, 1},
                          {GL_LIGHT_MODEL_TWO_SIDE, 1},
                          {GL_LIGHT_MODEL_COLOR_CONTROL, 1},
                          {GL_LIGHT0, 1},
                          {GL_LIGHT7, 1},
                          {GL_POINT_SIZE, 1},
                          {GL_LINE_WIDTH, 1},
                          {GL_CULL_FACE, 1},
                          {GL_CULL_FACE_MODE, 1},
                          {GL_FRONT_FACE, 1},
                          {GL_POLYGON_MODE, 2},
                          {GL_TEXTURE_2D, 1},
                          {GL_TEXTURE_BINDING_2D, 1},
                          {GL_SCISSOR_TEST, 1},
                          {GL_SCISSOR_BOX, 4},
                          {GL_ALPHA_TEST, 1},
                          {GL_ALPHA_TEST_FUNC, 1},
                          {GL_ALPHA_TEST_REF, 1},
                          {GL_STENCIL_TEST, 1},
                          {GL_STENCIL_FUNC, 1},
                          {GL_STENCIL_REF, 1},
                          {GL_STENCIL_FAIL, 1},
                          {GL_STENCIL_PASS_DEPTH_FAIL, 1},
                          {GL_STENCIL_PASS_DEPTH_PASS, 1},
                          {GL_STENCIL_CLEAR_VALUE, 1},
                          {GL_DEPTH_TEST, 1},
                          {GL_DEPTH_FUNC, 1},
                          {GL_DEPTH_WRITEMASK, 1},
                          {GL_DEPTH_CLEAR_VALUE, 1},
                          {GL_BLEND, 1},
                          {GL_BLEND_SRC, 1},
                          {GL_BLEND_DST, 1},
                          {GL_COLOR_WRITEMASK, 4},
                          {GL_COLOR_CLEAR_VALUE, 4},
                          {GL_UNPACK_SWAP_BYTES, 1},
                          {GL_UNPACK_LSB_FIRST, 1},
                          {GL_UNPACK_IMAGE_HEIGHT, 1},
                          {GL_UNPACK_SKIP_IMAGES, 1},
                          {GL_UNPACK_ROW_LENGTH, 1},
                          {GL_UNPACK_SKIP_ROWS, 1},
                          {GL_UNPACK_SKIP_PIXELS, 1},
                          {GL_UNPACK_ALIGNMENT, 1},
                          {GL_PACK_ALIGNMENT, 1},
                          {GL_LIST_BASE, 1},
                          {GL_LIST_INDEX, 1},
                          {GL_LIST_MODE, 1},
                          {GL_MAX_LIST_NESTING, 1},
                          {GL_PERSPECTIVE_CORRECTION_HINT, 1},
                          {GL_POINT_SMOOTH_HINT, 1},
                          {GL_LINE_SMOOTH_HINT, 1},
                          {GL_POLYGON_SMOOTH_HINT, 1},
                          {GL_FOG_HINT, 1},
                          {GL_TEXTURE_COMPRESSION_HINT, 1},
                          {GL_RENDER_MODE, 1},
                          {GL_NAME_STACK_DEPTH, 1},
                          {GL_ATTRIB_STACK_DEPTH, 1},
                          {GL_CLIENT_ATTRIB_STACK_DEPTH, 1},
                          {GL_MAX_ATTRIB_STACK_DEPTH, 1},
                          {GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, 1},
                          {GL_AUTO_NORMAL, 1},
                          {GL_MAP1_GRID_DOMAIN, 2},
                          {GL_MAP1_GRID_SEGMENTS, 1},
                          {GL_MAP2_GRID_DOMAIN, 4},
                          {GL_MAP2_GRID_SEGMENTS, 2},
                          {GL_MAP1_VERTEX_3, 1},
                          {GL_MAP2_COLOR_4, 1},
                          {GL_FEEDBACK_BUFFER_SIZE, 1},
                          {GL_FEEDBACK_BUFFER_TYPE, 1},
                          {GL_SELECTION_BUFFER_SIZE, 1},
                          {GL_RGBA_MODE, 1},
                          {GL_INDEX_MODE, 1},
                          {GL_STEREO, 1},
                          {GL_MAX_LIGHTS, 1},
                          {GL_RED_BITS, 1},
                          {GL_ALPHA_BITS, 1},
                          {GL_STENCIL_BITS, 1}};

void set_state(int k) {
    const auto f = [k](float v) { return v + static_cast<float>(k) * 0.25f; };
    const GLfloat four[4] = {f(0.1f), f(0.2f), f(0.3f), f(0.4f)};
    glColor4f(f(0.1f), f(-0.2f), f(0.6f), f(0.4f));
    glNormal3f(f(0.5f), f(-0.6f), f(0.2f));
    glTexCoord4f(f(1), f(2), f(3), f(4));
    glIndexf(f(3));
    glEdgeFlag(static_cast<GLboolean>(k));
    glPointSize(f(2.5f));
    glLineWidth(f(1.5f));
    glCullFace(k != 0 ? GL_FRONT : GL_BACK);
    glFrontFace(k != 0 ? GL_CW : GL_CCW);
    glPolygonMode(GL_BACK, k != 0 ? GL_LINE : GL_POINT);
    glShadeModel(k != 0 ? GL_FLAT : GL_SMOOTH);
    glDepthFunc(k != 0 ? GL_LEQUAL : GL_GREATER);
    glDepthMask(static_cast<GLboolean>(k));
    glClearDepth(static_cast<double>(f(0.5f)));
    glStencilFunc(k != 0 ? GL_LESS : GL_EQUAL, k + 1, 7);
    glStencilOp(GL_ZERO, k != 0 ? GL_REPLACE : GL_INVERT, GL_INCR);
    glClearStencil(k + 5);
    glViewport(k + 1, k + 2, k + 30, k + 40);
    glDepthRange(static_cast<double>(f(0.25f)), static_cast<double>(f(0.5f)));
    glAlphaFunc(k != 0 ? GL_LESS : GL_GREATER, f(0.5f));
    glBlendFunc(k != 0 ? GL_SRC_ALPHA : GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA);
    glColorMask(static_cast<GLboolean>(k), 1, 0, 1);
    glClearColor(f(0.1f), f(0.2f), f(0.3f), f(0.8f));
    for (const GLenum hint : std::initializer_list<GLenum>{
             GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT,
             GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT, GL_TEXTURE_COMPRESSION_HINT})
        glHint(hint, k != 0 ? GL_NICEST : GL_FASTEST);
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(k) + 8);
    glScissor(k + 1, k + 2, k + 3, k + 4);
    glFogfv(GL_FOG_COLOR, four);
    for (const GLenum name : std::initializer_list<GLenum>{GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END})
        glFogf(name, f(2));
    glFogi(GL_FOG_MODE, k != 0 ? GL_LINEAR : GL_EXP2);
    glColorMaterial(k != 0 ? GL_FRONT : GL_BACK, GL_EMISSION);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, four);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, k);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, k);
    glListBase(static_cast<GLuint>(k) + 3);
    glMapGrid1f(k + 2, f(1), f(2));
    glMapGrid2f(k + 2, f(1), f(2), k + 3, f(3), f(4));
    glMatrixMode(k != 0 ? GL_PROJECTION : GL_MODELVIEW);
    for (const GLenum cap : std::initializer_list<GLenum>{
             GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_NORMALIZE, GL_RESCALE_NORMAL, GL_ALPHA_TEST,
             GL_BLEND, GL_TEXTURE_2D, GL_SCISSOR_TEST, GL_LIGHTING, GL_LIGHT0, GL_LIGHT7, GL_FOG,
             GL_AUTO_NORMAL, GL_MAP1_VERTEX_3, GL_MAP2_COLOR_4})
        (k != 0 ? glEnable : glDisable)(cap);
}

void set_client(int k) {
    static const char memory[16] = {};
    for (const GLenum array : std::initializer_list<GLenum>{GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY,
                                                            GL_TEXTURE_COORD_ARRAY})
        (k != 0 ? glEnableClientState : glDisableClientState)(array);
    const GLenum type = k != 0 ? GL_SHORT : GL_DOUBLE;
    glVertexPointer(k + 2, type, k + 8, memory);
    glNormalPointer(type, k + 8, memory);
    glColorPointer(k + 3, type, k + 8, memory);
    glTexCoordPointer(k + 2, type, k + 8, memory);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, k + 3);
    glPixelStorei(GL_UNPACK_SWAP_BYTES, k);
    glPixelStorei(GL_PACK_ALIGNMENT, k + 1);
}

Answers initial_state() {
    Asker asker;
    for (const Name& n : names)
        asker.state(n.name, n.count);
    asker.error("queries");
    return asker.answers;
}

Answers state_that_was_set() {
    Asker asker;
    for (int k = 0; k < 2; ++k) {
        set_state(k);
        set_client(k);
        for (const Name& n : names)
            asker.state(n.name, n.count);
        asker.error("set");
    }
    return asker.answers;
}

/// Every group by itself: what is saved, and what is not. Mesa's ENABLE_BIT forgets the lights (GL 1.3, table
/// 6.11 has them).
Answers attribute_groups() {
    Asker asker;
    for (unsigned bit = 0; bit < 20; ++bit) {
        set_state(0);
        glPushAttrib(1u << bit);
        set_state(1);
        glPopAttrib();
        asker.note("bit", {static_cast<double>(bit)});
        for (const Name& n : names)
            if (1u << bit != GL_ENABLE_BIT || n.name < GL_LIGHT0 || n.name > GL_LIGHT7)
                asker.state(n.name, n.count);
    }
    for (const GLbitfield bit : {1u, 2u, 0xFFFFFFFFu}) {
        set_client(0);
        glPushClientAttrib(bit);
        set_client(1);
        glPopClientAttrib();
        for (const Name& n : names)
            asker.state(n.name, n.count);
    }
    glPopAttrib();
    asker.error("underflow");
    glPopClientAttrib();
    asker.error("client underflow");
    for (int i = 0; i < 17; ++i)
        glPushAttrib(GL_ALL_ATTRIB_BITS);
    asker.error("overflow");
    for (int i = 0; i < 17; ++i)
        glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    asker.error("client overflow");
    return asker.answers;
}

void perspective() {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -1, 1, 2, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.1f, -0.2f, -5);
    glRotatef(30, 1, 0.5f, 0.25f);
}

void ring(GLenum mode, int n, float size) {
    static const float unit[8][2] = {{1, 0.1f},   {0.7f, 0.8f},   {-0.1f, 1}, {-0.8f, 0.6f},
                                     {-1, -0.2f}, {-0.6f, -0.7f}, {0.2f, -1}, {0.9f, -0.5f}};
    glBegin(mode);
    for (int i = 0; i < n; ++i) {
        const auto v = static_cast<float>(i) / 8;
        glColor4f(v, 1 - v, 0.5f, 0.25f + v / 2);
        glTexCoord4f(v, 2 * v, 3 - v, 1 + v);
        glVertex3f(size * unit[i][0], size * unit[i][1], v);
    }
    glEnd();
}

Answers selection() {
    Asker asker;
    perspective();
    asker.selection("primitives", [] {
        glPushName(100);
        for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
            glPushName(mode);
            ring(mode, 8, 1);
            glPopName();
        }
    });
    asker.selection("names", [] {
        ring(GL_TRIANGLES, 3, 1);
        glPushName(5);
        glPushName(6);
        ring(GL_TRIANGLES, 3, 0.5f);
        ring(GL_POINTS, 8, 0.25f);
        glLoadName(7);
        glPopName();
        ring(GL_LINES, 2, 1);
        glInitNames();
        glPushName(8);
    });
    asker.selection("cut", [] {
        glPushName(1);
        ring(GL_QUADS, 4, 40);
        glLoadName(2);
        ring(GL_LINES, 8, 30);
        glLoadName(3);
        glTranslatef(0, 0, 100);
        ring(GL_TRIANGLES, 6, 2);
        glTranslatef(0, 0, -100);
    });
    glEnable(GL_CULL_FACE);
    asker.selection("culled", [] {
        glPushName(1);
        ring(GL_POLYGON, 8, 1);
        glCullFace(GL_FRONT);
        glLoadName(2);
        ring(GL_POLYGON, 8, 1);
    });
    glDisable(GL_CULL_FACE);
    asker.selection(
        "overflow", [] { ring(GL_POINTS, 8, 1); }, 2);
    GLuint word = 0;
    glSelectBuffer(-1, &word);
    asker.error("negative size");
    glSelectBuffer(1, &word);
    glRenderMode(GL_SELECT);
    glPopName();
    asker.error("underflow");
    glLoadName(1);
    asker.error("no name");
    glSelectBuffer(1, &word);
    asker.error("in use");
    glRenderMode(GL_RENDER);
    return asker.answers;
}

/// Texture coordinates pass the matrix in Mesa only where there is a texture.
void texture() {
    const GLubyte texel[4] = {255, 255, 255, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
}

/// Unclipped triangles, and lines: of polygons that are cut or have more corners every GL makes others. Mesa
/// does not flatten colours that it feeds back.
Answers feedback() {
    Asker asker;
    perspective();
    texture();
    glMatrixMode(GL_TEXTURE);
    glRotatef(20, 0, 0, 1);
    glScalef(2, 3, 1);
    glMatrixMode(GL_MODELVIEW);
    for (const GLenum type :
         std::initializer_list<GLenum>{GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE, GL_4D_COLOR_TEXTURE})
        for (const GLenum mode :
             std::initializer_list<GLenum>{GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES,
                                           GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN})
            asker.feedback("primitive " + std::to_string(mode) + " type " + std::to_string(type), type,
                           [mode] { ring(mode, 8, 1); });
    asker.feedback("cut lines", GL_4D_COLOR_TEXTURE, [] { ring(GL_LINES, 8, 8); });
    asker.feedback("markers", GL_2D, [] {
        glPassThrough(1.5f);
        ring(GL_POINTS, 2, 1);
        glPassThrough(-3);
    });
    asker.feedback(
        "overflow", GL_2D, [] { ring(GL_POINTS, 8, 1); }, 5);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    const GLfloat red[4] = {0.9f, 0.1f, 0.2f, 0.5f};
    glMaterialfv(GL_BACK, GL_DIFFUSE, red);
    glNormal3f(0.2f, 0.4f, 0.9f);
    asker.feedback("lit from both sides", GL_3D_COLOR, [] { ring(GL_TRIANGLE_STRIP, 8, 1); });
    GLfloat word = 0;
    glFeedbackBuffer(-1, GL_2D, &word);
    asker.error("negative size");
    glFeedbackBuffer(1, GL_RGBA, &word);
    asker.error("no type");
    return asker.answers;
}

constexpr GLenum map1[] = {GL_MAP1_COLOR_4,         GL_MAP1_INDEX,           GL_MAP1_NORMAL,
                           GL_MAP1_TEXTURE_COORD_1, GL_MAP1_TEXTURE_COORD_2, GL_MAP1_TEXTURE_COORD_3,
                           GL_MAP1_TEXTURE_COORD_4, GL_MAP1_VERTEX_3,        GL_MAP1_VERTEX_4};
constexpr int map_components[] = {4, 1, 3, 1, 2, 3, 4, 3, 4};
constexpr GLenum to_map2 = GL_MAP2_COLOR_4 - GL_MAP1_COLOR_4;

/// 4 x 4 control points of a sheet within the view volume; w is at least 1.
std::array<GLfloat, 64> sheet(int components) {
    std::array<GLfloat, 64> out{};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const auto x = static_cast<float>(i), y = static_cast<float>(j);
            const float p[4] = {x / 2 - 0.75f, y / 2 - 0.75f, static_cast<float>((i * 5 + j * 3) % 4) / 4,
                                1 + static_cast<float>((i + j) % 3) / 4};
            for (int c = 0; c < components; ++c)
                out[static_cast<std::size_t>((i * 4 + j) * components + c)] = p[c];
        }
    return out;
}

Answers evaluators() {
    Asker asker;
    perspective();
    for (std::size_t t = 0; t < 9; ++t) {
        const int k = map_components[t];
        const auto points = sheet(k);
        glMap1f(map1[t], 0.25f, 2, 4 * k, 4, points.data());
        glMap2f(map1[t] + to_map2, -1, 1, 4 * k, 4, 0.5f, 2.5f, k, 4, points.data());
        for (const GLenum target : {map1[t], map1[t] + to_map2})
            for (const GLenum query : std::initializer_list<GLenum>{GL_COEFF, GL_ORDER, GL_DOMAIN}) {
                GLdouble v[64] = {};
                GLint n[64] = {};
                glGetMapdv(target, query, v);
                glGetMapiv(target, query, n);
                asker.note("map", {v, v + 64});
                if (query != GL_COEFF)
                    asker.note("map as integers", {n, n + 4});
            }
    }
    glMapGrid1f(9, 0.25f, 2);
    glMapGrid2f(5, -1, 1, 4, 0.5f, 2.5f);
    for (const GLenum vertex : std::initializer_list<GLenum>{GL_MAP1_VERTEX_3, GL_MAP1_VERTEX_4}) {
        glEnable(vertex);
        glEnable(vertex + to_map2);
        for (const GLenum attribute : std::initializer_list<GLenum>{GL_MAP1_COLOR_4, GL_MAP1_TEXTURE_COORD_1,
                                                                    GL_MAP1_TEXTURE_COORD_3}) {
            glEnable(attribute);
            glEnable(attribute + to_map2);
            glColor4f(0.25f, 0.5f, 0.75f, 1); // Mesa's evaluators change what is current
            glTexCoord4f(0.5f, 0.25f, 0, 1);
            asker.feedback("curve", GL_4D_COLOR_TEXTURE, [] {
                glBegin(GL_LINE_STRIP);
                for (int i = 0; i <= 20; ++i)
                    glEvalCoord1f(0.25f + 0.0875f * static_cast<float>(i));
                glEnd();
                glEvalMesh1(GL_POINT, 0, 9);
                glEvalMesh1(GL_LINE, 2, 7);
            });
            asker.feedback("surface", GL_4D_COLOR_TEXTURE, [] {
                glEvalMesh2(GL_POINT, 0, 5, 0, 4);
                glEvalMesh2(GL_LINE, 1, 4, 0, 3);
                glBegin(GL_TRIANGLE_STRIP);
                for (int i = 0; i < 5; ++i) {
                    glEvalPoint2(i, 1);
                    glEvalPoint2(i, 2);
                }
                glEnd();
            });
            glDisable(attribute);
            glDisable(attribute + to_map2);
        }
        glEnable(GL_LIGHTING);
        glEnable(GL_LIGHT0);
        glEnable(GL_NORMALIZE);
        for (const GLenum normals : std::initializer_list<GLenum>{GL_AUTO_NORMAL, GL_MAP2_NORMAL}) {
            glEnable(normals);
            asker.feedback("normals", GL_3D_COLOR, [] { glEvalMesh2(GL_POINT, 0, 5, 0, 4); });
            glDisable(normals);
        }
        glDisable(GL_LIGHTING);
        glDisable(vertex);
        glDisable(vertex + to_map2);
    }
    const GLfloat p[4] = {};
    glMap1f(GL_MAP1_VERTEX_3, 1, 1, 3, 1, p);
    asker.error("empty domain");
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 1, p);
    asker.error("stride");
    glMap1f(GL_MAP2_VERTEX_3, 0, 1, 3, 1, p);
    asker.error("target");
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, p);
    asker.error("order");
    glMapGrid1f(0, 0, 1);
    asker.error("grid");
    glEvalMesh1(GL_FILL, 0, 1);
    asker.error("mesh");
    return asker.answers;
}

Answers lists() {
    Asker asker;
    perspective();
    const GLuint base = glGenLists(70);
    for (GLuint i = 0; i < 70; ++i) { // each calls the one before it
        glNewList(base + i, GL_COMPILE);
        glPassThrough(static_cast<GLfloat>(i));
        if (i != 0)
            glCallList(base + i - 1);
        glEndList();
    }
    for (const GLuint top : {5u, 62u, 63u})
        asker.feedback("nested", GL_2D, [=] { glCallList(base + top); });
    const GLubyte bytes[] = {0, 3, 1, 2}, two[] = {0, 5, 0, 3}, three[] = {0, 0, 4}, four[] = {0, 0, 0, 2};
    const GLbyte negative[] = {-1, -2};
    const GLshort shorts[] = {2, -1};
    const GLfloat floats[] = {2.75f, 1.25f};
    asker.feedback("every type", GL_2D, [&] {
        glListBase(base);
        glCallLists(4, GL_UNSIGNED_BYTE, bytes);
        glCallLists(2, GL_2_BYTES, two);
        glCallLists(1, GL_3_BYTES, three);
        glCallLists(1, GL_4_BYTES, four);
        glCallLists(2, GL_FLOAT, floats);
        glListBase(base + 5);
        glCallLists(2, GL_BYTE, negative);
        glCallLists(2, GL_SHORT, shorts);
    });
    GLfloat v[] = {0, 0, 0.5f, 0, 0, 0.5f};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, v);
    glNewList(base, GL_COMPILE_AND_EXECUTE);
    glColor3f(0.25f, 0.5f, 0.75f);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glMatrixMode(0xDEAD);
    glEndList();
    asker.error("executed");
    glNewList(base + 1, GL_COMPILE);
    glMatrixMode(0xDEAD);
    glEndList();
    asker.error("compiled");
    glCallList(base + 1);
    asker.error("called");
    v[2] = 0.125f; // arrays were read when the list was compiled
    asker.feedback("arrays", GL_3D_COLOR, [=] { glCallList(base); });
    glNewList(0, GL_COMPILE);
    asker.error("list 0");
    glEndList();
    asker.error("no list");
    glDeleteLists(base, -1);
    asker.error("range");
    glDeleteLists(base, 2);
    asker.note("lists", {static_cast<double>(glIsList(base)), static_cast<double>(glIsList(base + 2))});
    return asker.answers;
}

} // namespace

const std::vector<Questions>& all_questions() {
    static const std::vector<Questions> all = {{"initial_state", initial_state},
                                               {"state_that_was_set", state_that_was_set},
                                               {"attribute_groups", attribute_groups},
                                               {"selection", selection},
                                               {"feedback", feedback},
                                               {"evaluators", evaluators},
                                               {"lists", lists}};
    return all;
}

} // namespace spangle::oracle
