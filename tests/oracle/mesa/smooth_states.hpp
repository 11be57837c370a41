// Antialiased figures (GL 1.3, 3.3, 3.4.2, 3.5.3), one in each drawing. They are white and not blended, so
// alpha is the coverage. Whoever compares a drawing knows its figure.
#pragma once

#include "tests/oracle/mesa/states.hpp"

namespace spangle::oracle {

struct SmoothFigure {
    double point_size, line_width;
    struct Corner {
        double x, y;
    } corner[3];
};

/// Returns the figure of a drawing of the families smooth_points, smooth_lines, smooth_polygons.
SmoothFigure smooth_figure(int drawing, int corners);
const std::vector<Family>& smooth_families();

} // namespace spangle::oracle
