// Builds the model of a display module from the data of its panel, and takes pictures of its glass.
#pragma once

#include <memory>
#include <vector>

#include <spangle/hal/orientation.hpp>
#include <spangle/hal/panel.hpp>
#include <spangle/sim/image.hpp>

#include "host_sim/controller/dcs_controller.hpp"

namespace spangle::sim {

/// Returns a model of the panel's controller as the module uses it on this bus.
std::unique_ptr<Controller> make_controller(const hal::PanelDesc& panel, hal::BusKind bus);
/// The chip of a DCS panel, with the memory size that the module straps.
Chip chip_of(const hal::PanelDesc& panel);
/// The part of the frame memory that the module's glass covers, and how the glass is mounted.
GlassMount mount_of(const hal::PanelDesc& panel);
Image picture_of(const std::vector<Rgb666>& pixels, int width, int height);
/// What the glass shows now, when the module is held with its controller's first row up. The picture is
/// transparent outside round glass.
Image picture_of_glass(Controller& controller, Time now);
/// Makes the pixels transparent black that a disc which fills the picture does not reach.
void hide_corners(Image& glass);
/// Turns a picture of the glass back to the picture that was drawn: first rotation, then mirroring is undone.
Image upright(const Image& glass, hal::Orientation o);

} // namespace spangle::sim
