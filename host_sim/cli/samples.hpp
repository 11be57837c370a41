// Edges and translucent things with one sample a pixel, with four, and antialiased.
#pragma once

#include <string>

#include <spangle/sim/image.hpp>

namespace spangle::cli {

/// Cells in two rows of three, enlarged. Empty, or why it could not be drawn.
std::string draw_samples(sim::Image& out);

} // namespace spangle::cli
