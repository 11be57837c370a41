// Writes primitives and pixels into a record.
#include <new>

#include "raster/band/layout.hpp"
#include "raster/band/reach.hpp"
#include "raster/band/vertex_code.hpp"
#include "raster/numeric/bits.hpp"

#if SPANGLE_HAS_RECORDS

namespace spangle::raster {

namespace {

constexpr std::uint8_t most_items = 32; ///< the most items of a block; with more, a band can skip less

} // namespace

/// The place of an equal vertex in the record, stored by any primitive, or `nowhere`.
std::uint32_t Record::find_vertex(const std::uint32_t* words, int count) const {
    const std::uint32_t hash = (words[0] * 0x9E3779B1u ^ words[1] * 0x85EBCA6Bu) >> (32 - log2_vertices);
    const std::uint32_t place = vertex_[hash];
    if (place == nowhere ||
        __builtin_memcmp(at<std::uint32_t>(place), words, static_cast<std::size_t>(count) * 4) != 0)
        return nowhere;
    return place;
}

void Record::remember_vertex(const std::uint32_t* words, int, std::uint32_t place) {
    const std::uint32_t hash = (words[0] * 0x9E3779B1u ^ words[1] * 0x85EBCA6Bu) >> (32 - log2_vertices);
    vertex_[hash] = place;
}

void Record::record_primitive(Recorder& self, const DrawState& state, const Primitive& primitive) {
    static_cast<Record&>(self).add(state, primitive);
}

void Record::add(const DrawState& live, const Primitive& p) {
    const Rect& scissor = live.fragment.scissor;
    const Reach all = reach(p);
    const std::int32_t first = all.low > scissor.y ? all.low : scissor.y,
                       end = all.high < scissor.y + scissor.h ? all.high : scissor.y + scissor.h;
    if (first >= end)
        return;
    State* const state = find_or_store(live);
    if (state == nullptr)
        return;
    const auto of_state = static_cast<std::uint32_t>(reinterpret_cast<std::uint8_t*>(state) - memory_);
    if (p.corners > Item::most_corners)
        return add_polygon(live, p, of_state, {first, end});
    const VertexCode code(state->draw);
    const auto words = static_cast<std::uint32_t>(code.words());

    // There must be room for a new block and for all vertices of the item, because it may be that none is
    // stored yet.
    Item item;
    item.shape = p.shape;
    item.corners = static_cast<std::uint8_t>(p.corners);
    item.first = static_cast<std::int16_t>(first);
    item.end = static_cast<std::int16_t>(end);
    item.line_stippled = p.stipple != nullptr;
    item.polygon_stippled = live.primitive != nullptr && live.primitive->stippled;
    item.moved = has_samples && live.primitive != nullptr && live.primitive->moved;
    const bool offsets = live.primitive != nullptr && live.fragment.depth_offset;
    item.has_offset = offsets && live.primitive->depth_offset != 0;
    const std::size_t most = sizeof(Block) + (item.words() + (item.corners + 1u) * words) * 4 + 8;
    if (!room(most))
        return;
    Block* block = block_ == nowhere ? nullptr : at<Block>(block_);
    if (block == nullptr || block->content != Content::primitives || block->state != of_state ||
        block->items == most_items || block_ + block->bytes != used_)
        block = open(Content::primitives, of_state, {first, end}, 0);

    const auto start = static_cast<std::uint32_t>(used_);
    std::uint32_t* to = at<std::uint32_t>(start) + sizeof(Item) / 4;
    const auto put = [&to](const auto& value) {
        __builtin_memcpy(to, &value, sizeof value);
        to += sizeof value / 4;
    };
    if (item.has_size())
        put(p.size);
    if (item.line_stippled)
        put(*p.stipple);
    if (item.has_offset)
        put(live.primitive->depth_offset);
    auto* const refs = reinterpret_cast<std::uint16_t*>(to);
    std::uint32_t* vertex = at<std::uint32_t>(start) + item.words();
    std::uint32_t coded[VertexCode::most_words];
    for (unsigned i = 0; i <= item.corners; ++i) {
        // The provoking vertex matters only where shading is flat.
        if (i == item.corners && !live.fragment.flat) {
            refs[i] = refs[i - 1];
            break;
        }
        code.encode(i < item.corners ? *p.corner[i] : *p.provoking, coded);
        std::uint32_t place = find_vertex(coded, code.words());
        const auto here = static_cast<std::uint32_t>(reinterpret_cast<std::uint8_t*>(vertex) - memory_);
        if (place == nowhere || (place < start && (start - place) / 4 > Item::farthest)) {
            __builtin_memcpy(vertex, coded, words * 4);
            remember_vertex(coded, code.words(), here);
            place = here;
            vertex += words;
            ++item.fresh;
        }
        const std::uint32_t first_fresh = start + item.words() * 4;
        refs[i] = static_cast<std::uint16_t>(place >= start ? (place - first_fresh) / 4 / words
                                                            : Item::fresh_corners + (start - place) / 4);
    }
    __builtin_memcpy(at<Item>(start), &item, sizeof item);
    const auto bytes =
        static_cast<std::uint32_t>(reinterpret_cast<std::uint8_t*>(vertex) - at<std::uint8_t>(start));
    // Blocks end at multiples of 8 bytes, where the next block may begin.
    (void)append((bytes + 7) / 8 * 8);
    block->bytes += (bytes + 7) / 8 * 8;
    block->first = item.first < block->first ? item.first : block->first;
    block->end = item.end > block->end ? item.end : block->end;
    ++block->items;
    has_uncounted_ = has_uncounted_ || state->counters != nullptr;
}

void Record::add_polygon(const DrawState& live, const Primitive& p, std::uint32_t state, Rows rows) {
    static_assert(sizeof(Polygon) % 8 == 0 && sizeof(FixedVertex) % alignof(FixedVertex) == 0);
    if (open(Content::polygon, state, rows, Polygon::bytes(p.corners)) == nullptr)
        return;
    auto* const polygon = new (at<Polygon>(block_ + sizeof(Block))) Polygon;
    if (live.fragment.depth_offset)
        polygon->depth_offset = live.primitive->depth_offset;
    polygon->corners = p.corners;
    polygon->stippled = live.primitive->stippled;
    for (int i = 0; i <= p.corners; ++i)
        polygon->pointers()[i] =
            new (polygon->vertices() + i) FixedVertex(i < p.corners ? *p.corner[i] : *p.provoking);
    const State& kept = *at<State>(state);
    has_uncounted_ = has_uncounted_ || kept.counters != nullptr;
}

/// Stores runs of pixels in the order in which they come.
class Record::PixelRecorder : public PixelSink {
  public:
    PixelRecorder(Record& record, const DrawState& live, std::uint32_t state, const FixedVertex& at)
        : PixelSink{run, depth}, record_(record), live_state_(live) {
        Block* const block = record.open(Content::pixels, state, {INT16_MAX, 0}, sizeof(FixedVertex));
        if (block == nullptr)
            return;
        block_ = record.block_;
        if (has_samples && live.primitive != nullptr)
            block->sample = live.primitive->sample;
        __builtin_memcpy(record.at<FixedVertex>(block_ + sizeof(Block)), &at, sizeof at);
    }

  private:
    static PixelRecorder& self(PixelSink& sink) { return static_cast<PixelRecorder&>(sink); }

    /// Appends a run with room for its payload. Returns null where there is no room.
    Run* put(const Run& run) {
        const std::size_t bytes = (sizeof(Run) + run.payload() + 7) / 8 * 8;
        if (block_ == nowhere || !record_.room(bytes))
            return nullptr;
        Run* const to = new (record_.at<Run>(record_.append(bytes))) Run(run);
        Block& block = *record_.at<Block>(block_);
        block.bytes += static_cast<std::uint32_t>(bytes);
        return to;
    }

    static void depth(PixelSink& sink, std::uint32_t z) {
        if (Run* const to = self(sink).put({0, 0, 0, Run::Form::depth, 0}); to != nullptr)
            __builtin_memcpy(static_cast<void*>(to + 1), &z, sizeof z);
    }

    static void run(PixelSink& sink, std::int32_t y, std::int32_t begin, std::int32_t end,
                    const void* pixels) {
        PixelRecorder& own = self(sink);
        const Rect& clip = own.live_state_.fragment.scissor;
        const std::int32_t first = begin > clip.x ? begin : clip.x,
                           last = end < clip.x + clip.w ? end : clip.x + clip.w;
        if (y < clip.y || y >= clip.y + clip.h)
            return;
        for (std::int32_t x = first; x < last; x += Run::longest)
            own.keep(y, x, last - x < Run::longest ? last - x : Run::longest, pixels, x - begin);
    }

    void keep(std::int32_t y, std::int32_t x, std::int32_t count, const void* pixels, std::int32_t from) {
        const auto* const words = static_cast<const std::uint16_t*>(pixels) + from;
        const auto* const units = static_cast<const std::uint32_t*>(pixels) + 4 * std::ptrdiff_t{from};
        Run run{static_cast<std::int16_t>(y),
                static_cast<std::int16_t>(x),
                static_cast<std::uint16_t>(count),
                {},
                0};
        run.form = pixels == nullptr   ? Run::Form::plain
                   : live_state_.words ? Run::Form::words
                                       : form_of(units, count);
        Run* const to = put(run);
        if (to == nullptr)
            return;
        if (run.form == Run::Form::words)
            __builtin_memcpy(static_cast<void*>(to + 1), words, static_cast<std::size_t>(count) * 2);
        if (run.form == Run::Form::units)
            __builtin_memcpy(static_cast<void*>(to + 1), units, static_cast<std::size_t>(count) * 16);
        auto* const bytes = reinterpret_cast<std::uint8_t*>(to + 1);
        for (std::int32_t i = 0; run.form == Run::Form::bytes && i < 4 * count; ++i)
            bytes[i] = static_cast<std::uint8_t>(units[i] >> color_fraction_bits);
        Block& block = *record_.at<Block>(block_);
        block.first = run.y < block.first ? run.y : block.first;
        block.end = run.y >= block.end ? static_cast<std::int16_t>(run.y + 1) : block.end;
    }

    /// The form that holds these components exactly: bytes for whole 255ths, and otherwise colour units.
    static Run::Form form_of(const std::uint32_t* units, std::int32_t count) {
        std::uint32_t fractions = 0;
        for (std::int32_t i = 0; i < 4 * count; ++i)
            fractions |= units[i];
        return fractions << (32 - color_fraction_bits) == 0 ? Run::Form::bytes : Run::Form::units;
    }

    Record& record_;
    const DrawState& live_state_;
    std::uint32_t block_ = nowhere;
};

void Record::record_pixels(Recorder& self, const DrawState& live, const FixedVertex& vertex,
                           PixelSource& source) {
    auto& record = static_cast<Record&>(self);
    const State* const state = record.find_or_store(live);
    if (state == nullptr)
        return;
    record.has_uncounted_ = record.has_uncounted_ || state->counters != nullptr;
    PixelRecorder keeper(
        record, live,
        static_cast<std::uint32_t>(reinterpret_cast<const std::uint8_t*>(state) - record.memory_), vertex);
    source.emit(source, keeper);
}

} // namespace spangle::raster

#endif
