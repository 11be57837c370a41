#include "tests/tools/bench/states/apply.hpp"

#include "tests/tools/bench/states/shapes.hpp"
#include "tests/tools/bench/states/textures.hpp"

namespace spangle::bench::states {

namespace {

void set_projection(const State& state) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (state.has(Word::view))
        glFrustum(-1, 1, -1, 1, nearest, farthest);
    else
        glOrtho(0, canvas_width, 0, canvas_height, nearest, farthest);
    glMatrixMode(GL_MODELVIEW);
}

/// Lights both sides, because triangles may show either.
void set_lighting(const State& state) {
    const std::uint8_t shade = state[Word::shade];
    glShadeModel(shade == flat ? GL_FLAT : GL_SMOOTH);
    if (shade != lit && shade != lit_specular)
        return;
    const GLfloat alpha = state.has(Word::alpha) ? 0.625f : 1;
    const GLfloat from[] = {0.3f, 0.4f, 0.85f, 0}, diffuse[] = {0.8f, 0.6f, 0.3f, alpha},
                  back[] = {0.2f, 0.5f, 0.9f, alpha}, specular[] = {0.5f, 0.5f, 0.5f, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, from);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_BACK, GL_DIFFUSE, back);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 8);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    if (shade == lit_specular)
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHTING);
}

void set_tests(const State& state) {
    if (state.has(Word::alpha_test)) {
        glEnable(GL_ALPHA_TEST);
        glAlphaFunc(state.value(Word::alpha_test)[0],
                    static_cast<GLfloat>(state.value(Word::alpha_test)[1]) / 16);
    }
    if (state.has(Word::stencil)) {
        const GLenum* const how = state.value(Word::stencil);
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(how[0], 0, ~0u);
        glStencilOp(GL_KEEP, how[1], how[2]);
    }
    if (state.has(Word::depth)) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(state.value(Word::depth)[0]);
        glDepthMask(static_cast<GLboolean>(state.value(Word::depth_write)[0]));
    }
    if (state.has(Word::offset)) {
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(1, 1);
    }
    if (state.has(Word::scissor)) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(canvas_width / 8 + 1, canvas_height / 8 + 1, 3 * canvas_width / 4, 3 * canvas_height / 4);
    }
}

void set_stipple(const State& state) {
    if (!state.has(Word::stipple))
        return;
    GLubyte pattern[128];
    for (int i = 0; i < 128; ++i)
        pattern[i] = i / 4 % 2 == 0 ? 0xCC : 0x77;
    glPolygonStipple(pattern);
    glLineStipple(2, 0x7733);
    glEnable(GL_POLYGON_STIPPLE);
    glEnable(GL_LINE_STIPPLE);
}

void set_writes(const State& state) {
    if (state.has(Word::logic)) {
        glEnable(GL_COLOR_LOGIC_OP);
        glLogicOp(state.value(Word::logic)[0]);
    }
    if (state.has(Word::blend)) {
        const GLenum* const how = state.value(Word::blend);
        glEnable(GL_BLEND);
        glBlendColor(0.25f, 0.5f, 0.75f, 0.375f);
        glBlendFunc(how[0], how[1]);
        glBlendEquation(how[2]);
    }
    const GLenum open = state.value(Word::mask)[0];
    glColorMask((open & 1) != 0, (open & 2) != 0, (open & 4) != 0, (open & 8) != 0);
    (state.has(Word::dither) ? glEnable : glDisable)(GL_DITHER);
}

void set_fog(const State& state) {
    if (!state.has(Word::fog))
        return;
    const GLfloat color[] = {0.5f, 0.6f, 0.7f, 1};
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, static_cast<GLint>(state.value(Word::fog)[0]));
    glFogfv(GL_FOG_COLOR, color);
    glFogf(GL_FOG_START, nearest);
    glFogf(GL_FOG_END, farthest);
    glFogf(GL_FOG_DENSITY, 0.125f);
}

void set_shape(const State& state) {
    const std::uint8_t shape = state[Word::shape];
    glPointSize(shape == large_points ? 8 : 1);
    glLineWidth(shape == wide_lines ? 3 : 1);
    if (state.has(Word::smooth)) {
        glEnable(GL_POINT_SMOOTH);
        glEnable(GL_LINE_SMOOTH);
    }
    if (state.has(Word::samples))
        glEnable(GL_MULTISAMPLE);
}

} // namespace

void apply(const State& state) {
    set_projection(state);
    set_shape(state);
    set_lighting(state);
    set_textures(state);
    set_tests(state);
    set_stipple(state);
    set_writes(state);
    set_fog(state);
}

void prepare(const State& state, int amount) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    glClearDepth(state.has(Word::depth) ? state.value(Word::depth)[1] : 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glPopAttrib();
    if (state.has(Word::depth) && state.value(Word::depth)[0] == GL_EQUAL) {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glDepthFunc(GL_ALWAYS);
        glDepthMask(GL_TRUE);
        glDisable(GL_ALPHA_TEST);
        glDisable(GL_STENCIL_TEST);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        draw(state, amount);
        glPopAttrib();
    }
}

} // namespace spangle::bench::states
