// Runs a program on the emulated Cortex-M4, for host_sim/profile/firmware/measure.py, and counts its frames
// and its memory. Prints by semihosting a line "frame INSTRUCTIONS HASH" for each frame, and a line "NAME
// BYTES" for each kind of memory. MEASURE_SIZE leaves out all measuring, so that the image is as large as the
// program's own. MEASURE_REPLAYS says that each frame continues the one before, so that none is drawn twice.
// Run the image with -icount shift=0.
#include <cstdint>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/mcu/instructions.hpp>
#include <spangle/mcu/semihosting.hpp>
#include <spangle/mcu/stack.hpp>
#include <spangle/message.hpp>
#include <spangle/native.hpp>

#include "host_sim/profile/firmware/counting.hpp"
#include MEASURE_HEADER

extern "C" {
extern char data_begin, data_end, bss_begin, bss_end;
}

namespace {

using namespace spangle;
namespace semihosting = mcu::semihosting;

constexpr int width = MEASURE_WIDTH, height = MEASURE_HEIGHT;
constexpr std::uint32_t clock_hz = 25'000'000; ///< clock rate of these boards
alignas(8) unsigned char memory_pool[MEASURE_POOL];

std::size_t surface_bytes = 0;

bool open() {
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        return false;
    constexpr EGLint wish[] = {
        EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,  EGL_SURFACE_TYPE,      EGL_PBUFFER_BIT,   EGL_RED_SIZE,
        MEASURE_RED,         EGL_ALPHA_SIZE,  MEASURE_ALPHA,         EGL_DEPTH_SIZE,    16,
        EGL_STENCIL_SIZE,    MEASURE_STENCIL, EGL_PRECISION_SPANGLE, MEASURE_PRECISION, EGL_NONE};
    constexpr EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wish, &config, 1, &count) == EGL_FALSE || count == 0)
        return false;
    const std::size_t before = memory_use().used;
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    surface_bytes = memory_use().used - before;
    const EGLContext context = eglCreateContext(display, config, nullptr, nullptr);
    return eglMakeCurrent(display, surface, surface, context) != EGL_FALSE;
}

#ifndef MEASURE_SIZE

GLubyte row[width * 4];

/// A hash of the picture: FNV-1a over its components, row by row.
std::uint32_t picture_hash() {
    std::uint32_t hash = 2166136261u;
    for (int y = 0; y < height; ++y) {
        glReadPixels(0, y, width, 1, GL_RGBA, GL_UNSIGNED_BYTE, row);
        for (const GLubyte component : row)
            hash = (hash ^ component) * 16777619u;
    }
    return hash;
}

void print(const char* name, std::size_t number) {
    semihosting::print(name);
    semihosting::print(" ");
    semihosting::print_number(static_cast<std::uint32_t>(number));
    semihosting::print("\n");
}

void print_frame(std::uint32_t instructions) {
    semihosting::print("frame ");
    semihosting::print_number(instructions);
    semihosting::print(" ");
    semihosting::print_hex(picture_hash());
    semihosting::print("\n");
}

void print_memory() {
    print("surface", surface_bytes);
    print("peak", memory_use().peak);
    // without what measuring itself needs: the pool, the row of picture_hash() and the counters
    print("static", static_cast<std::size_t>((&data_end - &data_begin) + (&bss_end - &bss_begin)) -
                        sizeof memory_pool - sizeof row - measure::counting_bytes());
    print("stack", mcu::deepest_stack());
}

#endif

} // namespace

int main() {
    spangle::memory(memory_pool, sizeof memory_pool);
#if SPANGLE_MESSAGES
    spangle::on_message([](unsigned, const char* text) {
        semihosting::print("message ");
        semihosting::print(text);
        semihosting::print("\n");
    });
#endif
    const auto& program = MEASURE_PROGRAM;
    if (!open())
        return 1;
    program.setup(width, height);
    if (!MEASURE_REPLAYS)
        program.draw(MEASURE_FIRST); // work that is done once is not counted
#ifdef MEASURE_SIZE
    for (int frame = MEASURE_FIRST;; ++frame)
        program.draw(frame);
#else
    mcu::InstructionCount count(clock_hz);
    for (int frame = MEASURE_FIRST; frame < MEASURE_END; ++frame) {
        count.begin();
        measure::begin_frame();
        program.draw(frame);
        measure::end_frame();
        print_frame(count.end());
    }
    print_memory();
    measure::print_counts();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        print("error", error);
        return 1;
    }
    return 0;
#endif
}
