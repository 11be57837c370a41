// One scene on every format of surfaces: what each of them keeps.
#pragma once

#include <string>

#include <spangle/sim/image.hpp>

namespace spangle::cli {

/// Cells of 160x120 in rows of five, in the order of PixelFormat. Empty, or why it could not be drawn.
std::string draw_formats(sim::Image& out);

} // namespace spangle::cli
