// What covers a pixel in part: samples of it (GL 1.3, 3.2.1), and antialiasing (3.3, 3.4.2, 3.5.3).
#include "tests/oracle/state_families.hpp"

namespace spangle::oracle {

namespace {

using test::Random;

GLfloat place(Random& random) {
    return static_cast<GLfloat>(random.below(state_size * 256)) / 256;
}
void vertex(Random& random) {
    const GLfloat x = place(random), y = place(random), z = static_cast<GLfloat>(random.below(64)) / 40 - 0.8f;
    glVertex3f(x, y, z);
}
void color(Random& random) {
    GLubyte c[4];
    for (GLubyte& v : c)
        v = static_cast<GLubyte>(random.below(256));
    glColor4ubv(c);
}

void clear() {
    glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    glClearStencil(3);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void random_tests(Random& random) {
    constexpr GLenum ops[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT};
    if (random.below(2) != 0) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS + random.below(7));
        glDepthMask(random.below(3) != 0);
    }
    if (random.below(2) != 0) {
        glEnable(GL_STENCIL_TEST);
        const GLenum func = GL_LESS + random.below(7);
        glStencilFunc(func, static_cast<GLint>(random.below(8)), 7);
        const GLenum fail = ops[random.below(6)], zfail = ops[random.below(6)], zpass = ops[random.below(6)];
        glStencilOp(fail, zfail, zpass);
    }
    if (random.below(4) == 0) {
        glEnable(GL_COLOR_LOGIC_OP);
        glLogicOp(GL_CLEAR + random.below(16));
    }
    if (random.below(3) == 0) {
        GLboolean open[4];
        for (GLboolean& m : open)
            m = random.below(3) != 0;
        glColorMask(open[0], open[1], open[2], open[3]);
    }
    if (random.below(3) == 0) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(3, 5, 15, 13);
    }
}

/// Triangles, point by point: coverage, depth and stencil of every sample.
void multisample(Random& random, Quads&) {
    clear();
    for (int i = 0; i < 4; ++i) {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        random_tests(random);
        glBegin(GL_TRIANGLES);
        for (int k = 0; k < 3; ++k) {
            color(random);
            for (int v = 0; v < 3; ++v)
                vertex(random);
        }
        glEnd();
        if (random.below(3) == 0) { // of a part, or masked
            glClearColor(0.9f, 0.1f, 0.3f, 0.5f);
            glClear(GL_COLOR_BUFFER_BIT);
        }
        glPopAttrib();
    }
}

void figures(Random& random, GLenum mode, int corners) {
    clear();
    glPointSize(static_cast<GLfloat>(8 + random.below(57)) / 8);
    glLineWidth(static_cast<GLfloat>(8 + random.below(33)) / 8);
    glColor4f(1, 1, 1, 1);
    glBegin(mode);
    for (int i = 0; i < corners; ++i)
        vertex(random);
    glEnd();
}

void multisample_lines(Random& random, Quads&) {
    figures(random, GL_LINES, 2);
}
void multisample_points(Random& random, Quads&) {
    figures(random, GL_POINTS, 1);
}

/// Alpha is what is covered.
void smooth_points(Random& random, Quads&) {
    glEnable(GL_POINT_SMOOTH);
    figures(random, GL_POINTS, 1);
}
void smooth_lines(Random& random, Quads&) {
    glEnable(GL_LINE_SMOOTH);
    figures(random, GL_LINES, 2);
}
void smooth_polygons(Random& random, Quads&) {
    glEnable(GL_POLYGON_SMOOTH);
    figures(random, GL_TRIANGLES, 3);
}

} // namespace

void add_sample_families(std::vector<Family>& all) {
    all.push_back({"multisample", 1000, 0, 1, multisample, 4});
    all.push_back({"multisample_lines", 500, 0, 1, multisample_lines, 4});
    all.push_back({"multisample_points", 500, 0, 1, multisample_points, 4});
    all.push_back({"smooth_points", 300, 0, 1, smooth_points});
    all.push_back({"smooth_lines", 300, 0, 1, smooth_lines});
    all.push_back({"smooth_polygons", 300, 0, 1, smooth_polygons});
}

} // namespace spangle::oracle
