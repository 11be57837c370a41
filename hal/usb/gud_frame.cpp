#include "hal/usb/gud_frame.hpp"

#include <algorithm>

#include "hal/display/window_plan.hpp"
#include "hal/usb/gud_pixels.hpp"

namespace spangle::hal {
namespace {

/// What a rectangle costs beyond its pixels: SET_BUFFER and its two turn-rounds, an eighth of a millisecond
/// at high speed.
constexpr std::uint32_t window_bytes = 2048;

void add_band(GudFrame& frame, const GudPicture& picture, std::uint8_t format, const Rect& r) {
    const auto u = [](std::int32_t v) { return static_cast<std::uint32_t>(v); };
    const std::size_t line = gud::row_bytes(format, u(r.w)), at = frame.wire.size();
    frame.wire.resize(at + line * u(r.h));
    for (std::int32_t y = 0; y < r.h; ++y) {
        const std::size_t first = static_cast<std::size_t>(r.y + y) * u(picture.width) + u(r.x);
        gud::convert_row(format, picture.pixels + 2 * first, r.x, picture.height - 1 - (r.y + y), u(r.w),
                         frame.wire.data() + at + line * u(y));
    }
    const auto length = static_cast<std::uint32_t>(frame.wire.size() - at);
    frame.bands.push_back({{u(r.x), u(r.y), u(r.w), u(r.h), length, 0}, at});
}

/// Bands of whole rows, or pieces of rows, that fit the device's buffer.
void add_rect(GudFrame& frame, const GudPicture& picture, const gud::Descriptor& device, std::uint8_t format,
              Rect r) {
    const auto unit = static_cast<std::int32_t>(gud::pixels_per_byte(format));
    r.w += r.x % unit;
    r.x -= r.x % unit;
    const std::size_t most = device.max_buffer_size != 0 ? device.max_buffer_size : SIZE_MAX;
    const auto row = [&](std::int32_t w) { return gud::row_bytes(format, static_cast<std::uint32_t>(w)); };
    std::int32_t columns = r.w;
    while (columns > unit && row(columns) > most)
        columns = (columns / 2 + unit - 1) / unit * unit;
    const auto fitting = static_cast<std::int64_t>(most / row(columns));
    const auto rows = static_cast<std::int32_t>(std::clamp<std::int64_t>(fitting, 1, r.h));
    for (std::int32_t y = r.y; y < r.y + r.h; y += rows)
        for (std::int32_t x = r.x; x < r.x + r.w; x += columns)
            add_band(frame, picture, format,
                     {x, y, std::min(columns, r.x + r.w - x), std::min(rows, r.y + r.h - y)});
}

} // namespace

void cut(GudFrame& frame, const GudPicture& picture, const gud::Descriptor& device, std::uint8_t format,
         std::uint16_t* plan) {
    frame.bands.clear();
    frame.wire.clear();
    if ((device.flags & gud::FULL_UPDATE) != 0) {
        if (std::any_of(frame.damage.begin(), frame.damage.end(), [](RowSpan r) { return r.begin < r.end; }))
            add_band(frame, picture, format, {0, 0, picture.width, picture.height});
        return;
    }
    const std::uint32_t bytes = std::max<std::uint32_t>(1, gud::bits_per_pixel(format) / 8);
    WindowPlan windows(frame.damage.data(), picture.height, {window_bytes, bytes}, plan);
    for (Rect r; windows.next(r);)
        add_rect(frame, picture, device, format, r);
}

} // namespace spangle::hal
