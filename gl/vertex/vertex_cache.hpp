// Keeps processed vertices that a program may give again.
//
// VertexCache owns the memory of kept vertices and the epoch that tells which of them are valid. Elements of
// arrays are found by their index, and vertices of Vertex commands by their position. Both kinds share one
// memory, which holds one kind at a time. The cache takes vertices that somebody else processes, and knows
// nothing of matrices, colours and primitives. It promises that a vertex whose epoch is not current is never
// taken for a valid one, and that memory which the arena cannot give costs speed only.
//
// Builds with SPANGLE_VERTEX_CACHE=1 keep nothing.
#pragma once

#include <bit>
#include <cstdint>
#include <new>
#include <type_traits>

#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/vertex/cache_memory.hpp"
#include "gl/vertex/vertex_kinds.hpp"

namespace spangle::gl {

/// True if this build keeps the window positions of vertices that Vertex commands give. Models give most
/// positions several times, with another normal or for the next face. Such a position is transformed once.
inline constexpr bool caches_window_positions = vertex_cache != 1 && may_cache_positions;

#if SPANGLE_VERTEX_CACHE == 1

template <class M> class VertexCache {
  public:
    void invalidate() {}
    void invalidate_colors() {}
};

#else

template <class M> class VertexCache {
  public:
    using Vertex = gl::Vertex<M>;

    /// True if kept vertices keep their positions while lights, materials or the current colour change. The
    /// code for it is left out of firmware.
    static constexpr bool keeps_positions = may_keep_positions;

    /// Makes all kept vertices invalid, by a new epoch.
    SPANGLE_RUN_CALL void invalidate();
    /// Makes the colours of all kept vertices invalid. Their positions stay valid in builds with
    /// keeps_positions.
    void invalidate_colors();
    /// True if the vertex was stamped after the last time that anything became invalid.
    bool is_valid(const Vertex& v) const { return v.cache_epoch == epoch_; }
    /// True if at least the position of the vertex is valid.
    bool has_position(const Vertex& v) const { return (v.cache_epoch ^ epoch_) < epoch_step; }
    /// Makes a vertex valid until anything becomes invalid.
    void stamp(Vertex& v) const { v.cache_epoch = epoch_; }

    // Elements of arrays.
    /// Prepares the cache for a draw of `count` elements. In builds where the cache may grow, the first draw
    /// of more elements than it holds enlarges it to vertex_cache elements, in the arena.
    void hold_elements(Context& context, std::uint32_t count);
    /// Makes kept vertices invalid if the layout of the arrays differs from that of the last draw, or if
    /// `others_changed`. If only the current colour differs, colours of vertices that are not lit become
    /// invalid. Vertices do not record these values.
    void begin_draw(unsigned layout, const Real (&color)[4], bool lit, bool others_changed);
    /// The place of an element, after hold_elements(). Whether its vertex is that of the element is for the
    /// caller to compare.
    Vertex& element(std::uint32_t index);

    // Vertices of Vertex commands.
    /// Sets window coordinates and flags of a vertex whose position is set. It copies the window position
    /// kept for an equal position; the flags are then `known_flags`. Otherwise it calls transform(v), and
    /// keeps the result unless flags other than uncolored are set.
    template <class Transform>
    SPANGLE_INLINE void place(Vertex& v, unsigned known_flags, const Transform& transform);

    /// Number of positions that the cache keeps.
    static constexpr std::size_t position_count() { return cached_position_count; }

  private:
    static constexpr std::uint32_t epoch_step = keeps_positions ? 1u << 16 : 1;
    /// The cache holds first_vertices elements at first. In builds where the cache may grow, the first draw
    /// of more elements enlarges it to vertex_cache elements.
    static constexpr bool grows_cache = may_grow_cache && vertex_cache > 1024 &&
                                        std::has_single_bit(vertex_cache);
    static constexpr std::size_t first_vertices = grows_cache ? 128 : vertex_cache;
    /// The window position of a vertex given by a Vertex command, not as an element of arrays.
    struct CachedPosition {
        Real position[3]{}; ///< position in object space as given; its w was 1
        /// The entry is valid while this differs from VertexCache::epoch_ below `epoch_step` only. It is the
        /// value of epoch_ when the entry was made.
        std::uint32_t cache_epoch = 0;
        typename M::Place window_position{};
    };
    /// Sizes of the cache of window positions. cached_position_room is in units of Vertex. More than
    /// most_cached_positions entries would not fit a host's first-level data cache.
    static constexpr std::size_t most_cached_positions = 512,
                                 cached_position_count = std::bit_floor(
                                     sizeof(Vertex) * vertex_cache / sizeof(CachedPosition) <
                                             most_cached_positions
                                         ? sizeof(Vertex) * vertex_cache / sizeof(CachedPosition)
                                         : most_cached_positions),
                                 cached_position_room =
                                     (sizeof(CachedPosition) * cached_position_count + sizeof(Vertex) - 1) /
                                     sizeof(Vertex),
                                 cached_position_overlap = cached_position_room < first_vertices
                                                               ? cached_position_room
                                                               : first_vertices;
    union Memory {
        Vertex vertex[first_vertices];
        CachedPosition cached_position[cached_position_count];
        Memory() : vertex{} {}
    };
    struct GrownCache {
        Vertex* elements = nullptr; ///< vertex_cache elements in the arena, or null
        Vertex* base = nullptr;     ///< the elements in use: `elements`, or memory_.vertex
        std::uint32_t mask = 0;     ///< mask of the index bits that choose an element
    };
    struct FixedCache {};

    /// Kept vertices whose `cache_epoch` differs from this are invalid. Where the values differ below
    /// `epoch_step` only, just the colours are invalid.
    std::uint32_t epoch_ = 0;
    bool caches_positions_ = false; ///< true if memory_ holds `cached_position`, not `vertex`
    /// Number of vertices that Vertex commands have given since the last draw of elements.
    std::uint32_t immediate_count_ = 0;
    unsigned layout_ = 0; ///< layout of the arrays that the elements came from
    Real color_[4] = {};  ///< current colour during the last draw of elements
    Memory memory_;
    [[no_unique_address]] std::conditional_t<grows_cache, GrownCache, FixedCache> grown_cache_;

    [[gnu::noinline]] void cache_positions();
    [[gnu::noinline]] void cache_elements();
    [[gnu::noinline]] void clear();
    void grow(Context& context, std::uint32_t count);
    static std::uint32_t cached_position_index(const Real* position);
};

template <class M> SPANGLE_RUN_CALL void VertexCache<M>::invalidate() {
    epoch_ = (epoch_ & ~(epoch_step - 1)) + epoch_step;
    if (epoch_ != 0)
        return;
    clear();
    epoch_ = epoch_step;
}

template <class M> inline void VertexCache<M>::invalidate_colors() {
    if ((epoch_ + 1) % epoch_step == 0)
        invalidate();
    else
        ++epoch_;
}

/// Empties the cache and switches it to positions of Vertex commands.
template <class M> void VertexCache<M>::cache_positions() {
    for (CachedPosition& p : memory_.cached_position)
        new (&p) CachedPosition;
    caches_positions_ = true;
}

/// Switches the cache to elements of arrays. Only the part that held positions is emptied.
template <class M> void VertexCache<M>::cache_elements() {
    const std::size_t lost =
        caches_window_positions && caches_positions_ ? cached_position_overlap : first_vertices;
    for (std::size_t i = 0; i < lost; ++i)
        new (&memory_.vertex[i]) Vertex;
    caches_positions_ = false;
}

/// Empties the cache when epoch_ wraps around to 0. Otherwise, old vertices would look valid.
template <class M> void VertexCache<M>::clear() {
    if (caches_window_positions && caches_positions_)
        cache_positions();
    else
        cache_elements();
    if constexpr (grows_cache)
        for (std::size_t i = 0; grown_cache_.elements != nullptr && i < vertex_cache; ++i)
            new (&grown_cache_.elements[i]) Vertex;
}

template <class M> inline void VertexCache<M>::hold_elements(Context& context, std::uint32_t count) {
    immediate_count_ = 0;
    if (caches_positions_)
        cache_elements();
    if constexpr (grows_cache)
        grow(context, count);
}

#if SPANGLE_GROWS_CACHE

/// Chooses the memory of the cache. The first draw of more than first_vertices elements allocates
/// vertex_cache elements in the arena. Without memory for them, the small cache stays in use.
template <class M> inline void VertexCache<M>::grow(Context& context, std::uint32_t count) {
    if (grown_cache_.elements == nullptr && count > first_vertices) {
        void* const memory = context.arena->allocate(sizeof(Vertex) * vertex_cache);
        context.render.kept_vertices = memory;
        if (memory != nullptr)
            grown_cache_.elements = new (memory) Vertex[vertex_cache];
    }
    const bool all = grown_cache_.elements != nullptr;
    grown_cache_.base = all ? grown_cache_.elements : memory_.vertex;
    grown_cache_.mask = static_cast<std::uint32_t>(all ? vertex_cache : first_vertices) - 1;
}

#endif

template <class M>
inline void VertexCache<M>::begin_draw(unsigned layout, const Real (&color)[4], bool lit,
                                       bool others_changed) {
    if (layout != layout_ || others_changed)
        invalidate();
    else if (!lit && !equal_words<4>(color_, color))
        invalidate_colors();
    layout_ = layout;
    for (int c = 0; c < 4; ++c)
        color_[c] = color[c];
}

template <class M> inline typename VertexCache<M>::Vertex& VertexCache<M>::element(std::uint32_t index) {
    // The address is kept in a register, as base of all accesses to the vertex.
    if constexpr (grows_cache)
        return *numeric::kept_in_register(&grown_cache_.base[index & grown_cache_.mask]);
    else
        return *numeric::kept_in_register(&memory_.vertex[numeric::remainder<vertex_cache>(index)]);
}

/// Returns the index of a position in the cache. The hash separates positions that are much alike: short
/// fractions, a constant z, points and their mirror images.
template <class M> inline std::uint32_t VertexCache<M>::cached_position_index(const Real* position) {
    const std::uint32_t y = position[1].bits;
    const std::uint32_t mixed = position[0].bits + (y << 3) + (y >> 7) + (position[2].bits >> 1);
    return mixed * 0x9E3779B1u >> (32 - std::countr_zero(cached_position_count));
}

// A few vertices between draws of elements do not empty the cache of elements.
template <class M>
template <class Transform>
SPANGLE_INLINE void VertexCache<M>::place(Vertex& v, unsigned known_flags, const Transform& transform) {
    if (!caches_positions_) {
        if (++immediate_count_ < cached_position_count) [[unlikely]]
            return transform(v);
        cache_positions();
    }
    CachedPosition& kept = memory_.cached_position[cached_position_index(v.position)];
    const bool plain = v.position[3] == numeric::one;
    if (plain && (kept.cache_epoch ^ epoch_) < epoch_step && equal_words<3>(kept.position, v.position)) {
        M::take_place(kept.window_position, v.window);
        v.flags = known_flags;
        return;
    }
    transform(v);
    if (!plain || (v.flags & ~uncolored) != 0)
        return;
    for (int i = 0; i < 3; ++i)
        kept.position[i] = v.position[i];
    kept.cache_epoch = epoch_;
    M::keep_place(v.window, kept.window_position);
}

#endif

} // namespace spangle::gl
