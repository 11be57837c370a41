// Programs that each use one system of GL whose drawing could show the edge of a band.
#pragma once

#include "tests/system/bands/banded.hpp"

namespace spangle::test {

/// Makes one unit a pixel.
void start_program(int width, int height);

/// Returns programs of long batches of every mode, and of many short ones (batch_programs.cpp).
std::vector<Program> batch_programs();

/// dither, no dither, stipple, wide, smooth, pixels, stencil, blend, accumulation, outline, samples,
/// viewports.
const std::vector<Program>& programs();

} // namespace spangle::test
