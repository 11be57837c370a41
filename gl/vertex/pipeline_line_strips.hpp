// Draws line strips of one colour, in builds with a small vertex cache. Such a strip needs only the window
// positions of its vertices. A small cache would forget a vertex before another strip asks for it, so
// vertices bypass the cache.
#pragma once

#include "gl/vertex/pipeline.hpp"

#if SPANGLE_VERTEX_CACHE != 1

namespace spangle::gl {

/// True if all lines of this draw have one colour, no user plane clips them, and no mode changes how they are
/// drawn.
template <class M, class L> inline bool Pipeline<M, L>::draws_places() const {
    return modes_.mode() == GL_LINE_STRIP && !modes_.is_lit() && !modes_.has_fog() && modes_.units() == 0 &&
           !planes_.any() && !modes_.has_special_lines();
}

/// Draws a line strip. Where a line is not completely visible, draw_lines_of_elements() draws a batch of
/// lines.
template <class M, class L>
template <class I>
void Pipeline<M, L>::draw_line_strip(const ElementReader& reader, std::uint32_t count, const I indices) {
    const raster::DrawState::Area area =
        M::inside_viewport(transforms_, raster::strip_area(*state_, modes_.line_width()));
    if (area.w == 0)
        return draw_lines_of_elements(reader, count, indices, false);
    for (std::uint32_t i = 0; i < count;) {
        i += draw_visible_strip(reader, count - i, indices.from(i), area);
        const std::uint32_t left = count - i, now = left < line_batch ? left : line_batch;
        if (now < 2)
            return;
        draw_lines_of_elements(reader, now, indices.from(i), false);
        i += now - 1;
    }
}

/// Draws lines up to the first element that is not inside of `area`. Returns the index of the last element
/// inside, from which the caller goes on.
template <class M, class L>
template <class I>
std::uint32_t Pipeline<M, L>::draw_visible_strip(const ElementReader& reader, std::uint32_t count,
                                                 const I indices, const raster::DrawState::Area& area) const {
    const raster::DrawState::Area where = area;
    // Instructions with two operands have little room for offsets. On such processors the address is a value
    // of its own.
    const typename M::Transforms* const transforms =
        numeric::three_operands ? &transforms_ : numeric::factor32(&transforms_);
    numeric::LeadingZeros<> zeros; // counts the leading zeros of w
    raster::LineEnd ends[line_batch + 1], *end = ends;
    const auto draw = [&] {
        if (end - ends < 2)
            return;
        raster::draw_strip(*state_, context_->drawable.surface, ends, static_cast<int>(end - ends), unlit_);
        ends[0] = end[-1];
        end = ends + 1;
    };
    const auto seen = [&](std::uint32_t i) __attribute__((always_inline)) {
        const std::uint8_t* const words = reader.vertex.words(indices.at(i));
        return M::seen(*transforms,
                       {{ArrayReader::word(words, 0)},
                        {ArrayReader::word(words, 1)},
                        {ArrayReader::word(words, 2)},
                        numeric::one},
                       where, *end, zeros);
    };
    std::uint32_t i = 0; // `end` is where element i goes
    for (bool all = true; all && i < count;) {
        const auto room = static_cast<std::uint32_t>(ends + line_batch + 1 - end);
        const raster::LineEnd* const last = end + (count - i < room ? count - i : room);
        while (end != last && seen(i))
            ++end, ++i;
        all = end == last;
        draw();
    }
    return i == 0 ? 0 : i - 1;
}

} // namespace spangle::gl

#endif
