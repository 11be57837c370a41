// Compares a textured triangle in each tier with the double reference, and stage by stage, through the
// installed libraries only.
#include <cstdio>
#include <initializer_list>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/reference.hpp>

namespace {

constexpr int size = 128;

void draw() {
    GLubyte texels[64 * 64];
    for (unsigned i = 0; i < sizeof texels; ++i)
        texels[i] = static_cast<GLubyte>(i * 37 + i / 64 * 11);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 64, 64, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 16);
    glBegin(GL_TRIANGLES);
    glTexCoord2f(0, 0), glVertex3f(-1.1f, -1, -1.3f);
    glTexCoord2f(3, 0), glVertex3f(3, -2, -4.1f);
    glTexCoord2f(0, 3), glVertex3f(0.2f, 5, -6.3f);
    glEnd();
}

/// Draws in a config of that precision. The result is empty if there is no such config.
spangle::DrawnPicture picture_of(EGLint precision) {
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    const EGLint wish[] = {EGL_SURFACE_TYPE,      EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,        EGL_DEPTH_SIZE,  16,
                           EGL_PRECISION_SPANGLE, precision,       EGL_NONE};
    const EGLint area[] = {EGL_WIDTH, size, EGL_HEIGHT, size, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    spangle::DrawnPicture picture;
    if (!eglInitialize(display, nullptr, nullptr) || !eglChooseConfig(display, wish, &config, 1, &count) ||
        count == 0)
        return picture;
    const EGLSurface surface = eglCreatePbufferSurface(display, config, area);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    if (eglMakeCurrent(display, surface, surface, context)) {
        draw();
        picture = spangle::read_picture();
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglDestroySurface(display, surface);
    return picture;
}

struct Tier {
    const char* name;
    EGLint plain, shadow;
};

} // namespace

int main() {
    if (!picture_of(EGL_PRECISION_DOUBLE_SPANGLE).rgba.empty())
        return std::puts("there is a reference before anything asked for it"), 1;
    spangle::use_reference_engines();
    const spangle::DrawnPicture reference = picture_of(EGL_PRECISION_DOUBLE_SPANGLE);
    double coord = -1;
    for (const Tier& tier :
         {Tier{"exact", EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_SHADOW_SPANGLE},
          Tier{"balanced", EGL_PRECISION_BALANCED_SPANGLE, EGL_PRECISION_SHADOW_BALANCED_SPANGLE},
          Tier{"fast", EGL_PRECISION_FAST_SPANGLE, EGL_PRECISION_SHADOW_FAST_SPANGLE}}) {
        const spangle::DrawnPicture picture = picture_of(tier.plain);
        const spangle::PictureError error = spangle::compare(picture, reference);
        std::printf("%-9s %8.4f %% identical, %2d steps of RGB565 at most, %5.2f dB\n", tier.name,
                    error.identical_percent(), error.max_lsb, error.psnr_565());
        const spangle::StageReport report;
        if (picture_of(tier.shadow).rgba != picture.rgba)
            return std::puts("the shadow draws another picture"), 1;
        double worst = -1;
        for (const spangle::StageError& stage : report.stages()) {
            std::printf("  %-12s %8.2g %s at most, %8.2g RMS\n", stage.stage, stage.worst, stage.unit,
                        stage.rms);
            worst = stage.flips != 0 || stage.unit[0] == 't' ? stage.worst : worst;
        }
        if (worst < coord || error.pixels != size * size || error.compared_depths != error.pixels)
            return std::puts("the figures make no sense"), 1;
        coord = worst;
    }
    return 0;
}
