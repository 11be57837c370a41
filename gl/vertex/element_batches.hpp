// Draws lines and triangle strips of elements in batches.
//
// ElementBatches owns nothing between draws. It takes elements of arrays that is_common(). Each step
// (transform, division, set-up in the rasterizer) processes a whole batch, so that no operation waits for the
// result of another. It promises the pictures that elements one by one would give.
#pragma once

#include <type_traits>

#include "gl/vertex/cached_vertices.hpp"
#include "raster/primitive/line_end.hpp"

namespace spangle::gl {

template <class M, class L> class ElementBatches : public CachedVertices<M, L> {
    using Base = CachedVertices<M, L>;

  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;
    using ClippedVertex = gl::ClippedVertex<M, L>;

#if SPANGLE_VERTEX_CACHE != 1
    void draw_line_elements(const ElementReader& reader, std::uint32_t count, const Indices& indices,
                            bool normals);
    void draw_strip_elements(const ElementReader& reader, std::uint32_t count, const Indices& indices,
                             bool normals, bool textured);
#endif

  protected:
    using Base::assembler_;
    using Base::context_;
    using Base::divide;
    using Base::draw;
    using Base::draw_common_triangle;
    using Base::lines;
    using Base::modes_;
    using Base::planes_;
    using Base::process_common;
    using Base::read_position;
    using Base::set_flags;
    using Base::state_;
    using Base::transforms_;
    using Base::unlit_;
    using Base::vertex_slot_;
#if SPANGLE_VERTEX_CACHE != 1
    using Base::common_element;
#endif

    /// True if vertices of line strips bypass the cache. A small cache forgets a vertex before the next strip
    /// asks for it.
    static constexpr bool skips_cache_for_strips =
        vertex_cache < 1024 && std::is_same_v<Window, raster::FixedVertex>;
    /// Number of vertices that a Pending holds. A line strip of line_batch lines has one vertex more than
    /// lines.
    static constexpr int pending_vertices = (numeric::cheap_branches ? 1 : 4) * line_batch + 1;

    /// Vertices of lines and strips that are not drawn yet. `projections` holds the clip coordinates of
    /// `fresh`, the vertices among them that are not yet divided by w.
    struct Pending {
        Vertex *vertex[pending_vertices], *fresh[line_batch];
        typename M::template Projections<line_batch> projections;
        int count = 0, unprojected_count = 0;
        Pending() { vertex[0] = vertex[1] = nullptr; } // vertex[0] and [1] are read even while `count` is 0
    };

#if SPANGLE_VERTEX_CACHE != 1
    bool draws_places() const;
    template <class I> void draw_line_strip(const ElementReader& reader, std::uint32_t count, I indices);
    template <class I>
    [[gnu::noinline]] std::uint32_t draw_visible_strip(const ElementReader& reader, std::uint32_t count,
                                                       I indices, const raster::DrawState::Area& area) const;
    template <class I>
    [[gnu::noinline]] void draw_lines_of_elements(const ElementReader& reader, std::uint32_t count, I indices,
                                                  bool normals);
    template <class I>
    [[gnu::noinline]] void draw_strip_of_elements(const ElementReader& reader, std::uint32_t count, I indices,
                                                  bool normals, bool textured);
    template <class I>
    [[gnu::noinline]] void draw_strip_batches(const ElementReader& reader, std::uint32_t count, I indices,
                                              bool normals, bool textured);
    [[gnu::noinline]] void draw_strip(Pending& p, std::uint32_t first);
    void release_drawn(Pending& p, int left);
    SPANGLE_INLINE void add_unprojected(Pending& p, Vertex& v, const std::uint8_t* words);
    void divide(Pending& lines);
    [[gnu::noinline]] void draw_pending(Pending& p);
#endif
};

#if SPANGLE_VERTEX_CACHE != 1

/// Draws lines of elements. Aligned indices of 16 bits have a loop of their own.
template <class M, class L>
inline void ElementBatches<M, L>::draw_line_elements(const ElementReader& reader, std::uint32_t count,
                                                     const Indices& indices, bool normals) {
    const auto lines = [&](const auto& of) {
        if constexpr (skips_cache_for_strips)
            if (draws_places())
                return draw_line_strip(reader, count, of);
        draw_lines_of_elements(reader, count, of, normals);
    };
    if (const Indices::Shorts shorts = indices.shorts(); shorts.data != nullptr)
        return lines(shorts);
    lines(indices);
}

/// Draws a triangle strip of elements. Aligned indices of 16 bits have a loop of their own.
template <class M, class L>
inline void ElementBatches<M, L>::draw_strip_elements(const ElementReader& reader, std::uint32_t count,
                                                      const Indices& indices, bool normals, bool textured) {
    const auto strip = [&](const auto& of) {
        if constexpr (!numeric::cheap_branches)
            if (count > line_batch)
                return draw_strip_batches(reader, count, of, normals, textured);
        draw_strip_of_elements(reader, count, of, normals, textured);
    };
    if (const Indices::Shorts shorts = indices.shorts(); shorts.data != nullptr)
        return strip(shorts);
    strip(indices);
}

/// True if all lines of this draw have one colour, no user plane clips them, and no mode changes how they are
/// drawn.
template <class M, class L> inline bool ElementBatches<M, L>::draws_places() const {
    return modes_.mode() == GL_LINE_STRIP && !modes_.is_lit() && !modes_.has_fog() && modes_.units() == 0 &&
           !planes_.any() && !modes_.has_special_lines();
}

/// Draws a line strip. Where a line is not completely visible, draw_lines_of_elements() draws a batch of
/// lines.
template <class M, class L>
template <class I>
void ElementBatches<M, L>::draw_line_strip(const ElementReader& reader, std::uint32_t count,
                                           const I indices) {
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
std::uint32_t ElementBatches<M, L>::draw_visible_strip(const ElementReader& reader, std::uint32_t count,
                                                       const I indices,
                                                       const raster::DrawState::Area& area) const {
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

/// Draws lines of elements in batches. Each step (transform, division, set-up in the rasterizer) processes a
/// whole batch, so that no operation waits for the result of another.
template <class M, class L>
template <class I>
void ElementBatches<M, L>::draw_lines_of_elements(const ElementReader& reader, std::uint32_t count,
                                                  const I indices, bool normals) {
    Pending lines;
    // A copy of lines.count that may stay in a register; lines.count is set only for draw_pending().
    int held = 0;
    const auto draw = [&] {
        lines.count = held;
        draw_pending(lines);
        held = lines.count;
    };
    const auto place = [&](Vertex& cached) -> Vertex& {
        if ((cached.flags & is_pending) != 0) [[unlikely]]
            draw();
        if ((cached.flags & is_pending) == 0) [[likely]]
            return cached;
        // The vertex that draw() left over is in `cached`, so that the new vertex takes a slot.
        return lines.vertex[0] == &vertex_slot_[0] ? vertex_slot_[1] : vertex_slot_[0];
    };
    const auto begin = [&](Vertex& v, const std::uint8_t* words) {
        // A batch gains nothing where branches are cheap.
        if constexpr (numeric::cheap_branches)
            return process_common(v, words);
        add_unprojected(lines, v, words);
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        Vertex& v = common_element(reader, indices.at(i), normals, false, place, begin);
        v.flags |= is_pending;
        lines.vertex[held++] = &v;
        if (i == 0 && modes_.mode() == GL_LINE_LOOP) {
            divide(lines);
            vertex_slot_[2] = v;
        }
        if (!numeric::cheap_branches && lines.unprojected_count == line_batch)
            divide(lines);
        if (held == pending_vertices)
            draw();
    }
    draw();
    if (held == 0)
        return;
    lines.vertex[0]->flags &= ~is_pending;
    if (modes_.mode() == GL_LINE_LOOP && count > 1) { // end() draws the line that closes the loop
        assembler_.close_loop(vertex_slot_[2], *lines.vertex[0]);
    }
}

/// Draws a triangle strip vertex by vertex. The addresses of its last two vertices stay in registers.
template <class M, class L>
template <class I>
void ElementBatches<M, L>::draw_strip_of_elements(const ElementReader& reader, std::uint32_t count,
                                                  const I indices, bool normals, bool textured) {
    // The last two vertices, ordered so that all triangles have the same winding.
    Vertex *even = nullptr, *odd = nullptr;
    const auto place = [&](Vertex& cached) -> Vertex& {
        Vertex* v = &cached;
        for (Vertex* slot = vertex_slot_; v == even || v == odd; ++slot) // one of three slots is free
            v = slot;
        return *v;
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        Vertex* const v = &common_element(
            reader, indices.at(i), normals, textured, place,
            [this](Vertex& fresh, const std::uint8_t* words) { process_common(fresh, words); });
        if (i >= 2)
            draw_common_triangle(*even, *odd, *v, false);
        ((i & 1) == 0 ? even : odd) = v;
    }
}

/// Draws a triangle strip in batches: first all vertices of a batch, then their triangles. The window
/// positions are known long before the facing test needs them.
template <class M, class L>
template <class I>
void ElementBatches<M, L>::draw_strip_batches(const ElementReader& reader, std::uint32_t count,
                                              const I indices, bool normals, bool textured) {
    Pending corners;
    int held = 0; // this copy of corners.count may stay in a register
    std::uint32_t first = 0;
    const auto draw = [&] {
        corners.count = held;
        draw_strip(corners, first);
        first += static_cast<std::uint32_t>(held - corners.count);
        held = corners.count;
    };
    const auto place = [&](Vertex& cached) -> Vertex& {
        const auto taken = [&] { return (cached.flags & is_pending) != 0; };
        if (taken())
            draw();
        Vertex* v = &cached;
        for (Vertex* slot = vertex_slot_; taken() && (v == corners.vertex[0] || v == corners.vertex[1]);
             ++slot)
            v = slot; // v is one of the two vertices that draw() left over
        return *v;
    };
    const auto begin = [&](Vertex& v, const std::uint8_t* words) { add_unprojected(corners, v, words); };
    for (std::uint32_t i = 0; i < count; ++i) {
        Vertex& v = common_element(reader, indices.at(i), normals, textured, place, begin);
        v.flags |= is_pending;
        corners.vertex[held++] = &v;
        if (corners.unprojected_count == line_batch)
            divide(corners);
        if (held == pending_vertices)
            draw();
    }
    draw();
    release_drawn(corners, 0);
}

/// Draws the triangles of the pending vertices. `first` is the number of the first pending vertex within the
/// strip. The last two vertices stay pending.
template <class M, class L> void ElementBatches<M, L>::draw_strip(Pending& p, std::uint32_t first) {
    divide(p);
    for (int i = 2; i < p.count; ++i) {
        // Odd triangles swap two corners, so that all triangles have the same winding.
        const bool even = ((first + static_cast<std::uint32_t>(i)) & 1) == 0;
        draw_common_triangle(*p.vertex[even ? i - 2 : i - 1], *p.vertex[even ? i - 1 : i - 2], *p.vertex[i],
                             false);
    }
    release_drawn(p, p.count < 2 ? p.count : 2);
}

/// Releases all pending vertices except the last `left`, which the next primitive starts from.
template <class M, class L> inline void ElementBatches<M, L>::release_drawn(Pending& p, int left) {
    for (int i = 0; i < p.count - left; ++i)
        p.vertex[i]->flags &= ~is_pending;
    for (int i = 0; i < left; ++i) {
        p.vertex[i] = p.vertex[p.count - left + i];
        p.vertex[i]->flags |= is_pending;
    }
    p.count = left;
}

template <class M, class L>
SPANGLE_INLINE void ElementBatches<M, L>::add_unprojected(Pending& p, Vertex& v, const std::uint8_t* words) {
    read_position(words, v);
    p.fresh[p.unprojected_count] = &v;
    p.projections.add(p.unprojected_count++, transforms_, v.position, v.window, modes_.has_fog());
}

/// Divides the fresh vertices of a Pending by w.
template <class M, class L> inline void ElementBatches<M, L>::divide(Pending& lines) {
    lines.projections.finish(lines.unprojected_count);
    for (int i = 0; i < lines.unprojected_count; ++i) {
        Vertex& v = *lines.fresh[i];
        unsigned planes = 0;
        const bool divided = lines.projections.divide(i, transforms_, v.position, v.window, planes);
        set_flags(v, divided, planes);
        v.flags |= is_pending;
    }
    lines.unprojected_count = 0;
}

/// Draws the pending lines and releases their vertices. The last vertex stays pending if the next line starts
/// from it.
template <class M, class L> void ElementBatches<M, L>::draw_pending(Pending& p) {
    divide(p);
    const int step = modes_.mode() == GL_LINES ? 2 : 1, left = step == 2 ? p.count & 1 : p.count != 0 ? 1 : 0;
    if constexpr (pending_vertices == line_batch + 1)
        lines(p.vertex, p.count, step, !modes_.is_lit());
    else
        for (int i = 0; i + 1 < p.count; i += line_batch)
            lines(p.vertex + i, p.count - i <= line_batch ? p.count - i : line_batch + 1, step,
                  !modes_.is_lit());
    release_drawn(p, left);
}

#endif

} // namespace spangle::gl
