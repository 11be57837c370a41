// Polygons (GL 1.3, 3.5) of either facing: culled, smooth and flat, stippled, offset. Points and lines have
// other tests, because softpipe's squares are a pixel off, and its lines have another end.
#include <algorithm>
#include <vector>

#include "tests/oracle/mesa/random_values.hpp"
#include "tests/oracle/mesa/state_families.hpp"

namespace spangle::oracle {

namespace {

using test::Random;

void color(Random& random) {
    const GLfloat r = unit(random), g = unit(random), b = unit(random), a = unit(random);
    glColor4f(r, g, b, a);
}
void toggle(Random& random, GLenum cap, std::uint32_t of) {
    often(random, of) ? glDisable(cap) : glEnable(cap);
}
void start() {
    glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    glClearDepth(0.8);
    glClearStencil(3);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

/// A vertex between the centres of pixels.
struct Corner {
    GLfloat x, y;
    Corner(int column, int row)
        : x(static_cast<GLfloat>(column) + 35 / 256.0f), y(static_cast<GLfloat>(row) + 56 / 256.0f) {}
};

/// Sets facing and offset. Mesa clamps depths of vertices behind an offset, not those of fragments, so steep
/// polygons get no factor.
void facing(Random& random, int largest_factor) {
    constexpr GLenum faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
    toggle(random, GL_CULL_FACE, 3);
    glCullFace(faces[random.below(8) == 0 ? 2 : random.below(2)]);
    glFrontFace(maybe(random) ? GL_CW : GL_CCW);
    glShadeModel(maybe(random) ? GL_SMOOTH : GL_FLAT);
    GLubyte pattern[128];
    for (GLubyte& byte : pattern)
        byte = static_cast<GLubyte>(random.below(256));
    glPolygonStipple(pattern);
    toggle(random, GL_POLYGON_STIPPLE, 3);
    const auto units = static_cast<GLfloat>(whole(random, -9, 9)),
               factor = static_cast<GLfloat>(whole(random, -largest_factor, largest_factor));
    glPolygonOffset(factor, units * 32768);
    toggle(random, GL_POLYGON_OFFSET_FILL, 2);
}

void polygons(Random& random, Quads& quads) {
    constexpr GLenum modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};
    start();
    for (int i = 0; i < 4; ++i) {
        facing(random, 0);
        toggle(random, GL_DEPTH_TEST, 2);
        glDepthFunc(GL_ALWAYS);
        std::vector<Corner> corners;
        glBegin(one_of(random, modes));
        for (int n = whole(random, 3, 8); n > 0; --n) {
            color(random);
            const int x = whole(random, -6, 30), y = whole(random, -6, 30);
            const Corner at(x, y);
            glVertex3f(at.x, at.y, static_cast<GLfloat>(whole(random, -8, 8)) / 10);
            for (const Corner& other : corners)
                quads.add_edge(static_cast<double>(at.x), static_cast<double>(at.y),
                               static_cast<double>(other.x), static_cast<double>(other.y));
            corners.push_back(at);
        }
        glEnd();
    }
}

/// Draws a convex polygon of a flat colour, because GL does not say how it is cut into triangles.
void convex(Random& random, Quads&) {
    start();
    for (int i = 0; i < 6; ++i) {
        facing(random, 8);
        toggle(random, GL_DEPTH_TEST, 2);
        glDepthFunc(GL_ALWAYS);
        // These are slopes of depth, in 512ths a pixel.
        const int across = whole(random, -3, 3), up = whole(random, -3, 3);
        glShadeModel(GL_FLAT);
        color(random);
        const int x = whole(random, 0, 12), y = whole(random, 0, 12), w = whole(random, 3, 11),
                  h = whole(random, 3, 11), cut = whole(random, 1, std::min(w, h) - 1);
        const int corner[5][2] = {{x, y}, {x + w, y}, {x + w, y + h}, {x + cut, y + h}, {x, y + cut}};
        const bool turned = maybe(random), polygon = maybe(random);
        glBegin(polygon ? GL_POLYGON : GL_QUADS);
        for (int n = 0; n < (polygon ? 5 : 4); ++n) {
            const auto& at = corner[turned ? (polygon ? 4 : 3) - n : n];
            const Corner place(at[0], at[1]);
            glVertex3f(place.x, place.y, static_cast<GLfloat>(across * at[0] + up * at[1]) / 256);
        }
        glEnd();
    }
}

} // namespace

void add_primitive_families(std::vector<Family>& all) {
    all.push_back({"Polygons", 2000, 1, 0.9, polygons});
    all.push_back({"ConvexPolygons", 2000, 1, 0.9, convex});
}

} // namespace spangle::oracle
