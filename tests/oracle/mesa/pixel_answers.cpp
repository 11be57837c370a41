// Asks about pixel paths and fragment operations: the error of every wrong argument, and that nothing
// changed.
#include "tests/oracle/mesa/asker.hpp"

namespace spangle::oracle {

namespace {

void refused(Asker& ask, const std::string& question, const std::function<void()>& command) {
    command();
    ask.error(question);
}

void stores(Asker& ask) {
    const auto set = [&](GLenum name, GLint v) {
        glPixelStorei(name, v);
        ask.error("store " + std::to_string(name) + " " + std::to_string(v));
        ask.state(name, 1);
    };
    for (GLenum name = GL_UNPACK_SWAP_BYTES; name <= GL_UNPACK_ALIGNMENT; ++name)
        for (const GLint v : {-1, 0, 3, 4, 16})
            set(name, v);
    for (GLenum name = GL_PACK_SWAP_BYTES; name <= GL_PACK_ALIGNMENT; ++name)
        for (const GLint v : {-2, 1, 5, 8})
            set(name, v);
}

void transfers(Asker& ask) {
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_MAP_COLOR, GL_MAP_STENCIL, GL_INDEX_SHIFT, GL_INDEX_OFFSET,
                                       GL_RED_SCALE, GL_BLUE_BIAS, GL_DEPTH_SCALE, GL_DEPTH_BIAS, GL_RGB}) {
        glPixelTransferf(name, -2); // Mesa truncates to integers
        ask.error("transfer " + std::to_string(name));
        if (name != GL_RGB)
            ask.state(name, 1);
    }
    GLfloat map[256] = {0.25f, 2, -1, 0.5f};
    for (const GLsizei n : {0, 3, 4, 1 << 20}) {
        glPixelMapfv(GL_PIXEL_MAP_I_TO_R, n > 256 ? 0 : n, map);
        ask.error("map of indices " + std::to_string(n));
        glPixelMapfv(GL_PIXEL_MAP_R_TO_R, n > 256 ? -1 : n, map);
        ask.error("map of colours " + std::to_string(n));
        ask.state(GL_PIXEL_MAP_I_TO_R_SIZE, 1);
        ask.state(GL_PIXEL_MAP_R_TO_R_SIZE, 1);
        GLfloat out[256] = {};
        glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, out);
        ask.note("map",
                 {static_cast<double>(out[0]), static_cast<double>(out[1]), static_cast<double>(out[2])});
    }
    refused(ask, "no map", [&] { glPixelMapfv(GL_RED, 4, map); });
}

void rectangles(Asker& ask) {
    static GLubyte pixels[4096];
    const auto draw = [&](const std::string& what, GLsizei w, GLsizei h, GLenum format, GLenum type) {
        refused(ask, "draw " + what, [=] { glDrawPixels(w, h, format, type, pixels); });
        refused(ask, "read " + what, [=] { glReadPixels(0, 0, w, h, format, type, pixels); });
    };
    draw("width -1", -1, 4, GL_RGBA, GL_UNSIGNED_BYTE);
    draw("height -1", 4, -1, GL_RGBA, GL_UNSIGNED_BYTE);
    draw("nothing", 0, 0, GL_RGBA, GL_UNSIGNED_BYTE);
    draw("format 0", 4, 4, 0, GL_UNSIGNED_BYTE);
    draw("type 0", 4, 4, GL_RGBA, 0);
    draw("packed of three as four", 4, 4, GL_RGBA, GL_UNSIGNED_BYTE_3_3_2);
    draw("packed of four as three", 4, 4, GL_RGB, GL_UNSIGNED_INT_8_8_8_8);
    draw("bits of colours", 4, 4, GL_RGBA, GL_BITMAP);
    draw("packed depths", 4, 4, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT_5_6_5);
    refused(ask, "copy width -1", [] { glCopyPixels(0, 0, -1, 4, GL_COLOR); });
    refused(ask, "copy of RGBA", [] { glCopyPixels(0, 0, 4, 4, GL_RGBA); });
    refused(ask, "bitmap width -1", [] { glBitmap(-1, 4, 0, 0, 0, 0, pixels); });
    // With a clipped raster position nothing is drawn, and a bitmap does not move it.
    glRasterPos3f(5, 5, 5);
    ask.state(GL_CURRENT_RASTER_POSITION_VALID, 1);
    glBitmap(8, 8, 0, 0, 3, 4, pixels);
    glDrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    ask.error("clipped");
    glRasterPos3f(0, 0, 0);
    glBitmap(0, 0, 0, 0, 3.5f, -4.25f, nullptr);
    ask.state(GL_CURRENT_RASTER_POSITION, 4);
    glBegin(GL_POINTS);
    glEnd();
    refused(ask, "inside", [] {
        glBegin(GL_POINTS);
        glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
        glEnd();
    });
}

void names_of(Asker& ask, const std::string& what, const std::function<void(GLenum)>& set, GLenum query) {
    for (const GLenum v :
         {GLenum{GL_NEVER}, GLenum{GL_ALWAYS}, GLenum{GL_ZERO}, GLenum{GL_ONE}, GLenum{GL_SRC_COLOR},
          GLenum{GL_SRC_ALPHA_SATURATE}, GLenum{GL_CONSTANT_COLOR}, GLenum{GL_KEEP}, GLenum{GL_INCR_WRAP},
          GLenum{GL_COPY}, GLenum{GL_SET}, GLenum{GL_FUNC_ADD}, GLenum{GL_MAX}, GLenum{GL_FRONT},
          GLenum{GL_BACK}, GLenum{GL_NICEST}, GLenum{GL_RGBA}}) {
        set(v);
        ask.error(what + " " + std::to_string(v));
        ask.state(query, 1);
    }
}

} // namespace

Answers pixel_paths() {
    Asker ask;
    stores(ask);
    transfers(ask);
    rectangles(ask);
    return ask.answers;
}

/// Asks every operation with its own names and with others.
Answers fragment_operations() {
    Asker ask;
    names_of(
        ask, "alpha", [](GLenum v) { glAlphaFunc(v, 0.5f); }, GL_ALPHA_TEST_FUNC);
    names_of(
        ask, "depth", [](GLenum v) { glDepthFunc(v); }, GL_DEPTH_FUNC);
    names_of(
        ask, "stencil", [](GLenum v) { glStencilFunc(v, 300, 0xFF); }, GL_STENCIL_FUNC);
    names_of(
        ask, "stencil fail", [](GLenum v) { glStencilOp(v, GL_KEEP, GL_KEEP); }, GL_STENCIL_FAIL);
    names_of(
        ask, "stencil pass", [](GLenum v) { glStencilOp(GL_KEEP, GL_KEEP, v); }, GL_STENCIL_PASS_DEPTH_PASS);
    names_of(
        ask, "source", [](GLenum v) { glBlendFunc(v, GL_ONE); }, GL_BLEND_SRC);
    names_of(
        ask, "equation", [](GLenum v) { glBlendEquation(v); }, GL_BLEND_EQUATION);
    names_of(
        ask, "logic", [](GLenum v) { glLogicOp(v); }, GL_LOGIC_OP_MODE);
    names_of(
        ask, "cull", [](GLenum v) { glCullFace(v); }, GL_CULL_FACE_MODE);
    names_of(
        ask, "front", [](GLenum v) { glFrontFace(v); }, GL_FRONT_FACE);
    names_of(
        ask, "hint", [](GLenum v) { glHint(GL_FOG_HINT, v); }, GL_FOG_HINT);
    names_of(
        ask, "shade", [](GLenum v) { glShadeModel(v); }, GL_SHADE_MODEL);
    refused(ask, "polygon mode", [] { glPolygonMode(GL_FRONT, GL_FRONT); });
    refused(ask, "polygon mode face", [] { glPolygonMode(GL_LEFT, GL_FILL); });
    refused(ask, "scissor", [] { glScissor(0, 0, -1, 4); });
    refused(ask, "clear", [] { glClear(GL_CURRENT_BIT); });
    refused(ask, "accum", [] { glAccum(GL_REPLACE, 1); });
    refused(ask, "point size 0", [] { glPointSize(0); });
    refused(ask, "line width -1", [] { glLineWidth(-1); });
    refused(ask, "read buffer", [] { glReadBuffer(GL_RGBA); });
    refused(ask, "draw buffer", [] { glDrawBuffer(GL_RGBA); });
    ask.state(GL_SCISSOR_BOX, 4);
    ask.state(GL_POINT_SIZE, 1);
    ask.state(GL_LINE_WIDTH, 1);
    glClearColor(2, -1, 0.5f, 7);
    glClearDepth(3);
    glClearStencil(-1);
    glBlendColor(2, -1, 0.5f, 7);
    ask.state(GL_DEPTH_CLEAR_VALUE, 1);
    return ask.answers;
}

} // namespace spangle::oracle
