// The display of Arm's MPS3 board, landscape.
#pragma once

#include "boards/mps2/wiring.hpp"

namespace spangle::boards {

inline constexpr hal::Board mps3_an547 =
    mps2_board("mps3_an547", "Arm MPS3 (Cortex-M55), HX8347 320x240, SPI with start bytes", 32000000);

} // namespace spangle::boards
