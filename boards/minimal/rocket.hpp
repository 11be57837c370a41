// A lit, textured model that turns: a typical program for the smallest boards.
#pragma once

#include <spangle/hal/display.hpp>

namespace spangle::minimal {

/// Opens the display in the fast tier with 16-bit depth, and sets all state of GL that does not change.
/// Returns false if EGL or GL reports an error.
bool open(hal::Display& display);

/// Draws and presents the model, turned by `step` / 64 of a full turn. Returns false if the display did not
/// take the frame.
bool show(unsigned step);

} // namespace spangle::minimal
