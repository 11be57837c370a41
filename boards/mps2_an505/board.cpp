// Arm MPS2+ with FPGA image AN505: Cortex-M33, secure state.
#include "boards/board.hpp"

#include <spangle/mcu/mps2.hpp>
#include <spangle/native.hpp>

#include "boards/mps2_an505/display.hpp"

namespace spangle::board {

namespace {

constexpr mcu::Mps2 blocks = {.spi = 0x5020A000, .fpgaio = 0x50302000, .clock_hz = 20000000};

alignas(8) __attribute__((section(".noinit"))) unsigned char arena[512 * 1024];

mcu::Mps2Display<boards::mps2_an505, blocks> screen;

} // namespace

const std::uint32_t clock_hz = blocks.clock_hz;

hal::Display& start() {
    memory(arena, sizeof arena);
    return screen.start();
}

std::uint32_t bus_bytes() {
    return screen.bus_bytes();
}

} // namespace spangle::board
