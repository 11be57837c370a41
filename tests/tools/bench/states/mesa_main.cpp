// Draws random states on Mesa's llvmpipe, in framebuffers like Spangle's surfaces. Standard input has the
// numbers of the states.
//
// usage: LP_NUM_THREADS=0 bench_states_mesa SEED time    prints "NUMBER MICROSECONDS"
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "tests/tools/bench/states/apply.hpp"
#include "tests/tools/bench/states/timed.hpp"

#include <GL/glext.h>

namespace {

using namespace spangle::bench::states;

/// Opens a context without a surface (EGL_MESA_platform_surfaceless).
bool open_context() {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE || eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
        eglChooseConfig(display, wish, &config, 1, &count) == EGL_FALSE || count == 0)
        return false;
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_FALSE;
}

void attach(GLenum to, GLenum format, int samples) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, canvas_width, canvas_height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, to, GL_RENDERBUFFER, buffer);
}

bool select(const State& of) {
    static GLuint framebuffers[2][2];
    GLuint& name = framebuffers[of[Word::surface]][of[Word::samples]];
    if (name == 0) {
        const int samples = of.has(Word::samples) ? 4 : 0;
        const bool small = of[Word::surface] == surface_565_z16;
        glGenFramebuffers(1, &name);
        glBindFramebuffer(GL_FRAMEBUFFER, name);
        attach(GL_COLOR_ATTACHMENT0, small ? GL_RGB565 : GL_RGBA8, samples);
        attach(small ? GL_DEPTH_ATTACHMENT : GL_DEPTH_STENCIL_ATTACHMENT,
               small ? GL_DEPTH_COMPONENT16 : GL_DEPTH24_STENCIL8, samples);
        glDrawBuffer(GL_COLOR_ATTACHMENT0);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glViewport(0, 0, canvas_width, canvas_height);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3 || std::strcmp(argv[2], "time") != 0) {
        std::fprintf(stderr, "usage: LP_NUM_THREADS=0 bench_states_mesa SEED time < NUMBERS\n");
        return 2;
    }
    if (!open_context()) {
        std::fprintf(stderr, "bench_states_mesa: EGL gives no context without a surface\n");
        return 1;
    }
    const char* const renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    if (std::strstr(renderer, "llvmpipe") == nullptr) {
        std::fprintf(stderr, "bench_states_mesa: this is %s, not llvmpipe\n", renderer);
        return 1;
    }
    return time_all(static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10)), select);
}
