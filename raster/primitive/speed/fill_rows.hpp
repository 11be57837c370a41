// Fills rows of a triangle, and cuts them only where the scissor rectangle may.
#pragma once

#include "raster/primitive/edge.hpp"
#include "raster/primitive/pen.hpp"

namespace spangle::raster {

namespace detail {

/// Fills the rows of a pen with the next rows of a triangle, cut by the scissor rectangle. Returns the end of
/// the filled rows.
template <class E, class P>
SPANGLE_INLINE Row* fill_rows(TriangleRows<E>& rows, const Pen<P>& pen, Row* begin) {
    return pen.needs_scissor()
               ? rows.template fill<true>(begin, pen.batch, pen.column_begin(), pen.column_end())
               : rows.template fill<false>(begin, pen.batch, 0, 0);
}

} // namespace detail

} // namespace spangle::raster
