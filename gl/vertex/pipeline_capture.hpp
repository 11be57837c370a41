// Captures primitives, which are then selected or fed back instead of drawn (GL 1.3, 5.2 and 5.3).
#pragma once

#include "gl/vertex/pipeline.hpp"

namespace spangle::gl {

template <class M, class L>
void Pipeline<M, L>::capture_line(const Corner& a, const Corner& b, const Window& provoking) {
    begin_capture(stipple_starts_ ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN, 2);
    stipple_starts_ = mode_ == GL_LINES;
    capture({a.vertex, flat_ ? provoking : a.window});
    capture({b.vertex, flat_ ? provoking : b.window});
}

/// Begins a primitive of which clipping left n corners; capture() takes each of them next.
template <class M, class L>
void Pipeline<M, L>::begin_capture([[maybe_unused]] GLenum token, [[maybe_unused]] int n) {
#if SPANGLE_FEATURE_FEEDBACK
    if (context_->render.mode != GL_FEEDBACK)
        return;
    feed_token(*context_, token);
    if (token == GL_POLYGON_TOKEN)
        feed_count(*context_, n);
#endif
}

template <class M, class L> void Pipeline<M, L>::capture([[maybe_unused]] const Corner& corner) {
#if SPANGLE_FEATURE_SELECTION
    if (context_->render.mode == GL_SELECT)
        return record_hit(*context_, M::depth_word(corner.vertex.window));
#endif
#if SPANGLE_FEATURE_FEEDBACK
    feed(corner);
#endif
}

#if SPANGLE_FEATURE_FEEDBACK
template <class M, class L> void Pipeline<M, L>::feed(const Corner& corner) {
    const Vertex& v = corner.vertex;
    const bool cut = (v.flags & is_cut) != 0;
    FeedbackVertex out;
    M::window_of(transforms_,
                 cut ? M::narrow(static_cast<const Cut&>(v).clip) : M::to_clip(transforms_, v.position),
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
