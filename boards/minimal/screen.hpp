#pragma once

#include <spangle/hal/display.hpp>

namespace spangle::minimal {

/// Width and height of the mounted display, in pixels.
inline constexpr int width = 320, height = 240;

/// Starts clocks and pins, gives GL its memory, and returns the display, which is not yet initialised. Call
/// it once, before anything else.
hal::Display& start();

} // namespace spangle::minimal
