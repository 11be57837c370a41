// Processes one vertex: computes its window position, its attributes and its colour.
#pragma once

#include "gl/vertex/pipeline.hpp"

namespace spangle::gl {

template <class M, class L>
inline void Pipeline<M, L>::raster_position(Context& context, const Real (&position)[4]) {
    context_ = &context;
    derive(context, GL_POINTS);
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

template <class M, class L> inline void Pipeline<M, L>::settle_colors() {
    for (int i = 0; i < assembler_.count(); ++i) {
        color(assembler_.corner(i));
        color_back(assembler_.corner(i));
    }
    lighting_.materials_changed();
}

/// Computes the window position of a vertex whose position and normal are set. If the vertex is not divided
/// by w here, its flags say what is still to be done.
template <class M, class L> void Pipeline<M, L>::transform_vertex(Vertex& v) const {
    divide(v);
}

/// Reads a position of is_common() arrays and processes the vertex. w is known to be 1, and the position
/// stays in registers.
template <class M, class L> void Pipeline<M, L>::process_common(Vertex& v, const std::uint8_t* words) const {
    read_position(words, v);
    divide(v);
}

template <class M, class L> SPANGLE_INLINE void Pipeline<M, L>::divide(Vertex& v) const {
    typename M::template Projections<1> projection;
    projection.add(0, transforms_, v.position, v.window, modes_.has_fog());
    projection.finish(1);
    unsigned planes = 0;
    const bool divided = projection.divide(0, transforms_, v.position, v.window, planes);
    set_flags(v, divided, planes);
}

template <class M, class L>
SPANGLE_INLINE void Pipeline<M, L>::set_flags(Vertex& v, bool divided, unsigned planes) const {
    v.flags = divided ? planes : undivided_flags(v);
    if (modes_.is_lit())
        v.flags |= uncolored;
}

/// Returns the flags of a vertex that was not divided by w. The function is not inlined, since the loops over
/// elements have no registers to spare for a rare case.
template <class M, class L> unsigned Pipeline<M, L>::undivided_flags(const Vertex& v) const {
    // All vertices with w = 1 have been divided, so w is not 1 here.
    if constexpr (!raster::has_perspective)
        return unprojected;
    return flags_of(M::to_clip(transforms_, v.position));
}

/// Copies the current texture coordinates to a vertex, and the current colour if lighting is off.
template <class M, class L>
SPANGLE_INLINE void Pipeline<M, L>::set_attributes_of(const CurrentState& current, Vertex& v) {
    if (raster::has_textures && modes_.units() != 0)
        set_texture_coords(current, v);
    if (modes_.is_lit())
        return;
    set_unlit_color(current);
    M::copy_color(unlit_, v.window);
}

template <class M, class L> SPANGLE_INLINE void Pipeline<M, L>::set_unlit_color(const CurrentState& current) {
    if (has_unlit_color_ && equal_words<4>(unlit_color_, current.color))
        return;
    M::set_color(unlit_, current.color);
    if (SPANGLE_FEATURE_SECONDARY_COLOR && modes_.has_color_sum())
        M::set_secondary_color(unlit_, current.secondary_color);
    for (int c = 0; c < 4; ++c)
        unlit_color_[c] = current.color[c];
    has_unlit_color_ = !modes_.has_color_sum(); // else the secondary colour would have to be compared, too
}

/// Returns s, t, r and q of a vertex, after the texture matrix of a unit.
template <class M, class L>
typename M::Eye Pipeline<M, L>::texture_of(const CurrentState& current, const Vertex& v, int unit) const {
    const Real(&coords)[4] = current.tex_coord[unit].v;
    typename M::Scalar strq[4] = {M::scalar(coords[0]), M::scalar(coords[1]), M::scalar(coords[2]),
                                  M::scalar(coords[3])};
    if ((texgen_.units() >> unit & 1) != 0)
        texgen_.generate(transforms_, unit, v.position, v.normal, coords, strq);
    return M::texture_of(transforms_, strq, unit);
}

/// True if the coordinates of a unit are generated, or if the unit needs r.
template <class M, class L> inline bool Pipeline<M, L>::has_texgen(int unit) const {
    return (SPANGLE_FEATURE_TEXGEN || raster::has_third_coordinates) &&
           ((texgen_.units() | modes_.units() >> third_coordinate) >> unit & 1) != 0;
}

template <class M, class L>
void Pipeline<M, L>::generate_texture_coords(const CurrentState& current, Vertex& v, int unit) {
    const Real(&coords)[4] = current.tex_coord[unit].v;
    typename M::Scalar strq[4] = {M::scalar(coords[0]), M::scalar(coords[1]), M::scalar(coords[2]),
                                  M::scalar(coords[3])};
    if ((texgen_.units() >> unit & 1) != 0)
        texgen_.generate(transforms_, unit, v.position, v.normal, coords, strq);
    M::set_texture(transforms_, strq, unit, texgen_.keeps_q(unit) && coords[3] == numeric::one, v.window);
}

template <class M, class L> void Pipeline<M, L>::set_texture_coords(const CurrentState& current, Vertex& v) {
    for (int u = 0; u < texture_units; ++u) {
        if ((modes_.units() >> u & 1) == 0)
            continue;
        if (has_texgen(u))
            generate_texture_coords(current, v, u);
        else
            M::set_texture(transforms_, current.tex_coord[u].v, u, v.window);
        if constexpr (!raster::has_perspective)
            if (!M::q_is_one(v.window, u))
                v.flags |= unprojected;
    }
}

/// Returns the flags of a vertex with the given clip coordinates. The vertex counts as unprojected, since it
/// is projected only if it is visible.
template <class M, class L> template <class Point> unsigned Pipeline<M, L>::flags_of(const Point& clip) {
    unsigned flags = unprojected;
    for (unsigned plane = 0; plane < 6; ++plane) {
        const int p = static_cast<int>(plane);
        flags |= M::beyond(clip, p, 1) ? 1u << plane : 0u;
        if constexpr (has_clipping) // without clipping, `unprojected` alone refuses the vertex
            flags |= M::beyond(clip, p, M::guard_band) ? 1u << (plane + beyond_shift) : 0u;
    }
    return flags;
}

/// Lights a vertex and sets its colours in `out`. `side` is 0 for the front and 1 for the back.
template <class M, class L> void Pipeline<M, L>::light(const Vertex& v, int side, Window& out) {
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

/// Copies rarely used current state to a vertex: edge flag, fog coordinate and colour index. If the material
/// follows the current colour, the vertex is lit at once.
template <class M, class L> void Pipeline<M, L>::take_vertex_state(const CurrentState& current, Vertex& v) {
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

/// Returns the user planes that a vertex is outside of; bit p stands for plane p. The vertex must not be one
/// that clipping made.
template <class M, class L> unsigned Pipeline<M, L>::outside(const Vertex& v) const {
    return planes_.outside(M::to_eye(transforms_, v.position));
}

/// Lights the vertex unless that has been done.
template <class M, class L> inline void Pipeline<M, L>::color(Vertex& v) {
    if ((v.flags & uncolored) != 0)
        light(v);
}

template <class M, class L> void Pipeline<M, L>::light(Vertex& v) {
    static constexpr typename M::Eye unseen{};
    if ((SPANGLE_TWO_SIDES && (v.flags & is_clipped_vertex) != 0) || lighting_.needs_eye())
        light(v, 0, v.window);
    else
        lighting_.light(*context_, v.normal, unseen, 0, v.window);
    v.flags &= ~uncolored;
}

/// Lights the back of a vertex of vertex_slot_, too, before the material changes.
template <class M, class L> inline void Pipeline<M, L>::color_back([[maybe_unused]] Vertex& v) {
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
template <class M, class L> inline void Pipeline<M, L>::light_back(const Vertex& v, Window& out) {
#if SPANGLE_TWO_SIDES
    if ((v.flags & back_known) != 0)
        return M::copy_color((v.flags & is_clipped_vertex) != 0 ? static_cast<const ClippedVertex&>(v).back
                                                                : back_colors_[&v - vertex_slot_],
                             out);
#endif
    light(v, 1, out);
}

/// Sets the window coordinates of a vertex that has none yet. False: the vertex is not in front of the eye
/// and is not drawn.
template <class M, class L> bool Pipeline<M, L>::project(Vertex& v) {
    // Builds without clipping refuse vertices without window coordinates.
    if (!has_clipping || (v.flags & unprojected) == 0)
        return true;
    // The window position must be the same whether a polygon of the vertex is clipped or not.
    const typename M::Clip clip =
        M::narrow((v.flags & is_clipped_vertex) != 0 ? static_cast<const ClippedVertex&>(v).clip
                                                     : M::clip_point(transforms_, v.position));
    if (!M::in_front(clip))
        return false;
    M::project(transforms_, clip, v.window);
    v.flags &= ~unprojected;
    return true;
}

} // namespace spangle::gl
