// Rows of state that turns primitives into fragments: points, lines and polygons (GL 1.3, table 6.12).
#pragma once

#include "gl/context/state_row.hpp"

// Builds without stippling have no members for it.
#if SPANGLE_FEATURE_STIPPLE
#define STIPPLE_ROW(NAME, MEMBER) STORED(NAME, polygon.MEMBER)
#define STIPPLE_SWITCH(NAME, MEMBER) SWITCH(NAME, polygon.MEMBER)
#define STIPPLE HELD(polygon.stipple)
#else
#define STIPPLE_ROW(NAME, MEMBER) of_stipple(constant(NAME, 0))
#define STIPPLE_SWITCH(NAME, MEMBER) of_stipple(absent_switch(NAME))
#define STIPPLE in(Group::polygon_stipple)
#endif

#if SPANGLE_FEATURE_POINT_PARAMETERS
#define POINT_ROW(NAME, MEMBER) STORED(NAME, polygon.MEMBER)
#define POINT_SWITCH(NAME, MEMBER) SWITCH(NAME, polygon.MEMBER)
#define COORD_REPLACE HELD(polygon.coord_replace)
#else
#define POINT_ROW(NAME, MEMBER) of_point_parameters(constant(NAME, 0))
#define POINT_SWITCH(NAME, MEMBER) of_point_parameters(absent_switch(NAME))
#define COORD_REPLACE in(Group::point)
#endif

namespace spangle::gl {

inline constexpr auto raster_rows = std::to_array<WrittenRow>({
    in(Group::point),
    STORED(GL_POINT_SIZE, polygon.point_size),
    of_antialiasing(SWITCH(GL_POINT_SMOOTH, polygon.point_smooth)),
    POINT_ROW(GL_POINT_SIZE_MIN, point_size_min),
    POINT_ROW(GL_POINT_SIZE_MAX, point_size_max),
    POINT_ROW(GL_POINT_FADE_THRESHOLD_SIZE, point_fade_threshold),
    POINT_ROW(GL_POINT_DISTANCE_ATTENUATION, point_attenuation),
    POINT_SWITCH(GL_POINT_SPRITE, point_sprite),
    POINT_ROW(GL_POINT_SPRITE_COORD_ORIGIN, sprite_origin),
    COORD_REPLACE,
    in(Group::line),
    STORED(GL_LINE_WIDTH, polygon.line_width),
    of_antialiasing(SWITCH(GL_LINE_SMOOTH, polygon.line_smooth)),
    STIPPLE_SWITCH(GL_LINE_STIPPLE, line_stipple),
    STIPPLE_ROW(GL_LINE_STIPPLE_PATTERN, stipple_pattern),
    STIPPLE_ROW(GL_LINE_STIPPLE_REPEAT, stipple_factor),
    in(Group::polygon),
    SWITCH(GL_CULL_FACE, polygon.cull_face),
    STORED(GL_CULL_FACE_MODE, polygon.cull_face_mode),
    of_polygon_mode(STORED(GL_POLYGON_MODE, polygon.mode)),
    STORED(GL_FRONT_FACE, polygon.front_face),
    of_antialiasing(SWITCH(GL_POLYGON_SMOOTH, polygon.polygon_smooth)),
    STIPPLE_SWITCH(GL_POLYGON_STIPPLE, polygon_stipple),
    of_polygon_offset(STORED(GL_POLYGON_OFFSET_FACTOR, polygon.offset_factor)),
    of_polygon_offset(STORED(GL_POLYGON_OFFSET_UNITS, polygon.offset_units)),
    of_polygon_offset(SWITCH(GL_POLYGON_OFFSET_POINT, polygon.offset_point)),
    of_polygon_offset(SWITCH(GL_POLYGON_OFFSET_LINE, polygon.offset_line)),
    of_polygon_offset(SWITCH(GL_POLYGON_OFFSET_FILL, polygon.offset_fill)),
    in(Group::polygon_stipple),
    STIPPLE,
});

#undef POINT_ROW
#undef POINT_SWITCH
#undef COORD_REPLACE
#undef STIPPLE_ROW
#undef STIPPLE_SWITCH
#undef STIPPLE

} // namespace spangle::gl
