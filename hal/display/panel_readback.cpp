// Reads the panel's status, and the pixels in its memory.
#include <spangle/hal/panel_display.hpp>

namespace spangle::hal {
namespace {

/// Reverses the order of pixels of three bytes each.
void reverse_pixels(std::uint8_t* rgb, std::int32_t count) {
    for (std::int32_t i = 0, k = count - 1; i < k; ++i, --k)
        for (std::int32_t c = 0; c < 3; ++c) {
            const std::uint8_t left = rgb[3 * i + c];
            rgb[3 * i + c] = rgb[3 * k + c];
            rgb[3 * k + c] = left;
        }
}

} // namespace

Result<PanelStatus> PanelDisplay::status() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: status before init succeeded"};
    if (const auto r = settle(); !r)
        return r.error();
    return read_status(transfer_.bus(), *layout_.config.panel, scratch_);
}

Result<std::uint16_t> PanelDisplay::scanline() {
    if (!ready_)
        return Error{Fault::bad_argument, "display: scanline before init succeeded"};
    if (const auto r = settle(); !r)
        return r.error();
    return read_scanline(transfer_.bus(), *layout_.config.panel, scratch_);
}

Result<void> PanelDisplay::read_back(const Rect& area, std::uint8_t* rgb) {
    if (!ready_)
        return Error{Fault::bad_argument, "display: read_back before init succeeded"};
    if (const auto r = settle(); !r)
        return r;
    transfer_.forget_window();
    if (!layout_.turns())
        return read_pixels(transfer_.bus(), *layout_.config.panel, layout_.placement(), layout_.config.format,
                           area, rgb, scratch_);
    return read_turned(area, rgb);
}

/// Reads rows of the picture one by one. Each of them is a column or a row of the panel's memory.
Result<void> PanelDisplay::read_turned(const Rect& area, std::uint8_t* rgb) {
    if (area.x < 0 || area.w <= 0 || area.h < 0 || area.w > layout_.picture.width - area.x || area.y < 0 ||
        area.h > layout_.picture.height - area.y)
        return Error{Fault::bad_argument, "panel: the area to read is not inside the picture"};
    const bool backward = layout_.scan.swapped && layout_.scan.reversed;
    const std::int32_t from = backward ? area.x + area.w - 1 : area.x;
    for (std::int32_t y = area.y; y < area.y + area.h; ++y) {
        const Rect part = layout_.scan.swapped ? Rect{y, layout_.scan.row_of(from), 1, area.w}
                                               : Rect{area.x, layout_.scan.row_of(y), area.w, 1};
        if (const auto r = read_pixels(transfer_.bus(), *layout_.config.panel, layout_.placement(),
                                       layout_.config.format, part, rgb, scratch_);
            !r)
            return r;
        if (backward)
            reverse_pixels(rgb, area.w);
        rgb += std::ptrdiff_t{3} * area.w;
    }
    return {};
}

} // namespace spangle::hal
