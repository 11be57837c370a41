#pragma once

#include <spangle/hal/display.hpp>

namespace spangle::minimal {

/// Pixels of the display as it hangs.
inline constexpr int width = 320, height = 240;

/// Clocks, pins, memory for GL; then the display, not yet initialised. Call it once, first.
hal::Display& start();

} // namespace spangle::minimal
