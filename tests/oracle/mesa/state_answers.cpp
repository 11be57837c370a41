// Asks for initial values, for values that were set, and for what the attribute stacks save.
#include <initializer_list>

#include "tests/oracle/mesa/asker.hpp"

namespace spangle::oracle {

namespace {

struct Name {
    GLenum name;
    int count;
};

/// All state of the tables that both GLs have and that no implementation chooses.
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

} // namespace

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

/// Asks for each group what is saved and what is not. Mesa's ENABLE_BIT does not save the lights, which GL
/// 1.3, table 6.11 has.
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

} // namespace spangle::oracle
