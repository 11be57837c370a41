// How primitives become fragments: points, lines, polygons (GL 1.3, table 6.12).
#pragma once

#include "gl/context/state_row.hpp"

namespace spangle::gl {

inline constexpr auto raster_rows = std::to_array<StateRow>({
    in(Group::point),
    STORED(GL_POINT_SIZE, polygon.point_size),
    in(Group::line),
    STORED(GL_LINE_WIDTH, polygon.line_width),
    in(Group::polygon),
    SWITCH(GL_CULL_FACE, polygon.cull_face),
    STORED(GL_CULL_FACE_MODE, polygon.cull_face_mode),
    of_polygon_mode(STORED(GL_POLYGON_MODE, polygon.mode)),
    STORED(GL_FRONT_FACE, polygon.front_face),
});

} // namespace spangle::gl
