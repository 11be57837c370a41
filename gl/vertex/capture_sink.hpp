// Captures primitives for selection and feedback, in place of drawing them (GL 1.3, 5.2 and 5.3).
//
// CaptureSink owns nothing. It takes the token of a primitive and then each of its corners after clipping. It
// promises a hit or the words of feedback for each, as the render mode asks.
#pragma once

#include "gl/vertex/capture.hpp"
#include "gl/vertex/clipper.hpp"

namespace spangle::gl {

template <class M, class L> class CaptureSink : public Clipper<M, L> {
    using Base = Clipper<M, L>;

  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;
    using ClippedVertex = gl::ClippedVertex<M, L>;

    struct Corner {
        const Vertex& vertex;
        const Window& window; ///< window vertex of the side that is seen
    };
    [[gnu::noinline]] void begin_capture(GLenum token, int n);
    [[gnu::noinline]] void capture_vertex(const Corner& corner);

  protected:
    using Base::context_;
    using Base::modes_;
    using Base::transforms_;
    using Base::vertex_slot_;
#if SPANGLE_FEATURE_FEEDBACK
    using Base::texture_coords_;
#endif

#if SPANGLE_FEATURE_FEEDBACK
    void write_feedback_vertex(const Corner& corner);
#endif
};

/// Begins a primitive that has n corners after clipping. capture_vertex() takes each corner next.
template <class M, class L>
void CaptureSink<M, L>::begin_capture([[maybe_unused]] GLenum token, [[maybe_unused]] int n) {
#if SPANGLE_FEATURE_FEEDBACK
    if (context_->render.mode != GL_FEEDBACK)
        return;
    feed_token(*context_, token);
    if (token == GL_POLYGON_TOKEN)
        feed_count(*context_, n);
#endif
}

template <class M, class L> void CaptureSink<M, L>::capture_vertex([[maybe_unused]] const Corner& corner) {
#if SPANGLE_FEATURE_SELECTION
    if (context_->render.mode == GL_SELECT)
        return record_hit(*context_, M::depth_word(corner.vertex.window));
#endif
#if SPANGLE_FEATURE_FEEDBACK
    write_feedback_vertex(corner);
#endif
}

#if SPANGLE_FEATURE_FEEDBACK

template <class M, class L> void CaptureSink<M, L>::write_feedback_vertex(const Corner& corner) {
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

} // namespace spangle::gl
