// Primitives that are selected or fed back (GL 1.3, 5.2 and 5.3).
#pragma once

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

template <class M, class L> void Pipeline<M, L>::captured_line(Vertex& a, Vertex& b) {
    const unsigned both = a.flags & b.flags;
    if ((both & outside_mask) != 0)
        return;
    color(a);
    color(b);
    cut_line(a, b);
}

} // namespace spangle::gl
