// Captures primitives for selection and feedback, in place of drawing them (GL 1.3, 5.2 and 5.3).
#pragma once

#include "gl/vertex/pipeline.hpp"

namespace spangle::gl {

template <class M, class L>
void Pipeline<M, L>::capture_line(const Corner& a, const Corner& b, const Window& provoking) {
    begin_capture(restarts_stipple_ ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN, 2);
    restarts_stipple_ = modes_.mode() == GL_LINES;
    capture_vertex({a.vertex, modes_.is_flat_shaded() ? provoking : a.window});
    capture_vertex({b.vertex, modes_.is_flat_shaded() ? provoking : b.window});
}

/// Begins a primitive that has n corners after clipping. capture_vertex() takes each corner next.
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

template <class M, class L> void Pipeline<M, L>::capture_vertex([[maybe_unused]] const Corner& corner) {
#if SPANGLE_FEATURE_SELECTION
    if (context_->render.mode == GL_SELECT)
        return record_hit(*context_, M::depth_word(corner.vertex.window));
#endif
#if SPANGLE_FEATURE_FEEDBACK
    write_feedback_vertex(corner);
#endif
}

#if SPANGLE_FEATURE_FEEDBACK
template <class M, class L> void Pipeline<M, L>::write_feedback_vertex(const Corner& corner) {
    const Vertex& v = corner.vertex;
    const bool is_clipped = (v.flags & is_clipped_vertex) != 0;
    FeedbackVertex out;
    M::window_of(transforms_,
                 is_clipped ? M::narrow(static_cast<const ClippedVertex&>(v).clip)
                            : M::to_clip(transforms_, v.position),
                 out.window);
    if (modes_.has_color_index())
        out.color[0] = M::index_of(corner.window);
    else
        M::color_of(corner.window, out.color);
    out.colors = modes_.has_color_index() ? 1 : 4;
    M::to_reals(is_clipped ? static_cast<const ClippedVertex&>(v).texture
                           : texture_coords_[&v - vertex_slot_],
                out.texture);
    feed_vertex(*context_, out);
}
#endif

template <class M, class L> void Pipeline<M, L>::capture_clipped_line(Vertex& a, Vertex& b) {
    const unsigned both = a.flags & b.flags;
    if ((both & outside_mask) != 0)
        return;
    color(a);
    color(b);
    clip_and_draw_line(a, b);
}

} // namespace spangle::gl
