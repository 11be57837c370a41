#include <spangle/hal/scan_order.hpp>

namespace spangle::hal {
namespace {

/// Copies a row of the picture into a column. Rows come in ascending order, so the last row is the end of
/// each span.
template <std::int32_t Bytes>
void turn_row(const std::uint8_t* from, std::uint8_t* to, std::ptrdiff_t step, RowSpan* row,
              std::int32_t row_step, std::int32_t count, std::int32_t column) {
    for (std::int32_t i = 0; i < count; ++i, from += Bytes, to += step, row += row_step) {
        for (std::int32_t b = 0; b < Bytes; ++b)
            to[b] = from[b];
        if (row->begin > column)
            row->begin = static_cast<std::int16_t>(column);
        row->end = static_cast<std::int16_t>(column + 1);
    }
}

} // namespace

void turn(const ScanOrder& order, const TurnedPicture& p, const RowSpan* damage, RowSpan* turned) {
    for (std::int32_t y = 0; y < order.placement.size.height; ++y)
        turned[y] = RowSpan{};
    const std::int32_t direction = order.reversed ? -1 : 1;
    for (std::int32_t y = 0; y < p.height; ++y) {
        const std::int32_t count = damage[y].end - damage[y].begin, x = damage[y].begin;
        if (count <= 0)
            continue;
        const std::uint8_t* const from =
            p.from + static_cast<std::ptrdiff_t>(y) * p.from_stride + x * p.bytes_per_pixel;
        const std::int32_t row = order.row_of(order.swapped ? x : y);
        std::uint8_t* const to = p.to + static_cast<std::ptrdiff_t>(row) * p.to_stride +
                                 (order.swapped ? y : x) * p.bytes_per_pixel;
        if (!order.swapped) {
            for (std::int32_t i = 0; i < count * p.bytes_per_pixel; ++i)
                to[i] = from[i];
            turned[row] = damage[y];
        } else {
            const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(direction) * p.to_stride;
            const auto copy = p.bytes_per_pixel == 2 ? turn_row<2> : turn_row<3>;
            copy(from, to, step, turned + row, direction, count, y);
        }
    }
}

} // namespace spangle::hal
