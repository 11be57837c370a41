// Draws edges and translucent discs with one sample a pixel, with four, and antialiased.
#pragma once

#include <string>

#include <spangle/sim/image.hpp>

namespace spangle::cli {

/// Draws enlarged cells in two rows of three. Returns why they could not be drawn, or an empty string.
std::string draw_samples(sim::Image& out);

} // namespace spangle::cli
