// What a display module is made of, from the panel's data, and what is seen on it.
#pragma once

#include <memory>
#include <vector>

#include <spangle/hal/orientation.hpp>
#include <spangle/hal/panel.hpp>
#include <spangle/sim/image.hpp>

#include "host_sim/controller/dcs_controller.hpp"

namespace spangle::sim {

/// The panel's controller as the module is built, on this bus.
std::unique_ptr<Controller> make_controller(const hal::PanelDesc& panel, hal::BusKind bus);
/// A DCS panel's chip, its memory as the module straps it.
Chip chip_of(const hal::PanelDesc& panel);
/// How the module is built.
GlassMount mount_of(const hal::PanelDesc& panel);
Image picture_of(const std::vector<Rgb666>& pixels, int width, int height);
/// What the glass shows now, as the module is held with its controller's first row up. Around round glass the
/// picture is transparent.
Image seen(Controller& controller, Time now);
/// Transparent black where a disc that fills the picture does not reach.
void hide_corners(Image& glass);
/// The picture as it was drawn: turned back, then mirrored back.
Image upright(const Image& glass, hal::Orientation o);

} // namespace spangle::sim
