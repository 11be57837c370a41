// Implementation limits (GL 1.3, tables 6.26 to 6.29).
#pragma once

#include <cstdint>

namespace spangle::gl {

inline constexpr std::int32_t max_viewport_dim = 2048; ///< 4 x it is raster::guard_band
inline constexpr std::int32_t max_point_size = 64;     ///< sizes are whole pixels, 1 and up
inline constexpr std::int32_t max_line_width = 64;
inline constexpr std::int32_t modelview_stack_entries = 32, projection_stack_entries = 2,
                              texture_stack_entries = 2, attrib_stack_entries = 16;

} // namespace spangle::gl
