// The firmware of the instruction counts: one scene on an MPS2 board, three frames, counted one by one. It
// runs with -icount shift=0. By semihosting it prints a line "frame INSTRUCTIONS HASH" for each frame, and a
// line "NAME BYTES" for each kind of memory. An image that dithers also prints how many fragments a frame
// stores.
#include <cstdint>

#include <spangle/mcu/instructions.hpp>
#include <spangle/mcu/semihosting.hpp>
#include <spangle/mcu/stack.hpp>
#include <spangle/native.hpp>

#include "boards/scenes/scene.hpp"
#include "tests/tools/bench/headless.hpp"
#include "tests/tools/bench/picture_hash.hpp"

#ifndef BENCH_SCENE
#error "define BENCH_SCENE (a scene object), BENCH_PRECISION (an EGL token) and BENCH_DITHERS (true or false)"
#endif

extern "C" {
extern char data_begin, data_end, bss_begin, bss_end;
}

namespace {

using namespace spangle;
namespace semihosting = mcu::semihosting;

constexpr int width = 320, height = 240;
alignas(8) unsigned char memory_pool[1536 * 1024];

void print_number(const char* name, std::size_t number) {
    semihosting::print(name);
    semihosting::print(" ");
    semihosting::print_number(static_cast<std::uint32_t>(number));
    semihosting::print("\n");
}

/// Returns the mean of the frames that were counted.
std::size_t fragments_of(const scenes::Scene& scene) {
    GLuint query = 0, passed = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    for (int frame = 2; frame < 5; ++frame)
        scene.draw(frame);
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
    return passed / 3;
}

} // namespace

int main() {
    spangle::memory(memory_pool, sizeof memory_pool);
    bench::Headless gl;
    if (!gl.open(width, height, BENCH_PRECISION)) {
        semihosting::print("no context\n");
        return 1;
    }
    if (!BENCH_DITHERS)
        glDisable(GL_DITHER);
    const scenes::Scene& scene = scenes::BENCH_SCENE;
    scene.setup(width, height);
    scene.draw(1);                           // work that is done once is not counted
    mcu::InstructionCount count(25'000'000); // clock frequency of these boards in Hz
    for (int frame = 2; frame < 5; ++frame) {
        count.begin();
        scene.draw(frame);
        const std::uint32_t instructions = count.end();
        semihosting::print("frame ");
        semihosting::print_number(instructions);
        semihosting::print(" ");
        semihosting::print_hex(bench::picture_hash(width, height));
        semihosting::print("\n");
    }
    print_number("context", gl.context_bytes);
    print_number("surface", gl.surface_bytes);
    print_number("peak", memory_use().peak);
    // This program's own memory is subtracted: the pool, and the row of picture_hash().
    print_number("static", static_cast<std::size_t>((&data_end - &data_begin) + (&bss_end - &bss_begin)) -
                               sizeof memory_pool - 2048 * 4);
    print_number("stack", mcu::deepest_stack());
    if (BENCH_DITHERS)
        print_number("fragments", fragments_of(scene));
    return glGetError() == GL_NO_ERROR ? 0 : 1;
}
