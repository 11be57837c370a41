// Converts bytes of pixels to colours in the cells of a DCS controller's memory.
#include "host_sim/controller/dcs_controller.hpp"

#include <algorithm>

namespace spangle::sim {

/// The pixel format that COLMOD selects. execute() has reported a value that names no format. The model then
/// goes on with 16 bits per pixel, or with 18 on buses without 16.
DcsController::Format DcsController::format() const {
    const unsigned takes = is_parallel_ ? chip_.parallel_depths : chip_.serial_depths, asked = colmod_ & 7u;
    if ((takes >> asked & 1u) != 0)
        return static_cast<Format>(asked);
    return (takes & depths({5})) != 0 ? Format::rgb565 : Format::rgb666;
}

std::uint64_t DcsController::bytes_of(std::uint64_t pixels) const {
    switch (format()) {
    case Format::rgb444:
        return (pixels * 3 + 1) / 2;
    case Format::rgb565:
        return pixels * 2;
    default:
        return pixels * 3;
    }
}

std::uint64_t DcsController::window_pixels() const {
    return column_start_ > column_end_ || page_start_ > page_end_
               ? 1
               : static_cast<std::uint64_t>(column_end_ - column_start_ + 1) *
                     static_cast<std::uint64_t>(page_end_ - page_start_ + 1);
}

/// Finds the memory cell of a host address, if there is one (ST7735R datasheet, 9.11; the other chips do the
/// same).
bool DcsController::locate_cell(int x, int y, int& column, int& row) const {
    const int c = (madctl_ & dcs::rows_and_columns_exchanged) != 0 ? y : x,
              r = (madctl_ & dcs::rows_and_columns_exchanged) != 0 ? x : y;
    column = (madctl_ & dcs::columns_mirrored) != 0 ? chip_.width - 1 - c : c;
    row = (madctl_ & dcs::rows_mirrored) != 0 ? chip_.height - 1 - r : r;
    return column >= 0 && column < chip_.width && row >= 0 && row < chip_.height;
}

void DcsController::begin_write(bool restart, Time now) {
    scan_until(now);
    if (!is_awake_)
        report(Rule::write_in_sleep, "RAMWR while asleep", now);
    if (restart) {
        column_ = column_start_;
        page_ = page_start_;
    }
    int c0, r0, c1, r1;
    const bool inside =
        locate_cell(column_start_, page_start_, c0, r0) && locate_cell(column_end_, page_end_, c1, r1);
    if (!inside)
        return; // the command that set the window has reported it
    const auto [left, right] = std::minmax(c0, c1);
    const auto [top, bottom] = std::minmax(r0, r1);
    if (left < glass_.x || right >= glass_.x + glass_.width || top < glass_.y ||
        bottom >= glass_.y + glass_.height)
        report(Rule::window,
               "the window reaches memory that no glass shows: columns " + std::to_string(left) + ".." +
                   std::to_string(right) + ", rows " + std::to_string(top) + ".." + std::to_string(bottom),
               now);
}

void DcsController::pixel_byte(std::uint8_t byte, Time now) {
    ++stream_bytes_;
    pixel_bytes_[static_cast<std::size_t>(pixel_byte_count_++)] = byte;
    const Format f = format();
    const int whole = f == Format::rgb565 ? 2 : 3;
    if (f == Format::rgb444 &&
        pixel_byte_count_ == 2) // RRRRGGGG BBBBRRRR GGGGBBBB: two pixels in three bytes
        put_pixel(decode_pixel(0), now);
    if (pixel_byte_count_ < whole)
        return;
    pixel_byte_count_ = 0;
    put_pixel(decode_pixel(3), now);
}

/// Decodes the pixel in pixel_bytes_. `nibble` is the place of the red of a 12-bit pixel, in nibbles.
Rgb666 DcsController::decode_pixel(int nibble) const {
    const auto six = [](int v) { return static_cast<std::uint8_t>(v & 63); };
    if (format() == Format::rgb666)
        return {six(pixel_bytes_[0] >> 2), six(pixel_bytes_[1] >> 2), six(pixel_bytes_[2] >> 2)};
    if (format() == Format::rgb444) {
        const auto four = [this, six](int n) {
            const int v = pixel_bytes_[static_cast<std::size_t>(n / 2)] >> (n % 2 == 0 ? 4 : 0) & 15;
            return six(v << 2 | v >> 2);
        };
        return {four(nibble), four(nibble + 1), four(nibble + 2)};
    }
    const int word = pixel_bytes_[0] << 8 | pixel_bytes_[1];
    const int green = word >> 5 & 63, low = chip_.low_bit_from_green ? green & 1 : 0;
    return {six(word >> 11 << 1 | low), six(green), six((word & 31) << 1 | low)};
}

void DcsController::put_pixel(Rgb666 color, Time now) {
    int column, row;
    if (locate_cell(column_, page_, column, row)) {
        if (has_te_ && !has_torn_ && is_display_on_ && stream_pixels_ != 0) {
            // The scan stands in this row: the rows above show the new picture, and those below the old one.
            const int line = scan_line(now);
            if (line == row && line > 0 && column_ == column_start_) {
                has_torn_ = true;
                report(Rule::tear,
                       "the write crossed the scan line at row " + std::to_string(row) + ", frame " +
                           std::to_string(frames_scanned(now)),
                       now);
            }
        }
        if (now >= next_row_at_) // a row is shown as it was when its scan began
            scan_until(now);
        memory_[static_cast<std::size_t>(row * chip_.width + column)] = color;
        ++pixels_written_;
    }
    ++stream_pixels_;
    if (++column_ <= column_end_)
        return;
    column_ = column_start_;
    if (++page_ > page_end_)
        page_ = page_start_;
}

void DcsController::end_write(Time now) {
    if (!writes_memory() || stream_bytes_ == 0)
        return;
    const std::uint64_t window = window_pixels();
    for (const unsigned other : {2u, 3u})
        if (bytes_of(window) != window * other && stream_bytes_ == window * other) {
            report(Rule::color_format,
                   "the window was filled with " + std::to_string(other) + " bytes a pixel, COLMOD is " +
                       hex_text(colmod_),
                   now);
            return;
        }
    // A stream of 12-bit pixels with an odd count ends with two bytes, the second of which is half used; that
    // is no fault.
    const bool half = format() == Format::rgb444 ? pixel_byte_count_ == 1 : pixel_byte_count_ != 0;
    if (half)
        report(Rule::half_pixel, "the pixel stream ended inside a pixel: one byte slipped", now);
    if (stream_pixels_ % window != 0 || stream_pixels_ > window)
        report(Rule::pixel_count,
               std::to_string(stream_pixels_) + " pixels were sent to a window of " + std::to_string(window),
               now);
}

} // namespace spangle::sim
