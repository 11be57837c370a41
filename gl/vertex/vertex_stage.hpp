// Computes the window position and the texture coordinates of one vertex.
//
// VertexStage owns what is derived from matrices, user planes and texture coordinate generation, and the
// slots of the vertices that Vertex commands give. It takes a vertex whose position and normal are set. It
// promises that the result is a function of these and of the context's state alone, whichever way a program
// gives the vertex. If a vertex is not divided by w here, its flags say what is still to be done.
#pragma once

#include <algorithm>

#include "gl/context/reach.hpp"
#include "gl/vertex/current_element.hpp"
#include "gl/vertex/draw_scope.hpp"
#include "gl/vertex/primitive_assembler.hpp"
#include "gl/vertex/texgen.hpp"
#include "gl/vertex/user_planes.hpp"
#include "gl/vertex/vertex_kinds.hpp"

namespace spangle::gl {

template <class M> class VertexStage : public DrawScope {
  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;

    static constexpr int slot_count = PrimitiveAssembler<Vertex>::slot_count;

    /// Derives transforms, planes and generated coordinates from the state that changed. `dirty` is a set of
    /// Dirty bits.
    void derive_transforms(const Context& context, unsigned dirty) {
        if ((dirty & dirty_transform) != 0)
            M::derive(context.transform, dirty, transforms_);
        if ((dirty & dirty_others) != 0)
            planes_.derive(context.transform);
        texgen_.derive(context, dirty);
    }
    [[gnu::noinline]] void transform_vertex(Vertex& v) const;
    [[gnu::noinline]] void process_common(Vertex& v, const std::uint8_t* words) const;
    [[gnu::noinline]] void set_texture_coords(const CurrentState& current, Vertex& v);
    [[gnu::noinline]] typename M::Eye texture_of(const CurrentState& current, const Vertex& v,
                                                 int unit) const;
    [[gnu::noinline]] unsigned outside(const Vertex& v) const;
    template <class Point> [[gnu::noinline]] static unsigned flags_of(const Point& clip);

  protected:
    SPANGLE_INLINE void divide(Vertex& v) const;
    SPANGLE_INLINE void set_flags(Vertex& v, bool divided, unsigned planes) const;
    [[gnu::noinline]] unsigned undivided_flags(const Vertex& v) const;
    bool has_texgen(int unit) const;
    [[gnu::noinline]] void generate_texture_coords(const CurrentState& current, Vertex& v, int unit);
    SPANGLE_INLINE static void read_position(const std::uint8_t* words, Vertex& v);
    [[gnu::noinline]] void record_vertex_reach(const CurrentState& current, const Vertex& v) const;

    /// The corners of the current primitive.
    PrimitiveAssembler<Vertex> assembler_;
    typename M::Transforms transforms_;
    UserPlanes<M> planes_;
    TexGen<M> texgen_;
    Vertex vertex_slot_[slot_count];
#if SPANGLE_FEATURE_FEEDBACK
    /// Texture coordinates of unit 0 of vertex_slot_, set in render mode FEEDBACK.
    typename M::Eye texture_coords_[slot_count];
#endif
};

/// Computes the window position of a vertex whose position and normal are set. If the vertex is not divided
/// by w here, its flags say what is still to be done.
template <class M> void VertexStage<M>::transform_vertex(Vertex& v) const {
    divide(v);
}

/// Reads a position of is_common() arrays and processes the vertex. w is known to be 1, and the position
/// stays in registers.
template <class M> void VertexStage<M>::process_common(Vertex& v, const std::uint8_t* words) const {
    read_position(words, v);
    divide(v);
}

template <class M> void VertexStage<M>::set_texture_coords(const CurrentState& current, Vertex& v) {
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

/// Returns s, t, r and q of a vertex, after the texture matrix of a unit.
template <class M>
typename M::Eye VertexStage<M>::texture_of(const CurrentState& current, const Vertex& v, int unit) const {
    const Real(&coords)[4] = current.tex_coord[unit].v;
    typename M::Scalar strq[4] = {M::scalar(coords[0]), M::scalar(coords[1]), M::scalar(coords[2]),
                                  M::scalar(coords[3])};
    if ((texgen_.units() >> unit & 1) != 0)
        texgen_.generate(transforms_, unit, v.position, v.normal, coords, strq);
    return M::texture_of(transforms_, strq, unit);
}

/// Returns the user planes that a vertex is outside of; bit p stands for plane p. The vertex must not be one
/// that clipping made.
template <class M> unsigned VertexStage<M>::outside(const Vertex& v) const {
    return planes_.outside(M::to_eye(transforms_, v.position));
}

/// Returns the flags of a vertex with the given clip coordinates. The vertex counts as unprojected, since it
/// is projected only if it is visible.
template <class M> template <class Point> unsigned VertexStage<M>::flags_of(const Point& clip) {
    unsigned flags = unprojected;
    for (unsigned plane = 0; plane < 6; ++plane) {
        const int p = static_cast<int>(plane);
        flags |= M::beyond(clip, p, 1) ? 1u << plane : 0u;
        if constexpr (has_clipping) // without clipping, `unprojected` alone refuses the vertex
            flags |= M::beyond(clip, p, M::guard_band) ? 1u << (plane + beyond_shift) : 0u;
    }
    return flags;
}

template <class M> SPANGLE_INLINE void VertexStage<M>::divide(Vertex& v) const {
    typename M::template Projections<1> projection;
    projection.add(0, transforms_, v.position, v.window, modes_.has_fog());
    projection.finish(1);
    unsigned planes = 0;
    const bool divided = projection.divide(0, transforms_, v.position, v.window, planes);
    set_flags(v, divided, planes);
}

template <class M>
SPANGLE_INLINE void VertexStage<M>::set_flags(Vertex& v, bool divided, unsigned planes) const {
    v.flags = divided ? planes : undivided_flags(v);
    if (modes_.is_lit())
        v.flags |= uncolored;
}

/// Returns the flags of a vertex that was not divided by w. The function is not inlined, since the loops over
/// elements have no registers to spare for a rare case.
template <class M> unsigned VertexStage<M>::undivided_flags(const Vertex& v) const {
    // All vertices with w = 1 have been divided, so w is not 1 here.
    if constexpr (!raster::has_perspective)
        return unprojected;
    return flags_of(M::to_clip(transforms_, v.position));
}

/// True if the coordinates of a unit are generated, or if the unit needs r.
template <class M> inline bool VertexStage<M>::has_texgen(int unit) const {
    return (SPANGLE_FEATURE_TEXGEN || raster::has_third_coordinates) &&
           ((texgen_.units() | modes_.units() >> third_coordinate) >> unit & 1) != 0;
}

template <class M>
void VertexStage<M>::generate_texture_coords(const CurrentState& current, Vertex& v, int unit) {
    const Real(&coords)[4] = current.tex_coord[unit].v;
    typename M::Scalar strq[4] = {M::scalar(coords[0]), M::scalar(coords[1]), M::scalar(coords[2]),
                                  M::scalar(coords[3])};
    if ((texgen_.units() >> unit & 1) != 0)
        texgen_.generate(transforms_, unit, v.position, v.normal, coords, strq);
    M::set_texture(transforms_, strq, unit, texgen_.keeps_q(unit) && coords[3] == numeric::one, v.window);
}

template <class M> SPANGLE_INLINE void VertexStage<M>::read_position(const std::uint8_t* words, Vertex& v) {
    ArrayReader::read_3_floats(words, v.position);
    v.position[3] = numeric::one;
}

/// Reports the range of a vertex's position and texture coordinates, and whether they need a division.
template <class M>
void VertexStage<M>::record_vertex_reach(const CurrentState& current, const Vertex& v) const {
    Context& context = *context_;
    std::uint32_t bits = 0;
    for (const Real x : v.position)
        bits = std::max(bits, bits_before_point(x));
    reach(context, Range::POSITION_BITS, bits);
    Real clip[4];
    M::to_reals(M::to_clip(transforms_, v.position), clip);
    bool divides = !(clip[3] == numeric::one);
    for (int u = 0; u < texture_units; ++u) {
        if ((modes_.units() >> u & 1) == 0)
            continue;
        Real strq[4];
        M::to_reals(texture_of(current, v, u), strq);
        for (int c = 0; c < 3; ++c)
            reach(context, Range::TEXTURE_BITS, bits_before_point(strq[c]));
        divides = divides || !(strq[3] == numeric::one);
    }
    if constexpr (raster::has_perspective) // without perspective, dividing is an error elsewhere
        reach(context, Range::PERSPECTIVE, divides ? 1 : 0);
}

} // namespace spangle::gl
