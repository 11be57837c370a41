#include "host_sim/cli/samples.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "host_sim/cli/offscreen.hpp"
#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>

namespace spangle::cli {

namespace {

constexpr int cell_width = 80, cell_height = 60, scale = 3, gap = 4, columns = 3, rows = 2;

/// Sets a vertex at `angle` (turns) and `radius` (pixels) from a point.
void vertex_around(float x, float y, float angle, float radius) {
    const float at = 2 * std::numbers::pi_v<float> * angle;
    glVertex2f(x + radius * std::cos(at), y + radius * std::sin(at));
}

void draw_polygon(float x, float y, float radius, float turned, int corners) {
    glBegin(GL_POLYGON);
    for (int i = 0; i < corners; ++i)
        vertex_around(x, y, turned + static_cast<float>(i) / static_cast<float>(corners), radius);
    glEnd();
}

/// Draws polygons, lines of two widths, and points of several sizes.
void draw_edges() {
    glColor4f(0.2f, 0.45f, 0.8f, 1);
    draw_polygon(18, 39, 16, 0.03f, 7);
    glColor4f(0.95f, 0.6f, 0.1f, 1);
    draw_polygon(30, 30, 13, 0.22f, 3);
    glColor4f(1, 1, 1, 1);
    for (int i = 0; i < 8; ++i) {
        glLineWidth(i % 2 == 0 ? 1.0f : 2.5f);
        glBegin(GL_LINES);
        glVertex2f(44, 57);
        vertex_around(44, 57, 0.76f + 0.028f * static_cast<float>(i), 40);
        glEnd();
    }
    glColor4f(0.5f, 0.9f, 0.5f, 1);
    for (int i = 0; i < 4; ++i) {
        glPointSize(2.5f + 2.75f * static_cast<float>(i));
        glBegin(GL_POINTS);
        glVertex2f(6.3f + 9.2f * static_cast<float>(i) + static_cast<float>(i * i), 9.4f);
        glEnd();
    }
}

/// Draws overlapping discs whose alpha falls from 1 in the middle to 0 on the rim.
void draw_fading() {
    constexpr int corners = 24;
    for (int n = 0; n < 6; ++n) {
        const int row = n / 3;
        const auto up = static_cast<float>(row);
        const float x = 14 + 26 * static_cast<float>(n % 3) + 4 * up, y = 19 + 21 * up;
        const float red = n % 3 == 0 ? 0.95f : 0.3f, green = n % 3 == 1 ? 0.9f : 0.4f,
                    blue = n % 3 == 2 ? 1.0f : 0.2f;
        glBegin(GL_TRIANGLE_FAN);
        glColor4f(red, green, blue, 1);
        glVertex2f(x, y);
        glColor4f(red, green, blue, 0);
        for (int i = 0; i <= corners; ++i)
            vertex_around(x, y, static_cast<float>(i) / corners, 19);
        glEnd();
    }
}

struct Cell {
    EGLint samples;
    void (*draw)();
};
/// The cells of the sheet: edges plain, with four samples, and antialiased; discs by alpha test, coverage and
/// blending.
constexpr Cell cells[rows * columns] = {
    {0, draw_edges},
    {4, draw_edges},
    {0,
     [] {
         glEnable(GL_POINT_SMOOTH);
         glEnable(GL_LINE_SMOOTH);
         glEnable(GL_POLYGON_SMOOTH);
         glEnable(GL_BLEND);
         draw_edges();
     }},
    {0,
     [] {
         glEnable(GL_ALPHA_TEST);
         glAlphaFunc(GL_GEQUAL, 0.5f);
         draw_fading();
     }},
    {4,
     [] {
         glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
         draw_fading();
     }},
    {0,
     [] {
         glEnable(GL_BLEND);
         draw_fading();
     }},
};

void enlarge_picture(const std::vector<GLubyte>& rgba, sim::Image& out, int left, int top) {
    for (int y = 0; y < scale * cell_height; ++y)
        for (int x = 0; x < scale * cell_width; ++x)
            std::copy_n(
                &rgba[static_cast<std::size_t>(4 * ((cell_height - 1 - y / scale) * cell_width + x / scale))],
                3, out.at(left + x, top + y));
}

/// Draws one cell. Returns false where this build has no surfaces of that many samples.
bool draw_cell(EGLDisplay display, const Cell& cell, sim::Image& out, int left, int top) {
    const EGLint wish[] = {EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_ALPHA_SIZE,
                           8,
                           EGL_SAMPLES,
                           cell.samples,
                           EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wish, &config, 1, &count) == EGL_FALSE || count == 0)
        return false;
    const std::vector<GLubyte> rgba = drawn_offscreen(display, config, cell_width, cell_height, [&cell] {
        glClearColor(0.07f, 0.08f, 0.12f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, cell_width, 0, cell_height, -1, 1);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        cell.draw();
    });
    if (!rgba.empty())
        enlarge_picture(rgba, out, left, top);
    return !rgba.empty();
}

} // namespace

std::string draw_samples(sim::Image& out) {
    constexpr int width = scale * cell_width, height = scale * cell_height;
    out = sim::Image(columns * (width + gap) - gap, rows * (height + gap) - gap);
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        return "eglInitialize failed";
    for (int i = 0; i < rows * columns; ++i)
        if (!draw_cell(display, cells[i], out, i % columns * (width + gap), i / columns * (height + gap)))
            return "this build has no surfaces of " + std::to_string(cells[i].samples) + " samples";
    return "";
}

} // namespace spangle::cli
