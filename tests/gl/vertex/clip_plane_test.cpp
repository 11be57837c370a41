// Row C14: compares user clip planes with formulas in double. Complementary planes share every pixel.
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/lighting_equation.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

class ClipPlanes : public Canvas {
  protected:
    std::mt19937 random_{11};

    double number(double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<>(low, high)(random_));
    }
    Mat4 some_matrix() {
        Mat4 m = identity();
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t i = 0; i < 3; ++i)
                m[4 * j + i] = number(-2, 2) + (i == j ? 3 : 0);
        return m;
    }
    static void set_plane(GLenum plane, const Vec4& p) { glClipPlane(plane, p.data()); }
    static Vec4 kept(GLenum plane) {
        Vec4 p{};
        glGetClipPlane(plane, p.data());
        return p;
    }
    static double dot4(const Vec4& a, const Vec4& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    }
    static Vec4 negated(const Vec4& p) { return {-p[0], -p[1], -p[2], -p[3]}; }
};

/// A plane becomes p' = p M^-1 when it is set, so that p' . (M v) = p . v for every vertex (GL 1.3, 2.11).
TEST_F(ClipPlanes, PlanesAreKeptInEyeSpace) {
    for (GLenum i = 0; i < 6; ++i) {
        EXPECT_EQ(kept(GL_CLIP_PLANE0 + i), (Vec4{0, 0, 0, 0}));
        for (int round = 0; round < 200; ++round) {
            const Mat4 m = some_matrix();
            const Vec4 p{number(-3, 3), number(-3, 3), number(-3, 3), number(-3, 3)};
            glLoadMatrixd(m.data());
            const GLfloat f[4] = {static_cast<GLfloat>(p[0]), static_cast<GLfloat>(p[1]),
                                  static_cast<GLfloat>(p[2]), static_cast<GLfloat>(p[3])};
            round % 2 == 0 ? set_plane(GL_CLIP_PLANE0 + i, p) : glClipPlanefOES(GL_CLIP_PLANE0 + i, f);
            const Vec4 eye = kept(GL_CLIP_PLANE0 + i);
            for (std::size_t k = 0; k < 4; ++k) {
                Vec4 v{};
                v[k] = 1;
                const Vec4 e = times(m, v);
                double size = 0; // size of the terms, because the query returns floats
                for (std::size_t c = 0; c < 4; ++c)
                    size += std::fabs(eye[c] * e[c]);
                EXPECT_NEAR(dot4(eye, e), p[k], std::ldexp(size, -23));
            }
            glLoadIdentity(); // later matrices do not matter
            EXPECT_EQ(kept(GL_CLIP_PLANE0 + i), eye);
        }
    }
    const GLfixed x[4] = {0x8000, -0x10000, 0x20000, 0x4000};
    glClipPlanexOES(GL_CLIP_PLANE2, x);
    EXPECT_EQ(kept(GL_CLIP_PLANE2), (Vec4{0.5, -1, 2, 0.25}));
    const Vec4 before = kept(GL_CLIP_PLANE5);
    set_plane(GL_CLIP_PLANE0 + 6, {1, 2, 3, 4});
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(kept(GL_CLIP_PLANE5), before);
    const Mat4 singular{};
    glLoadMatrixd(singular.data());
    set_plane(GL_CLIP_PLANE0, {1, 2, 3, 4}); // the result is undefined, but must do no harm
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

/// A vertex is drawn if it is on the inner side of all enabled planes, or on a plane.
TEST_F(ClipPlanes, Points) {
    glScalef(0.5f, 0.5f, 0.5f);
    Vec4 plane[6];
    for (int round = 0; round < 500; ++round) {
        unsigned on = 0;
        for (GLenum i = 0; i < 6; ++i) {
            plane[i] = {number(-1, 1), number(-1, 1), number(-1, 1), number(0, 1)};
            set_plane(GL_CLIP_PLANE0 + i, plane[i]);
            on |= random_() % 2 << i;
            ((on >> i & 1) != 0 ? glEnable : glDisable)(GL_CLIP_PLANE0 + i);
        }
        const Vec4 v{number(-1, 1), number(-1, 1), number(-1, 1), 1};
        bool in = true, close = false;
        for (unsigned i = 0; i < 6; ++i)
            if ((on >> i & 1) != 0) {
                in = in && dot4(plane[i], v) >= 0;
                close = close || std::fabs(dot4(plane[i], v)) < 1e-5;
            }
        if (close)
            continue;
        WindowRecorder recorder;
        glBegin(GL_POINTS);
        glVertex4dv(v.data());
        glEnd();
        EXPECT_EQ(recorder.primitives.size(), in ? 1u : 0u) << round;
    }
    for (GLenum i = 1; i < 6; ++i)
        glDisable(GL_CLIP_PLANE0 + i);
    glEnable(GL_CLIP_PLANE0);
    for (const double side : {1.0, -1.0}) {
        set_plane(GL_CLIP_PLANE0, {side, 0, 0, 0});
        WindowRecorder recorder;
        glBegin(GL_POINTS);
        glVertex2f(0, 0.5f); // a point in the plane is on both sides
        glEnd();
        EXPECT_EQ(recorder.primitives.size(), 1u);
    }
}

/// Vertices that a plane makes lie on the plane, with the colour, texture coordinates and fog distance of
/// that place.
TEST_F(ClipPlanes, CornersOnThePlane) {
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 50);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_FOG);
    glEnable(GL_CLIP_PLANE3);
    int cut = 0;
    double worst = 0;
    for (int round = 0; round < 3000; ++round) {
        const Vec4 p{number(-1, 1), number(-1, 1), number(-0.2, 0.2), number(-1, 1)};
        set_plane(GL_CLIP_PLANE3, p);
        const GLenum mode = round % 2 == 0 ? GL_TRIANGLES : GL_LINES;
        Vec3 corner[3];
        WindowRecorder recorder;
        glBegin(mode);
        for (int i = 0; i < (mode == GL_LINES ? 2 : 3); ++i) {
            const double z = number(-10, -2);
            corner[i] = {number(z, -z), number(z, -z), z};
            // The colour is linear in space.
            glColor3d(0.5 + corner[i][0] / 20, 0.5 + corner[i][1] / 20, -z / 10);
            glTexCoord2d(corner[i][0], corner[i][1] - z);
            glVertex3dv(corner[i].data());
        }
        glEnd();
        for (const Primitive& primitive : recorder.primitives)
            for (int c = 0; c < primitive.corners; ++c) {
                const raster::FixedVertex& v = primitive.corner[c];
                const double w = 1 / std::ldexp(static_cast<double>(v.w_mantissa), v.w_exponent);
                const double x = (v.x / 256.0 / 32 - 1) * w, y = (v.y / 256.0 / 32 - 1) * w, z = -w;
                const double distance = dot4(p, {x, y, z, 1});
                // A step of the window is 1/8192 of w.
                EXPECT_GE(distance, -4e-4 * w) << "drawn beyond the plane";
                bool given = false;
                for (const Vec3& at : corner)
                    given = given || std::fabs(at[2] - z) < 1e-6;
                if (given)
                    continue;
                ++cut;
                EXPECT_LE(std::fabs(distance), 4e-4 * w);
                const auto& t = v.tex[0];
                const double q = t.q_is_one != 0 ? 1 : std::ldexp(t.q, t.exponent);
                const double errors[] = {v.color[0] / double(raster::color_one) - (0.5 + x / 20),
                                         v.color[1] / double(raster::color_one) - (0.5 + y / 20),
                                         v.color[2] / double(raster::color_one) + z / 10,
                                         std::ldexp(t.s, t.exponent) / q - x,
                                         std::ldexp(t.t, t.exponent) / q - (y - z),
                                         std::ldexp(double(v.fog_mantissa), v.fog_exponent) + z};
                for (const double e : errors) {
                    EXPECT_LE(std::fabs(e), 4e-4 * w) << "snapping and no more";
                    worst = std::fmax(worst, std::fabs(e) / w);
                }
            }
    }
    EXPECT_GT(cut, 1500);
    std::printf("%d corners on planes, worst error %.2g of w\n", cut, worst);
}

/// The same mesh over the whole window is drawn once on either side of a plane, so every pixel is drawn once.
TEST_F(ClipPlanes, ComplementsShareEveryPixel) {
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 50);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDisable(GL_DITHER);
    glEnable(GL_CLIP_PLANE1);
    glColor3ub(1, 0, 0);
    std::vector<GLubyte> pixels(size * size * 4);
    int crossed = 0;
    for (int round = 0; round < 400; ++round) {
        constexpr int cells = 5;
        Vec3 mesh[cells + 1][cells + 1];
        for (int i = 0; i <= cells; ++i)
            for (int j = 0; j <= cells; ++j) {
                const bool edge = i == 0 || j == 0 || i == cells || j == cells;
                const double z = edge ? -4 : number(-5, -3), bend = edge ? 0 : number(-0.1, 0.1);
                mesh[i][j] = {(i * 2.4 / cells - 1.2 + bend) * -z, (j * 2.4 / cells - 1.2 - bend) * -z, z};
            }
        Vec4 p{number(-1, 1), number(-1, 1), number(-1, 1), 0};
        // The plane goes through a vertex of the mesh, every third time through two.
        const Vec3& a = mesh[2][2];
        if (round % 3 == 0) {
            const Vec3 &b = mesh[3][3], d{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
            p = {d[1] * p[2] - d[2] * p[1], d[2] * p[0] - d[0] * p[2], d[0] * p[1] - d[1] * p[0], 0};
        }
        p[3] = -(p[0] * a[0] + p[1] * a[1] + p[2] * a[2]) + (round % 3 == 1 ? number(-1, 1) : 0);
        glClear(GL_COLOR_BUFFER_BIT);
        for (const bool complement : {false, true}) {
            set_plane(GL_CLIP_PLANE1, complement ? negated(p) : p);
            for (int i = 0; i < cells; ++i) {
                glBegin(GL_TRIANGLE_STRIP); // a strip of triangles, because a bent quad has no single shape
                for (int j = 0; j <= cells; ++j) {
                    glVertex3dv(mesh[i + 1][j].data());
                    glVertex3dv(mesh[i][j].data());
                }
                glEnd();
            }
            if (!complement) {
                glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
                int drawn = 0;
                for (std::size_t k = 0; k < pixels.size(); k += 4)
                    drawn += pixels[k];
                crossed += drawn > 0 && drawn < size * size ? 1 : 0;
            }
        }
        glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        for (int k = 0; k < size * size; ++k)
            ASSERT_EQ(pixels[static_cast<std::size_t>(4 * k)], 1)
                << "round " << round << ", pixel " << k % size << ' ' << k / size;
    }
    EXPECT_GT(crossed, 200);
}

/// Complementary planes make the same vertex of an edge, to the last bit.
TEST_F(ClipPlanes, ComplementsMakeTheSameCorners) {
    glEnable(GL_CLIP_PLANE1);
    glEnable(GL_FOG);
    using Corner = std::array<std::int64_t, 7>;
    int cut = 0, turned = 0;
    for (int round = 0; round < 20000; ++round) {
        Vec3 corner[3];
        for (Vec3& v : corner)
            v = {number(-0.9, 0.9), number(-0.9, 0.9), number(-0.9, 0.9)};
        Vec4 p{number(-1, 1), number(-1, 1), number(-1, 1), 0};
        // Small numbers give slivers.
        const double near = round % 2 == 0 ? number(-0.5, 0.5) : number(-0.01, 0.01);
        p[3] = near - dot({p[0], p[1], p[2]}, corner[round % 3]);
        std::vector<Corner> made[2];
        int ways[2] = {}; // numbers of triangles of either orientation
        for (const int side : {0, 1}) {
            set_plane(GL_CLIP_PLANE1, side == 0 ? p : negated(p));
            WindowRecorder recorder;
            glBegin(GL_TRIANGLES);
            for (int i = 0; i < 3; ++i) {
                glColor3d(i == 0, i == 1, i == 2);
                glVertex3dv(corner[i].data());
            }
            glEnd();
            for (const Primitive& t : recorder.primitives) {
                const std::int64_t ux = t.corner[1].x - t.corner[0].x, uy = t.corner[1].y - t.corner[0].y,
                                   vx = t.corner[2].x - t.corner[0].x, vy = t.corner[2].y - t.corner[0].y;
                ++ways[ux * vy > uy * vx ? 1 : 0];
                for (const raster::FixedVertex& v : t.corner)
                    if (v.color[0] % raster::color_one != 0 || v.color[1] % raster::color_one != 0)
                        made[side].push_back(
                            {v.x, v.y, v.z, v.color[0], v.color[1], v.color[2], v.fog_mantissa});
            }
        }
        turned += ways[0] != 0 && ways[1] != 0 ? 1 : 0;
        for (const Corner& a : made[0])
            for (const Corner& b : made[1]) // not all vertices: triangles without an area are not drawn
                if (a[0] == b[0] && a[1] == b[1]) {
                    ++cut;
                    ASSERT_EQ(a, b) << "round " << round;
                }
    }
    EXPECT_GT(cut, 10000);
    EXPECT_EQ(turned, 0) << "slivers that overlap what lies beside them";
}

/// Six planes at once surround a cube that is seen from a corner. What is left is what double leaves.
TEST_F(ClipPlanes, SixPlanesLeaveAHexagon) {
    constexpr double third = 1.0471975511965976;
    for (GLenum i = 0; i < 6; ++i) {
        set_plane(GL_CLIP_PLANE0 + i, {std::cos(third * i), std::sin(third * i), 0, 0.5});
        glEnable(GL_CLIP_PLANE0 + i);
    }
    glClear(GL_COLOR_BUFFER_BIT);
    glRectf(-2, -2, 2, 2); // the guard band clips this first
    std::vector<GLubyte> pixels(size * size * 4);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double u = (x + 0.5) / 32 - 1, v = (y + 0.5) / 32 - 1;
            double least = 1;
            for (int i = 0; i < 6; ++i)
                least = std::fmin(least, std::cos(third * i) * u + std::sin(third * i) * v + 0.5);
            if (std::fabs(least) > 1e-3) {
                EXPECT_EQ(pixels[static_cast<std::size_t>(4 * (y * size + x))], least > 0 ? 255 : 0)
                    << x << ' ' << y;
            }
        }
}

/// Arrays with cached vertices and lists are clipped as immediate mode is. Both sides keep their lighting.
TEST_F(ClipPlanes, EveryWayOfGivingVertices) {
    std::vector<GLfloat> position;
    std::vector<GLushort> index;
    for (int i = 0; i < 40; ++i) {
        for (int c = 0; c < 3; ++c)
            position.push_back(static_cast<GLfloat>(number(-1.2, 1.2)));
        index.push_back(static_cast<GLushort>(random_() % 40));
    }
    set_plane(GL_CLIP_PLANE4, {0.6, -0.8, 0.3, 0.1});
    glEnable(GL_CLIP_PLANE4);
    glVertexPointer(3, GL_FLOAT, 0, position.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
        const auto drawn = [](auto draw) {
            WindowRecorder recorder;
            draw();
            std::vector<std::int32_t> all;
            for (const Primitive& p : recorder.primitives)
                for (int c = 0; c < p.corners; ++c)
                    all.insert(all.end(),
                               {p.corner[c].x, p.corner[c].y, static_cast<std::int32_t>(p.corner[c].z)});
            return all;
        };
        const auto immediate = drawn([&] {
            glBegin(mode);
            for (const GLushort i : index)
                glVertex3fv(&position[3 * i]);
            glEnd();
        });
        EXPECT_FALSE(immediate.empty()) << mode;
        EXPECT_EQ(drawn([&] { glDrawElements(mode, 40, GL_UNSIGNED_SHORT, index.data()); }), immediate)
            << mode;
        glNewList(1, GL_COMPILE);
        glDrawElements(mode, 40, GL_UNSIGNED_SHORT, index.data());
        glEndList();
        EXPECT_EQ(drawn([] { glCallList(1); }), immediate) << mode;
    }
}

} // namespace
} // namespace spangle::test
