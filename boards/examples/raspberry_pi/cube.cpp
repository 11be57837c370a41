// A lit, turning cube on an ILI9341 at a Raspberry Pi, or any Linux board with spidev: cube [FRAMES]
//   panel   VCC  GND  CS        RESET    DC       SDI(MOSI)  SCK  LED      SDO(MISO)
//   header  3V3  GND  24 (CE0)  22 (25)  18 (24)  19         23   12 (18)  21
#include <cstdio>
#include <cstdlib>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/boards/ili9341_spi.hpp>
#include <spangle/linux/spidev_bus.hpp>
#include <spangle/message.hpp>
#include <spangle/native.hpp>

using namespace spangle;

static void draw_cube(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0, 0, -5);
    glRotatef(static_cast<float>(2 * frame), 1, 2, 0.5f);
    glBegin(GL_QUADS);
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2, sign = side % 2 * 2 - 1;
        float p[3] = {};
        p[axis] = static_cast<float>(sign);
        glNormal3fv(p);
        glColor3f(axis == 0 ? 0.9f : 0.2f, axis == 1 ? 0.8f : 0.3f, axis == 2 ? 0.9f : 0.1f);
        for (int corner = 0; corner < 4; ++corner) {
            p[(axis + 1) % 3] = corner == 0 || corner == 3 ? -1.0f : 1.0f;
            p[(axis + 2) % 3] = static_cast<float>(corner < 2 ? -sign : sign);
            glVertex3fv(p);
        }
    }
    glEnd();
}

int main(int argc, char** argv) {
    on_message([](unsigned, const char* text) { std::fprintf(stderr, "cube: %s\n", text); });
    const char* const chip = "/dev/gpiochip0";
    const hal::PanelPins pins = {{chip, 25}, {chip, 18}, {}}; // reset line, backlight line, no TE line
    hal::SpidevBus bus(hal::spidev_config(boards::ili9341_spi, "/dev/spidev0.0", {chip, 24}, pins));
    if (const auto opened = bus.open(); !opened)
        return std::fprintf(stderr, "cube: %s\n", opened.error().rule), 1;
    static hal::BoardDisplay<boards::ili9341_spi> panel(bus);
    const EGLDisplay display = eglGetDisplay(native(panel));
    EGLint count = 0, wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, wish, &config, 1, &count))
        return 1; // a message has told why
    const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
    eglMakeCurrent(display, window, window, eglCreateContext(display, config, nullptr, nullptr));
    glMatrixMode(GL_PROJECTION), glFrustum(-0.8, 0.8, -0.6, 0.6, 2, 10), glMatrixMode(GL_MODELVIEW);
    for (const GLenum system : {GL_DEPTH_TEST, GL_CULL_FACE, GL_LIGHTING, GL_LIGHT0, GL_COLOR_MATERIAL})
        glEnable(system);
    for (int frame = 0; argc < 2 || frame < std::atoi(argv[1]); ++frame)
        if (draw_cube(frame); !eglSwapBuffers(display, window))
            return 1;
    return 0;
}
