// Tests tiers that a program composes (spangle/tier.hpp). Each knob does what it says, in the tier's bytes
// and in the shadow's, and the three tiers are defined by their knobs alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
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
using raster::Runs;

constexpr int size = 64;

struct Wish {
    EGLint precision = EGL_PRECISION_EXACT_SPANGLE;
    std::optional<Knobs> knobs;
    bool dither = false, blend = false, fog = false, textured = true;
    GLenum env = GL_REPLACE, wrap = GL_REPEAT, hint = GL_DONT_CARE;
};

/// Draws a plane that goes into the distance, textured, with a colour at each vertex, in 565.
DrawnPicture picture_of(const Wish& wish) {
    const HeadlessGl gl(size, size,
                        {EGL_PRECISION_SPANGLE, wish.precision, EGL_ALPHA_SIZE, 0, EGL_DEPTH_SIZE, 16});
    if (wish.knobs) {
        EXPECT_TRUE(use_tier(*wish.knobs));
    }
    std::vector<GLubyte> texels;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (const int v : {4 * x, 4 * y, 255 - 2 * (x + y)})
                texels.push_back(static_cast<GLubyte>(v));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, axis, static_cast<GLint>(wish.wrap));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(wish.env));
    if (wish.textured)
        glEnable(GL_TEXTURE_2D);
    (wish.dither ? glEnable : glDisable)(GL_DITHER);
    if (wish.blend)
        glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if (wish.fog)
        glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_END, 8);
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, wish.hint);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 16);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    glColor4f(1, 0.2f, 0.1f, 0.7f);
    glTexCoord2f(0, 0);
    glVertex3f(-1.1f, -1, -1.3f);
    glColor4f(0.3f, 1, 0.4f, 0.4f);
    glTexCoord2f(1, 0);
    glVertex3f(3, -2, -4.1f);
    glColor4f(0.1f, 0.5f, 1, 0.9f);
    glTexCoord2f(0, 1);
    glVertex3f(0.2f, 5, -6.3f);
    glEnd();
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    return read_picture();
}

struct Tier {
    EGLint precision;
    Knobs knobs;
};
constexpr Tier tiers[] = {{EGL_PRECISION_EXACT_SPANGLE, raster::exact_knobs},
                          {EGL_PRECISION_BALANCED_SPANGLE, raster::balanced_knobs},
                          {EGL_PRECISION_FAST_SPANGLE, raster::fast_knobs}};

/// Returns everything that is drawn differently from tier to tier.
std::vector<Wish> wishes() {
    std::vector<Wish> out;
    for (const GLenum env : {GL_REPLACE, GL_MODULATE})
        for (const GLenum wrap : {GL_REPEAT, GL_CLAMP_TO_EDGE})
            for (int modes = 0; modes < 8; ++modes) {
                Wish wish;
                wish.dither = (modes & 1) != 0;
                wish.blend = (modes & 2) != 0;
                wish.fog = (modes & 4) != 0;
                wish.env = env;
                wish.wrap = wrap;
                out.push_back(wish);
            }
    return out;
}

/// Returns the figures of one stage of a shadow context.
StageError stage_of(Wish wish, const std::string& name) {
    wish.precision = EGL_PRECISION_SHADOW_SPANGLE;
    const StageReport report;
    picture_of(wish);
    for (const StageError& stage : report.stages())
        if (name == stage.stage)
            return stage;
    ADD_FAILURE() << "no stage " << name;
    return {};
}

struct OwnTiers : testing::Test {
    void SetUp() override { use_reference_engines(); }
};

TEST_F(OwnTiers, WithTheKnobsOfATierHaveItsBytes) {
    for (Wish wish : wishes())
        for (const Tier& tier : tiers) {
            wish.precision = tier.precision;
            wish.knobs = {};
            const DrawnPicture theirs = picture_of(wish);
            for (const Tier& base : tiers) { // each base must work, whatever tier the config has
                wish.precision = base.precision;
                wish.knobs = tier.knobs;
                EXPECT_EQ(picture_of(wish).rgba, theirs.rgba);
            }
        }
}

/// Changes one knob at a time to another tier's value, and tries all pairs of number system and runs. Where
/// no tier has the knobs, the chain draws, and the shadow has the same bytes.
TEST_F(OwnTiers, AreDrawnByTheShadowWithTheSameBytes) {
    std::vector<Knobs> all;
    for (const std::uint8_t bits : {8, 20})
        for (const Runs runs : {Runs::straight, Runs::cubic})
            for (const Knobs& base : {raster::exact_knobs, raster::balanced_knobs, raster::fast_knobs}) {
                all.push_back(base);
                all.back().color_bits = bits;
                all.back().runs = runs;
            }
    for (Wish wish : wishes())
        for (const Knobs& knobs : all) {
            wish.knobs = knobs;
            wish.precision = EGL_PRECISION_BALANCED_SPANGLE;
            const DrawnPicture drawn = picture_of(wish);
            wish.precision = EGL_PRECISION_SHADOW_BALANCED_SPANGLE;
            EXPECT_EQ(picture_of(wish).rgba, drawn.rgba)
                << int{knobs.color_bits} << " bits, " << (knobs.runs == Runs::cubic ? "cubic" : "straight");
        }
}

/// Coordinates are within the bound, and use a wider bound.
TEST_F(OwnTiers, CoordinatesAreAsFarOffAsTexelBitsSay) {
    for (const std::uint8_t colors : {8, 20})
        for (const Runs runs : {Runs::straight, Runs::cubic}) {
            double last = 0;
            for (const int bits : {9, 6, 4, 2}) {
                Wish wish;
                wish.knobs = raster::balanced_knobs;
                wish.knobs->color_bits = colors;
                wish.knobs->runs = runs;
                wish.knobs->texel_bits = static_cast<std::uint8_t>(bits);
                wish.knobs->affine_texel_bits = Knobs::never;
                wish.env = GL_MODULATE;
                const StageError coord = stage_of(wish, "coord 0");
                // Snapped vertices move coordinates a little, too.
                EXPECT_LE(coord.worst, 1.0 / (1 << bits) + 0.02);
                if (runs == Runs::straight && bits < 9) {
                    EXPECT_GT(coord.worst, last) << bits;
                }
                last = coord.worst;
            }
        }
}

/// Straight runs of 64 pixels find texels that are far off, in words of either size. Cubic runs do not.
TEST_F(OwnTiers, RunsAreOfTheKindThatIsAskedFor) {
    constexpr int step = 9; // the largest step of a 565 component, in 255ths
    const auto largest_difference = [](const auto& a, const auto& b) {
        int largest = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, std::abs(a[i] - b[i]));
        return largest;
    };
    for (const GLenum env : {GL_REPLACE, GL_MODULATE}) { // GL_REPLACE has fused spans of its own
        Wish wish;
        wish.env = env;
        wish.knobs = raster::balanced_knobs;
        wish.knobs->shortest_run = wish.knobs->longest_run = 6;
        wish.knobs->affine_texel_bits = Knobs::never;
        wish.knobs->color_bits = 8;
        const auto narrow = picture_of(wish).rgba;
        wish.knobs->color_bits = 20;
        EXPECT_LE(largest_difference(picture_of(wish).rgba, narrow), step);
        wish.knobs->runs = Runs::cubic;
        wish.knobs->shortest_run = 0;
        wish.knobs->longest_run = 4;
        const auto cubic = picture_of(wish).rgba;
        EXPECT_GT(largest_difference(cubic, narrow), 4 * step);
        wish.knobs->color_bits = 8;
        EXPECT_LE(largest_difference(picture_of(wish).rgba, cubic), step);
    }
}

/// With a wide bound, the two kinds of runs find different texels in runs of the same length.
TEST_F(OwnTiers, KindsOfRunsAreNotTheSame) {
    for (const std::uint8_t bits : {8, 20}) {
        Wish wish;
        wish.env = GL_MODULATE;
        wish.knobs = raster::balanced_knobs;
        wish.knobs->color_bits = bits;
        wish.knobs->texel_bits = 0;
        wish.knobs->longest_run = 4;
        wish.knobs->affine_texel_bits = Knobs::never;
        wish.knobs->runs = Runs::straight;
        const auto straight = picture_of(wish).rgba;
        wish.knobs->runs = Runs::cubic;
        EXPECT_NE(picture_of(wish).rgba, straight) << int{bits} << " bits";
    }
}

TEST_F(OwnTiers, RunsAreAsLongAsTheyMay) {
    Wish wish;
    wish.knobs = raster::balanced_knobs;
    wish.knobs->texel_bits = 0;
    const double wide = stage_of(wish, "coord 0").rms;
    wish.knobs->longest_run = 1;
    EXPECT_LT(stage_of(wish, "coord 0").rms, wide / 2) << "runs of two pixels";
    wish.knobs->texel_bits = 9;
    wish.knobs->longest_run = 6;
    const double narrow = stage_of(wish, "coord 0").rms;
    wish.knobs->shortest_run = 4;
    EXPECT_GT(stage_of(wish, "coord 0").rms, 2 * narrow) << "runs of sixteen pixels";
}

TEST_F(OwnTiers, DivideNothingWhereBoundsAreWide) {
    Wish wish;
    wish.env = GL_MODULATE;
    wish.fog = true;
    wish.textured = false; // with a texture, fog would be divided, too
    wish.knobs = raster::exact_knobs;
    const double colors = stage_of(wish, "primary").worst, fog = stage_of(wish, "fog factor").worst;
    EXPECT_LT(colors, 1e-5);
    EXPECT_LT(fog, 1e-4);
    wish.knobs->affine_color_bits = 0;
    EXPECT_GT(stage_of(wish, "primary").worst, 0.05);
    wish.knobs = raster::exact_knobs;
    wish.knobs->affine_color_bits = 0; // if colours were divided, fog would be, too
    wish.knobs->affine_fog_bits = 0;
    EXPECT_GT(stage_of(wish, "fog factor").worst, 0.05);
    wish.knobs = raster::exact_knobs;
    wish.knobs->affine_step_bits = 0; // affine colours of this triangle are off by more than a step
    EXPECT_LT(stage_of(wish, "primary").worst, 4.0 / 255);
}

TEST_F(OwnTiers, CombineBlendAndSnapAsTheyAreTold) {
    Wish wish;
    wish.env = GL_MODULATE;
    wish.blend = true;
    wish.knobs = raster::exact_knobs;
    const double fine = stage_of(wish, "blend").worst;
    wish.knobs->color_bits = 8;
    const double narrow = stage_of(wish, "blend").worst;
    EXPECT_GT(narrow, 4 * fine);
    wish.knobs->coarse_blend = true;
    EXPECT_GT(stage_of(wish, "blend").worst, 2 * narrow);
    wish = {};
    wish.knobs = raster::exact_knobs;
    const double unsnapped = stage_of(wish, "coord 0").worst;
    wish.knobs->unsnapped = false;
    EXPECT_GT(stage_of(wish, "coord 0").worst, 8 * unsnapped);
}

TEST_F(OwnTiers, GiveWayToHints) {
    Wish wish;
    wish.knobs = raster::balanced_knobs;
    const auto own = picture_of(wish).rgba;
    wish.knobs = {};
    const auto exact = picture_of(wish).rgba;
    EXPECT_NE(own, exact);
    wish.knobs = raster::balanced_knobs;
    wish.hint = GL_NICEST;
    EXPECT_EQ(picture_of(wish).rgba, exact);
}

TEST_F(OwnTiers, AreRefusedOutsideOfTheirRanges) {
    EXPECT_FALSE(use_tier(raster::exact_knobs)) << "there is no context";
    const HeadlessGl gl(size, size);
    EXPECT_TRUE(use_tier(raster::exact_knobs));
    glBegin(GL_POINTS);
    EXPECT_FALSE(use_tier(raster::exact_knobs)) << "a primitive is drawn";
    glEnd();
    const auto refused = [](std::uint8_t Knobs::*field, int value) {
        Knobs knobs = raster::balanced_knobs;
        knobs.*field = static_cast<std::uint8_t>(value);
        return !use_tier(knobs);
    };
    EXPECT_TRUE(refused(&Knobs::color_bits, 16));
    EXPECT_TRUE(refused(&Knobs::texel_bits, 14));
    EXPECT_TRUE(refused(&Knobs::shortest_run, 7));
    EXPECT_TRUE(refused(&Knobs::longest_run, 17));
    EXPECT_TRUE(refused(&Knobs::affine_texel_bits, 1));
    EXPECT_TRUE(refused(&Knobs::affine_color_bits, 25));
    EXPECT_TRUE(refused(&Knobs::affine_step_bits, 21));
    EXPECT_TRUE(refused(&Knobs::affine_fog_bits, 1));
    Knobs crossed = raster::fast_knobs;
    crossed.longest_run = 3;
    EXPECT_FALSE(use_tier(crossed)) << "the longest run is shorter than the shortest";
}

} // namespace
} // namespace spangle::test
