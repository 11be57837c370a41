#include "tests/oracle/mesa/states.hpp"

#include <algorithm>
#include <cmath>

#include "tests/oracle/mesa/state_families.hpp"

namespace spangle::oracle {

const std::vector<Family>& all_families() {
    static const std::vector<Family> families = [] {
        std::vector<Family> all;
        add_fragment_families(all);
        add_pixel_families(all);
        add_primitive_families(all);
        add_texture_families(all);
        add_texture_update_families(all);
        add_sample_families(all);
        return all;
    }();
    return families;
}

void Quads::add(double x0, double y0, double x1, double y1) {
    const Point corner[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    for (int i = 0; i < 4; ++i) // either diagonal is possible
        add_triangle(corner[i], corner[(i + 1) % 4], corner[(i + 2) % 4]);
}

void Quads::add_edge(double x0, double y0, double x1, double y1) {
    inner_edges_.push_back({{x0, y0}, {x1, y1}});
}

/// Notes the triangle's edges inside of the window, and all lines along which a polygon could be cut.
void Quads::add_triangle(Point a, Point b, Point c) {
    std::vector<Point> polygon = {a, b, c};
    for (int side = 0; side < 4; ++side) {
        const auto inside = [&](Point p) { // how far inside a point is
            const double v = side % 2 == 0 ? p.x : p.y;
            return side < 2 ? v : state_size - v;
        };
        std::vector<Point> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point p = polygon[i], q = polygon[(i + 1) % polygon.size()];
            const double at_p = inside(p), at_q = inside(q);
            if (at_p >= 0)
                kept.push_back(p);
            if ((at_p < 0) != (at_q < 0)) {
                const double t = at_p / (at_p - at_q);
                kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
            }
        }
        polygon = kept;
    }
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            inner_edges_.push_back({polygon[i], polygon[k]});
}

bool Quads::has_on_edge(int x, int y) const {
    constexpr double near = 1e-4; // coordinates of Mesa's vertices are floats
    const double cx = x + 0.5, cy = y + 0.5;
    return std::any_of(inner_edges_.begin(), inner_edges_.end(), [&](const Segment& s) {
        const double dx = s.to.x - s.from.x, dy = s.to.y - s.from.y;
        const bool between = (cx - s.from.x) * (cx - s.to.x) <= 0 && (cy - s.from.y) * (cy - s.to.y) <= 0;
        return between && std::fabs(dx * (cy - s.from.y) - dy * (cx - s.from.x)) <= near * std::hypot(dx, dy);
    });
}

Drawn draw_state(const Family& family, int n, void (*resolve)()) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, state_size, 0, state_size, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glViewport(0, 0, state_size, state_size);
    glDisable(GL_DITHER);
    test::Random random{seed_of(n)};
    Drawn drawn;
    family.draw(random, drawn.quads);
    glPopClientAttrib();
    glPopAttrib();
    if (resolve != nullptr)
        resolve();
    constexpr std::size_t pixels = std::size_t{state_size} * state_size;
    std::vector<GLubyte> color(4 * pixels), stencil(pixels);
    std::vector<GLfloat> depth(pixels); // floats, because Mesa's rounding to bytes is not compared
    glReadPixels(0, 0, state_size, state_size, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
    glReadPixels(0, 0, state_size, state_size, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
    glReadPixels(0, 0, state_size, state_size, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
    Planes& planes = drawn.planes;
    for (std::size_t i = 0; i < pixels; ++i) {
        planes.insert(planes.end(), &color[4 * i], &color[4 * i] + 4);
        planes.push_back(stencil[i]);
        planes.push_back(static_cast<GLubyte>(depth[i] * 255 + 0.5f));
    }
    return drawn;
}

} // namespace spangle::oracle
