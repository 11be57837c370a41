// Programs of the corpus about what happens to a fragment: stencil, tests, blending, patterns.
#include "host_sim/trade/corpus_parts.hpp"

#include <cmath>
#include <initializer_list>

#include <spangle/GL/gl.h>

#include "boards/scenes/textures.hpp"

namespace spangle::trade {

namespace {

constexpr float light[] = {1.5f, 3, -1}; ///< position of the light that casts shadows

/// Draws a box whose faces look outwards, with vertices at -size and size.
void box(float size) {
    constexpr float corners[6][4][3] = {{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
                                        {{1, -1, -1}, {-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}},
                                        {{1, -1, 1}, {1, -1, -1}, {1, 1, -1}, {1, 1, 1}},
                                        {{-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}, {-1, 1, -1}},
                                        {{-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1}},
                                        {{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}}};
    glBegin(GL_QUADS);
    for (const auto& face : corners) {
        glColor3f(0.5f + 0.3f * face[0][0], 0.5f + 0.3f * face[0][1], 0.5f + 0.3f * face[2][2]);
        for (const auto& corner : face)
            glVertex3f(size * corner[0], size * corner[1], size * corner[2]);
    }
    glEnd();
}

/// Draws the sides of the volume that a triangle keeps from the light. The light stands so high that lids of
/// the volume would be out of the view.
void shadow_sides(const float (&corners)[3][3]) {
    glBegin(GL_QUADS);
    for (int i = 0; i < 3; ++i) {
        const float(&a)[3] = corners[i], (&b)[3] = corners[(i + 1) % 3];
        const auto away = [](const float(&from)[3]) {
            glVertex3f(from[0] + 4 * (from[0] - light[0]), from[1] + 4 * (from[1] - light[1]),
                       from[2] + 4 * (from[2] - light[2]));
        };
        glVertex3fv(a);
        away(a);
        away(b);
        glVertex3fv(b);
    }
    glEnd();
}

void shadow_setup(int w, int h) {
    look(w, h, 1, 60);
    glClearStencil(0);
}
void shadow_draw(int f) {
    const float turn = 0.3f * static_cast<float>(f);
    float corners[3][3];
    for (int i = 0; i < 3; ++i) {
        const float a = turn + 2.0944f * static_cast<float>(i);
        const float corner[] = {0.3f + 0.8f * std::cos(a), 0.3f, -3 - 0.8f * std::sin(a)};
        for (int k = 0; k < 3; ++k)
            corners[i][k] = corner[k];
    }
    clear();
    glColor3f(0.8f, 0.75f, 0.6f);
    glBegin(GL_QUADS);
    for (const auto& at : {0, 1, 2, 3})
        glVertex3f(at == 0 || at == 3 ? -6.0f : 6.0f, -1, at < 2 ? -1.0f : -12.0f);
    glEnd();
    glBegin(GL_TRIANGLES);
    for (const auto& corner : corners)
        glColor3f(0.9f, 0.3f, corner[0]), glVertex3fv(corner);
    glEnd();

    glEnable(GL_STENCIL_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glStencilFunc(GL_ALWAYS, 0, 0xFF);
    glEnable(GL_CULL_FACE);
    // Sides that face the viewer count up, the others count down.
    for (const GLenum hidden : std::initializer_list<GLenum>{GL_BACK, GL_FRONT}) {
        glCullFace(hidden);
        glStencilOp(GL_KEEP, GL_KEEP, hidden == GL_BACK ? GL_INCR : GL_DECR);
        shadow_sides(corners);
    }
    glDisable(GL_CULL_FACE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glStencilFunc(GL_NOTEQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_DEPTH_TEST);
    glColor4f(0, 0, 0.1f, 0.6f);
    glBegin(GL_QUADS);
    for (const auto& at : {0, 1, 2, 3})
        glVertex3f(at == 0 || at == 3 ? -2.0f : 2.0f, at < 2 ? -2.0f : 2.0f, -1.5f);
    glEnd();
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glDepthMask(GL_TRUE);
}

void outline_setup(int w, int h) {
    look(w, h, 1, 60);
    glClearStencil(0);
    glEnable(GL_CULL_FACE);
}
void outline_draw(int f) {
    clear();
    glTranslatef(0, 0, -3);
    glRotatef(20 + 13 * static_cast<float>(f), 1, 2, 0);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 0xFF);
    glStencilOp(GL_KEEP, GL_REPLACE, GL_REPLACE);
    box(0.8f);
    glStencilFunc(GL_NOTEQUAL, 1, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
    glStencilMask(0x0F);
    box(0.9f);
    glStencilMask(0xFF);
    glDisable(GL_STENCIL_TEST);
}

void equations_setup(int w, int h) {
    look(w, h, 1, 60);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendColor(0.25f, 0.5f, 0.75f, 0.6f);
}
void equations_draw(int f) {
    constexpr GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    clear();
    for (int i = 0; i < 15; ++i) {
        glBlendEquation(equations[i % 5]);
        if (i % 2 == 0)
            glBlendFunc(GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA);
        else
            glBlendFuncSeparate(GL_SRC_ALPHA_SATURATE, GL_ONE, GL_ONE, GL_ZERO);
        const float at = static_cast<float>((5 * i + f) % 8) * 0.3f - 1.5f;
        sheet(at, at * 0.5f - 0.4f, at + 1.1f, at * 0.5f + 0.6f, -1.5f, 0.1f + 0.06f * static_cast<float>(i));
    }
}

void patterns_setup(int w, int h) {
    look(w, h, 1, 60);
    GLubyte mask[128];
    for (int i = 0; i < 128; ++i)
        mask[i] = static_cast<GLubyte>((i / 4 % 8 < 4) != (i % 4 < 2) ? 0xF3 : 0x3C);
    glPolygonStipple(mask);
    glShadeModel(GL_FLAT);
}
void patterns_draw(int f) {
    clear();
    glTranslatef(0, 0, -2);
    glRotatef(7 * static_cast<float>(f), 0, 1, 1);
    glEnable(GL_POLYGON_STIPPLE);
    sheet(-1.8f, -1, 0.2f, 1.1f, -0.5f, 1);
    glDisable(GL_POLYGON_STIPPLE);
    glEnable(GL_LINE_STIPPLE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    for (int i = 1; i < 5; ++i) {
        glLineStipple(i, 0x5A3F);
        glLineWidth(static_cast<float>(i));
        const float size = 0.25f * static_cast<float>(i);
        sheet(-size, -size, size + 0.6f, size, 0, 1);
    }
    glDisable(GL_LINE_STIPPLE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glPointSize(9);
    sheet(-1.2f, -0.9f, 1.4f, 0.9f, 0.2f, 1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_XOR);
    sheet(0.4f, -0.8f, 1.5f, 0.5f, 0.1f, 1);
    glDisable(GL_COLOR_LOGIC_OP);
}

void smooth_setup(int w, int h) {
    look(w, h, 1, 60);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (const GLenum smooth :
         std::initializer_list<GLenum>{GL_LINE_SMOOTH, GL_POINT_SMOOTH, GL_POLYGON_SMOOTH})
        glEnable(smooth);
}
void smooth_draw(int f) {
    clear();
    glTranslatef(0, 0, -2);
    for (int i = 0; i < 24; ++i) {
        const float a = static_cast<float>(i) * 0.27f + static_cast<float>(f) * 0.02f;
        glLineWidth(0.5f + 0.25f * static_cast<float>(i % 7));
        glPointSize(1.5f + 0.75f * static_cast<float>(i % 9));
        glColor4f(1, 0.8f, 0.04f * static_cast<float>(i), 0.9f);
        glBegin(GL_LINES);
        glVertex3f(0.2f * std::cos(a), 0.2f * std::sin(a), 0),
            glVertex3f(1.3f * std::cos(a), 1.3f * std::sin(a), -1);
        glEnd();
        glBegin(GL_POINTS);
        glVertex3f(1.5f * std::cos(a), 0.9f * std::sin(a), 0);
        glEnd();
        glBegin(GL_TRIANGLES);
        glColor4f(0.2f, 0.5f + 0.5f * std::sin(a), 1, 0.5f);
        for (const float corner : {0.0f, 0.6f, 2.1f})
            glVertex3f(0.8f * std::cos(a) + 0.3f * std::cos(a + corner),
                       0.6f * std::sin(a) + 0.3f * std::sin(a + corner), 0);
        glEnd();
    }
}

void cutout_setup(int w, int h) {
    look(w, h, 1, 60);
    scenes::make_ball();
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_ALPHA_TEST);
    glEnable(GL_SCISSOR_TEST);
    glScissor(w / 16, h / 12, w - w / 9, h - h / 7);
}
void cutout_draw(int f) {
    clear();
    glRotatef(2.3f, 0, 0, 1);
    for (int i = 0; i < 20; ++i) {
        glAlphaFunc(i % 3 == 0   ? GL_GREATER
                    : i % 3 == 1 ? GL_GEQUAL
                                 : GL_NOTEQUAL,
                    0.1f * static_cast<float>(i % 7));
        glDepthFunc(i % 4 == 3 ? GL_ALWAYS : GL_LESS);
        const float x = static_cast<float>((7 * i + f) % 10) * 0.3f - 1.6f,
                    y = static_cast<float>(i % 5) * 0.35f - 0.9f,
                    z = -1.2f - 0.1f * static_cast<float>(i % 6);
        glBegin(GL_TRIANGLE_FAN);
        glColor4f(1, 0.05f * static_cast<float>(i), 0.4f, 0.9f);
        glTexCoord2f(0, 0), glVertex3f(x, y, z);
        glTexCoord2f(1, 0), glVertex3f(x + 0.6f, y + 0.1f, z - 0.3f);
        glColor4f(0.2f, 0.9f, 0.05f * static_cast<float>(i), 0.7f);
        glTexCoord2f(1, 1), glVertex3f(x + 0.5f, y + 0.7f, z - 0.4f);
        glTexCoord2f(0, 1), glVertex3f(x - 0.1f, y + 0.6f, z);
        glEnd();
    }
    glDepthFunc(GL_LESS);
}

} // namespace

const scenes::Scene shadow_scene = {"SHADOW", "a shadow volume counted in the stencil buffer", shadow_setup,
                                    shadow_draw};
const scenes::Scene outline_scene = {"OUTLINE", "a box with an outline by stencil values", outline_setup,
                                     outline_draw};
const scenes::Scene equations_scene = {"EQUATIONS", "sheets by the five blend equations", equations_setup,
                                       equations_draw};
const scenes::Scene patterns_scene = {"PATTERNS", "stipples, polygon modes and a logical operation",
                                      patterns_setup, patterns_draw};
const scenes::Scene smooth_scene = {"SMOOTH", "antialiased lines, points and triangles", smooth_setup,
                                    smooth_draw};
const scenes::Scene cutout_scene = {"CUTOUT", "sprites cut out by alpha, in a scissor box", cutout_setup,
                                    cutout_draw};

} // namespace spangle::trade
