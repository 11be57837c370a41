// Primitives that are selected or fed back (GL 1.3, 5.2 and 5.3).
#pragma once

#include <new>

#include "gl/context/arena.hpp"
#include "gl/vertex/pipeline.hpp"

namespace spangle::gl {

template <class M, class L>
void Pipeline<M, L>::capture_line(const Corner& a, const Corner& b, const Window& provoking) {
    const GLenum token = stipple_starts_ ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN;
    stipple_starts_ = mode_ == GL_LINES;
    capture(
        token,
        [&](int i) {
            return Corner{(i == 0 ? a : b).vertex, flat_ ? provoking : (i == 0 ? a : b).window};
        },
        2);
}

/// corner(i): what is left of the primitive's corners after clipping, with their windows.
template <class M, class L>
template <class At>
inline void Pipeline<M, L>::capture([[maybe_unused]] GLenum token, [[maybe_unused]] At corner,
                                    [[maybe_unused]] int n) {
#if SPANGLE_FEATURE_SELECTION
    if (context_->render.mode == GL_SELECT) {
        std::uint32_t nearest = 0xFFFFFFFF, farthest = 0;
        for (int i = 0; i < n; ++i) {
            const std::uint32_t depth = M::depth_word(corner(i).vertex.window);
            nearest = depth < nearest ? depth : nearest;
            farthest = depth > farthest ? depth : farthest;
        }
        return record_hit(*context_, nearest, farthest);
    }
#endif
#if SPANGLE_FEATURE_FEEDBACK
    feed_token(*context_, token);
    if (token == GL_POLYGON_TOKEN)
        feed_count(*context_, n);
    for (int i = 0; i < n; ++i)
        feed(corner(i));
#endif
}

#if SPANGLE_FEATURE_FEEDBACK
template <class M, class L> void Pipeline<M, L>::feed(const Corner& corner) {
    const Vertex& v = corner.vertex;
    const bool cut = (v.flags & is_cut) != 0;
    FeedbackVertex out;
    M::window_of(transforms_, cut ? static_cast<const Cut&>(v).clip : M::to_clip(transforms_, v.position),
                 out.window);
    if (indexed())
        out.color[0] = M::index_of(corner.window);
    else
        M::color_of(corner.window, out.color);
    out.colors = indexed() ? 1 : 4;
    M::reals(cut ? static_cast<const Cut&>(v).texture : texture_[&v - slot_], out.texture);
    feed_vertex(*context_, out);
}
#endif

/// A POLYGON is fed back as one, so all of its corners have to be there first (GL 1.3, 5.3).
template <class M, class L> inline bool Pipeline<M, L>::gathers() const {
    return SPANGLE_FEATURE_FEEDBACK && captures_ && context_->render.mode == GL_FEEDBACK;
}

template <class M, class L> void Pipeline<M, L>::gather([[maybe_unused]] Vertex& v) {
    held_ = 0;
#if SPANGLE_FEATURE_FEEDBACK
    if (gathered_count_ == gathered_room_) {
        const int room = gathered_room_ != 0 ? 2 * gathered_room_ : 8;
        void* const memory = room < (1 << 20)
                                 ? context_->arena->allocate(sizeof(Cut) * static_cast<std::size_t>(room))
                                 : nullptr;
        gathering_lost_ = gathering_lost_ || memory == nullptr;
        if (memory == nullptr)
            return;
        auto* const more = static_cast<Cut*>(memory);
        for (int i = 0; i < gathered_count_; ++i)
            new (more + i) Cut(gathered_[i]);
        context_->arena->free(gathered_);
        context_->render.feedback.polygon = gathered_ = more;
        gathered_room_ = room;
    }
    color_back(v);
    Cut& corner = to_be_cut(v, *new (gathered_ + gathered_count_++) Cut);
    if ((v.flags & edge_flag) != 0)
        corner.flags |= boundary;
#endif
}

template <class M, class L> void Pipeline<M, L>::feed_gathered() {
#if SPANGLE_FEATURE_FEEDBACK
    const int n = gathered_count_, room = n + clip_vertices;
    Arena& arena = *context_->arena;
    auto** const work =
        n >= 3 ? static_cast<Vertex**>(arena.allocate(2 * sizeof(Vertex*) * static_cast<std::size_t>(room)))
               : nullptr;
    if (gathering_lost_ || (n >= 3 && work == nullptr)) {
        error(*context_, GL_OUT_OF_MEMORY,
              SPANGLE_TEXT("no room in the arena for a polygon that is fed back"));
    } else if (n >= 3) {
        unsigned all = outside_mask, any = 0, all_user = ~0u, any_user = 0;
        for (int i = 0; i < n; ++i) {
            const Vertex& v = *(work[i] = gathered_ + i);
            const unsigned user = planes_.any() ? outside(v) : 0;
            all &= v.flags;
            any |= v.flags;
            all_user &= user;
            any_user |= user;
        }
        const unsigned planes = clip_planes(any) | any_user << user_shift;
        const int left = all != 0 || all_user != 0 ? 0
                         : planes != 0             ? clip_polygon(work, work + room, room, n, planes)
                                                   : n;
        if (left >= 3)
            feed_polygon(work, left);
    }
    arena.free(work);
    arena.free(gathered_);
    context_->render.feedback.polygon = gathered_ = nullptr;
    gathered_count_ = gathered_room_ = 0;
    gathering_lost_ = false;
#endif
}

template <class M, class L>
inline void Pipeline<M, L>::feed_polygon([[maybe_unused]] Vertex* const* corners, [[maybe_unused]] int n) {
#if SPANGLE_FEATURE_FEEDBACK
    for (int i = 0; i < n; ++i)
        if (!project(*corners[i]))
            return;
    const bool ccw = area_of(corners, n) > 0, front = ccw == front_is_ccw_;
    if (ccw ? culls_ccw_ : culls_cw_)
        return;
    Vertex& provoking = *gathered_;
    if (!front && two_sided_) {
        back_of(provoking, provoking.window);
        for (int i = 0; i < n; ++i)
            if (corners[i] != &provoking)
                back_of(*corners[i], corners[i]->window);
    }
    draw([corners](int i) -> Window& { return corners[i]->window; }, corners, n, provoking.window,
         front ? 0 : 1, nullptr);
#endif
}

template <class M, class L> void Pipeline<M, L>::captured_line(Vertex& a, Vertex& b) {
    const unsigned both = a.flags & b.flags;
    if ((both & outside_mask) != 0)
        return;
    color(a);
    color(b);
    cut_line(a, b);
}

} // namespace spangle::gl
