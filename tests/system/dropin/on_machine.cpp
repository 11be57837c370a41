// A program for the pair on a modelled machine. It draws changing pictures to a pbuffer and swaps each. When
// it is told to end, it writes what the display shows. ON_MACHINE names the display: spidev, i2c, ftdi, gud;
// none: there is no such machine. ON_MACHINE_GLASS is the picture that it writes.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>

#include "tests/tools/cli/machines.hpp"

namespace {

volatile std::sig_atomic_t ended = 0;

std::unique_ptr<on_machine::Machine> machine_of(const std::string& name) {
    if (name == "spidev")
        return std::make_unique<on_machine::OnSpidev>();
    if (name == "i2c")
        return std::make_unique<on_machine::OnI2c>();
    if (name == "ftdi")
        return std::make_unique<on_machine::OnFtdi>();
    if (name == "gud")
        return std::make_unique<on_machine::OnUsb>();
    return nullptr;
}

void draw(int frame) {
    const float at = 0.1f * static_cast<float>(frame);
    glClearColor(0.2f, at, 0.6f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0);
    glVertex2f(-0.8f + at, -0.8f);
    glColor3f(0, 1, 0);
    glVertex2f(0.8f, -0.8f + at);
    glColor3f(1, 1, 1);
    glVertex2f(0, 0.8f);
    glEnd();
}

/// Writes what the display shows, and prints the rules that were broken. Returns false if the picture could
/// not be written.
bool write_what_is_seen(on_machine::Machine& machine) {
    std::string wrong = machine.wrong();
    if (machine.kernel.open_files() != 0)
        wrong += "files were left open\n";
    std::fputs(wrong.c_str(), stdout);
    const char* const glass = std::getenv("ON_MACHINE_GLASS");
    return glass != nullptr && spangle::sim::write_png(machine.glass(), glass).empty();
}

} // namespace

int main() {
    constexpr int most_frames = 100;
    const char* const name = std::getenv("ON_MACHINE");
    const auto machine = machine_of(name != nullptr ? name : "none");
    std::signal(SIGTERM, [](int) { ended = 1; });
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    EGLConfig config = nullptr;
    EGLint count = 0;
    const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RED_SIZE, 8, EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, 320, EGL_HEIGHT, 240, EGL_NONE};
    eglInitialize(display, nullptr, nullptr);
    eglChooseConfig(display, wish, &config, 1, &count);
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, nullptr, nullptr);
    if (!eglMakeCurrent(display, surface, surface, context))
        return 3;
    for (int frame = 0; frame < most_frames && ended == 0; ++frame) {
        draw(frame);
        eglSwapBuffers(display, surface);
    }
    return machine == nullptr || write_what_is_seen(*machine) ? 0 : 3;
}
