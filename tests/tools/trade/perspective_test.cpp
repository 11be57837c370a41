// Colours and fog follow the perspective in every tier. If 1/w varies much they are divided; if it varies
// little they are affine and cost nothing.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include <spangle/GL/gl.h>
#include <spangle/reference.hpp>
#include <spangle/tier.hpp>

#include "tests/support/headless_gl.hpp"

namespace spangle::test {
namespace {

using raster::Knobs;

constexpr int size = 64;

struct Slope {
    double ratio; ///< w of the far edge, if that of the near edge is 1
    bool fog = false, lines = false;
};

/// Draws a white plane in fog, or a plane from black to white. The plane covers the picture and leans away.
DrawnPicture picture_of(const Slope& slope, EGLint precision, const std::optional<Knobs>& knobs = {}) {
    const HeadlessGl gl(size, size,
                        {EGL_PRECISION_SPANGLE, precision, EGL_ALPHA_SIZE, 0, EGL_DEPTH_SIZE, 16});
    if (knobs) {
        EXPECT_TRUE(use_tier(*knobs));
    }
    const double r = slope.ratio;
    glDisable(GL_DITHER);
    if (slope.fog)
        glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, 1);
    glFogf(GL_FOG_END, static_cast<GLfloat>(r));
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 4096);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const auto paint = [&](float gray) { slope.fog ? glColor3f(1, 1, 1) : glColor3f(gray, gray, gray); };
    glBegin(slope.lines ? GL_LINES : GL_QUADS);
    const int count = slope.lines ? size : 1;
    for (int i = 0; i < count; ++i) {
        const double left = slope.lines ? (2 * i + 1.0) / size - 1 : -1, right = slope.lines ? left : 1;
        paint(0);
        glVertex3d(left, -1, -1);
        if (!slope.lines)
            glVertex3d(right, -1, -1);
        paint(1);
        glVertex3d(right * r, r, -r);
        if (!slope.lines)
            glVertex3d(left * r, r, -r);
    }
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    return read_picture();
}

double worst_of(const Slope& slope, EGLint shadow, const std::string& name) {
    const StageReport report;
    picture_of(slope, shadow);
    for (const StageError& stage : report.stages())
        if (name == stage.stage)
            return stage.worst;
    ADD_FAILURE() << "no stage " << name;
    return 1;
}

struct TierOf {
    EGLint shadow;
    double color, fog; ///< largest errors of colours and of fog
};
/// Balanced colours are within a quarter of a step of six bits. Colours and factors of 16 bits are rounded.
constexpr TierOf tiers[] = {{EGL_PRECISION_SHADOW_SPANGLE, 1e-4, 1e-4},
                            {EGL_PRECISION_SHADOW_BALANCED_SPANGLE, 1.0 / 255 + 3e-3, 1.0 / 512 + 1e-3},
                            {EGL_PRECISION_SHADOW_FAST_SPANGLE, 1.0 / 16 + 3e-3, 1.0 / 16 + 1e-3}};

struct Perspective : testing::Test {
    void SetUp() override { use_reference_engines(); }
};

TEST_F(Perspective, IsFollowedWithinTheBoundOfEachTier) {
    for (const double ratio : {1.01, 1.1, 1.2, 1.24, 1.26, 1.5, 2.0, 8.0, 100.0, 4000.0})
        for (const bool lines : {false, true})
            for (const TierOf& tier : tiers) {
                EXPECT_LE(worst_of({ratio, false, lines}, tier.shadow, "primary"), tier.color)
                    << "colours, w from 1 to " << ratio << ", precision " << tier.shadow;
                EXPECT_LE(worst_of({ratio, true, lines}, tier.shadow, "fog factor"), tier.fog)
                    << "fog, w from 1 to " << ratio << ", precision " << tier.shadow;
            }
}

/// In the fast tier a mild perspective divides nothing: its bytes are those of affine primitives.
TEST_F(Perspective, IsStraightInTheFastTierWhereItIsMild) {
    Knobs straight = raster::fast_knobs;
    straight.affine_color_bits = straight.affine_fog_bits = 0;
    for (const bool fog : {false, true})
        for (const double ratio : {1.0, 1.1, 1.2, 1.24, 1.3, 2.0, 100.0}) {
            const Slope slope{ratio, fog};
            const auto drawn = picture_of(slope, EGL_PRECISION_FAST_SPANGLE).rgba,
                       affine = picture_of(slope, EGL_PRECISION_FAST_SPANGLE, straight).rgba;
            EXPECT_EQ(drawn == affine, ratio < 1.25)
                << (fog ? "fog" : "colours") << ", w from 1 to " << ratio;
        }
}

/// A frame of the fast tier keeps its promise of 22 dB in every perspective.
TEST_F(Perspective, KeepsThePromiseOfTheFastTier) {
    for (const bool fog : {false, true})
        for (const double ratio : {1.2, 1.25, 2.0, 30.0, 4000.0}) {
            const Slope slope{ratio, fog};
            const DrawnPicture fast = picture_of(slope, EGL_PRECISION_FAST_SPANGLE);
            const PictureError error = compare(fast, picture_of(slope, EGL_PRECISION_DOUBLE_SPANGLE));
            EXPECT_GE(error.psnr_565(), 24) << (fog ? "fog" : "colours") << ", w from 1 to " << ratio;
        }
}

} // namespace
} // namespace spangle::test
