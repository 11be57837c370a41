#include "boards/minimal/rocket.hpp"

#include <array>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/native.hpp>

#include "boards/minimal/screen.hpp"
#include "boards/scenes/models/rocket.hpp"
#include "boards/scenes/trig.hpp"

namespace spangle::minimal {

namespace {

namespace model = baked::rocket;

// The board computes no floats: all numbers in matrices are constants, and a turn only changes their signs.

/// Half the side of the visible square, in radii of the model.
constexpr double half_view = 1.12;

/// The model's axes after its tilt, which turns it about x by 18 degrees and then about z by -32 degrees. The
/// model's own axis is y.
struct Tilt {
    double across[3], axis[3], towards[3];
};
consteval Tilt tilt() {
    constexpr double z = -32 * scenes::turn / 360, x = 18 * scenes::turn / 360;
    constexpr double cz = scenes::cosine(z), sz = scenes::sine(z), cx = scenes::cosine(x),
                     sx = scenes::sine(x);
    return {{cz, sz, 0}, {-sz * cx, cz * cx, sx}, {sz * sx, -cz * sx, cx}};
}

/// The tilt, then glOrtho() around the model in the units of its arrays. Both stand in the projection matrix,
/// so that the modelview matrix is a plain rotation and keeps the length of normals.
consteval std::array<GLfloat, 16> projection() {
    constexpr Tilt t = tilt();
    constexpr int side = width < height ? width : height;
    constexpr double size = static_cast<double>(model::mesh.position_scale) / half_view;
    constexpr double scale[3] = {size * side / width, size * side / height, -size};
    std::array<GLfloat, 16> m{};
    for (unsigned i = 0; i < 3; ++i) {
        m[i] = static_cast<GLfloat>(scale[i] * t.across[i]);
        m[4 + i] = static_cast<GLfloat>(scale[i] * t.axis[i]);
        m[8 + i] = static_cast<GLfloat>(scale[i] * t.towards[i]);
    }
    m[15] = 1;
    return m;
}

/// The sine of `step` 64ths of a turn.
GLfloat sine(unsigned step) {
    static constexpr auto quarter = [] {
        std::array<GLfloat, 17> table{};
        for (unsigned i = 0; i < table.size(); ++i)
            table[i] = static_cast<GLfloat>(scenes::sine(scenes::turn * i / 64));
        return table;
    }();
    const unsigned place = step & 31;
    const GLfloat value = quarter[place < 16 ? place : 32 - place];
    return (step & 32) != 0 ? -value : value;
}

/// Loads a rotation about y whose cosine is `c` and whose sine is `s`; `y` is 1. With s = 0 the matrix scales
/// x and z by `c`, and y by `y`.
void load_turn(GLfloat c, GLfloat s, GLfloat y) {
    const GLfloat m[16] = {c, 0, -s, 0, 0, y, 0, 0, s, 0, c, 0, 0, 0, 0, 1};
    glLoadMatrixf(m);
}

/// Light, material, viewport and background keep the values that GL begins with. GL's first light stands
/// behind the eye.
void set_up() {
    static constexpr auto to_screen = projection();
    static constexpr GLfloat texels = model::mesh.texcoord_scale;
    static constexpr GLenum systems[] = {GL_TEXTURE_2D, GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST, GL_CULL_FACE};
    glDisable(GL_DITHER);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(to_screen.data());
    glMatrixMode(GL_TEXTURE);
    load_turn(texels, 0, texels);
    glMatrixMode(GL_MODELVIEW);
    baked::load(model::textures[0]);
    for (const GLenum system : systems)
        glEnable(system);
    baked::point_arrays(model::parts[0]);
}

/// The build's profile leaves two configs: config 0 has no depth buffer, config 1 has one. A program whose
/// build has more configs calls eglChooseConfig().
#ifndef MINIMAL_CONFIG
#define MINIMAL_CONFIG 1
#endif

EGLDisplay screen;
EGLSurface window;

} // namespace

/// The function is not inlined, so that its part of the stack is free while frames are drawn.
[[gnu::noinline]] bool open(hal::Display& display) {
    EGLConfig configs[MINIMAL_CONFIG + 1];
    EGLint count = 0;
    screen = eglGetDisplay(native(display));
    if (eglInitialize(screen, nullptr, nullptr) == EGL_FALSE ||
        eglGetConfigs(screen, configs, MINIMAL_CONFIG + 1, &count) == EGL_FALSE || count <= MINIMAL_CONFIG)
        return false;
    const EGLConfig config = configs[MINIMAL_CONFIG];
    window = eglCreateWindowSurface(screen, config, 0, nullptr);
    const EGLContext context = eglCreateContext(screen, config, EGL_NO_CONTEXT, nullptr);
    if (eglMakeCurrent(screen, window, window, context) == EGL_FALSE)
        return false;
    set_up();
    return glGetError() == GL_NO_ERROR;
}

bool show(unsigned step) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    load_turn(sine(step + 16), sine(step), 1);
    baked::draw(model::parts[0]);
    return eglSwapBuffers(screen, window) != EGL_FALSE;
}

} // namespace spangle::minimal
