// Partial coverage of pixels: samples (GL 1.3, 3.2.1), and points with sizes by distance.
#include "tests/oracle/mesa/state_families.hpp"

namespace spangle::oracle {

namespace {

using test::Random;

GLfloat place(Random& random) {
    return static_cast<GLfloat>(random.below(state_size * 256)) / 256;
}
void vertex(Random& random) {
    const GLfloat x = place(random), y = place(random),
                  z = static_cast<GLfloat>(random.below(64)) / 40 - 0.8f;
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
    if (random.below(3) == 0) {
        GLboolean open[4];
        for (GLboolean& m : open)
            m = random.below(3) != 0;
        glColorMask(open[0], open[1], open[2], open[3]);
    }
}

/// Draws triangles; points then show coverage, depth and stencil of every sample.
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
        if (random.below(3) == 0) { // clears a part, or with a mask
            glEnable(GL_SCISSOR_TEST);
            glScissor(3, 5, 15, 13);
            glClearColor(0.8f, 0.2f, 1, 0.6f);
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

/// Draws points at distances from the eye; as sprites, whose sizes Mesa does not round to whole pixels.
void point_parameters(Random& random, Quads&) {
    glEnable(GL_POINT_SPRITE);
    const auto a = static_cast<GLfloat>(1 + random.below(3)), b = static_cast<GLfloat>(random.below(3)) / 64,
               c = static_cast<GLfloat>(random.below(3)) / 512;
    const GLfloat abc[] = {a, b, c};
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, abc);
    glPointParameterf(GL_POINT_SIZE_MIN, static_cast<GLfloat>(random.below(3)));
    glPointParameterf(GL_POINT_SIZE_MAX, static_cast<GLfloat>(3 + random.below(12)));
    figures(random, GL_POINTS, 3);
}

void point_sprites(Random& random, Quads&) {
    glEnable(GL_POINT_SPRITE);
    glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, random.below(2) != 0 ? GL_LOWER_LEFT : GL_UPPER_LEFT);
    GLubyte texels[8 * 8 * 4];
    for (GLubyte& t : texels)
        t = static_cast<GLubyte>(random.below(256));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    figures(random, GL_POINTS, 1);
}

} // namespace

void add_sample_families(std::vector<Family>& all) {
    // Spangle rounds halves of a mean up. There is no scissor box, because Mesa draws samples of pixels below
    // it.
    all.push_back({"multisample", 1000, 1, 0.976, multisample, 4, "llvmpipe"});
    // Corners of a line's rectangle are snapped to 1/256, so a sample sometimes lies in between.
    all.push_back({"multisample_lines", 500, 51, 0.9999, multisample_lines, 4, "llvmpipe"});
    // Mesa's points are squares; the specification's are discs.
    all.push_back({"multisample_points", 500, 204, 0.981, multisample_points, 4, "llvmpipe"});
    // Spangle's sizes are multiples of 1/8. Centres between these and Mesa's floats are in only one of the
    // squares.
    all.push_back({"point_parameters", 300, 204, 0.982, point_parameters, 0, "llvmpipe"});
    // If a coordinate is on the edge of a texel, Mesa's floats take either texel.
    all.push_back({"point_sprites", 300, 255, 0.9997, point_sprites, 0, "llvmpipe"});
}

} // namespace spangle::oracle
