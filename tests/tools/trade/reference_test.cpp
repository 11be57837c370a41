// Tests spangle/reference.hpp: figures of pictures, and reports of stages that agree with the pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <spangle/GL/gl.h>
#include <spangle/reference.hpp>

#include "tests/support/headless_gl.hpp"

namespace spangle::test {
namespace {

constexpr int size = 128;

/// Draws a plane that goes into the distance at the upper right, with 64 x 64 texels of different colours.
void draw_texels(GLenum wrap) {
    std::vector<GLubyte> texels;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (const int v : {4 * x, 4 * y, 0, 255})
                texels.push_back(static_cast<GLubyte>(v));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, axis, static_cast<GLint>(wrap));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glDisable(GL_DITHER);
    glEnable(GL_DEPTH_TEST);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 16);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    glTexCoord2f(0, 0);
    glVertex3f(-1.1f, -1, -1.3f);
    glTexCoord2f(1, 0);
    glVertex3f(3, -2, -4.1f);
    glTexCoord2f(0, 1);
    glVertex3f(0.2f, 5, -6.3f);
    glEnd();
}

DrawnPicture picture_of(EGLint precision, GLenum wrap, int alpha = 8) {
    const HeadlessGl gl(size, size, {EGL_PRECISION_SPANGLE, precision, EGL_ALPHA_SIZE, alpha});
    draw_texels(wrap);
    DrawnPicture picture = read_picture();
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    return picture;
}

struct Tier {
    const char* name;
    EGLint plain, shadow;
    double bound; ///< in texels; the fast tier has no bound
};
constexpr Tier tiers[] = {
    {"exact", EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_SHADOW_SPANGLE, 0x1p-10},
    {"balanced", EGL_PRECISION_BALANCED_SPANGLE, EGL_PRECISION_SHADOW_BALANCED_SPANGLE, 0.26},
    {"fast", EGL_PRECISION_FAST_SPANGLE, EGL_PRECISION_SHADOW_FAST_SPANGLE, 64}};

struct Reference : testing::Test {
    void SetUp() override { use_reference_engines(); }
};

std::uint64_t different(const DrawnPicture& a, const DrawnPicture& b) {
    std::uint64_t n = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        n += std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]) ? 0 : 1;
    return n;
}

/// Each texel has a colour of its own, so each pixel of another colour is a flip, and each flip is such a
/// pixel. Clamped coordinates beyond the image name one texel, whatever they are.
TEST_F(Reference, FlipsOfTexelsAreThePixelsThatDiffer) {
    for (const GLenum wrap : {GL_REPEAT, GL_CLAMP_TO_EDGE}) {
        const DrawnPicture reference = picture_of(EGL_PRECISION_DOUBLE_SPANGLE, wrap);
        double worst = 0;
        for (const Tier& tier : tiers) {
            const DrawnPicture picture = picture_of(tier.plain, wrap);
            const StageReport report;
            EXPECT_EQ(picture_of(tier.shadow, wrap).rgba, picture.rgba) << tier.name;
            for (const StageError& stage : report.stages())
                if (std::string(stage.stage) == "coord 0") {
                    EXPECT_EQ(stage.flips, different(picture, reference)) << tier.name;
                    EXPECT_GT(stage.count, 1000u);
                    EXPECT_GE(stage.worst, worst) << tier.name << " is closer than the tier before";
                    worst = stage.worst;
                    EXPECT_LE(worst, tier.bound) << tier.name;
                } else {
                    EXPECT_EQ(stage.flips, 0u) << stage.stage;
                }
        }
        EXPECT_GT(worst, 0.5) << "sixteen pixels of this plane are no straight line";
    }
}

/// Tests what docs/trade.md says about the hint.
TEST_F(Reference, HintsChooseTheTierWithinAFrame) {
    const auto hinted = [](EGLint precision, GLenum hint) {
        const HeadlessGl gl(size, size, {EGL_PRECISION_SPANGLE, precision});
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, hint);
        draw_texels(GL_REPEAT);
        return read_picture().rgba;
    };
    const auto plain = [](EGLint precision) { return picture_of(precision, GL_REPEAT).rgba; };
    const auto exact = plain(EGL_PRECISION_EXACT_SPANGLE), balanced = plain(EGL_PRECISION_BALANCED_SPANGLE),
               fast = plain(EGL_PRECISION_FAST_SPANGLE);
    EXPECT_NE(exact, balanced);
    EXPECT_NE(balanced, fast);
    EXPECT_EQ(hinted(EGL_PRECISION_FAST_SPANGLE, GL_NICEST), exact);
    EXPECT_EQ(hinted(EGL_PRECISION_EXACT_SPANGLE, GL_FASTEST), fast);
    EXPECT_EQ(hinted(EGL_PRECISION_BALANCED_SPANGLE, GL_DONT_CARE), balanced);
}

TEST_F(Reference, ReportsOfStagesBeginAndEnd) {
    const StageReport outer;
    {
        StageReport inner;
        picture_of(EGL_PRECISION_SHADOW_SPANGLE, GL_REPEAT);
        EXPECT_FALSE(inner.stages().empty());
        inner.clear();
        EXPECT_TRUE(inner.stages().empty());
    }
    EXPECT_TRUE(outer.stages().empty()) << "the inner one collects";
    picture_of(EGL_PRECISION_SHADOW_SPANGLE, GL_REPEAT);
    const std::vector<StageError> stages = outer.stages();
    EXPECT_GT(stages.size(), 5u);
    picture_of(EGL_PRECISION_EXACT_SPANGLE, GL_REPEAT);
    EXPECT_EQ(outer.stages().front().count, stages.front().count) << "only SHADOW contexts report";
}

TEST_F(Reference, PicturesAreReadWhateverTheStateIs) {
    const HeadlessGl gl(size, size);
    draw_texels(GL_REPEAT);
    const DrawnPicture plain = read_picture();
    glPixelStorei(GL_PACK_ROW_LENGTH, 3 * size);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 5);
    glPixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
    glPixelTransferf(GL_RED_SCALE, 0.25f);
    glPixelTransferf(GL_DEPTH_BIAS, 0.5f);
    glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
    const DrawnPicture odd = read_picture();
    EXPECT_EQ(plain.rgba, odd.rgba);
    EXPECT_EQ(plain.depth, odd.depth);
    GLint row = 0, map = 0;
    GLfloat scale = 0;
    glGetIntegerv(GL_PACK_ROW_LENGTH, &row);
    glGetIntegerv(GL_MAP_COLOR, &map);
    glGetFloatv(GL_RED_SCALE, &scale);
    EXPECT_EQ(row, 3 * size);
    EXPECT_EQ(map, GL_TRUE);
    EXPECT_EQ(scale, 0.25f) << "the state is as it was";
    EXPECT_EQ(*std::max_element(plain.depth.begin(), plain.depth.end()), (1u << plain.depth_bits) - 1);
}

TEST(PictureFigures, CountStepsDecibelsAndDepths) {
    DrawnPicture a;
    a.width = 2;
    a.height = 2;
    a.depth_bits = 16;
    a.rgba = {0, 0, 0, 0, 8, 4, 8, 255, 255, 255, 255, 0, 7, 3, 7, 1};
    a.depth = {0, 100, 200, 65535};
    DrawnPicture b = a;
    EXPECT_EQ(compare(a, b).psnr_888(), PictureError::alike);
    b.rgba[0] = 7;   // still the same 565 colour
    b.rgba[9] = 251; // differs by one step of green
    b.rgba[15] = 9;  // alpha is not compared
    b.depth = {3, 100 + one_surface + 1, 200, 65535};
    const PictureError e = compare(a, b);
    EXPECT_EQ(e.pixels, 4u);
    EXPECT_EQ(e.identical, 3u);
    EXPECT_EQ(e.max_lsb, 1);
    EXPECT_EQ(e.max_255, 7);
    EXPECT_EQ(e.depth_steps, 3u);
    EXPECT_EQ(e.order_flips, 1u);
    EXPECT_DOUBLE_EQ(e.squares_888, 7 * 7 + 4 * 4);
    EXPECT_NEAR(e.psnr_565(), 10 * std::log10(63.0 * 63.0 * 12), 1e-9);
    EXPECT_NEAR(e.psnr_888(), 10 * std::log10(255.0 * 255.0 * 12 / 65), 1e-9);
    const std::vector<bool> mask = {true, false, true, false};
    const PictureError part = compare(a, b, &mask);
    EXPECT_EQ(part.pixels, 2u);
    EXPECT_EQ(part.order_flips, 0u);
    PictureError sum = part;
    sum.add(e);
    EXPECT_EQ(sum.pixels, 6u);
    EXPECT_EQ(sum.order_flips, 1u);
    b.width = 1;
    EXPECT_EQ(compare(a, b).pixels, 0u);
}

} // namespace
} // namespace spangle::test
