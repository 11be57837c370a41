// Draws one scene on surfaces of every format, which shows what each format keeps.
#pragma once

#include <string>

#include <spangle/sim/image.hpp>

namespace spangle::cli {

/// Draws cells of 160x120 pixels in rows of five, in the order of PixelFormat. Returns why they could not be
/// drawn, or an empty string.
std::string draw_formats(sim::Image& out);

} // namespace spangle::cli
