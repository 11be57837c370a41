// Drawings in states taken at random, the same from Mesa and from Spangle: a family of them a chapter of GL.
#pragma once

#include <vector>

#include "tests/random.hpp"

namespace spangle::oracle {

inline constexpr int state_size = 24; ///< pixels each way

/// What one drawing leaves behind, rows from below: RGBA, stencil and depth (255ths).
inline constexpr int pixel_channels = 6;
using Planes = std::vector<unsigned char>;

struct Family {
    const char* id;
    int drawings;
    int tolerance;    ///< largest difference of a channel, 255ths
    double identical; ///< share of the pixels that must be the same to the bit
    void (*draw)(test::Random&);
};
const std::vector<Family>& all_families();

/// Drawing `n` of a family, from a state of its own that is left as it was; the current drawable has the size
/// above.
Planes draw_state(const Family& family, int n);

} // namespace spangle::oracle
