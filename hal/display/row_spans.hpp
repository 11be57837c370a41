// Intervals of columns: their union, and their part inside of a picture.
#pragma once

#include <spangle/format.hpp>

namespace spangle::hal {

inline RowSpan unite(RowSpan a, RowSpan b) {
    return {a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

/// The columns inside of the picture. Where there are none, the result is RowSpan{}, the canonical empty row.
inline RowSpan clip(RowSpan row, std::int16_t width) {
    const RowSpan inside = {row.begin > 0 ? row.begin : std::int16_t{0}, row.end < width ? row.end : width};
    return inside.begin < inside.end ? inside : RowSpan{};
}

} // namespace spangle::hal
