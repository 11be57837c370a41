#include "host_sim/board/module.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

#include "host_sim/controller/hx8347_controller.hpp"
#include "host_sim/controller/mono_controller.hpp"
#include "host_sim/controller/windowed_controller.hpp"

namespace spangle::sim {

std::unique_ptr<Controller> make_controller(const hal::PanelDesc& panel, hal::BusKind bus) {
    const GlassMount mount = mount_of(panel);
    const OledBus oled_bus = bus == hal::BusKind::i2c     ? OledBus::i2c
                             : bus == hal::BusKind::i8080 ? OledBus::parallel
                                                          : OledBus::serial;
    const auto mono = [&](const MonoChip& chip) {
        return std::make_unique<MonoController>(chip, mount, oled_bus);
    };
    const auto windowed = [&](const WindowedChip& chip) {
        return std::make_unique<WindowedController>(chip, mount, oled_bus);
    };
    switch (panel.controller) {
    case hal::Controller::ssd1306:
        return mono(ssd1306);
    case hal::Controller::sh1106:
        return mono(sh1106);
    case hal::Controller::ssd0303:
        return mono(ssd0303);
    case hal::Controller::ssd1327:
        return windowed(ssd1327);
    case hal::Controller::ssd0323:
        return windowed(ssd0323);
    case hal::Controller::ssd1351:
        return windowed(ssd1351);
    case hal::Controller::ssd1331:
        return windowed(ssd1331);
    case hal::Controller::hx8347:
        return std::make_unique<Hx8347Controller>(
            mount, bus == hal::BusKind::i8080 ? RegisterBus::parallel : RegisterBus::start_byte);
    default:
        return std::make_unique<DcsController>(chip_of(panel), mount, bus == hal::BusKind::i8080);
    }
}

Chip chip_of(const hal::PanelDesc& panel) {
    const auto index = static_cast<std::size_t>(panel.controller);
    const Chip chip = index < std::size(chips)
                          ? with_memory_size(chips[index], {panel.memory.width, panel.memory.height})
                          : Chip{};
    if (chip.width == 0)
        throw std::invalid_argument(std::string(panel.name) + ": its controller has no such memory");
    return chip;
}

GlassMount mount_of(const hal::PanelDesc& panel) {
    GlassMount m;
    m.x = panel.offset.x;
    m.y = panel.offset.y;
    m.width = panel.glass.width;
    m.height = panel.glass.height;
    m.mirror_columns = (panel.mount & 0x40) != 0;
    m.mirror_rows = (panel.mount & 0x80) != 0;
    m.bgr_filter = panel.order == hal::ColorOrder::bgr;
    m.normally_inverted = panel.inverted;
    m.round = panel.round;
    return m;
}

Image picture_of(const std::vector<Rgb666>& pixels, int width, int height) {
    Image out(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Rgb666 p = pixels[static_cast<std::size_t>(y * width + x)];
            const auto eight = [](int six) { return static_cast<std::uint8_t>(six << 2 | six >> 4); };
            std::uint8_t* const to = out.at(x, y);
            to[0] = eight(p.r);
            to[1] = eight(p.g);
            to[2] = eight(p.b);
        }
    return out;
}

Image picture_of_glass(Controller& controller, Time now) {
    const GlassMount& mount = controller.mount();
    Image glass = picture_of(controller.glass(now), mount.width, mount.height);
    if (mount.round)
        hide_corners(glass);
    return glass;
}

void hide_corners(Image& glass) {
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x)
            if (!on_disc(x, y, glass.width, glass.height))
                std::fill_n(glass.at(x, y), 4, std::uint8_t{0});
}

Image upright(const Image& glass, hal::Orientation o) {
    const bool across = o.rotation == hal::Rotation::r90 || o.rotation == hal::Rotation::r270;
    Image out(across ? glass.height : glass.width, across ? glass.width : glass.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int px = o.mirrored ? out.width - 1 - x : x;
            int gx = px, gy = y;  // Rotation::r0 leaves the picture as it is
            switch (o.rotation) { // the rotation turned the picture clockwise on the glass
            case hal::Rotation::r90:
                gx = glass.width - 1 - y, gy = px;
                break;
            case hal::Rotation::r180:
                gx = glass.width - 1 - px, gy = glass.height - 1 - y;
                break;
            case hal::Rotation::r270:
                gx = y, gy = glass.height - 1 - px;
                break;
            default:
                break;
            }
            const std::uint8_t* const from = glass.at(gx, gy);
            for (int c = 0; c < 4; ++c)
                out.at(x, y)[c] = from[c];
        }
    return out;
}

} // namespace spangle::sim
