// Rows are what a primitive hands to a span function, several at a time. So the walk along edges and the
// drawing of fragments each have all registers to themselves.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/fill.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {

/// Columns [left, right) of window row y, of which [first, last) are drawn: left <= first < last <= right.
struct Row {
    std::int32_t y, left, right, first, last;
};

/// Draws rows [row, end) of the primitive whose planes the span holds.
template <class P> using RowsFunction = void (*)(Span<P>&, const Row* row, const Row* end);

/// Finds the addresses of column x of row y in the colour plane and, where there is one, in the depth plane.
SPANGLE_INLINE void point_at(std::uint8_t*& color, std::uint8_t*& depth, const Surface& target,
                             std::int32_t x, std::int32_t y, std::int32_t bytes, int depth_shift) {
    color = target.color + std::ptrdiff_t{y} * target.color_stride + std::ptrdiff_t{x} * bytes;
    if (target.depth != nullptr)
        depth = target.depth + std::ptrdiff_t{y} * target.depth_stride + (std::ptrdiff_t{x} << depth_shift);
}

/// The addresses in the colour plane and in the depth plane at which a row begins or ends.
struct RowPlace {
    std::uint8_t *color, *depth;
};

/// A row for stages of lists without runs. The planes are those of the span; the place of the row stays in
/// registers.
struct PlaneRow {
    Span<Fixed>& planes;
    std::uint8_t *color, *depth;        ///< addresses of the fragment from which the list counts
    std::int32_t x, y;                  ///< window position of pixel 0
    std::int32_t dither_column;         ///< column of the fragment from which the list counts
    const inner::Half* words = nullptr; ///< the words of this row (DitherRows)
    const Span<Fixed>::Affine& z = planes.z;
    const Span<Fixed>::Affine (&color_value)[4] = planes.color_value;
    const Span<Fixed>::Affine& fog = planes.fog;
    const Span<Fixed>::Affine (&s)[max_texture_units] = planes.s;
    const Span<Fixed>::Affine (&t)[max_texture_units] = planes.t;
    const Span<Fixed>::Projective& q = planes.q;
    const Span<Fixed>::Projective (&color_q)[Span<Fixed>::colors_over_w] = planes.color_q;
    const Span<Fixed>::Projective& fog_q = planes.fog_q;
    const Span<Fixed>::Unit (&unit)[max_texture_units] = planes.unit;
    const DrawState* state = planes.state;
    std::uint32_t flat_word = planes.flat_word;
    // True where all fog coordinates lie in [0, 1). This is a reference, because set-up sets the value later.
    const bool& fog_inside = planes.fog_inside;

    template <class T> T at(std::int32_t column, const Interpolant<T>& plane) const {
        return plane.at(column + (x - planes.anchor_x), y - planes.anchor_y);
    }
};

/// Makes the span describe this row, for any state.
template <class P> SPANGLE_INLINE void enter(Span<P>& span, const Row& row) {
    span.x = row.left;
    span.y = row.y;
    span.length = row.right - row.left;
    span.begin = row.first - row.left;
    span.end = row.last - row.left;
    point_at(span.color, span.depth, *span.target, row.first, row.y, span.state->color_bytes,
             span.state->depth_bytes >> 1);
}

/// A RowsFunction that calls a function for each row.
template <class P, void (*Draw)(const Span<P>&)> void by_row(Span<P>& span, const Row* row, const Row* end) {
    for (; row != end; ++row) {
        enter(span, *row);
        Draw(span);
    }
}

} // namespace spangle::raster
