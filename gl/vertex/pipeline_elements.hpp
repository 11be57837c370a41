// Draws elements of arrays. Processed vertices are kept in a cache, found by index. Lines and triangle strips
// are processed in batches.
#pragma once

#include "gl/vertex/pipeline.hpp"

namespace spangle::gl {

/// Draws elements. While a callback draws bands, the elements are divided into pieces, and pieces that do not
/// reach the band are left out.
template <class M, class L>
inline void Pipeline<M, L>::elements(Context& context, std::uint32_t count, const Indices& indices) {
    if constexpr (skips_batches) {
        if (batches_ == nullptr)
            return draw_elements(context, ElementReader(context.arrays), count, indices);
        const int repeated = count > piece ? repeated_elements() : -1;
        const std::uint32_t step = repeated < 0 ? count : piece;
        if (is_outside_band())
            return batches_->skip_pieces(repeated < 0 ? 0 : (count + piece - 1) / piece);
        const ElementReader reader(context.arrays);
        for (std::uint32_t first = 0; first < count; first += step) {
            if (repeated >= 0 && !batches_->begin_piece())
                continue;
            const std::uint32_t from = first == 0 ? 0 : first - static_cast<std::uint32_t>(repeated),
                                end = count - first < step ? count : first + step;
            // Each piece starts like the first one, so that the triangles of a strip keep their winding.
            assembler_.restart();
            draw_elements(context, reader, end - from, indices.from(from));
            if (repeated >= 0)
                batches_->end_piece();
        }
    } else {
        draw_elements(context, ElementReader(context.arrays), count, indices);
    }
}

/// Number of elements that a piece repeats of the piece before it, since each piece of a strip is a strip.
/// -1: draws in this mode are not divided. A stippled line strip is not divided, because its stipple
/// continues from line to line.
template <class M, class L> int Pipeline<M, L>::repeated_elements() const {
    // A piece holds whole primitives, and an even number of triangles of a strip.
    static_assert(piece % 12 == 0);
    // The modes go from POINTS to POLYGON.
    constexpr std::int8_t repeated[] = {0, 0, -1, 1, 0, 2, -1, 0, 2, -1};
    const bool stippled = SPANGLE_FEATURE_STIPPLE && context_->polygon.line_stipple;
    return assembler_.mode() == GL_LINE_STRIP && stippled ? -1 : repeated[assembler_.mode()];
}

template <class M, class L>
void Pipeline<M, L>::draw_elements(Context& context, const ElementReader& reader, std::uint32_t count,
                                   const Indices& indices) {
#if SPANGLE_VERTEX_CACHE != 1
    if constexpr (raster::has_shortcuts)
        if (!modes_.needs_vertex_state() && reader.seldom == nullptr && reader.vertex.on())
            return draw_cached_elements(context, reader, count, indices);
#endif
    draw_elements_immediate(context, reader, count, indices);
}

/// Draws elements one by one, through vertex(). Materials that follow the colour need this path, and so do
/// arrays without positions. Builds without shortcuts have no other path.
template <class M, class L>
void Pipeline<M, L>::draw_elements_immediate(Context& context, const ElementReader& reader,
                                             std::uint32_t count, const Indices& indices) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t index = indices.at(i);
        set_attributes(context, reader, index);
        if (!reader.vertex.on())
            continue;
        Real v[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
        reader.vertex.read(index, v);
#if SPANGLE_VERTEX_CACHE != 1
        if (!raster::has_shortcuts && !modes_.needs_vertex_state()) {
            next_element(context.current, cache_.element(index), v);
            continue;
        }
#endif
        vertex(context, v[0], v[1], v[2], v[3]);
    }
}

#if SPANGLE_VERTEX_CACHE != 1

/// Adds the vertex of an element, all attributes of which are current. `kept` is the element's place in the
/// cache. If position and normal in `kept` are equal, its window position is used again. If `kept` is a
/// corner of the current primitive, it stays unchanged and the vertex goes to another slot.
template <class M, class L>
inline void Pipeline<M, L>::next_element(const CurrentState& current, Vertex& kept,
                                         const Real (&position)[4]) {
    const bool known = cache_.is_valid(kept) && equal_words<4>(kept.position, position) &&
                       (!has_normals || equal_words<3>(kept.normal, current.normal));
    Vertex& next = slot_for_vertex(kept);
    if (!known) {
        for (int c = 0; c < 4; ++c)
            next.position[c] = position[c];
        next.set_normal(current.normal);
        transform_vertex(next);
    } else if (&next != &kept) {
        next = kept;
    }
    set_attributes_of(current, next);
    assembler_.set_next(next);
    if (assembler_.take_next())
        primitive();
}

/// Draws elements through the cache of vertices.
template <class M, class L>
inline void Pipeline<M, L>::draw_cached_elements(Context& context, const ElementReader& reader,
                                                 std::uint32_t count, const Indices& indices) {
    CurrentState& current = context.current;
    cache_.hold_elements(context, count);
    const bool textured = is_common_texture(reader), normals = modes_.is_lit() && reader.normal.on();
    arrays_begin(reader, current, textured);
    if (!modes_.is_lit())
        set_unlit_color(current);
    const auto next = [&](Vertex& v) {
        assembler_.set_next(v);
        if (assembler_.take_next())
            primitive();
    };
    if (!is_common(reader) || (reader.textured || modes_.units() != 0) != textured)
        for (std::uint32_t i = 0; i < count; ++i)
            next(general_element(context, reader, indices.at(i)));
    else if (raster::has_shortcuts && draws_lines())
        draw_line_elements(reader, count, indices, normals);
    else if (raster::has_shortcuts && modes_.mode() == GL_TRIANGLE_STRIP && !modes_.needs_polygon_path())
        draw_strip_elements(reader, count, indices, normals, textured);
    else
        for (std::uint32_t i = 0; i < count; ++i)
            next(common_element(
                reader, indices.at(i), normals, textured,
                [this](Vertex& cached) -> Vertex& { return slot_for_vertex(cached); },
                [this](Vertex& v, const std::uint8_t* words) { process_common(v, words); }));
}

/// Makes cached vertices invalid if the layout of the arrays, the current normal or the current colour has
/// changed. Cached vertices do not record these values.
template <class M, class L>
inline void Pipeline<M, L>::arrays_begin(const ElementReader& reader, const CurrentState& current,
                                         bool textured) {
    const unsigned layout = reader.vertex.components() << 8 | reader.normal.components() << 4 |
                            (textured ? 4u : 0u) | (reader.color.on() ? 2u : 0u) |
                            (reader.textured ? 1u : 0u);
    cache_.begin_draw(layout, current.color,
                      !reader.normal.on() && !equal_words<3>(object_vertex_.normal, current.normal));
    object_vertex_.position[2] = numeric::zero; // the array may not have these components
    object_vertex_.position[3] = numeric::one;
    object_vertex_.set_normal(current.normal);
}

template <class M, class L> inline bool Pipeline<M, L>::draws_lines() const {
    return has_lines && modes_.mode() >= GL_LINES && modes_.mode() <= GL_LINE_STRIP;
}

/// True if positions have three floats, normals (where they matter) have three floats, and there is no colour
/// array. Most programs draw such arrays.
template <class M, class L> inline bool Pipeline<M, L>::is_common(const ElementReader& reader) const {
    return reader.vertex.is_floats(3) &&
           (!modes_.is_lit() || !reader.normal.on() || reader.normal.is_floats(3)) && !reader.color.on();
}

/// True if only texture unit 0 is enabled and its coordinates have two floats.
template <class M, class L> inline bool Pipeline<M, L>::is_common_texture(const ElementReader& reader) const {
    bool others = false;
    for (int u = 1; u < texture_units; ++u)
        others = others || reader.tex_coord[u].on();
    return modes_.units() == 1 && reader.tex_coord[0].is_floats(2) && !others && !has_texgen(0) &&
           !draws_lines();
}

/// Returns the vertex of an element, without colour and texture coordinates. A cached vertex is used again if
/// position and normal in the arrays have not changed.
template <class M, class L>
inline typename Pipeline<M, L>::Vertex& Pipeline<M, L>::element(const ElementReader& reader,
                                                                std::uint32_t index) {
    Vertex& v = cache_.element(index);
    reader.vertex.read(index, object_vertex_.position);
    if constexpr (has_normals)
        if (reader.normal.on())
            reader.normal.read(index, object_vertex_.normal);
    if (cache_.is_valid(v) && equal_words<4>(v.position, object_vertex_.position) &&
        equal_words<3>(v.normal, object_vertex_.normal))
        return v;
    Vertex& fresh = slot_for_vertex(v);
    static_cast<ObjectVertex&>(fresh) = object_vertex_;
    transform_vertex(fresh);
    return fresh;
}

/// Returns the vertex of an element, with colour and texture coordinates. If the cached vertex is a corner of
/// the current primitive, it is copied, since another index may have brought it.
template <class M, class L>
SPANGLE_INLINE typename Pipeline<M, L>::Vertex&
Pipeline<M, L>::general_element(Context& context, const ElementReader& reader, std::uint32_t index) {
    Vertex& kept = element(reader, index);
    Vertex& v = slot_for_vertex(kept);
    if (&v != &kept)
        v = kept;
    set_color_and_texture(context, reader, index);
    set_attributes_of(context.current, v);
    return v;
}

/// Returns the vertex of an element of is_common() arrays, with coordinates of is_common_texture() if
/// `textured`. Unlit vertices take the current colour, which all vertices with this `cache_epoch` share. For
/// a new vertex, `place` returns where to store it, and `finish` does the work of process_common().
template <class M, class L>
template <class Place, class Finish>
SPANGLE_INLINE typename Pipeline<M, L>::Vertex&
Pipeline<M, L>::common_element(const ElementReader& reader, std::uint32_t index, bool normals, bool textured,
                               const Place& place, const Finish& finish) {
    Vertex& v = cache_.element(index);
    const std::uint8_t* const words = reader.vertex.words(index);
    const bool of_now = cache_.is_valid(v);
    if (of_now && equal(v.position, words) && (!normals || equal(v.normal, reader.normal.words(index))) &&
        (!textured || equal_texture(v, reader.tex_coord[0].words(index)))) [[likely]]
        return v;
    Vertex& fresh = place(v);
    cache_.stamp(fresh);
    if constexpr (has_normals) {
        if (normals)
            ArrayReader::read_3_floats(reader.normal.words(index), fresh.normal);
        else if (modes_.is_lit())
            fresh.set_normal(object_vertex_.normal);
    }
    finish(fresh, words);
    if (textured)
        read_texture(reader.tex_coord[0].words(index), fresh);
    if (!modes_.is_lit() && !(of_now && &fresh == &v))
        M::copy_color(unlit_, fresh.window);
    return fresh;
}

template <class M, class L>
SPANGLE_INLINE void Pipeline<M, L>::read_position(const std::uint8_t* words, Vertex& v) {
    ArrayReader::read_3_floats(words, v.position);
    v.position[3] = numeric::one;
}

template <class M, class L> void Pipeline<M, L>::read_texture(const std::uint8_t* words, Vertex& v) {
    for (int i = 0; i < 2; ++i)
        v.st[i] = numeric::from_float_bits(ArrayReader::word(words, i));
    const Real given[4] = {v.st[0], v.st[1], numeric::zero, numeric::one};
    M::set_texture(transforms_, given, 0, v.window);
}

/// True if three coordinates of a vertex equal those in an array.
template <class M, class L>
SPANGLE_INLINE bool Pipeline<M, L>::equal(const Real* v, const std::uint8_t* words) {
    if (v[0].bits != ArrayReader::word(words, 0)) // most vertices that differ do so in x
        return false;
    return ((v[1].bits ^ ArrayReader::word(words, 1)) | (v[2].bits ^ ArrayReader::word(words, 2))) == 0;
}

template <class M, class L>
SPANGLE_INLINE bool Pipeline<M, L>::equal_texture(const Vertex& v, const std::uint8_t* words) {
    return v.st[0].bits == ArrayReader::word(words, 0) && v.st[1].bits == ArrayReader::word(words, 1);
}

template <class M, class L>
SPANGLE_INLINE void Pipeline<M, L>::add_unprojected(Pending& p, Vertex& v, const std::uint8_t* words) {
    read_position(words, v);
    p.fresh[p.unprojected_count] = &v;
    p.projections.add(p.unprojected_count++, transforms_, v.position, v.window, modes_.has_fog());
}

/// Draws lines of elements in batches. Each step (transform, division, set-up in the rasterizer) processes a
/// whole batch, so that no operation waits for the result of another.
template <class M, class L>
template <class I>
void Pipeline<M, L>::draw_lines_of_elements(const ElementReader& reader, std::uint32_t count, const I indices,
                                            bool normals) {
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

/// Draws lines of elements. Aligned indices of 16 bits have a loop of their own.
template <class M, class L>
inline void Pipeline<M, L>::draw_line_elements(const ElementReader& reader, std::uint32_t count,
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
inline void Pipeline<M, L>::draw_strip_elements(const ElementReader& reader, std::uint32_t count,
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

/// Draws a triangle strip in batches: first all vertices of a batch, then their triangles. The window
/// positions are known long before the facing test needs them.
template <class M, class L>
template <class I>
void Pipeline<M, L>::draw_strip_batches(const ElementReader& reader, std::uint32_t count, const I indices,
                                        bool normals, bool textured) {
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
template <class M, class L> void Pipeline<M, L>::draw_strip(Pending& p, std::uint32_t first) {
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
template <class M, class L> inline void Pipeline<M, L>::release_drawn(Pending& p, int left) {
    for (int i = 0; i < p.count - left; ++i)
        p.vertex[i]->flags &= ~is_pending;
    for (int i = 0; i < left; ++i) {
        p.vertex[i] = p.vertex[p.count - left + i];
        p.vertex[i]->flags |= is_pending;
    }
    p.count = left;
}

/// Draws a triangle strip vertex by vertex. The addresses of its last two vertices stay in registers.
template <class M, class L>
template <class I>
void Pipeline<M, L>::draw_strip_of_elements(const ElementReader& reader, std::uint32_t count, const I indices,
                                            bool normals, bool textured) {
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

/// Divides the fresh vertices of a Pending by w.
template <class M, class L> inline void Pipeline<M, L>::divide(Pending& lines) {
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
template <class M, class L> void Pipeline<M, L>::draw_pending(Pending& p) {
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

/// Returns the place of a new vertex: `cached`, its place in the cache, unless a corner of the current
/// primitive is there.
template <class M, class L>
SPANGLE_INLINE typename Pipeline<M, L>::Vertex& Pipeline<M, L>::slot_for_vertex(Vertex& cached) {
    Vertex& v = assembler_.place_beside_corners(cached, vertex_slot_);
    cache_.stamp(v);
    return v;
}

#endif

} // namespace spangle::gl
