// Prints "SCENE TIER HASH" for every scene in every tier. The hashes must be the same from every compiler, at
// every optimization, on every instruction set (design, promise 2). One program serves hosts and emulated
// boards.
#include <cstdint>

#include <spangle/native.hpp>

#include "boards/scenes/scene.hpp"
#include "tests/tools/bench/headless.hpp"
#include "tests/tools/bench/picture_hash.hpp"
#ifdef SPANGLE_FIRMWARE
#include <spangle/mcu/semihosting.hpp>
#else
#include <cstdio>
#endif

namespace {

using namespace spangle;

constexpr int width = 320, height = 240;

#ifdef SPANGLE_FIRMWARE
alignas(8) unsigned char memory_pool[2048 * 1024];
void print(const char* text) {
    mcu::semihosting::print(text);
}
#else
void print(const char* text) {
    std::fputs(text, stdout);
}
#endif

void print_hex(std::uint32_t value) {
    char digits[9] = {};
    for (unsigned i = 0; i < 8; ++i)
        digits[i] = "0123456789abcdef"[value >> (28 - 4 * i) & 15];
    print(digits);
}

/// Hashes frames 0 and 1 without dithering, and frame 2 with it. Returns false if GL raised an error.
bool hash_scene(const scenes::Scene& scene, std::uint32_t& hash) {
    hash = bench::no_picture;
    scene.setup(width, height);
    for (int frame = 0; frame < 3; ++frame) {
        if (frame == 2)
            glEnable(GL_DITHER);
        else
            glDisable(GL_DITHER);
        scene.draw(frame);
        hash = bench::picture_hash(width, height, hash);
    }
    return glGetError() == GL_NO_ERROR;
}

} // namespace

int main() {
#ifdef SPANGLE_FIRMWARE
    spangle::memory(memory_pool, sizeof memory_pool);
#endif
    constexpr struct {
        const char* name;
        EGLint precision;
    } tiers[] = {{"exact", EGL_PRECISION_EXACT_SPANGLE},
                 {"balanced", EGL_PRECISION_BALANCED_SPANGLE},
                 {"fast", EGL_PRECISION_FAST_SPANGLE}};
    for (const scenes::Scene& scene : scenes::all())
        for (const auto& tier : tiers) {
            bench::Headless gl;
            std::uint32_t hash = 0;
            if (!gl.open(width, height, tier.precision) || !hash_scene(scene, hash)) {
                print("cannot draw ");
                print(scene.id);
                print("\n");
                return 1;
            }
            gl.close();
            print(scene.id);
            print(" ");
            print(tier.name);
            print(" ");
            print_hex(hash);
            print("\n");
        }
    return 0;
}
