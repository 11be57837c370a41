// Row C14: tests as which two triangles a quad is drawn, and that a clipped quad is drawn as the same two
// triangles.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/gl/vertex/canvas.hpp"

namespace spangle::test {
namespace {

class CutQuads : public Canvas {
  protected:
    struct Corner {
        std::array<GLfloat, 3> position;
        std::array<GLubyte, 4> color;
    };
    using Quad = std::array<Corner, 4>;
    using Pixels = std::vector<GLubyte>;

    std::mt19937 random_{23};

    float number(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }

    /// Returns a convex quad in a random plane; `size` is half its diagonal.
    Quad some_quad(float size) {
        const float tilt = number(0.2f, 1.4f), turn = number(0, 6.2f), depth = number(-3, -0.5f);
        const float x = number(-1, 1), y = number(-1, 1);
        Quad quad{};
        for (std::size_t i = 0; i < quad.size(); ++i) {
            const float angle = turn + 1.5707963f * static_cast<float>(i);
            const float u = size * std::cos(angle), v = size * std::sin(angle);
            quad[i].position = {x + u, y + v * std::cos(tilt), depth + v * std::sin(tilt)};
            for (GLubyte& part : quad[i].color)
                part = static_cast<GLubyte>(random_());
        }
        return quad;
    }

    static void corner(const Corner& at) {
        glColor4ubv(at.color.data());
        glVertex3fv(at.position.data());
    }

    static Pixels drawn(GLenum mode, const std::vector<Corner>& corners) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glBegin(mode);
        for (const Corner& at : corners)
            corner(at);
        glEnd();
        Pixels pixels(std::size_t{size} * size * 4);
        glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }

    static bool is_empty(const Pixels& pixels) {
        for (std::size_t i = 0; i < pixels.size(); i += 4)
            if ((pixels[i] | pixels[i + 1] | pixels[i + 2]) != 0)
                return false;
        return true;
    }

    /// Draws many quads as QUADS and as QUAD_STRIP, and the triangles that they stand for. The diagonal ends
    /// at the provoking vertex: in QUADS the quad's last vertex, in a strip the last vertex so far, which is
    /// the third of the outline.
    void all_are_triangles(int rounds, float quad_size) {
        int seen = 0, divided_otherwise = 0;
        for (int round = 0; round < rounds; ++round) {
            const Quad q = some_quad(quad_size);
            const Pixels quad = drawn(GL_TRIANGLES, {q[1], q[2], q[3], q[1], q[3], q[0]});
            const Pixels strip = drawn(GL_TRIANGLES, {q[0], q[1], q[2], q[0], q[2], q[3]});
            ASSERT_EQ(drawn(GL_QUADS, {q[0], q[1], q[2], q[3]}), quad) << "round " << round;
            ASSERT_EQ(drawn(GL_QUAD_STRIP, {q[0], q[1], q[3], q[2]}), strip) << "round " << round;
            seen += is_empty(quad) ? 0 : 1;
            divided_otherwise += quad != strip ? 1 : 0;
        }
        EXPECT_GT(seen, rounds / 4);
        EXPECT_GT(divided_otherwise, rounds / 4);
    }

    static void look(double far) {
        glEnable(GL_DEPTH_TEST);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glFrustum(-0.5, 0.5, -0.5, 0.5, 0.5, far);
        glMatrixMode(GL_MODELVIEW);
    }
};

TEST_F(CutQuads, ByNothing) {
    look(100);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -8);
    all_are_triangles(200, 2);
}

TEST_F(CutQuads, ByTheViewVolume) {
    look(20);
    all_are_triangles(400, 3);
}

TEST_F(CutQuads, ByTheFarPlane) {
    look(2);
    all_are_triangles(200, 2);
}

TEST_F(CutQuads, ByTheGuardBand) {
    look(1000);
    all_are_triangles(200, 400);
}

TEST_F(CutQuads, ByAPlaneOfTheUser) {
    look(20);
    const GLdouble plane[] = {0.3, 1, 0.2, 0.1};
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    all_are_triangles(300, 1);
}

TEST_F(CutQuads, WithTwoSides) {
    look(20);
    const GLfloat back[] = {0.9f, 0.3f, 0.1f, 1}, light[] = {1, 2, 3, 0};
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    all_are_triangles(200, 3);
}

TEST_F(CutQuads, WithAnOffset) {
    look(20);
    glPolygonOffset(1, 2);
    glEnable(GL_POLYGON_OFFSET_FILL);
    all_are_triangles(100, 3);
}

/// A flat quad has the colour of its last vertex in both of its triangles.
TEST_F(CutQuads, AreFlatInOneColor) {
    look(20);
    glShadeModel(GL_FLAT);
    int seen = 0;
    for (int round = 0; round < 100; ++round) {
        const Quad q = some_quad(3);
        Quad same = q;
        for (Corner& at : same)
            at.color = q[3].color;
        const Pixels one_color = drawn(GL_TRIANGLES, {same[1], same[2], same[3], same[1], same[3], same[0]});
        ASSERT_EQ(drawn(GL_QUADS, {q[0], q[1], q[2], q[3]}), one_color) << "round " << round;
        seen += is_empty(one_color) ? 0 : 1;
    }
    EXPECT_GT(seen, 25);
}

/// If one side is outlined, the other is filled in the same way as where both are filled.
TEST_F(CutQuads, WithOneSideOutlined) {
    look(20);
    int compared = 0;
    for (int round = 0; round < 100; ++round) {
        const Quad q = some_quad(0.5f);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        const Pixels filled = drawn(GL_QUADS, {q[0], q[1], q[2], q[3]});
        const bool is_cut = std::any_of(q.begin(), q.end(), [](const Corner& at) {
            return at.position[2] > -0.5f || std::abs(at.position[0]) > -at.position[2] ||
                   std::abs(at.position[1]) > -at.position[2];
        });
        glPolygonMode(GL_BACK, GL_LINE);
        glEnable(GL_CULL_FACE);
        const Pixels front = drawn(GL_QUADS, {q[0], q[1], q[2], q[3]});
        glDisable(GL_CULL_FACE);
        if (!is_cut && !is_empty(front)) {
            ASSERT_EQ(front, filled) << "round " << round;
            ++compared;
        }
    }
    EXPECT_GT(compared, 20);
}

/// The outline of a clipped quad has no line along the diagonal.
TEST_F(CutQuads, AreOutlinedWithoutADiagonal) {
    look(20);
    glDisable(GL_DEPTH_TEST);
    const auto count = [](const Pixels& pixels) {
        int lit = 0;
        for (std::size_t i = 0; i < pixels.size(); i += 4)
            lit += pixels[i] != 0 ? 1 : 0;
        return lit;
    };
    const Corner near{{0, -1, 1}, {255, 255, 255, 255}}, left{{-0.5f, 0, -1.5f}, {255, 255, 255, 255}},
        high{{0, 0.6f, -1.5f}, {255, 255, 255, 255}}, right{{0.5f, 0, -1.5f}, {255, 255, 255, 255}};
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    const int quad = count(drawn(GL_QUADS, {near, right, high, left})),
              halves = count(drawn(GL_TRIANGLES, {near, right, high, near, high, left}));
    EXPECT_GT(quad, 40);
    EXPECT_GT(halves, quad + 10);
}

} // namespace
} // namespace spangle::test
