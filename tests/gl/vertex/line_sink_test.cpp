// The sink of lines alone: what it draws of lines, which ends it colours, and where the stipple starts.
#include <memory>
#include <string>
#include <vector>

#include "gl/vertex/line_sink.hpp"
#include "tests/gl/vertex/vertex_parts.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

using LineSink = gl::LineSink<gl::FixedMath, gl::FixedLighting>;
using gl::line_batch;

struct At {
    float x, y, z = 0, w = 1;
};

class LineSinkAlone : public VertexParts {
  protected:
    const std::unique_ptr<Alone<LineSink>> part_ = std::make_unique<Alone<LineSink>>();

    void begin(GLenum mode) {
        part_->begin(mode);
        part_->begin_lines(*gl::current_context());
    }
    Vertex processed(const At& at) {
        Vertex v;
        part_->process(v, at.x, at.y, at.z, at.w);
        return v;
    }
    void line(const At& from, const At& to) {
        Vertex a = processed(from), b = processed(to);
        part_->line(a, b);
    }
    /// The lines that are drawn of one line.
    std::vector<Primitive> drawn(const At& from, const At& to, GLenum mode = GL_LINES) {
        begin(mode);
        WindowRecorder recorder;
        line(from, to);
        return recorder.primitives;
    }
    /// Vertices (i / 64, i / 64), in colours that differ.
    std::vector<Vertex> diagonal(int n) {
        std::vector<Vertex> all;
        for (int i = 0; i < n; ++i) {
            glColor4f(static_cast<float>(i + 1) / 32, 0, 0, 1);
            all.push_back(processed({static_cast<float>(i) / 64, static_cast<float>(i) / 64}));
        }
        return all;
    }
    static std::vector<Vertex*> pointers(std::vector<Vertex>& vertices) {
        std::vector<Vertex*> all;
        for (Vertex& v : vertices)
            all.push_back(&v);
        return all;
    }
    /// Draws horizontal lines through the middle of row 32, from pixel to pixel. Returns the row, from pixel
    /// 0 on: '#' where it is drawn.
    std::string row_of_lines(const std::vector<int>& ends, bool separate) {
        glClear(GL_COLOR_BUFFER_BIT);
        const auto at = [](int pixel) {
            return At{static_cast<float>(pixel) / 32 - 1 + 1 / 128.0f, 1 / 64.0f};
        };
        for (std::size_t i = 0; i + 1 < ends.size(); i += separate ? 2 : 1)
            line(at(ends[i]), at(ends[i + 1]));
        std::string row;
        for (const bool is_drawn : row_of_picture(32))
            row += is_drawn ? '#' : '.';
        return row;
    }
    static std::string row(const std::string& begin) { return begin + std::string(size - begin.size(), '.'); }
};

TEST_F(LineSinkAlone, DrawsALineProvokedByItsSecondVertex) {
    glLineWidth(5);
    begin(GL_LINES);
    std::vector<Vertex> ends = diagonal(2);
    WindowRecorder recorder;
    part_->line(ends[0], ends[1]);
    ASSERT_EQ(recorder.primitives.size(), 1u);
    const Primitive& drawn = recorder.primitives[0];
    EXPECT_EQ(drawn.corners, 2);
    EXPECT_EQ(drawn.size, 5);
    EXPECT_TRUE(is_at(drawn.corner[0], ends[0]) && is_at(drawn.corner[1], ends[1]));
    EXPECT_TRUE(is_at(drawn.provoking, ends[1]));
}

TEST_F(LineSinkAlone, DrawsNothingOfALineBeyondOnePlane) {
    glEnable(GL_LIGHTING);
    for (const float far : {1.5f, 1e30f}) {
        const At pairs[][2] = {{{far, 0}, {2, 1}},       {{-far, 0}, {-2, 1}},     {{0, far}, {0, 2}},
                               {{0, -far}, {0, -2}},     {{0, 0, far}, {0, 0, 2}}, {{0, 0, -far}, {0, 0, -2}},
                               {{far, 0, 0, -1}, {2, 1}}};
        for (const auto& [from, to] : pairs) {
            begin(GL_LINES);
            Vertex a = processed(from), b = processed(to);
            WindowRecorder recorder;
            part_->line(a, b);
            EXPECT_TRUE(recorder.primitives.empty()) << from.x << ' ' << from.y << ' ' << from.z;
            EXPECT_NE(a.flags & b.flags & gl::uncolored, 0u);
        }
    }
}

/// Both ends are outside of the view volume, but the line crosses it.
TEST_F(LineSinkAlone, DrawsALineWhoseEndsAreNotVisible) {
    const std::vector<Primitive> inside = drawn({-2, 0.5f}, {2, 0.5f}); // within the guard band
    ASSERT_EQ(inside.size(), 1u);
    EXPECT_EQ(pixels(inside[0].corner[0].x), -32);
    EXPECT_EQ(pixels(inside[0].corner[1].x), 96);
    const std::vector<Primitive> clipped = drawn({-9, 0.5f, -1}, {9, 0.5f, 1});
    ASSERT_EQ(clipped.size(), 1u);
    EXPECT_EQ(pixels(clipped[0].corner[0].x), -96); // four times as wide as the viewport
    EXPECT_EQ(pixels(clipped[0].corner[1].x), 160);
    EXPECT_EQ(clipped[0].corner[0].y, clipped[0].corner[1].y);
    EXPECT_EQ(pixels(clipped[0].provoking.x), 320); // the vertex as it was given
    EXPECT_EQ(drawn({-3e38f, 0}, {3e38f, 0}).size(), 1u);
}

TEST_F(LineSinkAlone, CutsALineThatPassesTheEye) {
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 10);
    const std::vector<Primitive> to_eye = drawn({0, 0, -5}, {2, 0, 5});
    ASSERT_EQ(to_eye.size(), 1u);
    EXPECT_EQ(pixels(to_eye[0].corner[0].x), 32);
    EXPECT_NEAR(pixels(to_eye[0].corner[1].x), 32 + 32 * 0.8, 0.01); // at z = -1, x is 0.8
    EXPECT_TRUE(drawn({0, 0, 0}, {2, 0, 5}).empty());
    EXPECT_TRUE(drawn({0, 0, 0}, {0, 0, 0}).empty());
}

TEST_F(LineSinkAlone, CutsALineAtAUserPlane) {
    const GLdouble plane[4] = {1, 0, 0, 0};
    glClipPlane(GL_CLIP_PLANE4, plane);
    glEnable(GL_CLIP_PLANE4);
    const std::vector<Primitive> cut = drawn({-0.5f, 0.25f}, {0.5f, 0.25f});
    ASSERT_EQ(cut.size(), 1u);
    EXPECT_EQ(pixels(cut[0].corner[0].x), 32);
    EXPECT_EQ(pixels(cut[0].corner[1].x), 48);
    EXPECT_TRUE(drawn({-0.5f, 0}, {-0.25f, 0}).empty());
    EXPECT_EQ(drawn({0, 0}, {0, 0.5f}).size(), 1u); // in the plane
}

/// A point has no fragments, but it is a line.
TEST_F(LineSinkAlone, DrawsALineOfNoLength) {
    EXPECT_EQ(drawn({0.25f, 0.25f}, {0.25f, 0.25f}).size(), 1u);
    begin(GL_LINES);
    line({0, 1 / 64.0f}, {0, 1 / 64.0f});
    EXPECT_EQ(row_of_picture(32), std::vector<bool>(size, false));
}

TEST_F(LineSinkAlone, LightsOnlyTheSecondEndOfAFlatLine) {
    glEnable(GL_LIGHTING);
    for (const GLenum model : {GL_SMOOTH, GL_FLAT})
        for (const float to : {0.5f, 9.0f}) { // the second line is clipped
            glShadeModel(model);
            begin(GL_LINES);
            Vertex a = processed({0, 0}), b = processed({to, 0.25f});
            WindowRecorder recorder;
            part_->line(a, b);
            ASSERT_EQ(recorder.primitives.size(), 1u);
            EXPECT_EQ(b.flags & gl::uncolored, 0u);
            EXPECT_EQ((a.flags & gl::uncolored) != 0, model == GL_FLAT && to < 1); // clipping mixes colours
        }
}

TEST_F(LineSinkAlone, DrawsEachLineOfAGroupOnce) {
    for (const int step : {1, 2})
        for (int n = 0; n <= line_batch + 1; ++n) {
            begin(step == 1 ? GL_LINE_STRIP : GL_LINES);
            std::vector<Vertex> vertices = diagonal(n);
            WindowRecorder recorder;
            part_->lines(pointers(vertices).data(), n, step, false);
            const auto count = static_cast<std::size_t>(n < 2 ? 0 : step == 1 ? n - 1 : n / 2);
            ASSERT_EQ(recorder.primitives.size(), count) << n << " vertices, step " << step;
            for (std::size_t i = 0; i < count; ++i) {
                const std::size_t first = i * static_cast<std::size_t>(step);
                EXPECT_TRUE(is_at(recorder.primitives[i].corner[0], vertices[first]));
                EXPECT_TRUE(is_at(recorder.primitives[i].corner[1], vertices[first + 1]));
                EXPECT_EQ(red(recorder.primitives[i].corner[0]), red(vertices[first].window));
            }
        }
}

/// One vertex of a group that is not visible sends all lines the long way. They are the same lines.
TEST_F(LineSinkAlone, DrawsTheSameGroupIfOneVertexIsNotVisible) {
    for (const int hidden : {0, 1, 7, 15}) {
        begin(GL_LINE_STRIP);
        std::vector<Vertex> vertices = diagonal(16);
        vertices[static_cast<std::size_t>(hidden)] = processed({0, 0, 2});
        WindowRecorder recorder;
        part_->lines(pointers(vertices).data(), 16, 1, false);
        std::size_t next = 0;
        for (int i = 0; i < 15; ++i) {
            ASSERT_LT(next, recorder.primitives.size());
            const Primitive& drawn = recorder.primitives[next++];
            EXPECT_TRUE(i == hidden || is_at(drawn.corner[0], vertices[static_cast<std::size_t>(i)])) << i;
            EXPECT_TRUE(i + 1 == hidden || is_at(drawn.corner[1], vertices[static_cast<std::size_t>(i + 1)]));
        }
        EXPECT_EQ(next, recorder.primitives.size());
    }
}

TEST_F(LineSinkAlone, LightsTheVerticesOfAGroupThatAreSeen) {
    glEnable(GL_LIGHTING);
    for (const GLenum model : {GL_SMOOTH, GL_FLAT})
        for (const int step : {1, 2}) {
            glShadeModel(model);
            begin(step == 1 ? GL_LINE_STRIP : GL_LINES);
            std::vector<Vertex> vertices = diagonal(6);
            WindowRecorder recorder;
            part_->lines(pointers(vertices).data(), 6, step, false);
            for (int i = 0; i < 6; ++i) {
                const bool provokes = step == 1 ? i > 0 : i % 2 == 1;
                EXPECT_EQ((vertices[static_cast<std::size_t>(i)].flags & gl::uncolored) == 0,
                          model == GL_SMOOTH || provokes)
                    << i;
            }
        }
}

/// The pattern starts anew with each line of LINES, and goes on from line to line of a strip (GL 1.3, 3.4.2).
TEST_F(LineSinkAlone, StartsTheStippleWithEachPrimitive) {
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(1, 0x00FF);
    begin(GL_LINES);
    EXPECT_EQ(row_of_lines({0, 4, 4, 20}, true), row("############........"));
    begin(GL_LINE_STRIP);
    EXPECT_EQ(row_of_lines({0, 4, 20}, false), row("########........####"));
    // Without begin_lines(), the strip goes on: the pattern is at bit 4.
    EXPECT_EQ(row_of_lines({0, 8}, false), row("####...."));
    begin(GL_LINE_STRIP);
    EXPECT_EQ(row_of_lines({0, 8}, false), row("########"));
}

TEST_F(LineSinkAlone, RepeatsEachBitOfTheStipple) {
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(3, 0x0005);
    begin(GL_LINE_STRIP);
    EXPECT_EQ(row_of_lines({0, 9}, false), row("###...###"));
    glLineStipple(256, 0x0002); // the first 256 fragments of the pattern are off
    begin(GL_LINE_STRIP);
    EXPECT_EQ(row_of_lines({0, 60}, false), row(""));
}

/// A wide line has the pattern of its width 1 in each row (GL 1.3, 3.4.2).
TEST_F(LineSinkAlone, StipplesAllRowsOfAWideLineAlike) {
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(2, 0x3333);
    glLineWidth(4);
    begin(GL_LINES);
    const std::string pattern = row_of_lines({0, 40}, true);
    EXPECT_EQ(pattern, row("####....####....####....####....####...."));
    int rows = 0;
    for (int y = 24; y < 40; ++y) {
        const std::vector<bool> drawn = row_of_picture(y);
        if (drawn == std::vector<bool>(size, false))
            continue;
        EXPECT_EQ(drawn, row_of_picture(32)) << y;
        ++rows;
    }
    EXPECT_EQ(rows, 4);
}

/// The token says where the stipple is reset. Both ends of a flat line have the colour of the second vertex.
TEST_F(LineSinkAlone, CapturesLinesWithTheirResets) {
    std::vector<GLfloat> words(256);
    glFeedbackBuffer(256, GL_3D_COLOR, words.data());
    glRenderMode(GL_FEEDBACK);
    const auto capture = [&] {
        for (const int to : {1, 2}) {
            glColor4f(to == 1 ? 0 : 0.5f, 0, 0, 1);
            part_->process(part_->vertex_slot_[0], 0, 0, 0);
            glColor4f(1, 0, 0, 1);
            part_->process(part_->vertex_slot_[1], 0.5f, 0, 0);
            part_->line(part_->vertex_slot_[0], part_->vertex_slot_[1]);
        }
    };
    begin(GL_LINE_STRIP);
    capture();
    begin(GL_LINES);
    capture();
    glShadeModel(GL_FLAT);
    begin(GL_LINE_STRIP);
    capture();
    begin(GL_LINES); // a line beyond a plane is not fed back
    part_->process(part_->vertex_slot_[0], 2, 0, 0);
    part_->process(part_->vertex_slot_[1], 3, 0, 0);
    part_->line(part_->vertex_slot_[0], part_->vertex_slot_[1]);
    constexpr std::size_t of_line = 15;
    ASSERT_EQ(glRenderMode(GL_RENDER), static_cast<GLint>(6 * of_line));
    const GLenum tokens[] = {GL_LINE_RESET_TOKEN, GL_LINE_TOKEN,       GL_LINE_RESET_TOKEN,
                             GL_LINE_RESET_TOKEN, GL_LINE_RESET_TOKEN, GL_LINE_TOKEN};
    const float first_red[] = {0, 0.5f, 0, 0.5f, 1, 1};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(words[of_line * i], static_cast<float>(tokens[i])) << i;
        EXPECT_NEAR(words[of_line * i + 4], first_red[i], 1e-6) << i;
        EXPECT_NEAR(words[of_line * i + 11], 1, 1e-6) << i;
    }
}

/// A wide line could draw beyond a viewport that is smaller than the window. It is therefore clipped to the
/// viewport itself, not to the guard band.
TEST_F(LineSinkAlone, EndsAWideLineAtTheEdgeOfASmallViewport) {
    glViewport(0, 0, 32, 64);
    for (const float width : {1.0f, 9.0f}) {
        glLineWidth(width);
        const std::vector<Primitive> lines = drawn({0, 0}, {3, 0});
        ASSERT_EQ(lines.size(), 1u);
        EXPECT_EQ(pixels(lines[0].corner[0].x), 16);
        EXPECT_EQ(pixels(lines[0].corner[1].x), width == 1 ? 64 : 32);
        begin(GL_LINES);
        line({0, 1 / 64.0f}, {3, 1 / 64.0f});
        EXPECT_TRUE(row_of_picture(32)[30]);
        EXPECT_FALSE(row_of_picture(32)[32]);
    }
}

TEST_F(LineSinkAlone, DrawsALineOfAnOutlineBetweenGivenWindowVertices) {
    begin(GL_TRIANGLES);
    std::vector<Vertex> ends = diagonal(3);
    raster::FixedVertex a = ends[0].window, b = ends[1].window;
    a.x += 256, b.y += 512;
    WindowRecorder recorder;
    part_->draw_line(ends[0], a, ends[1], b, ends[2].window);
    ASSERT_EQ(recorder.primitives.size(), 1u);
    EXPECT_EQ(recorder.primitives[0].corner[0].x, a.x);
    EXPECT_EQ(recorder.primitives[0].corner[1].y, b.y);
    EXPECT_TRUE(is_at(recorder.primitives[0].provoking, ends[2]));
}

} // namespace
} // namespace spangle::test
