// Draws a family of random states with Mesa and writes the planes of each drawing to a file.
//
// usage: mesa_states FAMILY FILE FIRST DRAWINGS
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <GL/osmesa.h>

#include <GL/glext.h>

#include "tests/oracle/mesa/smooth_states.hpp"

namespace {

GLuint sampled = 0, resolved = 0; ///< framebuffers: with samples, and resolved

GLuint framebuffer(int samples) {
    using spangle::oracle::state_size;
    GLuint name = 0, buffer[2] = {};
    glGenFramebuffers(1, &name);
    glGenRenderbuffers(2, buffer);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    const GLenum formats[] = {GL_RGBA8, GL_DEPTH24_STENCIL8},
                 attachments[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_STENCIL_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffer[i]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, formats[i], state_size, state_size);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, buffer[i]);
    }
    return name;
}

bool make_framebuffers(int samples) {
    resolved = framebuffer(0);
    sampled = framebuffer(samples);
    GLint has = 0;
    glGetIntegerv(GL_SAMPLES, &has);
    return has == samples && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void resolve() {
    using spangle::oracle::state_size;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
    glBlitFramebuffer(0, 0, state_size, state_size, 0, 0, state_size, state_size,
                      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved);
}

} // namespace

int main(int argc, char** argv) {
    using namespace spangle::oracle;
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, nullptr);
    std::vector<unsigned char> pixels(std::size_t{state_size} * state_size * 4);
    if (argc != 5 || context == nullptr ||
        OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, state_size, state_size) == 0)
        return 1;
    std::vector<Family> families = all_families();
    families.insert(families.end(), smooth_families().begin(), smooth_families().end());
    for (const Family& family : families) {
        if (std::strcmp(family.id, argv[1]) != 0)
            continue;
        if (family.samples != 0 && !make_framebuffers(family.samples))
            return 1;
        std::FILE* const out = std::fopen(argv[2], "wb");
        if (out == nullptr)
            return 1;
        for (int n = std::atoi(argv[3]); n < std::atoi(argv[3]) + std::atoi(argv[4]); ++n) {
            if (family.samples != 0)
                glBindFramebuffer(GL_FRAMEBUFFER, sampled);
            const Planes planes = draw_state(family, n, family.samples != 0 ? resolve : nullptr).planes;
            std::fwrite(planes.data(), 1, planes.size(), out);
        }
        return std::fclose(out);
    }
    return 1;
}
