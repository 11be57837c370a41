// The vertex pipeline turns vertices as given into primitives in window space. Its steps are: transform,
// assemble, clip, cull, light and draw. It is one template for all numeric policies: M supplies the
// arithmetic and L the lighting. Each step is a part of its own; draw_scope.hpp names them all.
//
// Pipeline owns the order of the steps from Begin to End, and takes vertices from the commands of a program.
// A vertex gives the same picture whether a Vertex command, an array or a list brings it.
//
// The order of steps is that of GL 1.3, figure 2.8, as far as a program can see it. Colours are computed
// late, only for vertices of primitives that survive culling. The pictures are the same, since no step in
// between changes the colour of a vertex.
#pragma once

#include "gl/vertex/current_element.hpp"
#include "gl/vertex/element_batches.hpp"
#include "gl/vertex/element_paths.hpp"

namespace spangle::gl {

template <class M, class L> class Pipeline : public ElementBatches<M, L> {
    using Base = ElementBatches<M, L>;
    template <class Pipeline>
    friend bool draw_cached(Pipeline& to, Context& context, const ElementReader& reader, std::uint32_t count,
                            const Indices& indices);
    template <class Pipeline>
    friend bool take_cached(Pipeline& to, const CurrentState& current, std::uint32_t index,
                            const Real (&position)[4]);

  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;

    void begin(Context& context, GLenum mode) {
        context_ = &context;
        assembler_.begin(mode, vertex_slot_);
        if (begins_outside_band(context))
            return;
        derive_draw(context, mode);
        begin_lines(context);
        if (tells_reach && is_told(context)) [[unlikely]]
            record_draw_reach();
        if (mode == GL_POLYGON && modes_.gathers_polygons())
            assembler_.set_form(PolygonForm::gathered);
        else if (mode == GL_POLYGON && modes_.has_outlines())
            assembler_.set_form(PolygonForm::outlined);
        const PrimitiveKind drawn = mode == GL_POINTS       ? PrimitiveKind::points
                                    : mode <= GL_LINE_STRIP ? PrimitiveKind::lines
                                                            : PrimitiveKind::polygons;
        state_ = &draw_state(context, drawn);
        context.fragments.primitive.stippled = drawn == PrimitiveKind::polygons;
    }

    SPANGLE_INLINE void vertex(Context& context, Real x, Real y, Real z, Real w) {
        if (is_outside_band())
            return;
        Vertex& v = assembler_.next();
        const CurrentState& current = context.current;
        v.position[0] = x;
        v.position[1] = y;
        v.position[2] = z;
        v.position[3] = w;
        v.set_normal(current.normal);
        if constexpr (caches_window_positions)
            transform_with_cache(v);
        else
            transform_vertex(v);
        set_attributes_of(current, v);
        if (modes_.needs_vertex_state())
            take_vertex_state(current, v);
        if (assembler_.take_next())
            primitive();
    }

    /// Takes elements of the enabled arrays, as if ArrayElement gave them one by one.
    void elements(Context& context, std::uint32_t count, const Indices& indices);

    void end() {
        if (!is_outside_band())
            assembler_.end(sink());
        if constexpr (skips_batches)
            if (batches_ != nullptr)
                batches_->end_batch();
    }

    /// Sets the current raster position from a vertex that is not drawn (RasterPos; GL 1.3, 2.12).
    void raster_position(Context& context, const Real (&position)[4]) {
        context_ = &context;
        derive_draw(context, GL_POINTS);
        set_raster_position(context, position);
    }

    /// Lights the vertices given so far with the old material. It is called before a material changes.
    using Base::settle_colors;

  private:
    using Base::assembler_;
    using Base::batches_;
    using Base::begin_lines;
    using Base::begins_outside_band;
    using Base::cache_;
    using Base::context_;
    using Base::derive;
    using Base::is_outside_band;
    using Base::modes_;
    using Base::process_common;
    using Base::set_attributes_of;
    using Base::set_raster_position;
    using Base::set_unlit_color;
    using Base::skips_batches;
    using Base::state_;
    using Base::take_vertex_state;
    using Base::transform_vertex;
    using Base::vertex_slot_;
#if SPANGLE_VERTEX_CACHE != 1
    using Base::arrays_begin;
    using Base::common_element;
    using Base::draw_line_elements;
    using Base::draw_strip_elements;
    using Base::draws_lines;
    using Base::general_element;
    using Base::is_common;
    using Base::is_common_texture;
    using Base::is_valid;
    using Base::slot_for_vertex;
    using Base::transform_with_cache;
#endif

    /// Draws of many elements are divided into pieces of this number of elements. Each band draws or skips a
    /// piece as a whole.
    static constexpr std::uint32_t piece = 12;

    void derive_draw(Context& context, GLenum mode) {
        const Stale stale = derive(context, mode);
        if (stale == Stale::all)
            cache_.invalidate();
        else if (stale == Stale::colors)
            cache_.invalidate_colors();
    }
    PrimitiveSink<M, L>& sink() {
        return *this;
    }
    /// Draws the primitive that the last vertex completed.
    [[gnu::noinline]] void primitive() {
        assembler_.complete(sink());
    }
    int repeated_elements() const;
    void draw_elements(Context& context, const ElementReader& reader, std::uint32_t count,
                       const Indices& indices);
    [[gnu::noinline]] void draw_elements_immediate(Context& context, const ElementReader& reader,
                                                   std::uint32_t count, const Indices& indices);
#if SPANGLE_VERTEX_CACHE != 1
    void next_element(const CurrentState& current, Vertex& kept, const Real (&position)[4]);
    void draw_cached_elements(Context& context, const ElementReader& reader, std::uint32_t count,
                              const Indices& indices);
#endif
    [[gnu::noinline]] void record_draw_reach() const;
};

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
    if (draw_cached(*this, context, reader, count, indices))
        return;
#endif
    draw_elements_immediate(context, reader, count, indices);
}

/// Draws elements one by one, through vertex(). Materials that follow the colour need this path, and so do
/// arrays without positions.
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
        if (take_cached(*this, context.current, index, v))
            continue;
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
    const bool known = is_valid(kept) && equal_words<4>(kept.position, position) &&
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
    else if (draws_lines())
        draw_line_elements(reader, count, indices, normals);
    else if (modes_.mode() == GL_TRIANGLE_STRIP && !modes_.needs_polygon_path())
        draw_strip_elements(reader, count, indices, normals, textured);
    else
        for (std::uint32_t i = 0; i < count; ++i)
            next(common_element(
                reader, indices.at(i), normals, textured,
                [this](Vertex& cached) -> Vertex& { return slot_for_vertex(cached); },
                [this](Vertex& v, const std::uint8_t* words) { process_common(v, words); }));
}

#endif

/// Reports the values that are known when a primitive begins.
template <class M, class L> void Pipeline<M, L>::record_draw_reach() const {
    Context& context = *context_;
    const auto tell = [&](Range range, std::int32_t value) {
        reach(context, range, static_cast<std::uint32_t>(value));
    };
    const raster::Surface& surface = context.drawable.surface;
    tell(Range::SURFACE_WIDTH, surface.width);
    tell(Range::SURFACE_HEIGHT, surface.height);
    tell(Range::BAND_ROWS, surface.area().h);
    if (modes_.mode() == GL_POINTS || modes_.has_outlines())
        tell(Range::POINT_SIZE, rounded_size(context.polygon.point_size));
    if ((modes_.mode() != GL_POINTS && modes_.mode() <= GL_LINE_STRIP) || modes_.has_outlines())
        tell(Range::LINE_WIDTH, rounded_size(context.polygon.line_width));
}

} // namespace spangle::gl
