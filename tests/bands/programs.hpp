// Programs of one system each: what a band's edge could show in.
#pragma once

#include "tests/bands/banded.hpp"

namespace spangle::test {

/// One unit a pixel.
void start_program(int width, int height);

/// Long batches of every mode, and many short ones (batch_programs.cpp).
std::vector<Program> batch_programs();

/// dither, no dither, stipple, wide, smooth, pixels, stencil, blend, accumulation, outline, samples,
/// viewports.
const std::vector<Program>& programs();

} // namespace spangle::test
