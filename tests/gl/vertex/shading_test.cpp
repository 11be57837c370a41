// Shading alone: when vertices are lit, and with which material.
#include <memory>

#include "gl/vertex/shading.hpp"
#include "tests/gl/vertex/vertex_parts.hpp"

namespace spangle::test {
namespace {

using Shading = gl::Shading<gl::FixedMath, gl::FixedLighting>;

class ShadingAlone : public VertexParts {
  protected:
    const std::unique_ptr<Alone<Shading>> part_ = std::make_unique<Alone<Shading>>();

    static void set_emission(float red) {
        const GLfloat emission[4] = {red, 0, 0, 1};
        glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission);
    }
};

TEST_F(ShadingAlone, DerivesOnlyWhatChanged) {
    EXPECT_EQ(part_->begin(GL_POINTS), gl::Stale::all);
    EXPECT_EQ(part_->begin(GL_POINTS), gl::Stale::nothing);
    glTranslatef(1, 0, 0);
    EXPECT_EQ(part_->begin(GL_POINTS), gl::Stale::all);
    EXPECT_EQ(part_->begin(GL_POINTS), gl::Stale::nothing);
    set_emission(0.5f);
    EXPECT_EQ(part_->begin(GL_POINTS), gl::Stale::nothing); // the material of unlit vertices does not matter
    glEnable(GL_LIGHTING);
    EXPECT_EQ(part_->begin(GL_POINTS), gl::Stale::all);
    set_emission(0.25f);
    EXPECT_EQ(part_->begin(GL_POINTS), gl::Stale::colors);
}

TEST_F(ShadingAlone, GivesUnlitVerticesTheCurrentColor) {
    part_->begin(GL_TRIANGLES);
    Vertex v;
    for (const float color : {0.25f, 0.75f, 0.75f, 0.5f}) {
        glColor4f(color, 0, 0, 1);
        part_->process(v, 0, 0, 0);
        EXPECT_EQ(v.flags & gl::uncolored, 0u);
        EXPECT_NEAR(red(v.window), color, 1e-4);
    }
}

TEST_F(ShadingAlone, LightsAVertexOnceAndOnlyWhenAsked) {
    glEnable(GL_LIGHTING);
    set_emission(0.25f);
    part_->begin(GL_TRIANGLES);
    Vertex v;
    part_->process(v, 0, 0, 0);
    EXPECT_NE(v.flags & gl::uncolored, 0u);
    part_->color(v);
    EXPECT_EQ(v.flags & gl::uncolored, 0u);
    const float lit = red(v.window);
    set_emission(0.75f);
    part_->begin(GL_TRIANGLES);
    part_->color(v);
    EXPECT_EQ(red(v.window), lit);
    v.flags |= gl::uncolored;
    part_->color(v);
    EXPECT_NEAR(red(v.window), lit + 0.5f, 1e-3);
}

/// The corners that wait for a complete primitive keep the material of their time.
TEST_F(ShadingAlone, SettlesTheColorsOfTheCornersThatWait) {
    glEnable(GL_LIGHTING);
    set_emission(0.25f);
    part_->begin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i)
        part_->process(part_->vertex_slot_[i], 0, 0, 0);
    part_->assembler_.take_next();
    part_->assembler_.take_next();
    part_->settle_colors();
    set_emission(0.75f);
    part_->begin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i)
        part_->color(part_->vertex_slot_[i]);
    EXPECT_EQ(red(part_->vertex_slot_[0].window), red(part_->vertex_slot_[1].window));
    EXPECT_NEAR(red(part_->vertex_slot_[2].window), red(part_->vertex_slot_[0].window) + 0.5f, 1e-3);
}

} // namespace
} // namespace spangle::test
