// Draws a first triangle on a simulated ST7789, through the installed libraries only.
#include <cstdio>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/boards/boards.hpp>
#include <spangle/native.hpp>
#include <spangle/sim/board.hpp>

int main() {
    spangle::sim::SimBoard board(spangle::boards::st7789_240);
    const EGLDisplay display = eglGetDisplay(spangle::native(board.display()));
    const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, wish, &config, 1, &count) ||
        count == 0)
        return 1;
    const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    if (!eglMakeCurrent(display, window, window, context))
        return 1;
    glBegin(GL_TRIANGLES);
    glColor3f(1.0f, 0.0f, 0.0f);
    glVertex2f(-0.8f, -0.8f);
    glColor3f(0.0f, 1.0f, 0.0f);
    glVertex2f(0.8f, -0.8f);
    glColor3f(0.0f, 0.0f, 1.0f);
    glVertex2f(0.0f, 0.8f);
    glEnd();
    if (!eglSwapBuffers(display, window))
        return 1;
    const spangle::sim::Image glass = board.glass();
    const unsigned char* const middle = glass.at(120, 120);
    std::printf("middle of the glass: %d %d %d, hash %s\n%s", middle[0], middle[1], middle[2],
                spangle::sim::hash(glass).c_str(), board.violations_text().c_str());
    return middle[0] > 32 && middle[1] > 32 && middle[2] > 32 && board.violations().empty() ? 0 : 1;
}
