// The firmware that `spangle trade --targets` counts: one scene or baked model in one tier, run with -icount
// shift=0. The command line is "NAME WIDTH HEIGHT FIRST FRAMES DITHER": frame 0 is drawn, then FRAMES from
// FIRST on are counted one by one. By semihosting it prints a line "frame INSTRUCTIONS HASH" for each frame,
// and a line "NAME BYTES" for each kind of memory.
#include <cstdint>

#include <spangle/mcu/instructions.hpp>
#include <spangle/mcu/semihosting.hpp>
#include <spangle/mcu/stack.hpp>
#include <spangle/native.hpp>

#ifdef BENCH_MODEL
#include "boards/scenes/baked_model.hpp"
#include BENCH_MODEL_HEADER
#endif
#include "boards/scenes/scene.hpp"
#include "tests/tools/bench/headless.hpp"
#include "tests/tools/bench/picture_hash.hpp"

#if !defined(BENCH_SCENE) && !defined(BENCH_MODEL)
#error                                                                                                       \
    "define BENCH_SCENE (a scene object), or BENCH_MODEL (a namespace of BENCH_MODEL_HEADER); and BENCH_PRECISION"
#endif

namespace {

using namespace spangle;
namespace semihosting = mcu::semihosting;

alignas(8) unsigned char memory_pool[1536 * 1024];
constexpr std::size_t picture_row = 2048 * 4; // bytes that picture_hash() needs

#ifdef BENCH_MODEL
const baked::Mesh& mesh = baked::BENCH_MODEL::mesh;
constexpr scenes::Scene program = {"MODEL", "a baked model",
                                   [](int width, int height) { scenes::setup_baked(mesh, width, height); },
                                   [](int frame) { scenes::draw_baked(mesh, frame); }};
#else
const scenes::Scene& program = scenes::BENCH_SCENE;
#endif

void print_line(const char* name, std::size_t number) {
    semihosting::print(name);
    semihosting::print(" ");
    semihosting::print_number(static_cast<std::uint32_t>(number));
    semihosting::print("\n");
}

struct Arguments {
    static constexpr int count = 5;
    int number[count] = {};

    /// Reads the command line. Returns false if words are missing.
    bool read() {
        char text[128];
        if (!semihosting::command_line(text, sizeof text))
            return false;
        const char* at = text;
        for (int& out : number) {
            while (*at != '\0' && *at != ' ')
                ++at;
            if (*at++ != ' ' || *at < '0' || *at > '9')
                return false;
            for (; *at >= '0' && *at <= '9'; ++at)
                out = out * 10 + (*at - '0');
        }
        return true;
    }
};

} // namespace

int main() {
    Arguments arguments;
    if (!arguments.read()) {
        semihosting::print("the command line is NAME WIDTH HEIGHT FIRST FRAMES DITHER\n");
        return 2;
    }
    const auto [width, height, first, frames, dither] = arguments.number;
    spangle::memory(memory_pool, sizeof memory_pool);
    bench::Headless gl;
    if (!gl.open(width, height, BENCH_PRECISION)) {
        semihosting::print("no context: the picture does not fit its memory\n");
        return 1;
    }
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    program.setup(width, height);
    (dither != 0 ? glEnable : glDisable)(GL_DITHER);
    program.draw(0);                         // work that is done once is not counted
    mcu::InstructionCount count(25'000'000); // clock frequency in Hz of the boards that count
    for (int frame = first; frame < first + frames; ++frame) {
        count.begin();
        program.draw(frame);
        const std::uint32_t instructions = count.end();
        semihosting::print("frame ");
        semihosting::print_number(instructions);
        semihosting::print(" ");
        semihosting::print_hex(bench::picture_hash(width, height));
        semihosting::print("\n");
    }
    print_line("own", sizeof memory_pool + picture_row);
    print_line("surface", gl.surface_bytes);
    print_line("peak", memory_use().peak);
    print_line("stack", mcu::deepest_stack());
    return glGetError() == GL_NO_ERROR ? 0 : 1;
}
