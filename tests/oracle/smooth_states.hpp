// Antialiased figures (GL 1.3, 3.3, 3.4.2, 3.5.3), one a drawing: white, not blended, so that alpha is what
// is covered. Each is known to whoever compares it.
#pragma once

#include "tests/oracle/states.hpp"

namespace spangle::oracle {

struct SmoothFigure {
    double point_size, line_width;
    struct Corner {
        double x, y;
    } corner[3];
};

/// What a drawing of the families smooth_points, smooth_lines, smooth_polygons shows.
SmoothFigure smooth_figure(int drawing, int corners);
const std::vector<Family>& smooth_families();

} // namespace spangle::oracle
