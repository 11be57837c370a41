// A lit, turning gem on an SSD1306 OLED of four pins, at a Raspberry Pi or any Linux board with i2c-dev.
// usage: gem [FRAMES]
//   panel   VCC  GND  SCL      SDA
//   header  3V3  GND  5 (SCL)  3 (SDA)
#include <cstdio>
#include <cstdlib>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/boards/ssd1306_i2c.hpp>
#include <spangle/linux/i2c_bus.hpp>
#include <spangle/message.hpp>
#include <spangle/native.hpp>

using namespace spangle;

static void draw_gem(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0, 0, -4);
    glRotatef(static_cast<float>(3 * frame), 1, 2, 0.5f);
    glBegin(GL_TRIANGLES);
    for (int face = 0; face < 8; ++face) {
        const float x = (face & 1) != 0 ? 1.0f : -1.0f, y = (face & 2) != 0 ? 1.0f : -1.0f,
                    z = (face & 4) != 0 ? 1.0f : -1.0f;
        // Whether the order x, y, z is counter-clockwise seen from outside.
        const bool outward = x * y * z > 0;
        glNormal3f(x * 0.577f, y * 0.577f, z * 0.577f);
        glVertex3f(x, 0, 0);
        glVertex3f(0, outward ? y : 0, outward ? 0 : z);
        glVertex3f(0, outward ? 0 : y, outward ? z : 0);
    }
    glEnd();
}

int main(int argc, char** argv) {
    on_message([](unsigned, const char* text) { std::fprintf(stderr, "gem: %s\n", text); });
    hal::I2cBus bus(hal::i2c_config(boards::ssd1306_i2c, "/dev/i2c-1", 0x3C));
    if (const auto opened = bus.open(); !opened)
        return std::fprintf(stderr, "gem: %s\n", opened.error().rule), 1;
    static hal::BoardDisplay<boards::ssd1306_i2c> panel(bus);
    const EGLDisplay display = eglGetDisplay(native(panel));
    EGLint count = 0, wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 16, EGL_NONE};
    EGLConfig config = nullptr;
    if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, wish, &config, 1, &count))
        return 1; // a message has told why
    const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
    eglMakeCurrent(display, window, window, eglCreateContext(display, config, nullptr, nullptr));
    glMatrixMode(GL_PROJECTION), glFrustum(-1, 1, -0.5, 0.5, 1.5, 10), glMatrixMode(GL_MODELVIEW);
    for (const GLenum system : {GL_DEPTH_TEST, GL_CULL_FACE, GL_LIGHTING, GL_LIGHT0})
        glEnable(system);
    for (int frame = 0; argc < 2 || frame < std::atoi(argv[1]); ++frame)
        if (draw_gem(frame); !eglSwapBuffers(display, window))
            return 1;
    return panel.finish() ? 0 : 1; // the last frame may still be on the wire
}
