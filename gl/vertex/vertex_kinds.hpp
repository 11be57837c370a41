// The kinds of vertices that the pipeline processes, and their flags.
//
// A vertex owns what is known of it alone: its position as given, its flags, and its window vertex. All kinds
// are plain data, and zero bytes are a valid vertex of each kind. M is the numeric policy, and L the
// lighting.
#pragma once

#include <cstdint>

#include "gl/context/features.hpp"
#include "gl/context/limits.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

/// Number of the user's first clip plane in sets of planes. Planes 0 to 5 are those of the view volume.
inline constexpr int user_shift = 6;

// Bits of Vertex::flags.
/// Bits 0 to 5. Bit p is set if the vertex is outside of plane p of the view volume.
inline constexpr unsigned outside_mask = 0x3F;
/// Bits 8 to 13. Bit 8 + p is set if plane p of the guard band, near or far must clip the vertex.
inline constexpr unsigned beyond_shift = 8, beyond_mask = 0x3F << beyond_shift;
/// The vertex has no window coordinates yet.
inline constexpr unsigned unprojected = 1 << 14;
/// The vertex is still to be lit.
inline constexpr unsigned uncolored = 1 << 15;
/// The vertex is a ClippedVertex.
inline constexpr unsigned is_clipped_vertex = 1 << 16;
/// The current edge flag was TRUE when the vertex was given.
inline constexpr unsigned edge_flag = 1 << 17;
/// The edge that starts at the vertex belongs to the outline of the polygon.
inline constexpr unsigned boundary = 1 << 18;
/// A primitive that waits in a batch of elements, and that uses the vertex, is still to be drawn.
inline constexpr unsigned is_pending = 1 << 19;
/// The colour of the vertex's back is known, as that of its front is.
inline constexpr unsigned back_known = 1 << 20;

/// Vertices have normals unless the build has neither lighting nor generated texture coordinates.
inline constexpr bool has_normals = SPANGLE_FEATURE_LIGHTING || SPANGLE_FEATURE_TEXGEN;

/// A vertex as it was given, in object space.
struct ObjectVertex {
    Real position[4]{numeric::zero, numeric::zero, numeric::zero, numeric::one};
#if SPANGLE_FEATURE_LIGHTING || SPANGLE_FEATURE_TEXGEN
    Real normal[3]{};
#else
    static constexpr Real normal[3]{};
#endif

    void set_normal([[maybe_unused]] const Real (&given)[3]) {
#if SPANGLE_FEATURE_LIGHTING || SPANGLE_FEATURE_TEXGEN
        for (int c = 0; c < 3; ++c)
            normal[c] = given[c];
#endif
    }
};

template <class M> struct Vertex : ObjectVertex {
    std::uint32_t flags = 0; ///< set of the flags above
#if SPANGLE_VERTEX_CACHE != 1
    /// A cached vertex is valid while this equals the epoch of the VertexCache, its value when the vertex was
    /// processed.
    std::uint32_t cache_epoch = 0;
    /// s and t as given, from which the texture coordinates of `window` were made.
    Real st[2]{};
#endif
    typename M::Window window{};
};

/// A vertex that is being clipped, or that clipping made. Clipping mixes its values; other vertices compute
/// these values only when needed.
template <class M, class L> struct ClippedVertex : Vertex<M> {
    typename M::Point clip{};
#if SPANGLE_FEATURE_FOG
    typename M::Depth eye_z{}; ///< z in eye space with its sign, or the fog coordinate
#endif
#if SPANGLE_TWO_SIDES || SPANGLE_FEATURE_CLIP_PLANES || SPANGLE_FEATURE_POINT_PARAMETERS
    typename M::Point eye{};
#endif
#if SPANGLE_FEATURE_FEEDBACK
    typename M::Eye texture{}; ///< texture coordinates of unit 0, set in render mode FEEDBACK only
#endif
#if SPANGLE_TWO_SIDES
    typename L::Input light{}; ///< the normal, to light the back with; the front has been lit before
    typename M::Colors back{}; ///< colours of the back, set where `flags` has back_known
#endif
};

/// True if the first N components of two vectors have the same bits.
template <int N> bool equal_words(const Real* a, const Real* b) {
    std::uint32_t differ = 0;
    for (int i = 0; i < N; ++i)
        differ |= a[i].bits ^ b[i].bits;
    return differ == 0;
}

} // namespace spangle::gl
