// Draws frames of one scene and prints the hash of the picture of frame 2. callgrind counts the instructions
// of this program, and the hash tells whether a timed picture is right.
//
// usage: frames SCENE WIDTH HEIGHT exact|balanced|fast plain|dither FRAMES
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "boards/scenes/scene.hpp"
#include "tests/tools/bench/headless.hpp"
#include "tests/tools/bench/picture_hash.hpp"

int main(int argc, char** argv) {
    const spangle::scenes::Scene* const scene = argc == 7 ? spangle::scenes::find(argv[1]) : nullptr;
    if (scene == nullptr) {
        std::fprintf(stderr, "usage: frames SCENE WIDTH HEIGHT exact|balanced|fast plain|dither FRAMES\n");
        return 2;
    }
    const int width = std::atoi(argv[2]), height = std::atoi(argv[3]);
    const EGLint precision = std::strcmp(argv[4], "fast") == 0       ? EGL_PRECISION_FAST_SPANGLE
                             : std::strcmp(argv[4], "balanced") == 0 ? EGL_PRECISION_BALANCED_SPANGLE
                                                                     : EGL_PRECISION_EXACT_SPANGLE;
    spangle::bench::Headless gl;
    if (!gl.open(width, height, precision))
        return 1;
    if (std::strcmp(argv[5], "dither") != 0)
        glDisable(GL_DITHER);
    scene->setup(width, height);
    for (int frame = 0; frame < std::atoi(argv[6]); ++frame) {
        scene->draw(frame);
        if (frame == 2)
            std::printf("%08x\n", spangle::bench::picture_hash(width, height));
    }
    gl.close();
    return 0;
}
