// Draws headers that `spangle bake` wrote; bake_test.py compiles this file with BAKED_HEADER and BAKED_NAME.
// Prints a PPM of 64 x 64 pixels. The exit status is 1 if GL raises an error.
#include <cstdio>
#include <vector>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/message.hpp>

#include BAKED_HEADER

namespace model = spangle::baked::BAKED_NAME;
using namespace spangle;

namespace {

constexpr int side = 64;

bool open() {
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    eglInitialize(display, nullptr, nullptr);
    const EGLint wish[] = {EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_SURFACE_TYPE,
                           EGL_PBUFFER_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           24,
                           EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, side, EGL_HEIGHT, side, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint n = 0;
    eglChooseConfig(display, wish, &config, 1, &n);
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    return eglMakeCurrent(display, surface, surface, eglCreateContext(display, config, nullptr, nullptr)) ==
           EGL_TRUE;
}

} // namespace

int main() {
    on_message([](unsigned, const char* text) { std::fprintf(stderr, "%s\n", text); });
    if (!open())
        return 2;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDisable(GL_DITHER);
    glEnable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION);
    glOrtho(-1.05, 1.05, -1.05, 1.05, -2.0, 2.0);
    glMatrixMode(GL_MODELVIEW);
    glRotatef(30.0f, 1.0f, 1.0f, 0.0f);
#ifdef BAKED_TEXTURE_ONLY
    static const float corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    baked::load(model::textures[0]);
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_QUADS);
    for (const auto& c : corner) {
        glTexCoord2f(c[0] * 0.5f + 0.5f, c[1] * 0.5f + 0.5f);
        glVertex2fv(c);
    }
    glEnd();
#else
    baked::scale_positions(model::mesh);
    baked::scale_texcoords(model::mesh);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    for (GLsizei i = 0; i < model::mesh.parts; ++i) {
        const baked::Part& part = model::mesh.part[i];
        if (part.texture != nullptr) {
            baked::load(*part.texture);
            glEnable(GL_TEXTURE_2D);
        } else {
            glDisable(GL_TEXTURE_2D);
        }
        (part.color.first != nullptr ? glEnable : glDisable)(GL_COLOR_MATERIAL);
        baked::material(part);
        baked::point_arrays(part);
        baked::draw(part);
    }
#endif
    std::vector<unsigned char> pixels(side * side * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, side, side, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    std::printf("P6 %d %d 255\n", side, side);
    std::fwrite(pixels.data(), 1, pixels.size(), stdout);
    return glGetError() == GL_NO_ERROR ? 0 : 1;
}
