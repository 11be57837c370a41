// Records which columns of a surface were touched.
#pragma once

#include <spangle/raster/surface.hpp>

namespace spangle::raster {

/// Widens the touched interval of GL row y to hold columns [begin, end).
inline void mark_damage(const Surface& s, std::int32_t y, std::int32_t begin, std::int32_t end) {
    if (s.touched == nullptr)
        return;
    RowSpan& row = s.touched[static_cast<std::intptr_t>(y) * s.touched_step];
    if (begin < row.begin)
        row.begin = static_cast<std::int16_t>(begin);
    if (end > row.end)
        row.end = static_cast<std::int16_t>(end);
}

} // namespace spangle::raster
