// State that turns primitives into fragments: shading, facing, culling and sizes (GL 1.3, 2.13.7 and 3.3 to
// 3.5).
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/limits.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

/// The polygon stipple. It has 32 rows from the bottom up, and bit x of a row says that column x is drawn (GL
/// 1.3, 3.5.2).
struct StipplePattern {
    std::uint32_t row[32];
    constexpr StipplePattern() : row{} {
        for (std::uint32_t& bits : row)
            bits = 0xFFFFFFFF;
    }
};

struct PolygonState {
    GLenum shade_model = GL_SMOOTH;
    GLenum cull_face_mode = GL_BACK;
    GLenum front_face = GL_CCW;
    bool cull_face = false;
    GLenum mode[2] = {GL_FILL, GL_FILL}; ///< polygon mode of front and back faces
    Real point_size = numeric::one;      ///< size in pixels as set, not clamped and not rounded
    Real line_width = numeric::one;
    bool point_smooth = false, line_smooth = false, polygon_smooth = false;
#if SPANGLE_FEATURE_POINT_PARAMETERS
    Real point_size_min = numeric::zero, point_size_max = numeric::from_i32(max_point_size);
    Real point_fade_threshold = numeric::one;
    Real point_attenuation[3] = {numeric::one, numeric::zero, numeric::zero};
    bool point_sprite = false;
    bool coord_replace[texture_units] = {}; ///< true for units with COORD_REPLACE
    GLenum sprite_origin = GL_UPPER_LEFT;
#endif
#if SPANGLE_FEATURE_STIPPLE
    bool line_stipple = false, polygon_stipple = false;
    GLuint stipple_pattern = 0xFFFF;
    GLint stipple_factor = 1;
    StipplePattern stipple;
#else
    static constexpr bool line_stipple = false, polygon_stipple = false;
#endif
    bool offset_point = false, offset_line = false, offset_fill = false;
    Real offset_factor = numeric::zero, offset_units = numeric::zero;
};

} // namespace spangle::gl
