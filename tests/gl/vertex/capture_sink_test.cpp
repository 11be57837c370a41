// The sink of captured primitives alone: the hits of selection, and the words of feedback.
#include <memory>
#include <vector>

#include "gl/vertex/capture_sink.hpp"
#include "tests/gl/vertex/vertex_parts.hpp"

namespace spangle::test {
namespace {

using CaptureSink = gl::CaptureSink<gl::FixedMath, gl::FixedLighting>;
using ClippedVertex = CaptureSink::ClippedVertex;

class CaptureSinkAlone : public VertexParts {
  protected:
    using Words = std::vector<GLfloat>;
    static constexpr GLfloat untouched = -7;

    const std::unique_ptr<Alone<CaptureSink>> part_ = std::make_unique<Alone<CaptureSink>>();
    Words buffer_ = Words(64, untouched);

    void begin_feedback(GLenum type, GLsizei room = 64) {
        glFeedbackBuffer(room, type, buffer_.data());
        glRenderMode(GL_FEEDBACK);
        part_->begin(GL_TRIANGLES);
    }
    /// The words of feedback.
    Words ended() {
        const GLint count = glRenderMode(GL_RENDER);
        EXPECT_GE(count, 0);
        return {buffer_.begin(), buffer_.begin() + count};
    }
    Vertex& vertex(int slot, float x, float y, float z, float w = 1) {
        part_->process(part_->vertex_slot_[slot], x, y, z, w);
        return part_->vertex_slot_[slot];
    }
    void capture(const Vertex& v) { part_->capture_vertex({v, v.window}); }
    static gl::SelectState& select() { return gl::current_context()->render.select; }
};

TEST_F(CaptureSinkAlone, RecordsTheDepthsOfAllCornersOfAHit) {
    GLuint hits[16] = {};
    glSelectBuffer(16, hits);
    glRenderMode(GL_SELECT);
    part_->begin(GL_TRIANGLES);
    part_->begin_capture(GL_POLYGON_TOKEN, 3);
    EXPECT_FALSE(select().hit); // a token is no hit
    capture(vertex(0, 0, 0, 0));
    EXPECT_TRUE(select().hit);
    EXPECT_EQ(select().nearest, select().farthest);
    EXPECT_NEAR(select().nearest, 0x1p31, 4);
    capture(vertex(1, 0, 0, 0.5f));
    EXPECT_NEAR(select().farthest, 0.75 * 0x1p32, 4);
    capture(vertex(2, 0, 0, -0.5f));
    EXPECT_NEAR(select().nearest, 0.25 * 0x1p32, 4);
    EXPECT_NEAR(select().farthest, 0.75 * 0x1p32, 4);
    EXPECT_EQ(glRenderMode(GL_RENDER), 1);
    EXPECT_EQ(hits[0], 0u);
    EXPECT_NEAR(hits[1], 0.25 * 0x1p32, 4);
    EXPECT_NEAR(hits[2], 0.75 * 0x1p32, 4);
}

/// Window z is multiplied by 2^32 - 1 (GL 1.3, 5.2).
TEST_F(CaptureSinkAlone, RecordsTheEndsOfTheDepthRange) {
    GLuint hits[16] = {};
    glSelectBuffer(16, hits);
    for (const bool reversed : {false, true}) {
        glDepthRange(reversed ? 1 : 0, reversed ? 0 : 1);
        for (const float z : {-1.0f, 1.0f}) {
            glRenderMode(GL_SELECT);
            part_->begin(GL_POINTS);
            capture(vertex(0, 0, 0, z));
            EXPECT_EQ(glRenderMode(GL_RENDER), 1);
            EXPECT_EQ(hits[1], (z > 0) != reversed ? 0xFFFFFFFFu : 0u);
            EXPECT_EQ(hits[2], hits[1]);
        }
    }
}

TEST_F(CaptureSinkAlone, CountsTheCornersOfPolygonsOnly) {
    begin_feedback(GL_2D);
    for (const GLenum token :
         {GL_POINT_TOKEN, GL_LINE_TOKEN, GL_LINE_RESET_TOKEN, GL_POLYGON_TOKEN, GL_BITMAP_TOKEN})
        part_->begin_capture(token, 5);
    EXPECT_EQ(ended(), (Words{GL_POINT_TOKEN, GL_LINE_TOKEN, GL_LINE_RESET_TOKEN, GL_POLYGON_TOKEN, 5,
                              GL_BITMAP_TOKEN}));
}

/// Table 5.1 of GL 1.3 says which values a vertex has in each type of feedback.
TEST_F(CaptureSinkAlone, WritesTheValuesOfEachTypeOfFeedback) {
    glViewport(0, 0, 32, 16);
    glColor4f(1, 0.5f, 0.25f, 0.75f);
    glMultiTexCoord4f(GL_TEXTURE0, 2, 3, 4, 5);
    const Words all = {24, 4, 0.5f, 2, 1, 0.5f, 0.25f, 0.75f, 2, 3, 4, 5};
    const struct {
        GLenum type;
        std::vector<std::size_t> values;
    } types[] = {
        {GL_2D, {0, 1}},
        {GL_3D, {0, 1, 2}},
        {GL_3D_COLOR, {0, 1, 2, 4, 5, 6, 7}},
        {GL_3D_COLOR_TEXTURE, {0, 1, 2, 4, 5, 6, 7, 8, 9, 10, 11}},
        {GL_4D_COLOR_TEXTURE, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}},
    };
    for (const auto& type : types) {
        begin_feedback(type.type);
        capture(vertex(2, 1, -1, 0, 2)); // w is 2
        const Words words = ended();
        ASSERT_EQ(words.size(), type.values.size()) << type.type;
        for (std::size_t i = 0; i < words.size(); ++i)
            EXPECT_NEAR(words[i], all[type.values[i]], 1e-6) << type.type << ", value " << i;
    }
}

TEST_F(CaptureSinkAlone, WritesTheColorOfTheSideThatIsSeen) {
    glColor4f(0, 0, 0, 1);
    begin_feedback(GL_3D_COLOR);
    const Vertex& v = vertex(0, 0, 0, 0);
    raster::FixedVertex back = v.window;
    const numeric::Real white[4] = {numeric::one, numeric::one, numeric::one, numeric::one};
    gl::FixedMath::set_color(back, white);
    back.x = back.y = 12345; // the place is that of the vertex
    part_->capture_vertex({v, back});
    EXPECT_EQ(ended(), (Words{32, 32, 0.5f, 1, 1, 1, 1}));
}

TEST_F(CaptureSinkAlone, KnowsTheCoordinatesOfEachSlot) {
    begin_feedback(GL_4D_COLOR_TEXTURE);
    for (int slot = 0; slot < 4; ++slot) {
        glTexCoord2f(static_cast<GLfloat>(slot), static_cast<GLfloat>(10 * slot));
        vertex(slot, 0, 0, 0);
    }
    for (int slot = 3; slot >= 0; --slot)
        capture(part_->vertex_slot_[slot]);
    const Words words = ended();
    ASSERT_EQ(words.size(), 48u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(words[12 * i + 8], static_cast<float>(3 - i));
        EXPECT_EQ(words[12 * i + 9], static_cast<float>(10 * (3 - i)));
    }
}

/// A vertex that clipping made has its values in the middle of the edge, not those of a slot.
TEST_F(CaptureSinkAlone, WritesTheValuesThatClippingMixed) {
    begin_feedback(GL_4D_COLOR_TEXTURE);
    glColor4f(0, 0, 0, 1);
    glTexCoord4f(0, 2, 0, 1);
    Vertex& a = vertex(0, 0, 0, -0.5f);
    glColor4f(1, 1, 0, 1);
    glTexCoord4f(1, 4, 0, 3);
    Vertex& b = vertex(1, 2, 0, 0.5f);
    Vertex* ends[2] = {&a, &b};
    ASSERT_TRUE(part_->clip_line(ends));
    EXPECT_NE(ends[1]->flags & gl::is_clipped_vertex, 0u);
    EXPECT_NE(ends[1]->flags & gl::unprojected, 0u);
    ASSERT_TRUE(part_->project(*ends[1]));
    capture(*ends[1]);
    const Words expected = {64, 32, 0.5f, 1, 0.5f, 0.5f, 0, 1, 0.5f, 3, 0, 2}, words = ended();
    ASSERT_EQ(words.size(), expected.size());
    for (std::size_t i = 0; i < words.size(); ++i)
        EXPECT_NEAR(words[i], expected[i], 1e-6) << i;
}

/// A full buffer is an overflow, and no word behind it changes.
TEST_F(CaptureSinkAlone, WritesNothingBehindTheBuffer) {
    for (const GLsizei room : {0, 1, 3, 4}) {
        buffer_.assign(64, untouched);
        begin_feedback(GL_3D, room);
        part_->begin_capture(GL_POINT_TOKEN, 1);
        capture(vertex(0, 0, 0, 0));
        EXPECT_EQ(glRenderMode(GL_RENDER), room == 4 ? 4 : -1) << room;
        for (std::size_t i = static_cast<std::size_t>(room); i < buffer_.size(); ++i)
            ASSERT_EQ(buffer_[i], untouched) << "room for " << room << ", word " << i;
    }
}

} // namespace
} // namespace spangle::test
