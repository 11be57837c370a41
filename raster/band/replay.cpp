// Draws the part of a record that lies in the rows of a band.
#include "raster/band/layout.hpp"
#include "raster/band/vertex_code.hpp"
#include "raster/primitive/sample_shift.hpp"
#include "raster/surface/pixel.hpp"

#if SPANGLE_HAS_RECORDS

namespace spangle::raster {

namespace {

/// The part of an area that lies in a band.
Rect cut(const Rect& area, const Rect& band) {
    const std::int32_t first = area.y > band.y ? area.y : band.y, a = area.y + area.h, b = band.y + band.h,
                       end = a < b ? a : b;
    return {area.x, first, area.w, end > first ? end - first : 0};
}

template <class T> T next(const std::uint32_t*& from) {
    T value;
    __builtin_memcpy(static_cast<void*>(&value), from, sizeof value);
    from += sizeof value / 4;
    return value;
}

} // namespace

/// Sets the scissor rectangle of each state to its part in the band.
void Record::prepare(const Surface& band) {
    for (std::uint32_t place = states_; place != nowhere; place = at<State>(place)->next) {
        State& state = *at<State>(place);
        state.draw.fragment.scissor = cut(state.scissor, band.area());
        scissor_changed(state.draw, band);
    }
}

void Record::replay(const Surface& band, bool count) {
    prepare(band);
    const Rect rows = band.area();
    for (std::uint32_t place = 0; place < used_;) {
        Block& block = *at<Block>(place);
        if (block.first < rows.y + rows.h && block.end > rows.y)
            replay_block(block, band, count && place >= counted_bytes_);
        place += block.bytes;
    }
    // States get the values with which they were stored, so that equal states are found again.
    for (std::uint32_t place = states_; place != nowhere; place = at<State>(place)->next) {
        DrawState& draw = at<State>(place)->draw;
        draw.fragment.scissor = {};
        draw.counters = nullptr;
    }
}

/// Calls draw(surface, number) for one sample of the band, or for each of its samples.
template <class Draw> void Record::each_target(const Surface& band, std::uint8_t only, Draw draw) {
    each_sample(band, [&](const Surface& target, unsigned sample) {
        if (only != every_sample && only != sample)
            return;
        primitive_.sample = static_cast<std::uint8_t>(sample);
        draw(target, sample);
    });
}

void Record::replay_block(Block& block, const Surface& band, bool count) {
    std::uint8_t* const content = reinterpret_cast<std::uint8_t*>(&block + 1);
    switch (block.content) {
    case Content::data:
        return;
    case Content::clear: {
        ClearRequest request = *reinterpret_cast<const ClearRequest*>(content);
        request.area = cut(request.area, band.area());
        return clear_samples(band, request);
    }
    case Content::accum: {
        AccumRequest request = *reinterpret_cast<const AccumRequest*>(content);
        request.area = cut(request.area, band.area());
        return raster::accum(band, request, band);
    }
    case Content::stencil: {
        const Run& run = *reinterpret_cast<const Run*>(content);
        const std::uint8_t* const values = content + sizeof(Run);
        return each_target(band, block.sample, [&](const Surface& target, unsigned) {
            for (std::int32_t i = 0; i < run.count; ++i)
                write_stencil(
                    target, run.x + i, run.y,
                    static_cast<std::uint8_t>((values[i] & run.mask) |
                                              (read_stencil(target, run.x + i, run.y) & ~run.mask)));
        });
    }
    case Content::primitives:
    case Content::polygon:
    case Content::pixels:
        State& state = *at<State>(block.state);
        state.draw.counters = count || state.counters == nullptr ? state.counters : &discarded_counters_;
        return block.content == Content::pixels    ? replay_pixels(block, state.draw, band)
               : block.content == Content::polygon ? replay_polygon(block, state.draw, band)
                                                   : replay_primitives(block, state.draw, band);
    }
}

void Record::replay_polygon(Block& block, DrawState& draw, const Surface& band) {
    auto& polygon = *reinterpret_cast<Polygon*>(&block + 1);
    primitive_.depth_offset = polygon.depth_offset;
    primitive_.stippled = polygon.stippled;
    each_target(band, every_sample, [&](const Surface& target, unsigned) {
        draw_smooth_polygon(draw, target, primitive_, polygon.pointers(), polygon.corners,
                            *polygon.pointers()[polygon.corners]);
    });
}

void Record::replay_primitives(Block& block, DrawState& draw, const Surface& band) {
    const VertexCode code(draw);
    const auto words = static_cast<std::uint32_t>(code.words());
    const std::int32_t low = draw.fragment.scissor.y, high = low + draw.fragment.scissor.h;
    const auto* start = reinterpret_cast<const std::uint32_t*>(&block + 1);
    for (unsigned n = 0; n < block.items; ++n) {
        const std::uint32_t* from = start;
        const Item item = next<Item>(from);
        const std::uint32_t size = (item.words() + item.fresh * words + 1) / 2 * 2;
        const std::uint32_t* const vertices = start + item.words();
        const std::uint32_t* const begin = start;
        start += size;
        if (item.first >= high || item.end <= low)
            continue;
        const std::int32_t extent = item.has_size() ? next<std::int32_t>(from) : 0;
        LineStipple stipple = item.line_stippled ? next<LineStipple>(from) : LineStipple{};
        primitive_.depth_offset = item.has_offset ? next<std::int64_t>(from) : 0;
        primitive_.stippled = item.polygon_stippled;
        const auto* const refs = reinterpret_cast<const std::uint16_t*>(from);
        FixedVertex corner[Item::most_corners + 1];
        for (unsigned i = 0; i <= item.corners; ++i) {
            const std::uint32_t ref = refs[i];
            code.decode(ref < Item::fresh_corners ? vertices + ref * words
                                                  : begin - (ref - Item::fresh_corners),
                        corner[i]);
        }
        each_target(band, every_sample, [&](const Surface& target, unsigned sample) {
            const bool moves = item.moved && band.samples != nullptr;
            const Position by = moves ? to_center(sample) : Position{};
            for (unsigned i = 0; moves && i <= item.corners; ++i)
                shift(corner[i], by);
            draw_item(draw, target, item, corner, extent, stipple);
            for (unsigned i = 0; moves && i <= item.corners; ++i)
                shift(corner[i], {-by.x, -by.y});
        });
    }
}

void Record::draw_item(const DrawState& draw, const Surface& target, const Item& item,
                       const FixedVertex* corner, std::int32_t extent, LineStipple stipple) {
    const FixedVertex &a = corner[0], &b = corner[1], &c = corner[2], &provoking = corner[item.corners];
    LineStipple* const parts = item.line_stippled ? &stipple : nullptr;
    switch (item.shape) {
    case Primitive::Shape::triangle:
        return draw_triangle(draw, target, a, b, c, provoking, signed_area(a.x, a.y, b.x, b.y, c.x, c.y));
    case Primitive::Shape::line:
        return parts != nullptr ? draw_stippled_line(draw, target, a, b, provoking, extent, stipple)
                                : draw_line(draw, target, a, b, provoking, extent);
    case Primitive::Shape::point:
        return draw_point(draw, target, a, extent);
    case Primitive::Shape::smooth_point:
        return draw_smooth_point(draw, target, primitive_, a, extent);
    case Primitive::Shape::smooth_line:
        return draw_smooth_line(draw, target, primitive_, a, b, provoking, extent, parts);
    case Primitive::Shape::smooth_polygon: {
        const FixedVertex* fan[Item::most_corners];
        for (unsigned i = 0; i < item.corners; ++i)
            fan[i] = &corner[i];
        return draw_smooth_polygon(draw, target, primitive_, fan, item.corners, provoking);
    }
    case Primitive::Shape::disc:
    case Primitive::Shape::line_rectangle:
#if SPANGLE_FEATURE_MULTISAMPLE
        if (item.shape == Primitive::Shape::disc)
            return draw_disc(draw, target, a, extent);
        return draw_line_rectangle(draw, target, a, b, provoking, extent, parts);
#endif
        break;
    }
}

namespace {

/// The runs of one block, as a source for a PixelSink.
struct KeptPixels : PixelSource {
    const std::uint8_t* begin;
    const std::uint8_t* end;
    Rect clip;
};

} // namespace

void Record::replay_pixels(Block& block, DrawState& draw, const Surface& band) {
    FixedVertex vertex;
    const std::uint8_t* const content = reinterpret_cast<const std::uint8_t*>(&block + 1);
    __builtin_memcpy(&vertex, content, sizeof vertex);
    constexpr std::size_t runs = (sizeof(Block) + sizeof(FixedVertex) + 7) / 8 * 8 - sizeof(Block);
    KeptPixels pixels;
    pixels.begin = content + runs;
    pixels.end = reinterpret_cast<const std::uint8_t*>(&block) + block.bytes;
    pixels.clip = draw.fragment.scissor;
    pixels.emit = [](PixelSource& source, PixelSink& sink) {
        const auto& kept = static_cast<const KeptPixels&>(source);
        for (const std::uint8_t* at = kept.begin; at < kept.end;) {
            const Run& run = *reinterpret_cast<const Run*>(at);
            const std::uint8_t* const payload = at + sizeof(Run);
            at += (sizeof(Run) + run.payload() + 7) / 8 * 8;
            if (run.form == Run::Form::depth) {
                std::uint32_t z;
                __builtin_memcpy(&z, payload, sizeof z);
                sink.depth(sink, z);
                continue;
            }
            if (run.y < kept.clip.y || run.y >= kept.clip.y + kept.clip.h)
                continue;
            union {
                std::uint32_t units[4 * Run::longest];
                std::uint16_t words[Run::longest + pixel_room];
            } row;
            if (run.form == Run::Form::bytes)
                for (std::int32_t i = 0; i < 4 * run.count; ++i)
                    row.units[i] = std::uint32_t{payload[i]} << color_fraction_bits;
            else
                __builtin_memcpy(&row, payload,
                                 run.form == Run::Form::words ? run.count * 2u : run.payload());
            sink.run(sink, run.y, run.x, run.x + run.count, run.form == Run::Form::plain ? nullptr : &row);
        }
    };
    each_target(band, block.sample,
                [&](const Surface& target, unsigned) { draw_pixels(draw, target, vertex, pixels); });
}

} // namespace spangle::raster

#endif
