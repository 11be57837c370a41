// Row C05: compares generated texture coordinates with formulas in double.
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/lighting_equation.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

constexpr GLenum coords[4] = {GL_S, GL_T, GL_R, GL_Q},
                 switches[4] = {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q};

class TexGen : public Canvas {
  protected:
    std::mt19937 random_{17};
    double number(double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<>(low, high)(random_));
    }
    Vec4 vec4(double size) {
        return {number(-size, size), number(-size, size), number(-size, size), number(-size, size)};
    }
    Mat4 some_matrix() {
        Mat4 m = identity();
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t i = 0; i < 3; ++i)
                m[4 * j + i] = number(-1, 1) + (i == j ? 2 : 0);
        return m;
    }
    static double dot4(const Vec4& a, const Vec4& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    }
    /// Draws one vertex and returns its s, t and q; r does not reach the rasterizer.
    static std::array<double, 3> drawn(const Vec4& position, std::size_t unit = 0) {
        WindowRecorder recorder;
        glBegin(GL_POINTS);
        glVertex4dv(position.data());
        glEnd();
        EXPECT_EQ(recorder.primitives.size(), 1u);
        if (recorder.primitives.empty())
            return {};
        const auto& t = recorder.primitives[0].corner[0].tex[unit];
        return {std::ldexp(t.s, t.exponent), std::ldexp(t.t, t.exponent),
                t.q_is_one != 0 ? 1 : std::ldexp(t.q, t.exponent)};
    }
};

/// Modelview matrices are random, planes are given under another one, and coordinates are on and off at
/// random. The texture matrix makes r visible.
TEST_F(TexGen, EveryModeAgainstDouble) {
    glEnable(GL_TEXTURE_2D);
    glMatrixMode(GL_PROJECTION);
    glScalef(1e-3f, 1e-3f, 1e-3f); // everything is in the view volume
    double worst = 0;
    for (int round = 0; round < 4000; ++round) {
        LitVertex v; // gives the normal in eye space
        v.modelview = some_matrix();
        v.normalize = round % 3 == 0;
        v.rescale = round % 3 == 1;
        v.normal = {number(-1, 1), number(-1, 1), number(-1, 1)};
        v.position = {number(-4, 4), number(-4, 4), number(-4, 4), round % 5 == 0 ? 2.0 : 1.0};
        (v.normalize ? glEnable : glDisable)(GL_NORMALIZE);
        (v.rescale ? glEnable : glDisable)(GL_RESCALE_NORMAL);
        const Mat4 before = some_matrix(), texture = some_matrix();
        Vec4 object[4], eye_plane[4];
        const Vec4 current = vec4(3);
        GLenum mode[4] = {};
        for (std::size_t c = 0; c < 4; ++c) {
            object[c] = vec4(2), eye_plane[c] = vec4(2);
            constexpr GLenum modes[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_NORMAL_MAP, GL_REFLECTION_MAP,
                                        GL_SPHERE_MAP};
            mode[c] = modes[random_() % (c < 2 ? 5 : c == 2 ? 4 : 2)];
            glMatrixMode(GL_MODELVIEW);
            glLoadMatrixd(before.data());
            glTexGendv(coords[c], GL_EYE_PLANE, eye_plane[c].data());
            glTexGendv(coords[c], GL_OBJECT_PLANE, object[c].data());
            glTexGeni(coords[c], GL_TEXTURE_GEN_MODE, static_cast<GLint>(mode[c]));
            if (random_() % 4 == 0)
                mode[c] = GL_NONE;
            (mode[c] != GL_NONE ? glEnable : glDisable)(switches[c]);
        }
        glLoadMatrixd(v.modelview.data());
        glTexCoord4dv(current.data());
        glNormal3dv(v.normal.data());
        // A plane is p' = p M^-1, so for each column of M: p' (M e) = p e.
        const Vec4 eye4 = times(v.modelview, v.position);
        const Vec3 n = eye_normal(v);
        const double sign = eye4[3] < 0 ? -1 : 1;
        const Vec3 u = unit({eye4[0] * sign, eye4[1] * sign, eye4[2] * sign});
        const Vec3 r = sum(u, scaled(n, -2 * dot(n, u)));
        const double m = 2 * std::sqrt(r[0] * r[0] + r[1] * r[1] + (r[2] + 1) * (r[2] + 1));
        if (m < 0.01)
            continue;
        Vec4 strq{};
        double size = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            GLfloat kept[4];
            glGetTexGenfv(coords[c], GL_EYE_PLANE, kept);
            const Vec4 eye_kept{double(kept[0]), double(kept[1]), double(kept[2]), double(kept[3])};
            for (std::size_t k = 0; k < 4; ++k) {
                Vec4 e{};
                e[k] = 1;
                EXPECT_NEAR(dot4(eye_kept, times(before, e)), eye_plane[c][k], 1e-4);
            }
            const double value = mode[c] == GL_OBJECT_LINEAR    ? dot4(object[c], v.position)
                                 : mode[c] == GL_EYE_LINEAR     ? dot4(eye_kept, eye4)
                                 : mode[c] == GL_NORMAL_MAP     ? n[c]
                                 : mode[c] == GL_REFLECTION_MAP ? r[c]
                                 : mode[c] == GL_SPHERE_MAP     ? r[c] / m + 0.5
                                                                : current[c];
            strq[c] = value;
            size = std::fmax(size, std::fabs(value));
        }
        glMatrixMode(GL_TEXTURE);
        round % 2 == 0 ? glLoadIdentity() : glLoadMatrixd(texture.data());
        const Vec4 expected = round % 2 == 0 ? strq : times(texture, strq);
        const std::array<double, 3> got = drawn(v.position);
        // Components share an exponent, so errors are relative to the largest. Terms of planes are up to 40,
        // terms of reflections 2 n (n . u).
        const double scale = std::fmax(size, 40 + 8 * dot(n, n)) * (round % 2 == 0 ? 1 : 8);
        const double errors[3] = {got[0] - expected[0], got[1] - expected[1], got[2] - expected[3]};
        for (const double e : errors) {
            ASSERT_LE(std::fabs(e), 1e-7 * scale) << "round " << round;
            worst = std::fmax(worst, std::fabs(e) / scale);
        }
    }
    std::printf("generated coordinates: worst error 2^%.1f of their terms\n", std::log2(worst));
}

/// Coordinates refuse modes that they cannot generate, and names that do not exist (GL 1.3, 2.10.4).
TEST_F(TexGen, Errors) {
    const auto code = [](GLenum coord, GLenum mode) {
        glTexGeni(coord, GL_TEXTURE_GEN_MODE, static_cast<GLint>(mode));
        return glGetError();
    };
    for (std::size_t c = 0; c < 4; ++c) {
        const GLenum none = GL_NO_ERROR, wrong = GL_INVALID_ENUM;
        EXPECT_EQ(code(coords[c], GL_OBJECT_LINEAR), none);
        EXPECT_EQ(code(coords[c], GL_SPHERE_MAP), c < 2 ? none : wrong);
        EXPECT_EQ(code(coords[c], GL_REFLECTION_MAP), c < 3 ? none : wrong);
        EXPECT_EQ(code(coords[c], GL_NORMAL_MAP), c < 3 ? none : wrong);
        GLint mode = 0;
        glGetTexGeniv(coords[c], GL_TEXTURE_GEN_MODE, &mode);
        EXPECT_EQ(mode, c < 3 ? GL_NORMAL_MAP : GL_OBJECT_LINEAR) << "refused calls change nothing";
        EXPECT_EQ(code(coords[c], GL_LINEAR), wrong);
    }
    EXPECT_EQ(code(GL_Q + 1, GL_EYE_LINEAR), static_cast<GLenum>(GL_INVALID_ENUM));
    glTexGenf(GL_S, GL_EYE_PLANE, 1);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM)) << "planes have four coefficients";
}

TEST_F(TexGen, FormsAndInitialState) {
    for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
        glActiveTexture(unit);
        for (std::size_t c = 0; c < 4; ++c)
            for (const GLenum plane : {GL_OBJECT_PLANE, GL_EYE_PLANE}) {
                GLdouble d[4] = {9, 9, 9, 9};
                glGetTexGendv(coords[c], plane, d);
                for (std::size_t k = 0; k < 4; ++k)
                    EXPECT_EQ(d[k], k == c && c < 2 ? 1 : 0);
                GLint mode = 0;
                glGetTexGeniv(coords[c], GL_TEXTURE_GEN_MODE, &mode);
                EXPECT_EQ(mode, GL_EYE_LINEAR);
            }
    }
    const GLdouble d[4] = {1.5, -2, 3, 0.25};
    const GLfloat f[4] = {1, -2.5, 3, 0.75};
    const GLint i[4] = {1, -2, 70000, 4};
    const GLfixed x[4] = {0x8000, -0x20000, 0, 0x10000};
    const auto is = [](std::array<double, 4> expected) {
        std::array<double, 4> got{};
        glGetTexGendv(GL_R, GL_OBJECT_PLANE, got.data());
        EXPECT_EQ(got, expected);
    };
    glTexGendv(GL_R, GL_OBJECT_PLANE, d), is({1.5, -2, 3, 0.25});
    glTexGenfv(GL_R, GL_OBJECT_PLANE, f), is({1, -2.5, 3, 0.75});
    glTexGeniv(GL_R, GL_OBJECT_PLANE, i), is({1, -2, 70000, 4});
    glTexGenxvOES(GL_R, GL_OBJECT_PLANE, x), is({0.5, -2, 0, 1});
    glTexGend(GL_R, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
    GLint mode = 0;
    glGetTexGeniv(GL_R, GL_TEXTURE_GEN_MODE, &mode);
    EXPECT_EQ(mode, GL_REFLECTION_MAP);
}

/// Each unit generates its own coordinates. Arrays with cached vertices, and lists, give what immediate mode
/// gives.
TEST_F(TexGen, UnitsArraysAndLists) {
    for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
        glActiveTexture(unit);
        glEnable(GL_TEXTURE_2D);
        glEnable(GL_TEXTURE_GEN_S);
        glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, unit == GL_TEXTURE0 ? GL_NORMAL_MAP : GL_OBJECT_LINEAR);
    }
    const GLfloat plane[4] = {0, 0, 4, 1};
    glTexGenfv(GL_S, GL_OBJECT_PLANE, plane);
    std::vector<GLfloat> position, normal;
    std::vector<GLubyte> index;
    for (int i = 0; i < 24; ++i) {
        for (int c = 0; c < 3; ++c) {
            position.push_back(static_cast<GLfloat>(number(-0.9, 0.9)));
            normal.push_back(static_cast<GLfloat>(number(-1, 1)));
        }
        index.push_back(static_cast<GLubyte>(random_() % 24));
    }
    const auto drawn_s = [](auto draw) {
        WindowRecorder recorder;
        draw();
        std::vector<double> all;
        for (const Primitive& p : recorder.primitives)
            for (const raster::FixedVertex& v : p.corner)
                for (const auto& t : v.tex)
                    all.insert(all.end(), {std::ldexp(t.s, t.exponent), std::ldexp(t.t, t.exponent)});
        return all;
    };
    glMultiTexCoord2f(GL_TEXTURE1, 0.5f, 0.125f);
    const auto immediate = drawn_s([&] {
        glBegin(GL_TRIANGLES);
        for (const GLubyte i : index) {
            glNormal3fv(&normal[3u * i]);
            glVertex3fv(&position[3u * i]);
        }
        glEnd();
    });
    ASSERT_GE(immediate.size(), 6u * 3 * 4); // two triangles with a common vertex have no area
    EXPECT_NEAR(immediate[0], double(normal[3u * index[0]]), 1e-6);
    EXPECT_NEAR(immediate[2], 1 + 4 * double(position[3u * index[0] + 2]), 1e-6);
    EXPECT_EQ(immediate[3], 0.125) << "t of unit 1 is current";
    glVertexPointer(3, GL_FLOAT, 0, position.data());
    glNormalPointer(GL_FLOAT, 0, normal.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    const auto draw = [&] { glDrawElements(GL_TRIANGLES, 24, GL_UNSIGNED_BYTE, index.data()); };
    EXPECT_EQ(drawn_s(draw), immediate);
    glNewList(1, GL_COMPILE);
    draw();
    glEndList();
    EXPECT_EQ(drawn_s([] { glCallList(1); }), immediate);
}

/// A vertex at the eye, a normal of zero, or a singular matrix gives some number and does no harm.
TEST_F(TexGen, DegenerateVertices) {
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_NORMALIZE);
    for (std::size_t c = 0; c < 2; ++c) {
        glEnable(switches[c]);
        glTexGeni(coords[c], GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    }
    glNormal3f(0, 0, 0);
    drawn({0, 0, 0, 1});
    glNormal3f(0, 0, 1);
    EXPECT_EQ(drawn({0, 0, -0.5, 1})[0], 0.5) << "r = (0, 0, 1)";
    const Mat4 flat = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    glLoadMatrixd(flat.data());
    drawn({0.5, 0.5, 0.5, 1});
}

} // namespace
} // namespace spangle::test
