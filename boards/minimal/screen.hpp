#pragma once

#include <spangle/hal/display.hpp>

namespace spangle::minimal {

/// Clocks, pins, memory for GL; then the display, not yet initialised. Call it once, first.
hal::Display& start();

} // namespace spangle::minimal
