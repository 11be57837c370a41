// A context of shadow precision draws the exact tier's picture to the byte, and reports every stage within
// its bounds (docs/trade.md), through lighting, texturing, fog and clipping.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <spangle/GL/gl.h>
#include <spangle/reference.hpp>

#include "raster/reference/shadow.hpp"
#include "tests/support/headless_gl.hpp"

namespace spangle::test {
namespace {

using raster::ShadowReport;
using Stage = raster::ShadowStage;

constexpr int size = 64;

void enable_everything() {
    const GLfloat position[] = {1, 2, 3, 1}, shine[] = {0.4f, 0.5f, 0.6f, 1}, fog[] = {0.1f, 0.2f, 0.3f, 1};
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1.5, 20);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -4);
    for (GLenum what : {GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_TEXTURE_2D, GL_FOG, GL_BLEND, GL_NORMALIZE})
        glEnable(what);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.05f);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glFogfv(GL_FOG_COLOR, fog);
    glFogf(GL_FOG_DENSITY, 0.2f);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    std::vector<GLubyte> texels(16 * 16 * 4);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = static_cast<GLubyte>(i * 29 + i / 16);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

/// Draws a sphere without its poles, where triangles are too thin for exact gradients
/// (Setup<Fixed>::thin_aspect). The sphere leaves the view volume through the near plane and the guard band.
void draw_ball() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    constexpr int n = 9;
    for (int i = 0; i < n; ++i) {
        glBegin(GL_QUAD_STRIP);
        for (int j = 0; j <= n; ++j)
            for (int k = 0; k < 2; ++k) {
                const float a = 0.2f + static_cast<float>(i + k) * 0.3f, b = static_cast<float>(j) * 0.7f;
                const float x = std::sin(a) * std::cos(b), y = std::cos(a), z = std::sin(a) * std::sin(b);
                glNormal3f(x, y, z);
                glTexCoord2f(b, a);
                glVertex3f(x * 2.6f, y * 2.6f, z * 2.6f);
            }
        glEnd();
    }
    glBegin(GL_TRIANGLES); // clipped at the guard band
    glVertex3f(-1, -1, 0);
    glVertex3f(90, -1, 0);
    glVertex3f(-1, 80, 2);
    glEnd();
}

/// Returns the bytes and depths of the picture.
std::vector<GLuint> picture_of(EGLint precision) {
    const HeadlessGl gl(size, size, {EGL_PRECISION_SPANGLE, precision});
    enable_everything();
    draw_ball();
    std::vector<GLuint> out(2 * size * size);
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    glReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_FLOAT, out.data() + size * size);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    return out;
}

struct ShadowContexts : testing::Test {
    void SetUp() override { use_reference_engines(); }
};

TEST_F(ShadowContexts, DrawThePictureOfTheirTier) {
    const EGLint tiers[][2] = {{EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_SHADOW_SPANGLE},
                               {EGL_PRECISION_BALANCED_SPANGLE, EGL_PRECISION_SHADOW_BALANCED_SPANGLE},
                               {EGL_PRECISION_FAST_SPANGLE, EGL_PRECISION_SHADOW_FAST_SPANGLE}};
    double texels = 0;
    for (const auto& [tier, shadow] : tiers) {
        const std::vector<GLuint> picture = picture_of(tier);
        ShadowReport report;
        EXPECT_EQ(raster::report_shadow(&report), nullptr);
        EXPECT_EQ(picture_of(shadow), picture);
        EXPECT_EQ(raster::report_shadow(nullptr), &report);
        EXPECT_EQ(picture_of(shadow), picture); // the picture is the same if no report is asked for
        EXPECT_NE(picture.front(), picture[size * size / 2 + size / 2]);
        EXPECT_GT(report[Stage::coord0].rms(), texels); // this tier's error is above that of the tier before
        texels = report[Stage::coord0].rms();
    }
}

TEST_F(ShadowContexts, EveryStageIsReportedWithinItsBound) {
    ShadowReport r;
    raster::report_shadow(&r);
    picture_of(EGL_PRECISION_SHADOW_SPANGLE);
    raster::report_shadow(nullptr);
    const struct {
        Stage stage;
        /// The largest allowed error. It includes 2^-18 of an attribute's range, for steep planes.
        double bound;
    } cases[] = {
        {Stage::vertex_color, 0x1p-19},
        {Stage::vertex_coord, 0x1p-20},
        {Stage::vertex_fog, 0x1p-27},
        {Stage::window_x, 0.5 / 256 + 1e-5},
        {Stage::window_y, 0.5 / 256 + 1e-5},
        {Stage::snapping, 1.0},
        {Stage::window_z, 0x1p-26},
        {Stage::inverse_w, 0x1p-26},
        {Stage::depth, 0x1p-18},
        {Stage::primary, 0x1p-18},
        {Stage::coord0, 1.0 / 64},
        {Stage::fog_factor, 0x1p-20},
    };
    for (const auto& c : cases) {
        EXPECT_GT(r[c.stage].count, 100u) << name_of(c.stage);
        EXPECT_LE(r[c.stage].worst, c.bound) << name_of(c.stage);
        EXPECT_LE(r[c.stage].rms(), r[c.stage].worst) << name_of(c.stage);
    }
    // Snapping is off by half a step at worst, and uniformly, so its RMS is 1 / (256 sqrt(12)) pixels.
    EXPECT_NEAR(r[Stage::window_x].rms(), 1.0 / 256 / std::sqrt(12.0), 1e-4);
    EXPECT_LT(r[Stage::snapping].rms(), 0.05);       // hardly any vertex falls on the other side of a step
    EXPECT_GT(r[Stage::vertex_color].saturated, 0u); // alpha is 1 everywhere, which is a limit of the range
    EXPECT_EQ(r[Stage::window_x].saturated, 0u);
    EXPECT_LT(r[Stage::window_x].least, 0.0);
    EXPECT_GT(r[Stage::window_x].greatest, 64.0);
}

} // namespace
} // namespace spangle::test
