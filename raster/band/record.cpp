// Stores states, primitives, clears and accumulation.
#include "raster/band/record.hpp"

#include <new>

#include "raster/band/layout.hpp"
#include "raster/band/vertex_code.hpp"
#include "raster/numeric/bits.hpp"

#if SPANGLE_HAS_RECORDS

namespace spangle::raster {

namespace {

constexpr std::size_t alignment = 8;
constexpr std::size_t rounded(std::size_t bytes) {
    return (bytes + alignment - 1) / alignment * alignment;
}

bool same(const void* a, const void* b, std::size_t bytes) {
    return __builtin_memcmp(a, b, bytes) == 0;
}

} // namespace

Record::Record() : Recorder{record_primitive, record_pixels} {
    clear();
}

void Record::give(void* memory, std::size_t bytes) {
    memory_ = static_cast<std::uint8_t*>(memory);
    size_ = bytes / alignment * alignment;
    clear();
}

void Record::clear() {
    used_ = counted_bytes_ = 0;
    block_ = states_ = texture_ = nowhere;
    is_full_ = has_uncounted_ = false;
    for (LiveState& live : live_states_)
        live = {};
    for (std::uint32_t& place : vertex_)
        place = nowhere;
}

// --- memory

bool Record::room(std::size_t bytes) {
    if (!is_full_ && bytes <= size_ - used_)
        return true;
    if (!is_full_ && on_full != nullptr) {
        is_full_ = true;
        on_full();
    }
    is_full_ = true;
    return false;
}

/// Appends bytes and returns their place. There must be room() for the bytes.
std::uint32_t Record::append(std::size_t bytes) {
    const auto place = static_cast<std::uint32_t>(used_);
    used_ += bytes;
    peak_ = used_ > peak_ ? used_ : peak_;
    return place;
}

/// Opens a new block. Returns null where there is no room.
Record::Block* Record::open(Content content, std::uint32_t state, Rows rows, std::size_t bytes) {
    const std::size_t all = rounded(sizeof(Block) + bytes);
    if (!room(all))
        return nullptr;
    block_ = append(all);
    return new (at<Block>(block_))
        Block{static_cast<std::uint32_t>(all), state, static_cast<std::int16_t>(rows.first),
              static_cast<std::int16_t>(rows.end), content};
}

/// Stores a copy in a block of its own. Returns null where there is no room.
template <class T> const T* Record::store_bytes(const T& value) {
    const Block* const block = open(Content::data, 0, {0, 0}, sizeof(T));
    return block == nullptr ? nullptr : new (at<T>(block_ + sizeof(Block))) T(value);
}

// --- states

namespace {

/// A texture as it was when it was recorded. These objects form a list.
struct KeptTexture {
    std::uint32_t next;
    Texture texture;
    CubeFaces faces;
};

} // namespace

const Texture* Record::store_texture(const Texture& texture) {
    static_assert(sizeof(Block) % alignment == 0);
    for (std::uint32_t place = texture_; place != nowhere; place = at<KeptTexture>(place)->next) {
        const KeptTexture& kept = *at<KeptTexture>(place);
        Texture as_given = kept.texture;
        const bool faces = as_given.faces != nullptr && texture.faces != nullptr;
        if (faces && !same(&kept.faces, texture.faces, sizeof kept.faces))
            continue;
        if (faces)
            as_given.faces = texture.faces;
        if (as_given == texture)
            return &kept.texture;
    }
    // Faces are the last member: textures without faces leave that memory out.
    const std::size_t bytes = texture.faces != nullptr ? sizeof(KeptTexture) : offsetof(KeptTexture, faces);
    if (open(Content::data, 0, {0, 0}, bytes) == nullptr)
        return nullptr;
    const std::uint32_t place = block_ + static_cast<std::uint32_t>(sizeof(Block));
    auto* const kept = at<KeptTexture>(place);
    kept->next = texture_;
    new (&kept->texture) Texture(texture);
    if (texture.faces != nullptr) {
        kept->faces = *texture.faces;
        kept->texture.faces = &kept->faces;
    }
    texture_ = place;
    return &kept->texture;
}

bool Record::store_textures(DrawState& draw) {
    for (TextureUnit& unit : draw.fragment.unit) {
        if (unit.texture == nullptr)
            continue;
        unit.texture = store_texture(*unit.texture);
        if (unit.texture == nullptr)
            return false;
    }
    return true;
}

Record::State* Record::equal_to(const State& state) const {
    for (std::uint32_t place = states_; place != nowhere; place = at<State>(place)->next) {
        State* const kept = at<State>(place);
        if (kept->scissor == state.scissor && kept->counters == state.counters &&
            kept->draw.fragment == state.draw.fragment)
            return kept;
    }
    return nullptr;
}

/// Stores a state, or finds an equal one. Members that replay() sets for each band are left out.
Record::State* Record::store(const DrawState& live) {
    if (!room(rounded(sizeof(Block) + sizeof(State))))
        return nullptr;
    State state{nowhere, live.fragment.scissor, live.counters, live};
    state.draw.fragment.scissor = {};
    state.draw.counters = nullptr;
    state.draw.primitive = &primitive_;
    state.draw.nothing = false;
    state.draw.recorder = nullptr;
    if (!store_textures(state.draw))
        return nullptr;
    if (const std::uint32_t* const rows = live.fragment.polygon_stipple; rows != nullptr) {
        struct Rows32 {
            std::uint32_t row[32];
        } copy;
        __builtin_memcpy(&copy, rows, sizeof copy);
        const State* const last = states_ == nowhere ? nullptr : at<State>(states_);
        const std::uint32_t* const before = last == nullptr ? nullptr : last->draw.fragment.polygon_stipple;
        if (before != nullptr && same(before, rows, sizeof copy)) {
            state.draw.fragment.polygon_stipple = before;
        } else {
            const Rows32* const kept = store_bytes(copy);
            if (kept == nullptr)
                return nullptr;
            state.draw.fragment.polygon_stipple = kept->row;
        }
    }
    if (State* const kept = equal_to(state); kept != nullptr)
        return kept;
    state.next = states_;
    if (open(Content::data, 0, {0, 0}, sizeof(State)) == nullptr)
        return nullptr;
    states_ = block_ + static_cast<std::uint32_t>(sizeof(Block));
    return new (at<State>(states_)) State(state);
}

/// The stored copy of a live state, made when the first primitive needs it.
Record::State* Record::find_or_store(const DrawState& live) {
    for (LiveState& known : live_states_) {
        if (known.state != &live)
            continue;
        if (known.stored == nowhere)
            if (const State* const state = store(live); state != nullptr)
                known.stored =
                    static_cast<std::uint32_t>(reinterpret_cast<const std::uint8_t*>(state) - memory_);
        return known.stored == nowhere ? nullptr : at<State>(known.stored);
    }
    return nullptr;
}

void Record::take(DrawState& live) {
    LiveState* slot = nullptr;
    for (LiveState& known : live_states_)
        if (known.state == &live)
            slot = &known;
    if (slot == nullptr)
        slot = &live_states_[next_live_state_++ % live_states];
    *slot = {&live, nowhere};
    if (live.nothing)
        return; // a state with `nothing` draws nothing in any band
    live.nothing = true;
    live.recorder = this;
    live.paths = {};
}

void Record::mark_counted() {
    counted_bytes_ = used_;
    block_ = nowhere; // counted and uncounted primitives may not share a block
    has_uncounted_ = false;
}

void Record::forget_counters() {
    for (std::uint32_t place = states_; place != nowhere; place = at<State>(place)->next)
        if (at<State>(place)->counters != nullptr)
            at<State>(place)->counters = &discarded_counters_;
    has_uncounted_ = false;
}

// --- clears, accumulation, stencil values

void Record::clear(const ClearRequest& request) {
    const Rect& area = request.area;
    if (area.w <= 0 || area.h <= 0)
        return;
    if (open(Content::clear, 0, {area.y, area.y + area.h}, sizeof request) != nullptr)
        new (at<ClearRequest>(block_ + sizeof(Block))) ClearRequest(request);
}

void Record::accum(const AccumRequest& request) {
    const Rect& area = request.area;
    if (area.w <= 0 || area.h <= 0)
        return;
    if (open(Content::accum, 0, {area.y, area.y + area.h}, sizeof request) != nullptr)
        new (at<AccumRequest>(block_ + sizeof(Block))) AccumRequest(request);
}

void Record::stencil(std::int32_t y, std::int32_t x, std::int32_t count, const std::uint8_t* values,
                     std::uint8_t mask, std::uint8_t sample) {
    const std::size_t bytes = sizeof(Run) + static_cast<std::size_t>(count);
    if (open(Content::stencil, 0, {y, y + 1}, bytes) == nullptr)
        return;
    at<Block>(block_)->sample = sample;
    auto* const run = new (at<Run>(block_ + sizeof(Block))) Run{static_cast<std::int16_t>(y),
                                                                static_cast<std::int16_t>(x),
                                                                static_cast<std::uint16_t>(count),
                                                                {},
                                                                mask};
    __builtin_memcpy(run + 1, values, static_cast<std::size_t>(count));
}

} // namespace spangle::raster

#endif
