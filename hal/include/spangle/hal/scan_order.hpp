// Pictures turned into the order in which the panel scans its memory: rows of the picture that are columns of
// the memory, or that run against the scan, tear whenever they are written.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/hal/orientation.hpp>

namespace spangle::hal {

/// How a picture lies in a buffer whose rows are rows of the memory, from the first scanned row on. Pixel (x,
/// y) is in row y and column x. With `swapped` it is in row x and column y. With `reversed` rows count from
/// the last one.
struct ScanOrder {
    Placement placement; ///< placement of the buffer: MADCTL without MV and MY
    /// Whether the axes are exchanged, and whether rows count from the last.
    bool swapped = false, reversed = false;

    /// Whether the display needs a second buffer, into which pictures are turned.
    constexpr bool turns() const { return swapped || reversed; }
    /// Returns the buffer's row that holds row `along` of the picture or, with `swapped`, column `along`.
    constexpr std::int32_t row_of(std::int32_t along) const {
        return reversed ? placement.size.height - 1 - along : along;
    }
};

/// A placement on the memory cells that place() gives, but without the axes exchanged (MV) and without rows
/// from the bottom (MY).
constexpr ScanOrder scan_order(const PanelDesc& panel, Orientation orientation) {
    const Placement placed = place(panel, orientation);
    ScanOrder out;
    out.swapped = (placed.madctl & dcs::MV) != 0;
    out.reversed = (placed.madctl & dcs::MY) != 0;
    out.placement = placed;
    out.placement.madctl = static_cast<std::uint8_t>(placed.madctl & dcs::MX);
    if (out.swapped) {
        out.placement.size = {placed.size.height, placed.size.width};
        out.placement.offset = {placed.offset.y, placed.offset.x};
    }
    if (out.reversed)
        out.placement.offset.y = static_cast<std::int16_t>(panel.memory.height - out.placement.offset.y -
                                                           out.placement.size.height);
    return out;
}

/// A picture and the buffer it is turned into.
struct TurnedPicture {
    /// The picture's top row.
    const std::uint8_t* from = nullptr;
    std::int32_t from_stride = 0, height = 0; ///< stride and rows of the picture
    /// The buffer's first row.
    std::uint8_t* to = nullptr;
    /// Bytes from row to row of the buffer, and bytes of a pixel of both.
    std::int32_t to_stride = 0, bytes_per_pixel = 0;
};

/// Copies the `damage` of the picture to the buffer, and writes where it lies there to `turned`, which has as
/// many rows as the buffer.
void turn(const ScanOrder& order, const TurnedPicture& picture, const RowSpan* damage, RowSpan* turned);

} // namespace spangle::hal
