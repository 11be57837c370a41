// Computes the colours of vertices.
//
// Shading owns the lighting and the current colour as the rasterizer takes it. It takes vertices that
// VertexStage has processed, and ClippedVertex objects. It promises that each vertex is lit at most once, and
// only when somebody asks for its colour: colours of vertices that nobody sees are not computed. If a
// material changes or follows the current colour, vertices given before keep the colour of their time.
#pragma once

#include "gl/vertex/capture.hpp"
#include "gl/vertex/vertex_stage.hpp"

namespace spangle::gl {

/// What of a vertex is to be computed again.
enum class Stale : std::uint8_t { nothing, colors, all };

template <class M, class L> class Shading : public VertexStage<M> {
    using Base = VertexStage<M>;

  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;
    using ClippedVertex = gl::ClippedVertex<M, L>;

    /// Derives everything that vertices and colours depend on, for primitives of `mode`. Returns what of the
    /// vertices that were processed before is invalid.
    Stale derive(Context& context, GLenum mode);
    /// Lights the vertices of the incomplete primitive with the old material. It is called before a material
    /// changes.
    void settle_colors();
    /// Sets the current raster position from a vertex that is not drawn (RasterPos; GL 1.3, 2.12). If the
    /// vertex is outside of the clip volume, only `valid` changes.
    void set_raster_position(Context& context, const Real (&position)[4]);
    SPANGLE_INLINE void set_attributes_of(const CurrentState& current, Vertex& v);
    SPANGLE_INLINE void set_unlit_color(const CurrentState& current);
    [[gnu::noinline]] void take_vertex_state(const CurrentState& current, Vertex& v);
    void color(Vertex& v);
    void color_back(Vertex& v);
    void light_back(const Vertex& v, Window& out);

  protected:
    using Base::assembler_;
    using Base::context_;
    using Base::derive_transforms;
    using Base::flags_of;
    using Base::modes_;
    using Base::outside;
    using Base::planes_;
    using Base::record_vertex_reach;
    using Base::set_texture_coords;
    using Base::slot_count;
    using Base::texture_of;
    using Base::transforms_;
    using Base::vertex_slot_;
#if SPANGLE_FEATURE_FEEDBACK
    using Base::texture_coords_;
#endif

    [[gnu::noinline]] void light(const Vertex& v, int side, Window& out);
    [[gnu::noinline]] void light(Vertex& v);

    L lighting_;
    Window unlit_{}; ///< the current colour as the rasterizer takes it
#if SPANGLE_TWO_SIDES
    /// Colours of the backs of vertex_slot_, set where the flags have back_known.
    typename M::Colors back_colors_[slot_count];
#endif

  private:
    /// Bit u is set if unit u needed r when the last vertices were processed.
    unsigned units_with_r_ = 0;
    Real unlit_color_[4] = {}; ///< the current colour from which unlit_ was made
    bool has_unlit_color_ = false;
};

/// Copies the current texture coordinates to a vertex, and the current colour if lighting is off.
template <class M, class L>
SPANGLE_INLINE void Shading<M, L>::set_attributes_of(const CurrentState& current, Vertex& v) {
    if (raster::has_textures && modes_.units() != 0)
        set_texture_coords(current, v);
    if (modes_.is_lit())
        return;
    set_unlit_color(current);
    M::copy_color(unlit_, v.window);
}

template <class M, class L> SPANGLE_INLINE void Shading<M, L>::set_unlit_color(const CurrentState& current) {
    if (has_unlit_color_ && equal_words<4>(unlit_color_, current.color))
        return;
    M::set_color(unlit_, current.color);
    if (SPANGLE_FEATURE_SECONDARY_COLOR && modes_.has_color_sum())
        M::set_secondary_color(unlit_, current.secondary_color);
    for (int c = 0; c < 4; ++c)
        unlit_color_[c] = current.color[c];
    // With a colour sum, the secondary colour would have to be compared, too.
    has_unlit_color_ = !modes_.has_color_sum();
}

/// Copies rarely used current state to a vertex: edge flag, fog coordinate and colour index. If the material
/// follows the current colour, the vertex is lit at once.
template <class M, class L> void Shading<M, L>::take_vertex_state(const CurrentState& current, Vertex& v) {
    if (tells_reach && is_told(*context_))
        record_vertex_reach(current, v);
    if (current.edge_flag)
        v.flags |= edge_flag;
    if (modes_.has_fog_coordinates())
        M::set_fog_coordinate(M::fog_coordinate(current.fog_coord), v.window);
    if (modes_.has_color_index() && !modes_.is_lit())
        M::set_index(current.index, modes_.index_bits(), v.window);
#if SPANGLE_FEATURE_FEEDBACK
    if (modes_.is_capturing())
        texture_coords_[&v - vertex_slot_] = texture_of(current, v, 0);
#endif
    if (lighting_.tracks_color()) {
        color(v);
        color_back(v);
    }
}

/// Lights the vertex unless that has been done.
template <class M, class L> inline void Shading<M, L>::color(Vertex& v) {
    if ((v.flags & uncolored) != 0)
        light(v);
}

/// Lights the back of a vertex of vertex_slot_. It is called before the material changes.
template <class M, class L> inline void Shading<M, L>::color_back([[maybe_unused]] Vertex& v) {
#if SPANGLE_TWO_SIDES
    if (!modes_.has_two_sides() || (v.flags & (back_known | is_clipped_vertex)) != 0)
        return;
    Window lit;
    light(v, 1, lit);
    M::copy_color(lit, back_colors_[&v - vertex_slot_]);
    v.flags |= back_known;
#endif
}

/// Sets the back colours of a vertex in `out`.
template <class M, class L> inline void Shading<M, L>::light_back(const Vertex& v, Window& out) {
#if SPANGLE_TWO_SIDES
    if ((v.flags & back_known) != 0)
        return M::copy_color((v.flags & is_clipped_vertex) != 0 ? static_cast<const ClippedVertex&>(v).back
                                                                : back_colors_[&v - vertex_slot_],
                             out);
#endif
    light(v, 1, out);
}

/// Lights a vertex and sets its colours in `out`. `side` is 0 for the front and 1 for the back.
template <class M, class L> void Shading<M, L>::light(const Vertex& v, int side, Window& out) {
#if SPANGLE_TWO_SIDES
    if ((v.flags & is_clipped_vertex) != 0) {
        const ClippedVertex& clipped = static_cast<const ClippedVertex&>(v);
        return lighting_.light(*context_, clipped.light, M::narrow(clipped.eye), side, out);
    }
#endif
    typename M::Eye eye{};
    if (lighting_.needs_eye())
        eye = M::to_eye(transforms_, v.position);
    lighting_.light(*context_, v.normal, eye, side, out);
}

template <class M, class L> void Shading<M, L>::light(Vertex& v) {
    static constexpr typename M::Eye unseen{};
    if ((SPANGLE_TWO_SIDES && (v.flags & is_clipped_vertex) != 0) || lighting_.needs_eye())
        light(v, 0, v.window);
    else
        lighting_.light(*context_, v.normal, unseen, 0, v.window);
    v.flags &= ~uncolored;
}

template <class M, class L> inline Stale Shading<M, L>::derive(Context& context, GLenum mode) {
    Stale stale = Stale::nothing;
    if (const unsigned dirty = context.dirty & dirty_vertex; dirty != 0) {
        derive_transforms(context, dirty);
        lighting_.derive(context, dirty);
        context.dirty = static_cast<std::uint16_t>(context.dirty & ~dirty_vertex);
        if ((dirty & ~unsigned{dirty_lights | dirty_materials}) != 0)
            stale = Stale::all;
        else if (context.lighting.lighting)
            stale = Stale::colors;
    }
    modes_.derive(context, mode, {lighting_.two_sided(), lighting_.tracks_color(), planes_.any()});
    if (modes_.has_color_sum())
        has_unlit_color_ = false;
    if (const unsigned thirds = modes_.units() >> third_coordinate; thirds != units_with_r_) {
        units_with_r_ = thirds;
        stale = Stale::all;
    }
    return stale;
}

template <class M, class L> inline void Shading<M, L>::settle_colors() {
    for (int i = 0; i < assembler_.count(); ++i) {
        color(assembler_.corner(i));
        color_back(assembler_.corner(i));
    }
    lighting_.materials_changed();
}

template <class M, class L>
inline void Shading<M, L>::set_raster_position(Context& context, const Real (&position)[4]) {
    const CurrentState& current = context.current;
    Vertex& v = vertex_slot_[0];
    for (int c = 0; c < 4; ++c)
        v.position[c] = position[c];
    v.set_normal(current.normal);
    const typename M::Clip clip = M::to_clip(transforms_, v.position);
    RasterPosition& out = context.current.raster;
    out.valid =
        (flags_of(clip) & outside_mask) == 0 && M::in_front(clip) && (!planes_.any() || outside(v) == 0);
    if (!out.valid)
        return;
    Real eye[4];
    M::to_reals(M::to_eye(transforms_, v.position), eye);
    M::window_of(transforms_, clip, out.position);
    out.distance = context.fog.source == GL_FOG_COORDINATE ? current.fog_coord : numeric::abs(eye[2]);
    v.flags = 0;
    if (tells_reach && is_told(context))
        record_vertex_reach(current, v);
    if (modes_.is_lit())
        light(v, 0, v.window);
    // The framebuffer has either indices or colours. The raster position's other value stays as it was.
    if (modes_.has_color_index()) {
        if (!modes_.is_lit())
            M::set_index(current.index, modes_.index_bits(), v.window);
        out.index = M::index_of(v.window);
    } else {
        for (int c = 0; c < 4; ++c)
            out.color[c] = numeric::clamp01(current.color[c]);
        if (modes_.is_lit())
            M::color_of(v.window, out.color);
    }
    for (int u = 0; u < texture_units; ++u)
        M::to_reals(texture_of(current, v, u), out.tex_coord[u].v);
#if SPANGLE_FEATURE_SELECTION
    if (context.render.mode == GL_SELECT) {
        M::project(transforms_, clip, v.window);
        record_hit(context, M::depth_word(v.window));
    }
#endif
}

} // namespace spangle::gl
