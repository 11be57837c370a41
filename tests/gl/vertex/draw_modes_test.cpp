// The modes of a draw, derived from a context that nothing else uses.
#include <memory>

#include <gtest/gtest.h>

#include "gl/vertex/draw_modes.hpp"

namespace spangle::test {
namespace {

class DrawModesAlone : public testing::Test {
  protected:
    const std::unique_ptr<gl::Context> context_ = std::make_unique<gl::Context>();
    gl::PolygonState& polygon_ = context_->polygon;

    gl::DrawModes derived(GLenum mode, gl::DrawModes::Derived others = {}) const {
        gl::DrawModes modes;
        modes.derive(*context_, mode, others);
        return modes;
    }
};

TEST_F(DrawModesAlone, OfAnInitialContextAskForNothing) {
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
        const gl::DrawModes modes = derived(mode);
        EXPECT_EQ(modes.mode(), mode);
        EXPECT_FALSE(modes.is_lit() || modes.has_fog() || modes.is_flat_shaded() || modes.is_capturing());
        EXPECT_FALSE(modes.needs_vertex_state() || modes.needs_polygon_path() || modes.is_drawn_whole());
        EXPECT_FALSE(modes.has_special_points() || modes.has_special_lines() || modes.gathers_polygons());
        EXPECT_FALSE(modes.culls(false) || modes.culls(true) || modes.clips_to_view_volume());
        EXPECT_EQ(modes.units(), 0u);
        EXPECT_EQ(modes.point_size(), 1);
        EXPECT_EQ(modes.line_width(), 1);
    }
}

/// CullFace names the sides that are culled, and FrontFace the winding of the front (GL 1.3, 3.5.1).
TEST_F(DrawModesAlone, CullTheWindingOfASide) {
    for (const GLenum front : {GL_CCW, GL_CW})
        for (const GLenum culled : {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}) {
            polygon_.cull_face = true;
            polygon_.front_face = front;
            polygon_.cull_face_mode = culled;
            const gl::DrawModes modes = derived(GL_TRIANGLES);
            for (const bool clockwise : {false, true}) {
                const GLenum side = clockwise == (front == GL_CW) ? GL_FRONT : GL_BACK;
                EXPECT_EQ(modes.culls(clockwise), culled == GL_FRONT_AND_BACK || culled == side);
            }
        }
}

TEST_F(DrawModesAlone, RoundAndClampSizes) {
    const struct {
        float given;
        std::int32_t rounded;
    } sizes[] = {{0.25f, 1}, {1.4f, 1}, {2.6f, 3}, {64.0f, 64}, {1000.0f, 64}};
    for (const auto& size : sizes) {
        polygon_.point_size = polygon_.line_width = numeric::from_float(size.given);
        EXPECT_EQ(derived(GL_POINTS).point_size(), size.rounded);
        EXPECT_EQ(derived(GL_LINES).line_width(), size.rounded);
    }
}

TEST_F(DrawModesAlone, SendPolygonsTheLongWayForWhatOthersDerive) {
    EXPECT_TRUE(derived(GL_TRIANGLES, {true, false, false}).needs_polygon_path());
    EXPECT_TRUE(derived(GL_TRIANGLES, {false, false, true}).needs_polygon_path());
    EXPECT_FALSE(derived(GL_TRIANGLES, {false, true, false}).needs_polygon_path());
    EXPECT_TRUE(derived(GL_TRIANGLES, {false, true, false}).needs_vertex_state());
}

TEST_F(DrawModesAlone, OutlinesClipToTheViewVolumeExceptInSelection) {
    polygon_.mode[1] = GL_LINE;
    const gl::DrawModes drawn = derived(GL_QUADS);
    EXPECT_TRUE(drawn.has_outlines() && drawn.clips_to_view_volume() && drawn.is_drawn_whole());
    EXPECT_EQ(drawn.face_mode(0), static_cast<GLenum>(GL_FILL));
    EXPECT_EQ(drawn.face_mode(1), static_cast<GLenum>(GL_LINE));
    context_->render.mode = GL_SELECT;
    const gl::DrawModes selected = derived(GL_QUADS);
    EXPECT_FALSE(selected.has_outlines());
    EXPECT_TRUE(selected.is_capturing() && selected.clips_to_view_volume());
}

/// Feedback and antialiasing need a POLYGON as a whole, selection does not.
TEST_F(DrawModesAlone, GatherPolygons) {
    context_->render.mode = GL_SELECT;
    EXPECT_FALSE(derived(GL_POLYGON).gathers_polygons());
    context_->render.mode = GL_FEEDBACK;
    EXPECT_TRUE(derived(GL_POLYGON).gathers_polygons());
    context_->render.mode = GL_RENDER;
    polygon_.polygon_smooth = true;
    EXPECT_TRUE(derived(GL_POLYGON).gathers_polygons());
    EXPECT_TRUE(derived(GL_POLYGON).needs_vertex_state());
    EXPECT_FALSE(derived(GL_TRIANGLES).needs_vertex_state());
}

/// The size of points matters for points, and for outlines that are points.
TEST_F(DrawModesAlone, FollowTheSizeOfPointsWherePointsAreDrawn) {
    polygon_.point_attenuation[1] = numeric::one;
    EXPECT_TRUE(derived(GL_POINTS).has_special_points());
    EXPECT_FALSE(derived(GL_TRIANGLES).has_special_points());
    polygon_.mode[0] = GL_POINT;
    EXPECT_TRUE(derived(GL_TRIANGLES).has_special_points());
}

} // namespace
} // namespace spangle::test
