// Processes vertices through the cache: elements of arrays, and vertices that Vertex commands give.
//
// CachedVertices owns the cache. It takes an index or a position, and returns a processed vertex that no
// corner of the current primitive shares by mistake. It promises that a kept vertex is used again only if the
// arrays still hold its values.
#pragma once

#include "gl/vertex/array_element.hpp"
#include "gl/vertex/primitive_sink.hpp"
#include "gl/vertex/vertex_cache.hpp"

namespace spangle::gl {

template <class M, class L> class CachedVertices : public PrimitiveSink<M, L> {
    using Base = PrimitiveSink<M, L>;

  public:
    using Window = typename M::Window;
    using Vertex = gl::Vertex<M>;
    using ClippedVertex = gl::ClippedVertex<M, L>;

#if SPANGLE_VERTEX_CACHE != 1
    [[gnu::noinline]] void transform_with_cache(Vertex& v);
    SPANGLE_INLINE bool is_valid(Vertex& v);
    void arrays_begin(const ElementReader& reader, const CurrentState& current, bool textured);
    bool is_common(const ElementReader& reader) const;
    bool is_common_texture(const ElementReader& reader) const;
    Vertex& element(const ElementReader& reader, std::uint32_t index);
    SPANGLE_INLINE Vertex& general_element(Context& context, const ElementReader& reader,
                                           std::uint32_t index);
    template <class Place, class Finish>
    SPANGLE_INLINE Vertex& common_element(const ElementReader& reader, std::uint32_t index, bool normals,
                                          bool textured, const Place& place, const Finish& finish);
    SPANGLE_INLINE Vertex& slot_for_vertex(Vertex& cached);
#endif

  protected:
    using Base::assembler_;
    using Base::has_texgen;
    using Base::modes_;
    using Base::set_attributes_of;
    using Base::transform_vertex;
    using Base::transforms_;
    using Base::unlit_;
    using Base::vertex_slot_;

#if SPANGLE_VERTEX_CACHE != 1
    bool draws_lines() const;
    [[gnu::noinline]] bool recolor(Vertex& v);
    [[gnu::noinline]] void read_texture(const std::uint8_t* words, Vertex& v);
    SPANGLE_INLINE static bool equal(const Real* v, const std::uint8_t* words);
    SPANGLE_INLINE static bool equal_texture(const Vertex& v, const std::uint8_t* words);
#endif

    VertexCache<M> cache_;

  private:
    ObjectVertex object_vertex_; ///< position and normal of the current element
};

#if SPANGLE_VERTEX_CACHE != 1

/// Does the work of transform_vertex(), or copies the window position that the cache keeps for an equal
/// position.
template <class M, class L> void CachedVertices<M, L>::transform_with_cache(Vertex& v) {
    cache_.place(v, modes_.is_lit() ? uncolored : 0, [this](Vertex& fresh) { transform_vertex(fresh); });
}

/// True if a cached vertex is still valid. A vertex of which only the colours are invalid is coloured anew.
template <class M, class L> SPANGLE_INLINE bool CachedVertices<M, L>::is_valid(Vertex& v) {
    return cache_.is_valid(v) || (VertexCache<M>::keeps_positions && recolor(v));
}

/// Makes cached vertices invalid if the layout of the arrays or the current normal has changed, and colours
/// of unlit vertices if the current colour has changed. Cached vertices do not record these values.
template <class M, class L>
inline void CachedVertices<M, L>::arrays_begin(const ElementReader& reader, const CurrentState& current,
                                               bool textured) {
    const unsigned layout = reader.vertex.components() << 8 | reader.normal.components() << 4 |
                            (textured ? 4u : 0u) | (reader.color.on() ? 2u : 0u) |
                            (reader.textured ? 1u : 0u);
    cache_.begin_draw(layout, current.color, modes_.is_lit(),
                      !reader.normal.on() && !equal_words<3>(object_vertex_.normal, current.normal));
    // The array of positions may lack z and w.
    object_vertex_.position[2] = numeric::zero;
    object_vertex_.position[3] = numeric::one;
    object_vertex_.set_normal(current.normal);
}

/// True if positions have three floats, normals (where they matter) have three floats, and there is no colour
/// array. Most programs draw such arrays.
template <class M, class L> inline bool CachedVertices<M, L>::is_common(const ElementReader& reader) const {
    return reader.vertex.is_floats(3) &&
           (!modes_.is_lit() || !reader.normal.on() || reader.normal.is_floats(3)) && !reader.color.on();
}

/// True if only texture unit 0 is enabled and its coordinates have two floats.
template <class M, class L>
inline bool CachedVertices<M, L>::is_common_texture(const ElementReader& reader) const {
    bool others = false;
    for (int u = 1; u < texture_units; ++u)
        others = others || reader.tex_coord[u].on();
    return modes_.units() == 1 && reader.tex_coord[0].is_floats(2) && !others && !has_texgen(0) &&
           !draws_lines();
}

/// Returns the vertex of an element, without colour and texture coordinates. A cached vertex is used again if
/// position and normal in the arrays have not changed.
template <class M, class L>
inline typename CachedVertices<M, L>::Vertex& CachedVertices<M, L>::element(const ElementReader& reader,
                                                                            std::uint32_t index) {
    Vertex& v = cache_.element(index);
    reader.vertex.read(index, object_vertex_.position);
#if SPANGLE_FEATURE_LIGHTING || SPANGLE_FEATURE_TEXGEN
    if (reader.normal.on())
        reader.normal.read(index, object_vertex_.normal);
#endif
    if (is_valid(v) && equal_words<4>(v.position, object_vertex_.position) &&
        equal_words<3>(v.normal, object_vertex_.normal))
        return v;
    Vertex& fresh = slot_for_vertex(v);
    static_cast<ObjectVertex&>(fresh) = object_vertex_;
    transform_vertex(fresh);
    return fresh;
}

/// Returns the vertex of an element, with colour and texture coordinates. If the cached vertex is a corner of
/// the current primitive, it is copied, since another index may have brought it.
template <class M, class L>
SPANGLE_INLINE typename CachedVertices<M, L>::Vertex&
CachedVertices<M, L>::general_element(Context& context, const ElementReader& reader, std::uint32_t index) {
    Vertex& kept = element(reader, index);
    Vertex& v = slot_for_vertex(kept);
    if (&v != &kept)
        v = kept;
    set_color_and_texture(context, reader, index);
    set_attributes_of(context.current, v);
    return v;
}

/// Returns the vertex of an element of is_common() arrays, with coordinates of is_common_texture() if
/// `textured`. Unlit vertices take the current colour, which all vertices with this `cache_epoch` share. For
/// a new vertex, `place` returns where to store it, and `finish` does the work of process_common().
template <class M, class L>
template <class Place, class Finish>
SPANGLE_INLINE typename CachedVertices<M, L>::Vertex&
CachedVertices<M, L>::common_element(const ElementReader& reader, std::uint32_t index, bool normals,
                                     bool textured, const Place& place, const Finish& finish) {
    Vertex& v = cache_.element(index);
    const std::uint8_t* const words = reader.vertex.words(index);
    const bool of_now = is_valid(v);
    if (of_now && equal(v.position, words) && (!normals || equal(v.normal, reader.normal.words(index))) &&
        (!textured || equal_texture(v, reader.tex_coord[0].words(index)))) [[likely]]
        return v;
    Vertex& fresh = place(v);
    cache_.stamp(fresh);
    if constexpr (has_normals) {
        if (normals)
            ArrayReader::read_3_floats(reader.normal.words(index), fresh.normal);
        else if (modes_.is_lit())
            fresh.set_normal(object_vertex_.normal);
    }
    finish(fresh, words);
    if (textured)
        read_texture(reader.tex_coord[0].words(index), fresh);
    if (!modes_.is_lit() && !(of_now && &fresh == &v))
        M::copy_color(unlit_, fresh.window);
    return fresh;
}

/// Returns the place of a new vertex: `cached`, its place in the cache, unless a corner of the current
/// primitive is there.
template <class M, class L>
SPANGLE_INLINE typename CachedVertices<M, L>::Vertex& CachedVertices<M, L>::slot_for_vertex(Vertex& cached) {
    Vertex& v = assembler_.place_beside_corners(cached, vertex_slot_);
    cache_.stamp(v);
    return v;
}

template <class M, class L> inline bool CachedVertices<M, L>::draws_lines() const {
    return has_lines && modes_.mode() >= GL_LINES && modes_.mode() <= GL_LINE_STRIP;
}

/// Colours a vertex anew if only its colours are invalid; lit vertices wait for color(). False: the vertex is
/// invalid.
template <class M, class L> bool CachedVertices<M, L>::recolor(Vertex& v) {
    if (!cache_.has_position(v))
        return false;
    cache_.stamp(v);
    if (modes_.is_lit())
        v.flags |= uncolored;
    else
        M::copy_color(unlit_, v.window);
    return true;
}

template <class M, class L> void CachedVertices<M, L>::read_texture(const std::uint8_t* words, Vertex& v) {
    for (int i = 0; i < 2; ++i)
        v.st[i] = numeric::from_float_bits(ArrayReader::word(words, i));
    const Real given[4] = {v.st[0], v.st[1], numeric::zero, numeric::one};
    M::set_texture(transforms_, given, 0, v.window);
}

/// True if three coordinates of a vertex equal those in an array.
template <class M, class L>
SPANGLE_INLINE bool CachedVertices<M, L>::equal(const Real* v, const std::uint8_t* words) {
    if (v[0].bits != ArrayReader::word(words, 0)) // most vertices that differ do so in x
        return false;
    return ((v[1].bits ^ ArrayReader::word(words, 1)) | (v[2].bits ^ ArrayReader::word(words, 2))) == 0;
}

template <class M, class L>
SPANGLE_INLINE bool CachedVertices<M, L>::equal_texture(const Vertex& v, const std::uint8_t* words) {
    return v.st[0].bits == ArrayReader::word(words, 0) && v.st[1].bits == ArrayReader::word(words, 1);
}

#endif

} // namespace spangle::gl
