#include "tests/oracle/mesa/smooth_states.hpp"

#include "tests/oracle/mesa/state_families.hpp"

namespace spangle::oracle {

namespace {

SmoothFigure figure(test::Random& random, int corners) {
    SmoothFigure out{};
    out.point_size = (8 + random.below(57)) / 8.0;
    out.line_width = (8 + random.below(33)) / 8.0;
    for (int i = 0; i < corners; ++i) {
        out.corner[i].x = random.below(state_size * 256) / 256.0;
        out.corner[i].y = random.below(state_size * 256) / 256.0;
    }
    return out;
}

void draw(test::Random& random, GLenum smooth, GLenum mode, int corners) {
    const SmoothFigure it = figure(random, corners);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(smooth);
    glPointSize(static_cast<GLfloat>(it.point_size));
    glLineWidth(static_cast<GLfloat>(it.line_width));
    glColor4f(1, 1, 1, 1);
    glBegin(mode);
    for (int i = 0; i < corners; ++i)
        glVertex2d(it.corner[i].x, it.corner[i].y);
    glEnd();
}

} // namespace

SmoothFigure smooth_figure(int drawing, int corners) {
    test::Random random{seed_of(drawing)};
    return figure(random, corners);
}

const std::vector<Family>& smooth_families() {
    static const std::vector<Family> all = {
        {"smooth_points", 1000, 255, 0,
         [](test::Random& r, Quads&) { draw(r, GL_POINT_SMOOTH, GL_POINTS, 1); }},
        {"smooth_lines", 1000, 255, 0, [](test::Random& r, Quads&) { draw(r, GL_LINE_SMOOTH, GL_LINES, 2); }},
        {"smooth_polygons", 1000, 255, 0,
         [](test::Random& r, Quads&) { draw(r, GL_POLYGON_SMOOTH, GL_TRIANGLES, 3); }},
    };
    return all;
}

} // namespace spangle::oracle
