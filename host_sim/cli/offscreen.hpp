// Draws a picture off screen, for the contact sheets of the documents.
#pragma once

#include <vector>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>

namespace spangle::cli {

/// Calls draw() on a pbuffer of that size and returns its pixels: R G B A bytes from the bottom row on.
/// Returns nothing where this build has no such surface.
template <class Draw>
std::vector<GLubyte> drawn_offscreen(EGLDisplay display, EGLConfig config, int width, int height, Draw draw) {
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    std::vector<GLubyte> rgba;
    if (eglMakeCurrent(display, surface, surface, context) != EGL_FALSE) {
        draw();
        rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    if (context != EGL_NO_CONTEXT)
        eglDestroyContext(display, context);
    if (surface != EGL_NO_SURFACE)
        eglDestroySurface(display, surface);
    return rgba;
}

} // namespace spangle::cli
