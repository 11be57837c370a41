// The sink of primitives alone: what it draws of complete primitives, and which corners it colours.
#include <memory>

#include "gl/vertex/primitive_sink.hpp"
#include "tests/gl/vertex/vertex_parts.hpp"
#include "tests/gl/vertex/window_recorder.hpp"

namespace spangle::test {
namespace {

using PrimitiveSink = gl::PrimitiveSink<gl::FixedMath, gl::FixedLighting>;

class PrimitiveSinkAlone : public VertexParts {
  protected:
    const std::unique_ptr<Alone<PrimitiveSink>> part_ = std::make_unique<Alone<PrimitiveSink>>();
    Vertex* corner_[4] = {};

    /// Processes the corners of a square that is drawn counter-clockwise, from the lower left one on.
    void begin_square(GLenum mode, float x = 0) {
        part_->begin(mode);
        part_->begin_lines(*gl::current_context());
        for (int i = 0; i < 4; ++i) {
            corner_[i] = &part_->vertex_slot_[i];
            part_->process(*corner_[i], x + (i == 1 || i == 2 ? 0.5f : 0.0f), i >= 2 ? 0.5f : 0.0f, 0);
        }
    }
};

TEST_F(PrimitiveSinkAlone, DrawsATriangleProvokedByItsLastCorner) {
    WindowRecorder recorder;
    begin_square(GL_TRIANGLES);
    part_->triangle(corner_);
    ASSERT_EQ(recorder.primitives.size(), 1u);
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(is_at(recorder.primitives[0].corner[i], *corner_[i])) << i;
    EXPECT_TRUE(is_at(recorder.primitives[0].provoking, *corner_[2]));
}

TEST_F(PrimitiveSinkAlone, DividesAQuadFromItsFirstCornerToItsProvokingOne) {
    WindowRecorder recorder;
    begin_square(GL_QUADS);
    part_->quad(corner_);
    ASSERT_EQ(recorder.primitives.size(), 2u);
    for (const Primitive& drawn : recorder.primitives) {
        EXPECT_TRUE(is_at(drawn.corner[0], *corner_[0]));
        EXPECT_TRUE(is_at(drawn.provoking, *corner_[2]));
    }
    EXPECT_TRUE(is_at(recorder.primitives[0].corner[1], *corner_[1]));
    EXPECT_TRUE(is_at(recorder.primitives[1].corner[2], *corner_[3]));
}

TEST_F(PrimitiveSinkAlone, ColorsNoCornerOfAFaceThatIsCulled) {
    glEnable(GL_LIGHTING);
    glEnable(GL_CULL_FACE);
    for (const GLenum culled : {GL_FRONT, GL_BACK}) {
        glCullFace(culled);
        WindowRecorder recorder;
        begin_square(GL_QUADS);
        part_->quad(corner_);
        part_->triangle(corner_);
        EXPECT_EQ(recorder.primitives.size(), culled == GL_FRONT ? 0u : 3u);
        for (const Vertex* corner : corner_)
            EXPECT_EQ((corner->flags & gl::uncolored) != 0, culled == GL_FRONT);
    }
}

TEST_F(PrimitiveSinkAlone, ColorsOnlyTheProvokingCornerOfAFlatFace) {
    glEnable(GL_LIGHTING);
    glShadeModel(GL_FLAT);
    WindowRecorder recorder;
    begin_square(GL_QUADS);
    part_->quad(corner_);
    for (const Vertex* corner : corner_)
        EXPECT_EQ((corner->flags & gl::uncolored) == 0, corner == corner_[2]);
}

TEST_F(PrimitiveSinkAlone, DrawsNothingOutsideOfTheViewVolume) {
    WindowRecorder recorder;
    begin_square(GL_QUADS, 1.5f);
    part_->quad(corner_);
    part_->triangle(corner_);
    part_->fan(corner_);
    part_->line(*corner_[0], *corner_[1]);
    part_->point(*corner_[0]);
    EXPECT_EQ(recorder.primitives.size(), 0u);
}

/// A face that leaves the guard band takes the way through polygon() and the clipper.
TEST_F(PrimitiveSinkAlone, DrawsWhatClippingLeaves) {
    WindowRecorder recorder;
    begin_square(GL_TRIANGLES);
    part_->process(*corner_[1], 9, 0, 0);
    part_->triangle(corner_);
    ASSERT_EQ(recorder.primitives.size(), 2u);
    for (const Primitive& drawn : recorder.primitives)
        EXPECT_TRUE(is_at(drawn.provoking, *corner_[2]));
}

TEST_F(PrimitiveSinkAlone, DrawsTheBoundaryOfAnOutlinedFan) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    WindowRecorder recorder;
    begin_square(GL_POLYGON);
    for (Vertex* corner : corner_)
        corner->flags |= gl::edge_flag;
    part_->outlined_fan(corner_, true, false);
    ASSERT_EQ(recorder.primitives.size(), 2u);
    EXPECT_TRUE(is_at(recorder.primitives[0].corner[1], *corner_[1]));
    EXPECT_TRUE(is_at(recorder.primitives[1].corner[1], *corner_[2]));
}

} // namespace
} // namespace spangle::test
