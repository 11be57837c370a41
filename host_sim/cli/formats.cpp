#include "host_sim/cli/formats.hpp"

#include <algorithm>
#include <vector>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/format.hpp>

#include "boards/scenes/torus.hpp"
#include "host_sim/cli/offscreen.hpp"

namespace spangle::cli {

namespace {

constexpr int cell_width = 160, cell_height = 120, gap = 4, columns = 5;

/// First indices of the three ramps of the palette: a sky, a torus from shade to highlight, and a bar of
/// hues.
constexpr int sky = 0, body = 64, hues = 192;

struct Color {
    float c[3];
};

Color sky_color(float t) {
    return {{0.05f + 0.35f * t, 0.08f + 0.52f * t, 0.25f + 0.65f * t}};
}

/// The hue at t in 0..1, which goes around from red to red.
Color hue_color(float t) {
    const auto part = [t](float peak) {
        const float away = t > peak ? t - peak : peak - t, near = away > 0.5f ? 1 - away : away;
        return std::clamp(2 - 6 * near, 0.0f, 1.0f);
    };
    return {{part(0), part(1 / 3.0f), part(2 / 3.0f)}};
}

constexpr Color shade = {{0.15f, 0.05f, 0.02f}}, lit = {{1, 0.55f, 0.1f}};

/// The colour of the torus at t in 0..1. The lower half of the ramp is diffuse light, the upper half the
/// highlight.
Color body_color(float t) {
    Color out{};
    for (int c = 0; c < 3; ++c)
        out.c[c] =
            t < 0.5f ? shade.c[c] + (lit.c[c] - shade.c[c]) * 2 * t : lit.c[c] + (1 - lit.c[c]) * (2 * t - 1);
    return out;
}

Color palette_color(int index) {
    return index < body   ? sky_color(static_cast<float>(index - sky) / (body - 1 - sky))
           : index < hues ? body_color(static_cast<float>(index - body) / (hues - 1 - body))
                          : hue_color(static_cast<float>(index - hues) / (255 - hues));
}

/// Sets the colour for both modes: as a colour for RGBA, and as the index of the same colour.
void set(const Color& color, float index) {
    glColor3fv(color.c);
    glIndexf(index);
}

void draw_background() {
    glBegin(GL_QUADS);
    set(sky_color(0), sky);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    set(sky_color(1), body - 1);
    glVertex2f(1, 1);
    glVertex2f(-1, 1);
    glEnd();
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= 63; ++i) {
        const float t = static_cast<float>(i) / 63;
        set(hue_color(t), static_cast<float>(hues + i));
        glVertex2f(2 * t - 1, -0.98f);
        glVertex2f(2 * t - 1, -0.84f);
    }
    glEnd();
}

void draw_torus() {
    static constexpr auto mesh = scenes::make_torus<32, 16>(1.0, 0.42, 1, 1);
    static constexpr auto strips = scenes::make_torus_strips<32, 16>();
    const GLfloat light[4] = {0.4f, 0.7f, 1, 0}, white[4] = {1, 1, 1, 1}, dark[4] = {0, 0, 0, 1};
    const GLfloat ambient[4] = {shade.c[0], shade.c[1], shade.c[2], 1},
                  diffuse[4] = {lit.c[0], lit.c[1], lit.c[2], 1};
    const GLfloat indexes[3] = {body, 0.5f * (body + hues), hues - 1};
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glLightfv(GL_LIGHT0, GL_SPECULAR, white);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, white);
    glMaterialfv(GL_FRONT, GL_AMBIENT, ambient);
    glMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
    glMaterialfv(GL_FRONT, GL_SPECULAR, white);
    glMaterialfv(GL_FRONT, GL_EMISSION, dark);
    glMaterialf(GL_FRONT, GL_SHININESS, 24);
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, indexes);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.4 * cell_width / cell_height, 0.4 * cell_width / cell_height, -0.4, 0.4, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0.1f, -3.7f);
    glRotatef(-55, 1, 0, 0);
    glRotatef(20, 0, 1, 0);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof mesh.vertices[0], mesh.vertices[0].position);
    glNormalPointer(GL_FLOAT, sizeof mesh.vertices[0], mesh.vertices[0].normal);
    for (const auto& strip : strips)
        glDrawElements(GL_QUAD_STRIP, static_cast<GLsizei>(strip.size()), GL_UNSIGNED_SHORT, strip.data());
}

/// Makes pixels that are read from indices have the colours of the palette.
void set_pixel_maps() {
    const GLenum names[3] = {GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_G, GL_PIXEL_MAP_I_TO_B};
    for (int c = 0; c < 3; ++c) {
        GLfloat map[256];
        for (int i = 0; i < 256; ++i)
            map[i] = palette_color(i).c[c];
        glPixelMapfv(names[c], 256, map);
    }
}

EGLConfig config_of(EGLDisplay display, PixelFormat format) {
    EGLint count = 0;
    eglGetConfigs(display, nullptr, 0, &count);
    std::vector<EGLConfig> all(static_cast<std::size_t>(count));
    eglGetConfigs(display, all.data(), count, &count);
    const auto get = [display](EGLConfig config, EGLint name) {
        EGLint value = 0;
        eglGetConfigAttrib(display, config, name, &value);
        return value;
    };
    for (const EGLConfig config : all)
        if ((get(config, EGL_NATIVE_VISUAL_ID) & 0xFF) == static_cast<EGLint>(format) &&
            get(config, EGL_DEPTH_SIZE) == 16 && get(config, EGL_SAMPLES) == 0 &&
            get(config, EGL_PRECISION_SPANGLE) == EGL_PRECISION_EXACT_SPANGLE)
            return config;
    return nullptr;
}

/// Draws one cell. Returns false where this build has no surfaces of the format, so that the cell stays
/// black.
bool draw_cell(EGLDisplay display, PixelFormat format, sim::Image& out, int left, int top) {
    const EGLConfig config = config_of(display, format);
    const std::vector<GLubyte> rgba = drawn_offscreen(display, config, cell_width, cell_height, [] {
        glClear(GL_DEPTH_BUFFER_BIT);
        draw_background();
        draw_torus();
        set_pixel_maps();
    });
    for (int y = 0; !rgba.empty() && y < cell_height; ++y)
        for (int x = 0; x < cell_width; ++x)
            std::copy_n(&rgba[static_cast<std::size_t>(4 * ((cell_height - 1 - y) * cell_width + x))], 3,
                        out.at(left + x, top + y));
    return !rgba.empty();
}

} // namespace

std::string draw_formats(sim::Image& out) {
    const int rows = (pixel_formats + columns - 1) / columns;
    out = sim::Image(columns * (cell_width + gap) - gap, rows * (cell_height + gap) - gap);
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        return "eglInitialize failed";
    for (int i = 0; i < pixel_formats; ++i)
        if (!draw_cell(display, static_cast<PixelFormat>(i), out, i % columns * (cell_width + gap),
                       i / columns * (cell_height + gap)))
            return "this build has no surfaces of format " + std::to_string(i);
    return "";
}

} // namespace spangle::cli
