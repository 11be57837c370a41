#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_DRAW_PIXELS || SPANGLE_FEATURE_BITMAPS

#include <cstring>

#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/pixel/rectangle.hpp"
#include "gl/pixel/row_elements.hpp"
#include "gl/pixel/targets.hpp"
#include "gl/vertex/capture.hpp"
#include "gl/vertex/engine.hpp"
#include "raster/band/record.hpp"
#include "raster/surface/pixel.hpp"

namespace spangle::gl {

bool raster_position_draws(Context& context, [[maybe_unused]] GLenum token) {
    const RasterPosition& raster = context.current.raster;
    if (!raster.valid)
        return false;
#if SPANGLE_FEATURE_FEEDBACK
    if (context.render.mode == GL_FEEDBACK) {
        FeedbackVertex v{};
        v.colors = is_indexed(context.drawable) ? 1 : 4;
        for (int c = 0; c < 4; ++c) {
            v.window[c] = raster.position[c];
            v.color[c] = raster.color[c];
            v.texture[c] = raster.tex_coord[0].v[c];
        }
        if (v.colors == 1)
            v.color[0] = raster.index;
        feed_token(context, token);
        feed_vertex(context, v);
    }
#endif
    return context.render.draws();
}

#if SPANGLE_FEATURE_DRAW_PIXELS

namespace {

/// Converts a group to the words of a fragment.
void convert(const GroupSource& source, RowForm form, std::int32_t n, std::int32_t m,
             std::uint32_t (&out)[4]) {
    const PixelGroup group = source.group(source, n, m);
    const Component* const value = group.color.value;
    switch (form) {
    case RowForm::color:
        for (int c = 0; c < 4; ++c)
            out[c] = color_units_of(value[c]);
        return;
    case RowForm::words:
        out[0] = code_of(value[0], 8) >> 3 << 11 | code_of(value[1], 8) >> 2 << 5 | code_of(value[2], 8) >> 3;
        return;
    case RowForm::index:
        if constexpr (raster::has_indices)
            out[0] = index_units(group.index, format_info(PixelFormat::index8).index_bits);
        return;
    case RowForm::depth:
        out[0] = steps_of(value[0], raster::depth_one);
        return;
    case RowForm::stencil:
        out[0] = static_cast<std::uint8_t>(rounded(group.index));
    }
}

/// Fills `out` with `count` fragments of row m of the groups. The walk `n` gives the group of each fragment.
/// A group that covers several fragments is converted once.
void fill_row(const GroupSource& source, RowForm form, std::int32_t m, ZoomAxis::GroupWalk n,
              std::int32_t count, RectangleRow& out) {
    std::uint32_t words[4] = {};
    std::int32_t last = -1;
    for (std::int32_t i = 0; i < count; ++i, n.step()) {
        if (n.group() != last)
            convert(source, form, n.group(), m, words);
        last = n.group();
        if (form == RowForm::depth)
            out.depth[i] = words[0];
        else if (form == RowForm::words)
            out.words[i] = static_cast<std::uint16_t>(words[0]);
        else if (form == RowForm::stencil)
            out.stencil[i] = static_cast<std::uint8_t>(words[0]);
        else
            std::memcpy(out.color + 4 * i, words, sizeof words);
    }
}

#if SPANGLE_ROW_CODES

constexpr GroupFields word_fields{2, false, true, {{11, 5}, {5, 6}, {0, 5}}};
static_assert(row_chunk >= rectangle_chunk);

/// Converts whole rows of groups, where each group is one fragment and transfer changes no colour.
class UnzoomedRows {
  public:
    UnzoomedRows(const GroupSource& source, RowForm form, bool zooms)
        : source_(source), form_(form),
          is_usable_(source.groups != nullptr && !zooms && form <= RowForm::words),
          reader_(source.form, bits(source, form)) {}

    bool is_supported() const { return is_usable_; }

    void fill(std::int32_t n, std::int32_t m, std::int32_t count, RectangleRow& out) {
        const std::uint8_t* const from = source_.groups(source_, n, m, count);
        const GroupForm& groups = source_.form;
        if (form_ == RowForm::color && groups.fields.bytes == 0)
            return read_units(from, *groups.layout, groups.swap, count, out.color);
        const CodeRow& row = reader_.read(from, count);
        if (form_ == RowForm::words)
            write_fields(row, word_fields, count, reinterpret_cast<std::uint8_t*>(out.words));
        else
            write_units(row, reader_.bits(), count, out.color);
    }

  private:
    /// Returns the bits of the codes that are written, or no bits if the reader is not used.
    static CodeBits bits(const GroupSource& source, RowForm form) {
        return source.groups == nullptr        ? CodeBits{}
               : form == RowForm::words        ? bits_of(word_fields)
               : source.form.fields.bytes != 0 ? own_bits(source.form.fields)
                                               : CodeBits{};
    }

    const GroupSource& source_;
    RowForm form_;
    bool is_usable_;
    RowReader reader_;
};

#endif

/// Converts a rectangle in chunks of columns, row by row. A row of groups is converted once for all rows of
/// fragments that it covers.
class Rectangle {
  public:
    Rectangle(const Context& context, const GroupSource& source, RowForm form, RectangleOrder order,
              raster::Position shift)
        : source_(source), form_(form), order_(order),
          x_(context.current.raster.position[0], context.pixel_mode.zoom[0], shift.x),
          y_(context.current.raster.position[1], context.pixel_mode.zoom[1], shift.y)
#if SPANGLE_ROW_CODES
          ,
          unzoomed_rows_(source, form, !x_.is_unit_zoom())
#endif
    {
        const Rect clip = drawing_rect(context);
        if (x_.is_empty() || y_.is_empty())
            return;
        columns_ = x_.covered_fragments(source.n.begin, source.n.end, clip.x, clip.x + clip.w);
        rows_ = y_.covered_fragments(source.m.begin, source.m.end, clip.y, clip.y + clip.h);
    }

    /// Calls put(y, x, count, row) for each row of each chunk.
    template <class Put> void for_each_fragment_row(Put put) {
        if (rows_.begin >= rows_.end)
            return;
        for (std::int32_t done = 0, all = columns_.end - columns_.begin; done < all;
             done += rectangle_chunk) {
            const std::int32_t count = all - done < rectangle_chunk ? all - done : rectangle_chunk;
            const std::int32_t x = order_.from_right ? columns_.end - done - count : columns_.begin + done;
            put_chunk(x, count, put);
        }
    }

  private:
    template <class Put> void put_chunk(std::int32_t x, std::int32_t count, Put put) {
        const ZoomAxis::GroupWalk n = x_.from(x);
        ZoomAxis::GroupWalk m = y_.from(rows_.begin);
        std::int32_t filled = -1;
        for (std::int32_t i = 0; i < rows_.end - rows_.begin; ++i) {
            const std::int32_t y = order_.from_top ? rows_.end - 1 - i : rows_.begin + i;
            if (order_.from_top)
                m = y_.from(y);
            if (m.group() != filled)
                fill(m.group(), n, count);
            filled = m.group();
            put(y, x, count, row_);
            m.step();
        }
    }

    void fill(std::int32_t m, const ZoomAxis::GroupWalk& n, std::int32_t count) {
#if SPANGLE_ROW_CODES
        if (unzoomed_rows_.is_supported())
            return unzoomed_rows_.fill(n.group(), m, count, row_);
#endif
        fill_row(source_, form_, m, n, count, row_);
    }

    const GroupSource& source_;
    RowForm form_;
    RectangleOrder order_;
    ZoomAxis x_, y_;
    ZoomAxis::Range columns_{0, 0}, rows_{0, 0};
    RectangleRow row_;
#if SPANGLE_ROW_CODES
    UnzoomedRows unzoomed_rows_;
#endif
};

struct Fragments : raster::PixelSource {
    Rectangle& rectangle;
    RowForm form;
    bool colored; ///< true if the fragments have the colours of the rectangle
};

/// Emits fragments as runs of equal depth.
void emit_depths(raster::PixelSink& sink, std::int32_t y, std::int32_t x, std::int32_t count,
                 const std::uint32_t* depth) {
    for (std::int32_t begin = 0, end; begin < count; begin = end) {
        for (end = begin + 1; end < count && depth[end] == depth[begin];)
            ++end;
        sink.depth(sink, depth[begin]);
        sink.run(sink, y, x + begin, x + end, nullptr);
    }
}

void emit(raster::PixelSource& source, raster::PixelSink& sink) {
    auto& fragments = static_cast<Fragments&>(source);
    fragments.rectangle.for_each_fragment_row(
        [&](std::int32_t y, std::int32_t x, std::int32_t count, const RectangleRow& row) {
            if (fragments.form == RowForm::depth)
                return emit_depths(sink, y, x, count, row.depth);
            sink.run(sink, y, x, x + count, fragments.colored ? &row : nullptr);
        });
}

/// Receives stencil values. They are neither textured nor tested: only pixel ownership, scissor and mask
/// apply (GL 1.3, 4.3.1).
struct StencilSink : raster::PixelSink {
    const Context& context;
    const raster::Surface& surface;
};

void store_stencil(raster::PixelSink& sink, std::int32_t y, std::int32_t begin, std::int32_t end,
                   const void* pixels) {
    const Context& context = static_cast<const StencilSink&>(sink).context;
    const raster::Surface& surface = static_cast<const StencilSink&>(sink).surface;
    const std::uint8_t* const value = static_cast<const RectangleRow*>(pixels)->stencil;
    const auto mask = static_cast<std::uint8_t>(context.fragment_ops.stencil[0].write_mask);
#if SPANGLE_HAS_RECORDS
    if (context.drawable.recording != nullptr)
        return context.drawable.recording->record->stencil(y, begin, end - begin, value, mask,
                                                           context.fragments.primitive.sample);
#endif
    for (std::int32_t x = begin; x < end; ++x) {
        const unsigned stored = raster::read_stencil(surface, x, y);
        raster::write_stencil(surface, x, y,
                              static_cast<std::uint8_t>((value[x - begin] & mask) | (stored & ~mask)));
    }
}

} // namespace

void draw_rectangle(Context& context, const GroupSource& source, raster::Colors colors,
                    RectangleOrder order) {
    const Content content = source.content;
    const raster::DrawState* const state =
        content == Content::stencil
            ? nullptr
            : &draw_state(context, PrimitiveKind::pixels,
                          content == Content::depth ? raster::Colors::of_vertices : colors);
    const RowForm form = state == nullptr            ? RowForm::stencil
                         : content == Content::depth ? RowForm::depth
                         : content == Content::index ? RowForm::index
                         : state->words              ? RowForm::words
                                                     : RowForm::color;
    each_target(context, [&](const raster::Surface& target, raster::Position shift) {
        Rectangle rectangle(context, source, form, order, shift);
        Fragments fragments{{emit}, rectangle, form, state == nullptr || state->pixels};
        StencilSink sink{{store_stencil, nullptr}, context, target};
        if (state == nullptr)
            emit(fragments, sink);
        else
            context.engine->pixels(context, *state, target, fragments);
    });
}

#endif

} // namespace spangle::gl

#endif
