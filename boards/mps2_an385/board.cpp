// Arm MPS2+ with FPGA image AN385: Cortex-M3.
#include "boards/board.hpp"

#include <spangle/mcu/mps2.hpp>
#include <spangle/native.hpp>

#include "boards/mps2_an385/display.hpp"

namespace spangle::board {

namespace {

constexpr const hal::Board& wiring = boards::mps2_an385;
constexpr mcu::Mps2 blocks = {.spi = 0x40021000, .fpgaio = 0x40028000, .clock_hz = boards::mps2_clock_hz};

} // namespace

} // namespace spangle::board

#include "boards/mps2/start.inc"
