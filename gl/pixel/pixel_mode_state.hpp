// Pixel transfer, pixel maps and zoom (GL 1.3, 3.6.3 to 3.6.5).
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

inline constexpr GLsizei max_pixel_map_table = 256;

/// The pixel maps, in the order of their tokens from PIXEL_MAP_I_TO_I on.
enum PixelMapName : unsigned {
    map_i_to_i,
    map_s_to_s,
    map_i_to_r,
    map_r_to_r = map_i_to_r + 4,
    pixel_maps = 10
};

/// A pixel map. The entries follow in the same block of memory. They are Reals, or integers if `integers` is
/// set.
struct PixelMap {
    GLsizei size;
    bool integers;

    std::uint32_t* entries() { return reinterpret_cast<std::uint32_t*>(this + 1); }
    const std::uint32_t* entries() const { return reinterpret_cast<const std::uint32_t*>(this + 1); }
};

/// The scale and bias that are applied to a component.
struct Linear {
    Real scale = numeric::one, bias = numeric::zero;
};

struct PixelModeState {
#if SPANGLE_FEATURE_PIXEL_TRANSFER
    bool map_color = false, map_stencil = false;
    GLint index_shift = 0, index_offset = 0;
    Linear linear[5];               ///< red, green, blue, alpha, depth
    PixelMap* map[pixel_maps] = {}; ///< null: the initial map, with one entry of 0
#endif
#if SPANGLE_FEATURE_DRAW_PIXELS
    Real zoom[2] = {numeric::one, numeric::one};
#endif
};

} // namespace spangle::gl
