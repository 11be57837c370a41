#include "host_sim/board/module.hpp"

#include <stdexcept>
#include <string>

namespace spangle::sim {

Chip chip_of(const hal::PanelDesc& panel) {
    const Chip chip =
        strapped(chips[static_cast<unsigned>(panel.controller)], {panel.memory.width, panel.memory.height});
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

Image upright(const Image& glass, hal::Orientation o) {
    const bool across = o.rotation == hal::Rotation::r90 || o.rotation == hal::Rotation::r270;
    Image out(across ? glass.height : glass.width, across ? glass.width : glass.height);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int px = o.mirrored ? out.width - 1 - x : x;
            int gx = px, gy = y;  // r0
            switch (o.rotation) { // the picture is turned clockwise on the glass
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
