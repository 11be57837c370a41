// The firmware of the instruction counts: one scene on an MPS2 board, three frames, counted one by one.
// Prints "SCENE TIER FRAME INSTRUCTIONS HASH" a line by semihosting; run with -icount shift=0.
#include <cstdint>

#include <spangle/native.hpp>

#include "boards/mps2/instructions.hpp"
#include "boards/mps2/semihosting.hpp"
#include "boards/scenes/scene.hpp"
#include "tests/bench/headless.hpp"

#ifndef BENCH_SCENE
#error "define BENCH_SCENE (a scene object) and BENCH_PRECISION (an EGL token)"
#endif

namespace {

using namespace spangle;

constexpr int width = 320, height = 240;
alignas(8) unsigned char memory_pool[1536 * 1024];

std::uint32_t picture_hash() {
    static GLubyte row[width * 4];
    std::uint32_t hash = 2166136261u;
    for (int y = 0; y < height; ++y) {
        glReadPixels(0, y, width, 1, GL_RGBA, GL_UNSIGNED_BYTE, row);
        for (const GLubyte byte : row)
            hash = (hash ^ byte) * 16777619u;
    }
    return hash;
}

} // namespace

int main() {
    spangle::memory(memory_pool, sizeof memory_pool);
    bench::Headless gl;
    if (!gl.open(width, height, BENCH_PRECISION)) {
        semihosting::print("no context\n");
        return 1;
    }
    glDisable(GL_DITHER);
    const scenes::Scene& scene = scenes::BENCH_SCENE;
    scene.setup(width, height);
    scene.draw(1); // what is done once is not counted
    for (int frame = 2; frame < 5; ++frame) {
        const std::uint32_t before = mps2::ticks();
        scene.draw(frame);
        const std::uint32_t after = mps2::ticks();
        semihosting::print(scene.id);
        semihosting::print(" ");
        semihosting::print_number((after - before) * mps2::instructions_per_tick);
        semihosting::print(" ");
        semihosting::print_hex(picture_hash());
        semihosting::print("\n");
    }
    return glGetError() == GL_NO_ERROR ? 0 : 1;
}
