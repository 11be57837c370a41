// The time of day on an ILI9341 at any computer's USB port, through an FT232H.
// usage: clock [FRAMES [/dev/bus/usb/BBB/DDD]]
//   panel    VCC  GND  CS  RESET  DC  SDI(MOSI)  SCK  LED  SDO(MISO)
//   FT232H   3V3  GND  D3  D6     D4  D1         D0   D7   D2
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/boards/ili9341_spi.hpp>
#include <spangle/message.hpp>
#include <spangle/native.hpp>
#include <spangle/usb/ftdi_bus.hpp>

using namespace spangle;

static void hand(double turns, float length, float width) {
    glLoadIdentity();
    glRotatef(static_cast<float>(-360 * turns), 0, 0, 1);
    glBegin(GL_TRIANGLES);
    glVertex2f(-width, -0.1f), glVertex2f(width, -0.1f), glVertex2f(0, length);
    glEnd();
}

int main(int argc, char** argv) {
    on_message([](unsigned, const char* text) { std::fprintf(stderr, "clock: %s\n", text); });
    hal::FtdiConfig adapter = hal::ftdi_config(boards::ili9341_spi);
    adapter.device_file = argc > 2 ? argv[2] : nullptr;
    hal::FtdiBus bus(adapter);
    if (const auto opened = bus.open(); !opened)
        return std::fprintf(stderr, "clock: %s\n", opened.error().rule), 1;
    static hal::BoardDisplay<boards::ili9341_spi> panel(bus);
    const EGLDisplay display = eglGetDisplay(native(panel));
    EGLint count = 0, wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, wish, &config, 1, &count))
        return 1; // a message has told why
    const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
    eglMakeCurrent(display, window, window, eglCreateContext(display, config, nullptr, nullptr));
    glMatrixMode(GL_PROJECTION), glOrtho(-1.33, 1.33, -1, 1, -1, 1), glMatrixMode(GL_MODELVIEW);
    for (int frame = 0; argc < 2 || frame < std::atoi(argv[1]); ++frame) {
        const std::time_t now = std::time(nullptr);
        const std::tm* const t = std::localtime(&now);
        glClear(GL_COLOR_BUFFER_BIT);
        glColor3f(0.9f, 0.9f, 1), hand((t->tm_hour + t->tm_min / 60.0) / 12, 0.5f, 0.08f);
        glColor3f(0.5f, 0.7f, 1), hand((t->tm_min + t->tm_sec / 60.0) / 60, 0.85f, 0.05f);
        glColor3f(1, 0.3f, 0.2f), hand(t->tm_sec / 60.0, 0.9f, 0.02f);
        while (!eglSwapBuffers(display, window)) { // unplugged: look for the adapter once a second
            if (argc >= 2)
                return 1;
            std::this_thread::sleep_for(std::chrono::seconds(1));
            (void)(bus.open() && panel.init());
        }
    }
    return 0;
}
