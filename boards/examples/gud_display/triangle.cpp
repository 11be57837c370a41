// A turning triangle on any GUD display (Generic USB Display: gud-pico, Raspberry Pi gadgets, ...).
// usage: triangle [FRAMES [/dev/bus/usb/BBB/DDD]]
// The example needs no kernel driver. If the kernel has one, it takes the display back at the end.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/message.hpp>
#include <spangle/native.hpp>
#include <spangle/usb/gud_display.hpp>

using namespace spangle;

static constexpr GLfloat corners[] = {0, 0.9f, -0.8f, -0.6f, 0.8f, -0.6f};
static constexpr GLubyte colors[] = {255, 40, 40, 255, 40, 255, 40, 255, 60, 60, 255, 255};

int main(int argc, char** argv) {
    on_message([](unsigned, const char* text) { std::fprintf(stderr, "triangle: %s\n", text); });
    hal::GudConfig gud;
    gud.device_file = argc > 2 ? argv[2] : nullptr;
    hal::GudDisplay panel(gud);
    const EGLDisplay display = eglGetDisplay(native(panel));
    EGLint count = 0, wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, wish, &config, 1, &count))
        return 1; // a message has told why
    const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
    eglMakeCurrent(display, window, window, eglCreateContext(display, config, nullptr, nullptr));
    glVertexPointer(2, GL_FLOAT, 0, corners);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    for (int frame = 0; argc < 2 || frame < std::atoi(argv[1]); ++frame) {
        glClear(GL_COLOR_BUFFER_BIT);
        glLoadIdentity();
        glRotatef(static_cast<GLfloat>(3 * frame), 0, 0, 1);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        while (!eglSwapBuffers(display, window)) { // unplugged: look for the display once a second
            if (argc >= 2)
                return 1;
            std::this_thread::sleep_for(std::chrono::seconds(1));
        }
    }
    eglTerminate(display);
    return 0;
}
