// Gathers the vertices of POLYGONs that must be drawn as a whole, when they end. Feedback reports a POLYGON
// as one polygon (GL 1.3, 5.3). An antialiased polygon must cover a pixel once, not once for each triangle of
// a fan (GL 1.3, 3.5.3).
#pragma once

#include <new>

#include "gl/context/arena.hpp"
#include "gl/vertex/pipeline.hpp"

namespace spangle::gl {

/// True if the current polygon was gathered.
template <class M, class L> inline bool Pipeline<M, L>::has_gathered() const {
#if SPANGLE_GATHERS_POLYGONS
    return gathered_count_ != 0;
#else
    return false;
#endif
}

/// Adds a vertex to the gathered polygon. When the array in the arena is full, one of twice the size replaces
/// it.
template <class M, class L> void Pipeline<M, L>::gather([[maybe_unused]] Vertex& v) {
#if SPANGLE_GATHERS_POLYGONS
    if (gathered_count_ == gathered_capacity_) {
        const int room = gathered_capacity_ != 0 ? 2 * gathered_capacity_ : 8;
        void* const memory =
            room < (1 << 20)
                ? context_->arena->allocate(sizeof(ClippedVertex) * static_cast<std::size_t>(room))
                : nullptr;
        gathering_failed_ = gathering_failed_ || memory == nullptr;
        if (memory == nullptr)
            return;
        auto* const more = static_cast<ClippedVertex*>(memory);
        for (int i = 0; i < gathered_count_; ++i)
            new (more + i) ClippedVertex(gathered_[i]);
        context_->arena->free(gathered_);
        context_->render.gathered = gathered_ = more;
        gathered_capacity_ = room;
    }
    color_back(v);
    ClippedVertex& corner = to_clip_vertex(v, *new (gathered_ + gathered_count_++) ClippedVertex);
    if ((v.flags & edge_flag) != 0)
        corner.flags |= boundary;
#endif
}

template <class M, class L> void Pipeline<M, L>::draw_gathered() {
#if SPANGLE_GATHERS_POLYGONS
    const int n = gathered_count_, room = n + clip_vertices;
    const auto places = static_cast<std::size_t>(room);
    void* const memory =
        n < 3 ? nullptr : context_->arena->allocate(places * (sizeof(std::int64_t) + 3 * sizeof(Vertex*)));
    if (gathering_failed_ || (n >= 3 && memory == nullptr)) {
        drawing_error(*context_, GL_OUT_OF_MEMORY,
                      SPANGLE_TEXT("no room in the arena for a polygon that is fed back or antialiased"));
    } else if (n >= 3) {
        auto* const part = static_cast<std::int64_t*>(memory);
        auto** const work = reinterpret_cast<Vertex**>(part + room);
        gathered_windows_ = static_cast<const Window**>(static_cast<void*>(work + 2 * room));
        clip_gathered(work, room, part);
    }
    context_->arena->free(memory);
    free_gathered();
#endif
}

/// Clips the gathered polygon and draws what is left. `work` has room for 2 * `room` corners, and `part` for
/// `room` areas.
template <class M, class L>
inline void Pipeline<M, L>::clip_gathered([[maybe_unused]] Vertex** work, [[maybe_unused]] int room,
                                          [[maybe_unused]] std::int64_t* part) {
#if SPANGLE_GATHERS_POLYGONS
    const int n = gathered_count_;
    unsigned all = outside_mask, any = 0, all_user = ~0u, any_user = 0;
    for (int i = 0; i < n; ++i) {
        const Vertex& v = *(work[i] = gathered_ + i);
        const unsigned user = planes_.any() ? outside(v) : 0;
        all &= v.flags;
        any |= v.flags;
        all_user &= user;
        any_user |= user;
    }
    if (all != 0 || all_user != 0)
        return;
    const unsigned planes = clip_planes(any) | any_user << user_shift;
    const int left = planes != 0 ? clip_polygon(work, work + room, room, n, planes) : n;
    if (left >= 3)
        draw_visible(work, left, *gathered_, part, 0);
#endif
}

template <class M, class L> inline void Pipeline<M, L>::free_gathered() {
#if SPANGLE_GATHERS_POLYGONS
    context_->arena->free(gathered_);
    context_->render.gathered = gathered_ = nullptr;
    gathered_count_ = gathered_capacity_ = 0;
    gathering_failed_ = false;
#endif
}

} // namespace spangle::gl
