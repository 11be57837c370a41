// Rows B03, D11: tests polygons as lines and points, and which edges are boundaries.
#include <random>
#include <utility>
#include <vector>

#include "tests/gl/vertex/canvas.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

using Edge = std::pair<int, int>;
using Edges = std::vector<Edge>;

/// Returns the polygons of each mode, with their vertices in order, from vertices 0 to n - 1 (GL 1.3, 2.6.1).
std::vector<std::vector<int>> polygons(GLenum mode, int n) {
    std::vector<std::vector<int>> all;
    switch (mode) {
    case GL_TRIANGLES:
        for (int i = 0; i + 2 < n; i += 3)
            all.push_back({i, i + 1, i + 2});
        break;
    case GL_TRIANGLE_STRIP:
        for (int i = 0; i + 2 < n; ++i)
            all.push_back(i % 2 == 0 ? std::vector<int>{i, i + 1, i + 2} : std::vector<int>{i + 1, i, i + 2});
        break;
    case GL_TRIANGLE_FAN:
        for (int i = 1; i + 1 < n; ++i)
            all.push_back({0, i, i + 1});
        break;
    case GL_QUADS:
        for (int i = 0; i + 3 < n; i += 4)
            all.push_back({i, i + 1, i + 2, i + 3});
        break;
    case GL_QUAD_STRIP:
        for (int i = 0; i + 3 < n; i += 2)
            all.push_back({i, i + 1, i + 3, i + 2});
        break;
    default:
        if (n >= 3) {
            all.emplace_back();
            for (int i = 0; i < n; ++i)
                all[0].push_back(i);
        }
    }
    return all;
}

constexpr GLenum polygon_modes[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN,
                                    GL_QUADS,     GL_QUAD_STRIP,     GL_POLYGON};

bool by_flag(GLenum mode) {
    return mode == GL_TRIANGLES || mode == GL_QUADS || mode == GL_POLYGON;
}

class PolygonMode : public Canvas {
  protected:
    void SetUp() override {
        Canvas::SetUp();
        glOrtho(0, size, 0, size, -1, 1);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    }
    /// Returns vertex i. No three vertices are in a line, all are in the window, and each has another x.
    static std::array<GLfloat, 2> place(int i) {
        constexpr GLfloat y[] = {8, 40, 12, 50, 4, 44, 16, 60, 2, 36, 20, 56};
        return {static_cast<GLfloat>(4 + 5 * i), y[i]};
    }
    static int vertex_at(std::int32_t x) { return (x / 256 - 4) / 5; }

    static void give(GLenum mode, int n, const std::vector<GLboolean>& flags) {
        glBegin(mode);
        for (int i = 0; i < n; ++i) {
            glEdgeFlag(flags[static_cast<std::size_t>(i)]);
            glVertex2fv(place(i).data());
        }
        glEnd();
    }
    static Edges drawn(const WindowRecorder& recorder, int corners) {
        Edges edges;
        for (const Primitive& p : recorder.primitives) {
            EXPECT_EQ(p.corners, corners);
            edges.emplace_back(vertex_at(p.corner[0].x), vertex_at(p.corner[corners - 1].x));
        }
        return edges;
    }
    static Edges expected(GLenum mode, int n, const std::vector<GLboolean>& flags, bool points) {
        Edges edges;
        for (const std::vector<int>& polygon : polygons(mode, n))
            for (std::size_t i = 0; i < polygon.size(); ++i)
                if (!by_flag(mode) || flags[static_cast<std::size_t>(polygon[i])]) {
                    const int next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
                    edges.emplace_back(polygon[i], points ? polygon[i] : next);
                }
        return edges;
    }
};

/// Draws around as many vertices as each mode needs, with random edge flags.
TEST_F(PolygonMode, BoundaryEdgesOfEveryMode) {
    std::mt19937 random(3);
    for (const bool points : {false, true}) {
        glPolygonMode(GL_FRONT_AND_BACK, points ? GL_POINT : GL_LINE);
        for (const GLenum mode : polygon_modes)
            for (int n = 0; n <= 12; ++n)
                for (int round = 0; round < 4; ++round) {
                    std::vector<GLboolean> flags(12);
                    for (GLboolean& flag : flags)
                        flag = round == 0 || random() % 2 != 0 ? GL_TRUE : GL_FALSE;
                    WindowRecorder recorder;
                    give(mode, n, flags);
                    EXPECT_EQ(drawn(recorder, points ? 1 : 2), expected(mode, n, flags, points))
                        << "mode " << mode << ", " << n << " vertices, points " << points;
                }
    }
}

TEST_F(PolygonMode, EdgeFlagArrays) {
    std::vector<std::array<GLfloat, 2>> position;
    std::vector<GLboolean> flags;
    std::vector<GLubyte> element;
    for (int i = 0; i < 12; ++i) {
        position.push_back(place(i));
        flags.push_back(i % 3 == 1 || i == 6 ? GL_TRUE : GL_FALSE);
        element.push_back(static_cast<GLubyte>(i));
    }
    std::vector<GLboolean> spread; // flags that are three bytes apart
    for (const GLboolean flag : flags)
        spread.insert(spread.end(), {flag, GL_TRUE, GL_FALSE});
    glVertexPointer(2, GL_FLOAT, 0, position.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_EDGE_FLAG_ARRAY);
    const GLuint list = glGenLists(1);
    for (const bool apart : {false, true}) {
        glEdgeFlagPointer(apart ? 3 : 0, apart ? spread.data() : flags.data());
        for (const GLenum mode : polygon_modes) {
            const Edges edges = expected(mode, 12, flags, false);
            const auto same = [&edges](auto draw) {
                WindowRecorder recorder;
                draw();
                EXPECT_EQ(drawn(recorder, 2), edges);
            };
            same([&] { glDrawArrays(mode, 0, 12); });
            same([&] { glDrawElements(mode, 12, GL_UNSIGNED_BYTE, element.data()); });
            glNewList(list, GL_COMPILE);
            glDrawArrays(mode, 0, 12);
            glEndList();
            same([&] { glCallList(list); });
        }
    }
    glEdgeFlag(GL_TRUE);
    glArrayElement(0);
    GLboolean flag = GL_TRUE;
    glGetBooleanv(GL_EDGE_FLAG, &flag);
    EXPECT_EQ(flag, GL_FALSE) << "elements set what is current";
}

/// What clipping leaves of an edge keeps its flag, and edges along a plane are boundaries (GL 1.3, 2.11).
TEST_F(PolygonMode, ClippedEdges) {
    const auto lines = [](std::initializer_list<GLboolean> flags) {
        const GLfloat corner[3][2] = {{-16, 16}, {48, 16}, {48, 48}};
        std::vector<std::array<int, 4>> found;
        WindowRecorder recorder;
        glBegin(GL_TRIANGLES);
        int i = 0;
        for (const GLboolean flag : flags) {
            glEdgeFlagv(&flag);
            glVertex2fv(corner[i++]);
        }
        glEnd();
        for (const Primitive& p : recorder.primitives)
            found.push_back(
                {p.corner[0].x / 256, p.corner[0].y / 256, p.corner[1].x / 256, p.corner[1].y / 256});
        return found;
    };
    using Lines = std::vector<std::array<int, 4>>;
    const std::array<int, 4> bottom{0, 16, 48, 16}, right{48, 16, 48, 48}, top{48, 48, 0, 24},
        cut{0, 24, 0, 16};
    EXPECT_THAT(lines({1, 1, 1}), testing::UnorderedElementsAre(bottom, right, top, cut));
    EXPECT_THAT(lines({0, 0, 0}), testing::UnorderedElementsAre(cut));
    EXPECT_THAT(lines({1, 0, 0}), testing::UnorderedElementsAre(bottom, cut));
    EXPECT_THAT(lines({0, 0, 1}), testing::UnorderedElementsAre(top, cut));
    EXPECT_EQ(lines({1, 1, 1}).size(), Lines({bottom, right, top, cut}).size());
}

/// Each side has its own mode; culling comes first.
TEST_F(PolygonMode, SidesAndCulling) {
    const auto kinds = [](bool counter_clockwise) {
        WindowRecorder recorder;
        glBegin(GL_TRIANGLES);
        glVertex2f(8, 8);
        counter_clockwise ? glVertex2f(40, 8) : glVertex2f(8, 40);
        counter_clockwise ? glVertex2f(8, 40) : glVertex2f(40, 8);
        glEnd();
        std::vector<int> corners;
        for (const Primitive& p : recorder.primitives)
            corners.push_back(p.corners);
        return corners;
    };
    const std::vector<int> filled{3}, lines{2, 2, 2}, points{1, 1, 1}, none;
    glPolygonMode(GL_FRONT, GL_POINT);
    EXPECT_EQ(kinds(true), points);
    EXPECT_EQ(kinds(false), lines);
    glPolygonMode(GL_BACK, GL_FILL);
    EXPECT_EQ(kinds(true), points);
    EXPECT_EQ(kinds(false), filled);
    glFrontFace(GL_CW);
    EXPECT_EQ(kinds(true), filled);
    EXPECT_EQ(kinds(false), points);
    glEnable(GL_CULL_FACE);
    EXPECT_EQ(kinds(true), none);
    EXPECT_EQ(kinds(false), points);
    GLint mode[2] = {};
    glGetIntegerv(GL_POLYGON_MODE, mode);
    EXPECT_EQ(mode[0], GL_POINT);
    EXPECT_EQ(mode[1], GL_FILL);
}

/// Outlines have the colours of their polygon: the provoking vertex's in flat shading, and the lit colours of
/// its side.
TEST_F(PolygonMode, ColorsOfOutlines) {
    glShadeModel(GL_FLAT);
    for (const GLenum how : {GL_LINE, GL_POINT})
        for (const GLenum mode : {GL_TRIANGLES, GL_POLYGON}) {
            glPolygonMode(GL_FRONT_AND_BACK, how);
            WindowRecorder recorder;
            glBegin(mode);
            for (int i = 0; i < 3; ++i) {
                glColor3ub(static_cast<GLubyte>(100 + i), 0, 0);
                glVertex2fv(place(i).data());
            }
            glEnd();
            ASSERT_EQ(recorder.primitives.size(), 3u);
            for (const Primitive& p : recorder.primitives) {
                const raster::FixedVertex& v = how == GL_LINE ? p.provoking : p.corner[0];
                EXPECT_EQ(v.color[0] >> 20, mode == GL_POLYGON ? 100u : 102u);
            }
        }
    const GLfloat emission[4] = {0.2f, 0, 0, 1}, back_emission[4] = {0.6f, 0, 0, 1}, black[4] = {0, 0, 0, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
    glMaterialfv(GL_FRONT, GL_EMISSION, emission);
    glMaterialfv(GL_BACK, GL_EMISSION, back_emission);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glEnable(GL_LIGHTING);
    glShadeModel(GL_SMOOTH);
    for (const bool front : {true, false}) {
        glFrontFace(front ? GL_CW : GL_CCW); // the corners 0, 1, 2 are clockwise
        WindowRecorder recorder;
        give(GL_TRIANGLES, 3, {1, 1, 1});
        ASSERT_EQ(recorder.primitives.size(), 3u);
        for (const Primitive& p : recorder.primitives)
            EXPECT_EQ((p.corner[0].color[0] + (1u << 19)) >> 20, front ? 51u : 153u);
    }
}

} // namespace
} // namespace spangle::test
