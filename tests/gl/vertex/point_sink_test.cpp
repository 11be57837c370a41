// The sink of points alone: which points it draws, how large they are, and when it asks for their colour.
#include <cmath>
#include <memory>
#include <vector>

#include "gl/vertex/point_sink.hpp"
#include "tests/gl/vertex/vertex_parts.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

using PointSink = gl::PointSink<gl::FixedMath, gl::FixedLighting>;

struct PointPart : Alone<PointSink> {
    using PointSink::project;
};

class PointSinkAlone : public VertexParts {
  protected:
    const std::unique_ptr<PointPart> part_ = std::make_unique<PointPart>();

    Vertex& vertex(float x, float y, float z, float w = 1) {
        part_->process(part_->vertex_slot_[0], x, y, z, w);
        return part_->vertex_slot_[0];
    }
    /// The primitives of one point.
    std::vector<Primitive> drawn(float x, float y, float z, float w = 1) {
        part_->begin(GL_POINTS);
        WindowRecorder recorder;
        part_->point(vertex(x, y, z, w));
        return recorder.primitives;
    }
    int size_of(float x, float y, float z, float w = 1) {
        const std::vector<Primitive> points = drawn(x, y, z, w);
        EXPECT_EQ(points.size(), 1u);
        return points.empty() ? 0 : points[0].size;
    }
    static void attenuate(float constant, float linear, float square) {
        const GLfloat factors[3] = {constant, linear, square};
        glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, factors);
    }
    static void enable_texture(int unit) {
        const GLubyte texel[4] = {};
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(unit) + 1);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
        glEnable(GL_TEXTURE_2D);
    }
};

/// The centre decides, however wide a point is (GL 1.3, 2.11).
TEST_F(PointSinkAlone, DrawsPointsWhoseCenterIsInTheViewVolume) {
    glPointSize(64);
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f})
            for (const float z : {-1.0f, 1.0f}) {
                const std::vector<Primitive> corner = drawn(x, y, z);
                ASSERT_EQ(corner.size(), 1u) << x << ' ' << y << ' ' << z;
                EXPECT_EQ(corner[0].corners, 1);
                EXPECT_EQ(corner[0].size, 64);
                EXPECT_EQ(pixels(corner[0].corner[0].x), 32 + 32 * x);
                EXPECT_EQ(pixels(corner[0].corner[0].y), 32 + 32 * y);
            }
    const float out = 1.0001f;
    for (const float side : {-out, out}) {
        EXPECT_TRUE(drawn(side, 0, 0).empty());
        EXPECT_TRUE(drawn(0, side, 0).empty());
        EXPECT_TRUE(drawn(0, 0, side).empty());
    }
    EXPECT_TRUE(drawn(0, 0, 0, 0).empty());
    EXPECT_TRUE(drawn(0, 0, 0, -1).empty());
    EXPECT_TRUE(drawn(3e38f, -3e38f, 0).empty());
}

TEST_F(PointSinkAlone, DrawsNoPointOutsideOfAUserPlane) {
    const GLdouble plane[4] = {1, 0, 0, -0.25};
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    EXPECT_EQ(drawn(0.25f, 0, 0).size(), 1u); // on the plane
    EXPECT_EQ(drawn(0.75f, 0, 0).size(), 1u);
    EXPECT_TRUE(drawn(0.249f, 0, 0).empty());
}

TEST_F(PointSinkAlone, LightsOnlyPointsThatAreDrawn) {
    glEnable(GL_LIGHTING);
    const GLdouble plane[4] = {0, 1, 0, 0};
    glClipPlane(GL_CLIP_PLANE2, plane);
    glEnable(GL_CLIP_PLANE2);
    drawn(0, 0.5f, 0);
    EXPECT_EQ(part_->vertex_slot_[0].flags & gl::uncolored, 0u);
    drawn(0, -0.5f, 0);
    EXPECT_NE(part_->vertex_slot_[0].flags & gl::uncolored, 0u);
    drawn(0, 1.5f, 0);
    EXPECT_NE(part_->vertex_slot_[0].flags & gl::uncolored, 0u);
}

/// A vertex without window coordinates gets those that the division would have given.
TEST_F(PointSinkAlone, ProjectsAVertexThatHasNoPlaceYet) {
    part_->begin(GL_POINTS);
    Vertex& v = vertex(0.5f, -0.25f, 0.5f, 2);
    const raster::FixedVertex before = v.window;
    v.flags |= gl::unprojected;
    v.window.x = v.window.y = 0;
    WindowRecorder recorder;
    part_->point(v);
    ASSERT_EQ(recorder.primitives.size(), 1u);
    EXPECT_EQ(recorder.primitives[0].corner[0].x, before.x);
    EXPECT_EQ(recorder.primitives[0].corner[0].y, before.y);
    EXPECT_EQ(v.flags & gl::unprojected, 0u);
}

TEST_F(PointSinkAlone, DrawsAPointOfAnOutlineAtTheGivenWindowVertex) {
    part_->begin(GL_TRIANGLES);
    const Vertex& v = vertex(0, 0, 0);
    raster::FixedVertex moved = v.window;
    moved.x += 5 * raster::subpixel_one;
    WindowRecorder recorder;
    part_->draw_point(v, moved);
    ASSERT_EQ(recorder.primitives.size(), 1u);
    EXPECT_EQ(recorder.primitives[0].corner[0].x, moved.x);
}

TEST_F(PointSinkAlone, CapturesPointsThatAreNotClipped) {
    GLfloat words[16];
    glFeedbackBuffer(16, GL_2D, words);
    glRenderMode(GL_FEEDBACK);
    EXPECT_TRUE(drawn(0.5f, 0, 0).empty());
    EXPECT_TRUE(drawn(1.5f, 0, 0).empty());
    ASSERT_EQ(glRenderMode(GL_RENDER), 3);
    EXPECT_EQ(words[0], GL_POINT_TOKEN);
    EXPECT_EQ(words[1], 48);
    EXPECT_EQ(words[2], 32);
}

/// The size is size * sqrt(1 / (a + b d + c d^2)) at the distance d (GL 1.4, 3.3).
TEST_F(PointSinkAlone, AttenuatesTheSizeByTheDistanceFromTheEye) {
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 100);
    glMatrixMode(GL_MODELVIEW);
    glPointSize(48);
    attenuate(0, 0, 1);
    EXPECT_EQ(size_of(0, 0, -4), 12);
    EXPECT_EQ(size_of(0, 0, -16), 3);
    EXPECT_EQ(size_of(3, 0, -4), 10);    // 48 / 5
    EXPECT_EQ(size_of(2, 0, -8, 2), 12); // the distance is that after the division by w, sqrt(17)
    attenuate(0, 1, 0);
    EXPECT_EQ(size_of(0, 0, -4), 24);
    attenuate(4, 0, 0);
    EXPECT_EQ(size_of(0, 0, -4), 24);
    attenuate(1, 0.75f, 0.75f);
    EXPECT_EQ(size_of(0, 0, -4), 12);
    glTranslatef(0, 0, -12);
    attenuate(0, 0, 1);
    EXPECT_EQ(size_of(0, 0, -4), 3);
}

TEST_F(PointSinkAlone, ClampsTheSizeToTheRangeOfTheProgram) {
    glPointSize(20);
    glPointParameterf(GL_POINT_SIZE_MIN, 5);
    glPointParameterf(GL_POINT_SIZE_MAX, 30);
    EXPECT_EQ(size_of(0, 0, 0), 20);
    attenuate(0, 0, 1);
    EXPECT_EQ(size_of(0, 0, 0), 30); // at the eye itself the size has no bound
    EXPECT_EQ(size_of(0, 0, 0.001f), 30);
    EXPECT_EQ(size_of(0, 0, 1), 20);
    attenuate(100, 0, 0);
    EXPECT_EQ(size_of(0, 0, 0), 5);
    attenuate(1, 0, 0);
    glPointSize(2);
    EXPECT_EQ(size_of(0, 0, 0), 5);
    glPointSize(64);
    EXPECT_EQ(size_of(0, 0, 0), 30);
    glPointParameterf(GL_POINT_SIZE_MIN, 40); // a minimum above the maximum: the maximum is applied last
    EXPECT_EQ(size_of(0, 0, 0), 30);
}

/// An outline's point at a corner that clipping made has the distance of that corner.
TEST_F(PointSinkAlone, AttenuatesTheSizeAtACornerThatClippingMade) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glPointSize(64);
    attenuate(0, 0, 1);
    part_->begin(GL_TRIANGLES);
    Vertex &a = part_->vertex_slot_[0], &b = part_->vertex_slot_[1];
    part_->process(a, 0, 0, 0.5f);
    part_->process(b, 0, 0, 8.5f);
    Vertex* ends[2] = {&a, &b};
    ASSERT_TRUE(part_->clip_line(ends)); // at z = 1
    ASSERT_TRUE(part_->project(*ends[1]));
    glPointSize(16);
    WindowRecorder recorder;
    part_->draw_point(*ends[1], ends[1]->window);
    ASSERT_EQ(recorder.primitives.size(), 1u);
    EXPECT_EQ(recorder.primitives[0].size, 16);
}

/// A sprite is a square of two triangles. s and t run across it only in units with COORD_REPLACE.
TEST_F(PointSinkAlone, SpansASpriteWithTheCoordinatesOfItsUnits) {
    enable_texture(0);
    enable_texture(1);
    glMultiTexCoord2f(GL_TEXTURE0, 7, 9);
    glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE); // of unit 1
    glEnable(GL_POINT_SPRITE);
    glPointSize(6.5f);
    for (const GLenum origin : {GL_UPPER_LEFT, GL_LOWER_LEFT}) {
        glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, static_cast<GLint>(origin));
        const std::vector<Primitive> halves = drawn(1, 0.5f, 0); // at the viewport's edge
        ASSERT_EQ(halves.size(), 2u);
        double area = 0;
        for (const Primitive& half : halves) {
            EXPECT_EQ(half.corners, 3);
            area += static_cast<double>(half.area2);
            for (const raster::FixedVertex& corner : half.corner) {
                const double dx = pixels(corner.x) - 64, dy = pixels(corner.y) - 48;
                EXPECT_EQ(std::fabs(dx), 3.25);
                EXPECT_EQ(std::fabs(dy), 3.25);
                const auto& given = corner.tex[0];
                EXPECT_EQ(std::ldexp(given.s, given.exponent), 7);
                EXPECT_EQ(std::ldexp(given.t, given.exponent), 9);
                const auto& across = corner.tex[1];
                EXPECT_EQ(std::ldexp(across.s, across.exponent), dx > 0 ? 1 : 0);
                EXPECT_EQ(std::ldexp(across.t, across.exponent),
                          (dy > 0) == (origin == GL_LOWER_LEFT) ? 1 : 0);
            }
        }
        EXPECT_EQ(area, 2 * 6.5 * 6.5 * 0x1p16);
    }
}

/// The pixels of an antialiased point have together the area of its disc.
TEST_F(PointSinkAlone, CoversTheAreaOfAnAntialiasedPoint) {
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glPointSize(10.5f);
    glColor4f(1, 1, 1, 1);
    part_->begin(GL_POINTS);
    part_->point(vertex(0.01f, 0.02f, 0));
    std::vector<GLubyte> image(size * size * 4);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    double covered = 0;
    for (std::size_t p = 0; p < image.size(); p += 4)
        covered += image[p] / 255.0;
    EXPECT_NEAR(covered, 3.14159 * 5.25 * 5.25, 1);
}

/// A drawable with four samples, in which points below the fade threshold become transparent.
class PointSinkOfSamples : public testing::Test {
  protected:
    const HeadlessGl current_{32, 32, {EGL_SAMPLES, 4}};
};

TEST_F(PointSinkOfSamples, DrawsADiscAndFadesBelowTheThreshold) {
    const auto part = std::make_unique<Alone<PointSink>>();
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 8);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ZERO);
    const auto red_at_center = [&](float size) {
        glClear(GL_COLOR_BUFFER_BIT);
        glPointSize(size);
        part->begin(GL_POINTS);
        WindowRecorder recorder;
        part->process(part->vertex_slot_[0], 0, 0, 0);
        part->point(part->vertex_slot_[0]);
        EXPECT_EQ(recorder.primitives.size(), 0u); // discs take a way of their own
        GLubyte pixel[4];
        glReadPixels(16, 16, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
        return int{pixel[0]};
    };
    EXPECT_EQ(red_at_center(8), 255);
    EXPECT_EQ(red_at_center(12), 255);
    EXPECT_NEAR(red_at_center(4), 255 / 4, 1); // the ratio of the areas
    EXPECT_NEAR(red_at_center(6), 255 * 9 / 16, 1);
    gl::current_context()->changed(gl::dirty_all);
}

} // namespace
} // namespace spangle::test
