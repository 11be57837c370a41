// Arm MPS3 with FPGA image AN547: Cortex-M55, secure state.
#include "boards/board.hpp"

#include <spangle/mcu/mps2.hpp>
#include <spangle/native.hpp>

#include "boards/mps3_an547/display.hpp"

namespace spangle::board {

namespace {

constexpr const hal::Board& wiring = boards::mps3_an547;
constexpr mcu::Mps2 blocks = {.spi = 0x59202000, .fpgaio = 0x59302000, .clock_hz = 32000000};

} // namespace

} // namespace spangle::board

#include "boards/mps2/start.inc"
