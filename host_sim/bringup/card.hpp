// The test card: what a new panel shows of its orientation, colour order, inversion, offset and edges.
#pragma once

#include <spangle/hal/display.hpp>
#include <spangle/sim/image.hpp>

namespace spangle::bringup {

/// A white frame on the outermost pixels of black, an F, and the colours R, G and B beside their letters. On
/// round glass the frame is the outermost pixels that are seen, and the rest lies in the square within.
sim::Image card(int width, int height, bool round = false);

/// Shows a picture of the display's size. `swapped`: with the two bytes of each pixel exchanged, as a driver
/// does that forgets the wire's order.
hal::Result<void> show(hal::Display& display, const sim::Image& picture, bool swapped = false);

} // namespace spangle::bringup
