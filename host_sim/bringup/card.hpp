// The test card, which shows the orientation, colour order, inversion, offset and edges of a new panel.
#pragma once

#include <spangle/hal/display.hpp>
#include <spangle/sim/image.hpp>

namespace spangle::bringup {

/// Draws a white frame on the outermost pixels of black, an F, and the colours R, G and B beside their
/// letters. On round glass the frame consists of the outermost pixels that are seen, and the rest lies in the
/// square inside.
sim::Image card(int width, int height, bool round = false);

/// Shows a picture of the display's size. `swapped` exchanges the two bytes of each pixel, as a driver does
/// that ignores the wire's byte order.
hal::Result<void> show(hal::Display& display, const sim::Image& picture, bool swapped = false);

} // namespace spangle::bringup
