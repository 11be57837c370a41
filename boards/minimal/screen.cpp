// The display of Arm's MPS2+ board (FPGA image AN386), and the memory of the program.
#include "boards/minimal/screen.hpp"

#include <spangle/hal/frame_display.hpp>
#include <spangle/mcu/mps2.hpp>
#include <spangle/native.hpp>

#include "boards/mps2_an386/display.hpp"

namespace spangle::minimal {

namespace {

constexpr mcu::Mps2 blocks = {.spi = 0x40021000, .fpgaio = 0x40028000, .clock_hz = 25000000};
using Wires = mcu::StartByteWires<mcu::Pl022, mcu::RegisterPin, mcu::RegisterPin, mcu::SysTick>;
using Screen = hal::FrameDisplay<boards::mps2_an386, Wires>;

static_assert(hal::picture_size(boards::mps2_an386.display).width == width &&
              hal::picture_size(boards::mps2_an386.display).height == height);

/// Bytes that GL keeps beside the depth buffer. A build of the whole library needs more than this profile,
/// and defines its own number.
#ifndef MINIMAL_GL_BYTES
#define MINIMAL_GL_BYTES 12 * 1024
#endif

alignas(4) std::uint8_t frame[Screen::bytes];
/// GL's memory. It holds a depth buffer of 16 bits a pixel, as large as the frame, and what GL keeps beside
/// it.
alignas(8) __attribute__((section(".noinit"))) unsigned char arena[Screen::bytes + MINIMAL_GL_BYTES];

constinit Wires wires{mcu::Pl022(blocks.spi), blocks.misc(0), blocks.misc(3), mcu::SysTick{blocks.clock_hz}};
constinit Screen screen{wires, frame};

} // namespace

hal::Display& start() {
    memory(arena, sizeof arena);
    mcu::start_display(blocks);
    return screen;
}

} // namespace spangle::minimal
