// How groups of pixels are changed on their way, and where they land (GL 1.3, 3.6.3 to 3.6.5).
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

inline constexpr GLsizei max_pixel_map_table = 256;

/// The maps in the order of their tokens, from PIXEL_MAP_I_TO_I.
enum PixelMapName : unsigned {
    map_i_to_i,
    map_s_to_s,
    map_i_to_r,
    map_r_to_r = map_i_to_r + 4,
    pixel_maps = 10
};

/// Entries follow in the same block: Reals, or with `integers` the indices themselves.
struct PixelMap {
    GLsizei size;
    bool integers;

    std::uint32_t* entries() { return reinterpret_cast<std::uint32_t*>(this + 1); }
    const std::uint32_t* entries() const { return reinterpret_cast<const std::uint32_t*>(this + 1); }
};

/// What components are multiplied with, and what is added.
struct Linear {
    Real scale = numeric::one, bias = numeric::zero;
};

struct PixelModeState {
#if SPANGLE_FEATURE_PIXEL_TRANSFER
    bool map_color = false, map_stencil = false;
    GLint index_shift = 0, index_offset = 0;
    Linear linear[5];               ///< red, green, blue, alpha, depth
    PixelMap* map[pixel_maps] = {}; ///< null: one entry, 0
#endif
#if SPANGLE_FEATURE_DRAW_PIXELS
    Real zoom[2] = {numeric::one, numeric::one};
#endif
};

} // namespace spangle::gl
