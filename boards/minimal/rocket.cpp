#include "boards/minimal/rocket.hpp"

#include <array>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/native.hpp>

#include "boards/scenes/models/rocket.hpp"
#include "boards/scenes/trig.hpp"

namespace spangle::minimal {

namespace {

namespace model = baked::rocket;

// Everything is fixed-point, and what does not change is computed by the compiler: no floats on the board.
constexpr GLfixed one = 0x10000;
consteval GLfixed fixed(double value) {
    return static_cast<GLfixed>(value * one + (value < 0 ? -0.5 : 0.5));
}

/// The model's vertices are shorts. The world counts 16 of them as one, so that all of it has room in
/// fixed-point numbers: its radius is `radius`, it stands four of these away.
constexpr double unit = 1.0 / 16, radius = unit / static_cast<double>(model::mesh.position_scale);

/// glFrustum(-0.28 near, 0.28 near, the same, near, far): a model of radius 1 at a distance of 4 fits.
consteval std::array<GLfixed, 16> projection() {
    constexpr double near = radius, far = 8 * radius;
    std::array<GLfixed, 16> m{};
    m[0] = m[5] = fixed(1 / 0.28);
    m[10] = fixed(-(far + near) / (far - near));
    m[11] = -one;
    m[14] = fixed(-2 * far * near / (far - near));
    return m;
}

/// Turns about z and x, the model's own axis being y.
struct Tilt {
    double across[3], axis[3], towards[3];
};
consteval Tilt tilt() {
    constexpr double z = -32 * scenes::turn / 360, x = 18 * scenes::turn / 360;
    constexpr double cz = scenes::cosine(z), sz = scenes::sine(z), cx = scenes::cosine(x),
                     sx = scenes::sine(x);
    return {{cz, sz, 0}, {-sz * cx, cz * cx, sx}, {sz * sx, -cz * sx, cx}};
}

constexpr unsigned steps = 64;
/// Of a step and, a quarter of a turn further, its cosine.
constexpr auto sines = [] {
    std::array<GLshort, steps * 5 / 4> table{};
    for (unsigned i = 0; i < table.size(); ++i) {
        const double value = scenes::sine(scenes::turn * (i % steps) / steps) * 0x4000;
        table[i] = static_cast<GLshort>(value < 0 ? value - 0.5 : value + 0.5);
    }
    return table;
}();

void load_modelview(unsigned step) {
    static constexpr auto columns = [] {
        constexpr Tilt t = tilt();
        std::array<GLfixed, 9> out{};
        for (unsigned i = 0; i < 3; ++i) {
            out[i] = static_cast<GLfixed>(t.across[i] * unit * one);
            out[3 + i] = static_cast<GLfixed>(t.axis[i] * unit * one);
            out[6 + i] = static_cast<GLfixed>(t.towards[i] * unit * one);
        }
        return out;
    }();
    const GLfixed sine = sines[step % steps], cosine = sines[step % steps + steps / 4];
    GLfixed m[16] = {};
    for (unsigned i = 0; i < 3; ++i) {
        m[i] = (columns[i] * cosine - columns[6 + i] * sine) >> 14;
        m[4 + i] = columns[3 + i];
        m[8 + i] = (columns[i] * sine + columns[6 + i] * cosine) >> 14;
    }
    m[14] = fixed(-4 * radius);
    m[15] = one;
    glLoadMatrixxOES(m);
}

void set_up(int width, int height) {
    static constexpr GLfixed light[] = {one / 2, one * 6 / 10, one * 8 / 10, 0};
    static constexpr auto to_screen = projection();
    static constexpr GLfixed texels[] = {2, 0, 0,   0, 0, 2, 0, 0,
                                         0, 0, one, 0, 0, 0, 0, one}; // shorts to 0..1
    const int side = width < height ? width : height;
    glViewport((width - side) / 2, (height - side) / 2, side, side);
    glClearColorxOES(one / 20, one * 7 / 100, one * 16 / 100, one);
    glDisable(GL_DITHER);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixxOES(to_screen.data());
    glMatrixMode(GL_TEXTURE);
    glLoadMatrixxOES(texels);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    baked::load(model::textures[0]);
    glLightxvOES(GL_LIGHT0, GL_POSITION, light);
    for (const GLenum system :
         {GL_TEXTURE_2D, GL_LIGHTING, GL_LIGHT0, GL_RESCALE_NORMAL, GL_DEPTH_TEST, GL_CULL_FACE})
        glEnable(system);
    baked::point_arrays(model::parts[0]);
}

EGLDisplay screen;
EGLSurface window;

} // namespace

/// Not in line: its part of the stack is free again while frames are drawn.
[[gnu::noinline]] bool open(hal::Display& display) {
    static constexpr EGLint wishes[] = {
        EGL_RENDERABLE_TYPE,        EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 16, EGL_PRECISION_SPANGLE,
        EGL_PRECISION_FAST_SPANGLE, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    screen = eglGetDisplay(native(display));
    if (eglInitialize(screen, nullptr, nullptr) == EGL_FALSE ||
        eglChooseConfig(screen, wishes, &config, 1, &count) == EGL_FALSE || count == 0)
        return false;
    window = eglCreateWindowSurface(screen, config, 0, nullptr);
    const EGLContext context = eglCreateContext(screen, config, EGL_NO_CONTEXT, nullptr);
    if (eglMakeCurrent(screen, window, window, context) == EGL_FALSE)
        return false;
    const hal::DisplayInfo info = display.info();
    set_up(info.width, info.height);
    return glGetError() == GL_NO_ERROR;
}

bool show(unsigned step) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    load_modelview(step);
    baked::draw(model::parts[0]);
    return eglSwapBuffers(screen, window) != EGL_FALSE;
}

} // namespace spangle::minimal
