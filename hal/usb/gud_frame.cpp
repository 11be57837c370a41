#include "hal/usb/gud_frame.hpp"

#include <algorithm>

#include "hal/display/window_plan.hpp"
#include "hal/usb/gud_pixels.hpp"

namespace spangle::hal {
namespace {

/// What a rectangle costs beyond its pixels, in bytes: SET_BUFFER and its two turn-arounds take an eighth of
/// a millisecond at high speed.
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

/// The size of a piece that fits the device's buffer.
struct Piece {
    std::int32_t columns = 0, rows = 0;
};

/// The largest piece of a rectangle that fits: rows of whole width, or as many pixels of one row as end with
/// a byte. There are no rows where the buffer does not hold the pixels of a byte.
Piece fitting_piece(const gud::Descriptor& device, std::uint8_t format, std::int32_t width,
                    std::int32_t height) {
    const std::uint64_t most = device.max_buffer_size != 0 ? device.max_buffer_size : UINT64_MAX / 8,
                        row = gud::row_bytes(format, static_cast<std::uint32_t>(width));
    if (row <= most)
        return {width, static_cast<std::int32_t>(
                           std::min<std::uint64_t>(most / row, static_cast<std::uint64_t>(height)))};
    const std::uint64_t unit = gud::pixels_per_byte(format), pixels = most * 8 / gud::bits_per_pixel(format);
    return {static_cast<std::int32_t>(pixels / unit * unit), pixels >= unit ? 1 : 0};
}

/// Adds bands of whole rows, or of pieces of rows, that fit the device's buffer.
void add_rect(GudFrame& frame, const GudPicture& picture, const gud::Descriptor& device, std::uint8_t format,
              Rect r) {
    const auto unit = static_cast<std::int32_t>(gud::pixels_per_byte(format));
    r.w += r.x % unit;
    r.x -= r.x % unit;
    const Piece piece = fitting_piece(device, format, r.w, r.h);
    for (std::int32_t y = r.y; y < r.y + r.h; y += piece.rows)
        for (std::int32_t x = r.x; x < r.x + r.w; x += piece.columns)
            add_band(frame, picture, format,
                     {x, y, std::min(piece.columns, r.x + r.w - x), std::min(piece.rows, r.y + r.h - y)});
}

} // namespace

std::uint64_t bands_of(const gud::Descriptor& device, std::uint8_t format, std::int32_t width,
                       std::int32_t height) {
    const bool whole = (device.flags & gud::FULL_UPDATE) != 0;
    const Piece piece = fitting_piece(device, format, width, height);
    if (piece.rows == 0 || (whole && (piece.columns < width || piece.rows < height)))
        return 0;
    const auto parts = [](std::int32_t all, std::int32_t part) {
        return static_cast<std::uint64_t>((all + part - 1) / part);
    };
    return parts(width, piece.columns) * parts(height, piece.rows);
}

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
