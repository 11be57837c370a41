// The display of Arm's MPS2+ board, landscape.
#pragma once

#include "boards/mps2/wiring.hpp"

namespace spangle::boards {

inline constexpr hal::Board mps2_an505 =
    mps2_board("mps2_an505", "Arm MPS2+ (Cortex-M33), HX8347 320x240, SPI with start bytes", 20000000);

} // namespace spangle::boards
