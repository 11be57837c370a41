// One program on a build of its own profile, on a host: a hash of each frame, and the error that waits.
#include <cstdio>

#include <spangle/message.hpp>

#include "boards/scenes/scene.hpp"
#include "tests/bench/headless.hpp"
#include "tests/bench/picture_hash.hpp"
#include "tests/profile/programs/program.hpp"

#ifndef PROFILE_PROGRAM
#error "define PROFILE_PROGRAM (a program or a scene) and PROFILE_PRECISION (an EGL token)"
#endif

int main() {
    using namespace spangle;
    constexpr int width = 320, height = 240;
    on_message([](unsigned, const char* text) { std::fprintf(stderr, "%s\n", text); });
    bench::Headless gl;
    if (!gl.open(width, height, PROFILE_PRECISION))
        return 1;
    const auto& program = PROFILE_PROGRAM;
    program.setup(width, height);
    program.draw(1);
    for (int frame = 2; frame < 5; ++frame) {
        program.draw(frame);
        std::printf("frame %08X\n", bench::picture_hash(width, height));
    }
    return glGetError() == GL_NO_ERROR ? 0 : 1;
}
