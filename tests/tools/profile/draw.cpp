// Runs a program on a host in a build of some profile. Prints a hash of each frame, and each error when it
// was raised. The first word names the program.
#include <cstdio>

#include <spangle/message.hpp>

#include "tests/tools/bench/headless.hpp"
#include "tests/tools/bench/picture_hash.hpp"
#include "tests/tools/profile/find_program.hpp"

#ifndef PROFILE_PRECISION
#error "define PROFILE_PRECISION (an EGL token)"
#endif

namespace {

/// Prints all pending errors. Returns whether there was one.
bool tell_errors() {
    bool any = false;
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
        std::printf("error %04X\n", error);
        any = true;
    }
    return any;
}

} // namespace

int main(int count, char** words) {
    using namespace spangle;
    constexpr int width = 320, height = 240;
    const programs::Program program = count == 2 ? programs::find(words[1]) : programs::Program{};
    if (program.name == nullptr) {
        std::puts("usage: draw PROGRAM");
        return 2;
    }
    on_message([](unsigned, const char* text) { std::printf("message %s\n", text); });
    bench::Headless gl;
    if (!gl.open(width, height, PROFILE_PRECISION))
        return 1;
    program.setup(width, height);
    program.draw(1);
    bool failed = tell_errors();
    for (int frame = 2; frame < 5; ++frame) {
        program.draw(frame);
        failed = tell_errors() || failed;
        std::printf("frame %08X\n", bench::picture_hash(width, height));
        failed = tell_errors() || failed;
    }
    return failed ? 1 : 0;
}
