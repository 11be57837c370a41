// Draws one frame of a scene with Mesa and writes it as a PAM file: the oracle. A program of its own, because
// Mesa defines the same gl* names as Spangle.
//
// usage: mesa_scene SCENE WIDTH HEIGHT FRAME FILE.pam        (GALLIUM_DRIVER=softpipe|llvmpipe chooses the
// rasterizer)
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <GL/osmesa.h>

#include "tests/oracle/mesa/probes.hpp"

int main(int argc, char** argv) {
    if (argc != 6) {
        std::fprintf(stderr, "usage: mesa_scene SCENE WIDTH HEIGHT FRAME FILE.pam\n");
        return 2;
    }
    const spangle::scenes::Scene* scene = spangle::oracle::find_picture(argv[1]);
    const int width = std::atoi(argv[2]), height = std::atoi(argv[3]), frame = std::atoi(argv[4]);
    if (scene == nullptr || width < 1 || height < 1 || width > 4096 || height > 4096) {
        std::fprintf(stderr, "mesa_scene: unknown picture '%s' or absurd size\n", argv[1]);
        return 2;
    }
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr);
    std::vector<unsigned char> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    if (context == nullptr ||
        OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, width, height) == 0) {
        std::fprintf(stderr, "mesa_scene: OSMesa gives no context\n");
        return 1;
    }
    glDisable(GL_DITHER);
    scene->setup(width, height);
    scene->draw(frame);
    glFinish();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        std::fprintf(stderr, "mesa_scene: %s raised GL error 0x%04x\n", scene->id, error);
        return 1;
    }
    std::FILE* out = std::fopen(argv[5], "wb");
    if (out == nullptr) {
        std::perror(argv[5]);
        return 1;
    }
    std::fprintf(out, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n", width,
                 height);
    for (int y = height; y-- > 0;)
        std::fwrite(&pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) * 4], 4,
                    static_cast<std::size_t>(width), out);
    return std::fclose(out) == 0 ? 0 : 1;
}
