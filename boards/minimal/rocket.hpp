// A lit, textured model that turns: what a program for the smallest boards is made of.
#pragma once

#include <spangle/hal/display.hpp>

namespace spangle::minimal {

/// Opens the display in the fast tier with 16-bit depth, and tells GL all that stays. False: something is not
/// there.
bool open(hal::Display& display);

/// Draws and presents the model, turned by `step` / 64 of a full turn. False: the display did not take it.
bool show(unsigned step);

} // namespace spangle::minimal
