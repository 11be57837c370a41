// Arm MPS2+ with FPGA image AN505: Cortex-M33, secure state.
#include "boards/board.hpp"

#include <spangle/mcu/mps2.hpp>
#include <spangle/native.hpp>

#include "boards/mps2_an505/display.hpp"

namespace spangle::board {

namespace {

constexpr const hal::Board& wiring = boards::mps2_an505;
constexpr mcu::Mps2 blocks = {.spi = 0x5020A000, .fpgaio = 0x50302000, .clock_hz = 20000000};

} // namespace

} // namespace spangle::board

#include "boards/mps2/start.inc"
