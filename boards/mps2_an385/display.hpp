// The display of Arm's MPS2+ board, landscape.
#pragma once

#include "boards/mps2/wiring.hpp"

namespace spangle::boards {

inline constexpr hal::Board mps2_an385 =
    mps2_board("mps2_an385", "Arm MPS2+ (Cortex-M3), HX8347 320x240, SPI with start bytes", mps2_clock_hz);

} // namespace spangle::boards
