// Draws frames of one scene and nothing else: what callgrind counts instructions of.
//
// usage: frames SCENE WIDTH HEIGHT exact|balanced|fast FRAMES
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "boards/scenes/scene.hpp"
#include "tests/bench/headless.hpp"

int main(int argc, char** argv) {
    const spangle::scenes::Scene* const scene = argc == 6 ? spangle::scenes::find(argv[1]) : nullptr;
    if (scene == nullptr) {
        std::fprintf(stderr, "usage: frames SCENE WIDTH HEIGHT exact|balanced|fast FRAMES\n");
        return 2;
    }
    const EGLint precision = std::strcmp(argv[4], "fast") == 0       ? EGL_PRECISION_FAST_SPANGLE
                             : std::strcmp(argv[4], "balanced") == 0 ? EGL_PRECISION_BALANCED_SPANGLE
                                                                     : EGL_PRECISION_EXACT_SPANGLE;
    spangle::bench::Headless gl;
    if (!gl.open(std::atoi(argv[2]), std::atoi(argv[3]), precision))
        return 1;
    glDisable(GL_DITHER);
    scene->setup(std::atoi(argv[2]), std::atoi(argv[3]));
    for (int frame = 0; frame < std::atoi(argv[5]); ++frame)
        scene->draw(frame);
    gl.close();
    return 0;
}
