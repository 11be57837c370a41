// All rows of the state tables as they are written, each with its group.
#pragma once

#include <array>
#include <cstddef>

#include "gl/context/state_rows_arrays.hpp"
#include "gl/context/state_rows_fragment.hpp"
#include "gl/context/state_rows_limits.hpp"
#include "gl/context/state_rows_pixel.hpp"
#include "gl/context/state_rows_raster.hpp"
#include "gl/context/state_rows_texture.hpp"
#include "gl/context/state_rows_vertex.hpp"

namespace spangle::gl {

/// Joins the rows of several tables. A section row gives its group to the rows that follow it.
template <std::size_t... N> constexpr auto concatenate(const std::array<WrittenRow, N>&... parts) {
    std::array<WrittenRow, (N + ...)> all{};
    std::size_t used = 0;
    Group group = Group::none;
    const auto add = [&](const auto& part) {
        for (const WrittenRow& row : part) {
            if (row.becomes == Row::section)
                group = row.group;
            all[used] = row;
            all[used++].group = group;
        }
    };
    (add(parts), ...);
    return all;
}

inline constexpr auto written_rows =
    concatenate(vertex_rows, arrays_rows, raster_rows, texture_rows, fragment_rows, pixel_rows, limits_rows);

} // namespace spangle::gl
