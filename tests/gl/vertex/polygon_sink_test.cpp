// The sink of polygons alone: what it clips, culls, colours and outlines, and how it draws gathered polygons.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "gl/vertex/polygon_sink.hpp"
#include "tests/gl/vertex/vertex_parts.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

using PolygonSink = gl::PolygonSink<gl::FixedMath, gl::FixedLighting>;

struct At {
    float x, y, z = 0, w = 1;
};
const std::vector<At> triangle = {{0, 0}, {0.5f, 0}, {0, 0.5f}},
                      square = {{0, 0}, {0.5f, 0}, {0.5f, 0.5f}, {0, 0.5f}};

class PolygonSinkAlone : public VertexParts {
  protected:
    const std::unique_ptr<Alone<PolygonSink>> part_ = std::make_unique<Alone<PolygonSink>>();
    Vertex* corner_[4] = {};

    static gl::Context& context() { return *gl::current_context(); }
    void begin(GLenum mode) {
        part_->begin(mode);
        part_->begin_lines(context());
    }
    void process(const std::vector<At>& corners, unsigned flags = 0) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            corner_[i] = &part_->vertex_slot_[i];
            const At& at = corners[i];
            part_->process(*corner_[i], at.x, at.y, at.z, at.w);
            corner_[i]->flags |= flags;
        }
    }
    /// The primitives of one polygon, whose provoking corner is number 2.
    std::vector<Primitive> drawn(const std::vector<At>& corners, GLenum mode = GL_QUADS, unsigned flags = 0) {
        begin(mode);
        process(corners, flags);
        WindowRecorder recorder;
        part_->polygon(corner_, static_cast<int>(corners.size()), *corner_[2]);
        return recorder.primitives;
    }
    /// Draws a POLYGON that is gathered.
    void gather(const std::vector<At>& corners) {
        begin(GL_POLYGON);
        for (const At& at : corners) {
            Vertex& v = part_->vertex_slot_[0];
            part_->process(v, at.x, at.y, at.z, at.w);
            part_->gather(v);
        }
        part_->gathered();
    }
    static std::vector<At> circle(int n, float radius, float x = 0) {
        std::vector<At> corners;
        for (int i = 0; i < n; ++i) {
            const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(n);
            corners.push_back({x + radius * std::cos(angle), radius * std::sin(angle)});
        }
        return corners;
    }
    /// Half the sum of the areas that the primitives tell, in pixels.
    static double area(const std::vector<Primitive>& primitives) {
        double sum = 0;
        for (const Primitive& p : primitives)
            sum += static_cast<double>(p.area2) / 2 / 0x1p16;
        return sum;
    }
    static std::int64_t true_area2(const Primitive& p) {
        const auto& [a, b, c] = p.corner;
        return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
    }
    int count_of_pixels() const {
        std::vector<GLubyte> image(size * size * 4);
        glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
        int count = 0;
        for (std::size_t p = 0; p < image.size(); p += 4)
            count += image[p] != 0 ? 1 : 0;
        return count;
    }
};

TEST_F(PolygonSinkAlone, DrawsAFanOfTrianglesFromTheFirstCorner) {
    const std::vector<Primitive> halves = drawn(square);
    ASSERT_EQ(halves.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_TRUE(is_at(halves[i].corner[0], *corner_[0]));
        EXPECT_TRUE(is_at(halves[i].corner[1], *corner_[i + 1]));
        EXPECT_TRUE(is_at(halves[i].corner[2], *corner_[i + 2]));
        EXPECT_TRUE(is_at(halves[i].provoking, *corner_[2]));
        EXPECT_EQ(halves[i].area2, true_area2(halves[i]));
    }
    EXPECT_EQ(area(halves), 16 * 16);
}

TEST_F(PolygonSinkAlone, DrawsNothingOfNoArea) {
    EXPECT_TRUE(drawn({{0, 0}, {0.25f, 0.25f}, {0.5f, 0.5f}}).empty());
    EXPECT_TRUE(drawn({{0, 0}, {0, 0}, {0, 0}, {0, 0}}).empty());
    EXPECT_TRUE(drawn({{0, 0}, {0.00005f, 0}, {0, 0.00005f}}).empty()); // less than a subpixel
    // One half of the quad has no area.
    const std::vector<Primitive> half = drawn({{0, 0}, {0.25f, 0.25f}, {0.5f, 0.5f}, {0, 0.5f}});
    ASSERT_EQ(half.size(), 1u);
    EXPECT_TRUE(is_at(half[0].corner[2], *corner_[3]));
}

/// The sum of both triangles decides, so that both halves of a bent quad face the same way.
TEST_F(PolygonSinkAlone, CullsTheSideOfTheWholePolygon) {
    glEnable(GL_LIGHTING);
    glEnable(GL_CULL_FACE);
    const std::vector<At> bent = {{0, 0}, {0.5f, 0}, {0.1f, 0.05f}, {0.2f, -0.1f}}; // half is turned over
    for (const GLenum culled : {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}) {
        glCullFace(culled);
        const bool front = culled == GL_BACK;
        EXPECT_EQ(drawn(square).size(), front ? 2u : 0u);
        for (const Vertex* corner : corner_)
            EXPECT_EQ((corner->flags & gl::uncolored) == 0, front);
        EXPECT_EQ(drawn({square[3], square[2], square[1], square[0]}).size(), culled == GL_FRONT ? 2u : 0u);
        EXPECT_EQ(drawn(bent).size(), front ? 2u : 0u);
    }
}

TEST_F(PolygonSinkAlone, DrawsNothingOutsideOfOnePlane) {
    glEnable(GL_LIGHTING);
    for (const float x : {-2.0f, 1.01f, 1e30f}) {
        EXPECT_TRUE(drawn({{x, 0}, {x + 0.5f, 0}, {x + 0.5f, 1}, {x, 1}}).empty());
        for (const Vertex* corner : corner_)
            EXPECT_NE(corner->flags & gl::uncolored, 0u);
    }
    EXPECT_TRUE(drawn({{0, 0, 0, -1}, {1, 0, 0, -1}, {0, 1, 0, -1}}).empty());
    EXPECT_TRUE(drawn({{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}).empty());
    const GLdouble plane[4] = {-1, 0, 0, -0.25};
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    EXPECT_TRUE(drawn(square).empty());
}

/// The diagonal runs from corner 0 to corner 2 of the quad, whichever corner is cut off.
TEST_F(PolygonSinkAlone, DividesAClippedQuadByTheDiagonalOfAWholeOne) {
    for (std::size_t away = 0; away < 4; ++away) {
        std::vector<At> quad = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}};
        quad[away].x *= 20;
        quad[away].y *= 20;
        const std::vector<Primitive> parts = drawn(quad);
        EXPECT_GT(parts.size(), 2u);
        for (const Primitive& part : parts) {
            EXPECT_TRUE(is_at(part.provoking, *corner_[2]));
            EXPECT_GT(part.area2, 0);
            EXPECT_EQ(part.area2, true_area2(part));
            // Corners lie on one side of y = x, the diagonal.
            int below = 0, above = 0;
            for (const raster::FixedVertex& v : part.corner) {
                below += v.y < v.x - 1 ? 1 : 0;
                above += v.y > v.x + 1 ? 1 : 0;
            }
            EXPECT_TRUE(below == 0 || above == 0) << away;
        }
    }
}

/// A quad around the eye: what is left is a part of the view volume, at most as large as the guard band.
TEST_F(PolygonSinkAlone, ClipsAPolygonThatReachesAsFarAsFloatsDo) {
    const std::vector<Primitive> plain =
        drawn({{-3e38f, -3e38f}, {3e38f, -3e38f}, {3e38f, 3e38f}, {-3e38f, 3e38f}});
    EXPECT_EQ(area(plain), 256.0 * 256);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 100);
    const std::vector<Primitive> ground =
        drawn({{-1000, -1, -2000}, {1000, -1, -2000}, {1000, -1, 2000}, {-1000, -1, 2000}});
    EXPECT_FALSE(ground.empty());
    for (const Primitive& part : ground)
        for (const raster::FixedVertex& v : part.corner) {
            EXPECT_LE(std::abs(v.x - 32 * 256), 4 * 32 * 256);
            EXPECT_LE(std::abs(v.y - 32 * 256), 4 * 32 * 256);
        }
}

/// A plane and its complement cut a polygon into two that have its area together.
TEST_F(PolygonSinkAlone, CutsAPolygonAtAUserPlane) {
    GLdouble plane[4] = {1, 0.5, 0, -0.2};
    glEnable(GL_CLIP_PLANE3);
    double sum = 0;
    for (int side = 0; side < 2; ++side) {
        glClipPlane(GL_CLIP_PLANE3, plane);
        const std::vector<Primitive> parts = drawn(square);
        EXPECT_FALSE(parts.empty());
        EXPECT_GT(area(parts), 10);
        sum += area(parts);
        for (GLdouble& p : plane)
            p = -p;
    }
    EXPECT_EQ(sum, 16 * 16);
}

/// Edge flags apply to separate triangles and quads only (GL 1.3, 2.6.2).
TEST_F(PolygonSinkAlone, OutlinesEdgesByTheirFlagsOrAllOfThem) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    for (const GLenum mode : {GL_TRIANGLES, GL_QUADS, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUAD_STRIP}) {
        const std::vector<At>& corners = mode == GL_QUADS || mode == GL_QUAD_STRIP ? square : triangle;
        const bool by_flag = mode == GL_TRIANGLES || mode == GL_QUADS;
        glEdgeFlag(GL_TRUE);
        EXPECT_EQ(drawn(corners, mode).size(), corners.size()) << mode;
        glEdgeFlag(GL_FALSE);
        EXPECT_EQ(drawn(corners, mode).size(), by_flag ? 0u : corners.size()) << mode;
        // A flag that an earlier primitive left says nothing.
        EXPECT_EQ(drawn(corners, mode, gl::boundary).size(), by_flag ? 0u : corners.size()) << mode;
    }
}

TEST_F(PolygonSinkAlone, OutlinesFromTheVertexThatWasGivenFirst) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glLineWidth(3);
    const std::vector<Primitive> sides = drawn(square, GL_QUADS);
    ASSERT_EQ(sides.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) { // the first vertex of a quad is its corner 3
        EXPECT_EQ(sides[i].corners, 2);
        EXPECT_EQ(sides[i].size, 3);
        EXPECT_TRUE(is_at(sides[i].corner[0], *corner_[(i + 3) % 4])) << i;
        EXPECT_TRUE(is_at(sides[i].corner[1], *corner_[i]));
        EXPECT_TRUE(is_at(sides[i].provoking, *corner_[2]));
    }
}

TEST_F(PolygonSinkAlone, DrawsEachSideInItsMode) {
    glPolygonMode(GL_FRONT, GL_POINT);
    glPolygonMode(GL_BACK, GL_LINE);
    glPointSize(7);
    glShadeModel(GL_FLAT);
    const std::vector<Primitive> points = drawn(triangle, GL_TRIANGLE_STRIP);
    ASSERT_EQ(points.size(), 3u);
    for (const Primitive& point : points) {
        EXPECT_EQ(point.corners, 1);
        EXPECT_EQ(point.size, 7);
        EXPECT_EQ(red(point.corner[0]), red(corner_[2]->window));
    }
    const std::vector<Primitive> lines = drawn({triangle[0], triangle[2], triangle[1]}, GL_TRIANGLE_STRIP);
    ASSERT_EQ(lines.size(), 3u);
    for (const Primitive& line : lines)
        EXPECT_EQ(line.corners, 2);
    EXPECT_TRUE(drawn({{0, 0}, {0, 0}, {0, 0}}, GL_TRIANGLE_STRIP).empty());
}

/// Clipping adds an edge along the plane, which is a boundary (GL 1.3, 2.11).
TEST_F(PolygonSinkAlone, OutlinesTheEdgeThatClippingMade) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    const std::vector<At> cut = {{0, 0}, {3, 0}, {0, 0.75f}};
    EXPECT_EQ(drawn(cut, GL_TRIANGLES).size(), 4u);
    glEdgeFlag(GL_FALSE);
    const std::vector<Primitive> along = drawn(cut, GL_TRIANGLES);
    ASSERT_EQ(along.size(), 1u);
    for (int end = 0; end < 2; ++end)
        EXPECT_EQ(pixels(along[0].corner[end].x), 64); // the right edge of the viewport
}

TEST_F(PolygonSinkAlone, LightsBacksWithTheBackMaterial) {
    glEnable(GL_LIGHTING);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    const GLfloat front[4] = {0.25f, 0, 0, 1}, back[4] = {0.75f, 0, 0, 1}, none[4] = {0, 0, 0, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, none);
    glMaterialfv(GL_FRONT, GL_EMISSION, front);
    glMaterialfv(GL_BACK, GL_EMISSION, back);
    const std::vector<At> turned = {square[3], square[2], square[1], square[0]},
                          clipped = {{0, 0}, {0, 0.5f}, {20, 0}};
    for (const GLenum model : {GL_SMOOTH, GL_FLAT}) {
        glShadeModel(model);
        for (const Primitive& part : drawn(square))
            EXPECT_NEAR(red(part.provoking), 0.25f, 1e-4);
        for (const auto* corners : {&turned, &clipped}) {
            const std::vector<Primitive> parts = drawn(*corners);
            ASSERT_EQ(parts.size(), 2u);
            for (const Primitive& part : parts) {
                EXPECT_NEAR(red(part.provoking), 0.75f, 1e-4);
                for (const raster::FixedVertex& corner : part.corner)
                    EXPECT_TRUE(model == GL_FLAT || std::fabs(red(corner) - 0.75f) < 1e-4) << red(corner);
            }
        }
    }
}

/// The largest triangle has the plane that decides (GL 1.3, 3.5.5). An offset applies in its own mode only.
TEST_F(PolygonSinkAlone, OffsetsThePlaneOfTheLargestTriangle) {
    const auto offset = [] { return context().fragments.primitive.depth_offset; };
    glPolygonOffset(1, 0);
    glEnable(GL_POLYGON_OFFSET_FILL);
    drawn({{0, 0, 0}, {0.5f, 0, 0.25f}, {0, 0.5f, 0}});
    const std::int64_t steep = offset(); // 0.125 in 16 pixels
    EXPECT_NEAR(static_cast<double>(steep), 0x1p32 / 128, 0x1p16);
    drawn(
        {{0, 0, 0}, {0.5f, 0, 0.25f}, {0.5f, 0.5f, 0.25f}, {0.49f, 0.5f, 0.75f}}); // the second half is small
    EXPECT_NEAR(static_cast<double>(offset()), 0x1p32 / 128, 0x1p16);
    drawn({{0, 0, 0}, {0.01f, 0, 0.75f}, {0, 0.5f, 0}, {-0.5f, 0, 0}}); // the first half is small
    EXPECT_EQ(offset(), 0);
    drawn({{0, 0, 0}, {0.5f, 0, 0.25f}, {0, 0.5f, 0}});
    glDisable(GL_POLYGON_OFFSET_FILL);
    glEnable(GL_POLYGON_OFFSET_LINE);
    drawn({{0, 0, 0}, {0.5f, 0, 0.25f}, {0, 0.5f, 0}});
    EXPECT_EQ(offset(), 0);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    drawn({{0, 0, 0}, {0.5f, 0, 0.25f}, {0, 0.5f, 0}});
    EXPECT_EQ(offset(), steep);
}

/// A POLYGON is fed back as one polygon, however many corners it has.
TEST_F(PolygonSinkAlone, FeedsBackAGatheredPolygonAsAWhole) {
    std::vector<GLfloat> words(4096);
    glFeedbackBuffer(4096, GL_2D, words.data());
    for (const int n : {0, 1, 2, 3, 8, 9, 1000}) {
        const std::size_t before = context().arena->used();
        glRenderMode(GL_FEEDBACK);
        gather(circle(n, 0.5f));
        EXPECT_EQ(context().arena->used(), before);
        const GLint written = glRenderMode(GL_RENDER);
        if (n < 3) {
            EXPECT_EQ(written, 0);
            continue;
        }
        ASSERT_EQ(written, 2 + 2 * n);
        EXPECT_EQ(words[0], GL_POLYGON_TOKEN);
        EXPECT_EQ(words[1], static_cast<float>(n));
        EXPECT_EQ(words[2], 48); // the first corner
        EXPECT_EQ(words[3], 32);
    }
}

TEST_F(PolygonSinkAlone, ClipsAGatheredPolygonOfManyCorners) {
    std::vector<GLfloat> words(4096);
    glFeedbackBuffer(4096, GL_2D, words.data());
    glRenderMode(GL_FEEDBACK);
    gather(circle(1000, 0.5f, 1)); // half of it is outside
    gather(circle(1000, 0.5f, 2)); // all of it is
    const GLint written = glRenderMode(GL_RENDER);
    ASSERT_GT(written, 2);
    EXPECT_EQ(written, 2 + 2 * static_cast<GLint>(words[1]));
    EXPECT_NEAR(words[1], 502, 2);
    for (std::size_t i = 2; i < static_cast<std::size_t>(written); i += 2)
        EXPECT_LE(words[i], 64);
}

TEST_F(PolygonSinkAlone, CoversEachPixelOfAnAntialiasedPolygonOnce) {
    glEnable(GL_POLYGON_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    glColor4f(0.5f, 0, 0, 1);
    gather(circle(64, 0.8f));
    std::vector<GLubyte> image(size * size * 4);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    double sum = 0;
    for (std::size_t p = 0; p < image.size(); p += 4) {
        ASSERT_LE(image[p], 128); // edges within the fan are covered once
        sum += image[p] / 127.5;
    }
    EXPECT_NEAR(sum, 3.14159 * 0.64 * 32 * 32, 15);
}

/// Without memory, nothing of the polygon is drawn, and GL tells so.
TEST_F(PolygonSinkAlone, ReportsAPolygonThatFindsNoMemory) {
    glEnable(GL_POLYGON_SMOOTH);
    gl::Arena& arena = *context().arena;
    std::vector<void*> blocks;
    for (std::size_t bytes = std::size_t{1} << 26; bytes >= 32;)
        if (void* const block = arena.allocate(bytes); block != nullptr)
            blocks.push_back(block);
        else
            bytes /= 2;
    const std::size_t used = arena.used();
    gather(circle(30, 0.5f));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_OUT_OF_MEMORY));
    EXPECT_EQ(arena.used(), used);
    EXPECT_EQ(count_of_pixels(), 0);
    gather(circle(2, 0.5f)); // no polygon needs no memory for its parts, but for its corners
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_OUT_OF_MEMORY));
    for (void* const block : blocks)
        arena.free(block);
    gather(circle(30, 0.5f));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_GT(count_of_pixels(), 500);
}

} // namespace
} // namespace spangle::test
