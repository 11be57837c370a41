// Draws a lit, smooth-shaded, depth-tested picture of 64x48 pixels, and returns its FNV-1a hash.
#include "picture.hpp"

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/native.hpp>

namespace {

constexpr int width = 64, height = 48;
/// A context on a PC keeps the vertices of whole meshes.
alignas(8) unsigned char memory[sizeof(void*) > 4 ? 2 * 1024 * 1024 : 96 * 1024];

bool open() {
    static const EGLint wish[] = {
        EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_DEPTH_SIZE, 16, EGL_NONE};
    static const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    spangle::memory(memory, sizeof memory);
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, wish, &config, 1, &count) ||
        count == 0)
        return false;
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    return eglMakeCurrent(display, surface, surface,
                          eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr)) == EGL_TRUE;
}

void draw() {
    static const GLfloat light[4] = {0.3f, 0.5f, 0.8f, 0.0f};
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.4, 0.4, -0.3, 0.3, 1.0, 10.0);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0.0f, 0.0f, -4.0f);
    glRotatef(33.0f, 0.2f, 1.0f, 0.4f);
    glClearColor(0.1f, 0.2f, 0.3f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    static const GLbyte corner[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    glBegin(GL_TRIANGLES);
    for (int face = 0; face < 8; ++face)
        for (int axis = 0; axis < 3; ++axis) {
            const GLbyte* const at = corner[2 * axis + (face >> axis & 1)];
            glColor3ub(static_cast<GLubyte>(60 + 24 * face), static_cast<GLubyte>(90 * axis), 200);
            glNormal3b(at[0], at[1], at[2]);
            glVertex3s(at[0], at[1], at[2]);
        }
    glEnd();
}

} // namespace

std::uint32_t picture_hash() {
    static unsigned char row[width * 4];
    if (!open())
        return 0;
    draw();
    std::uint32_t hash = 2166136261u;
    for (int y = 0; y < height; ++y) {
        glReadPixels(0, y, width, 1, GL_RGBA, GL_UNSIGNED_BYTE, row);
        for (const unsigned char byte : row)
            hash = (hash ^ byte) * 16777619u;
    }
    return glGetError() == GL_NO_ERROR ? hash : 0;
}
