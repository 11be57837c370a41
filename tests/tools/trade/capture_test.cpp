// Tests captures: what a drawing process hands to the judging process arrives unchanged, or not at all.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <spangle/GL/gl.h>

#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "host_sim/capture/capture_file.hpp"
#include "host_sim/capture/frame_watch.hpp"
#include "tests/support/headless_gl.hpp"

namespace spangle::trade {
namespace {

namespace fs = std::filesystem;

struct Captures : testing::Test {
    fs::path file = fs::temp_directory_path() /
                    ("spangle-capture-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
                     "-" + testing::UnitTest::GetInstance()->current_test_info()->name());
    void TearDown() override { fs::remove(file); }
};

DrawnFrame frame_of(int number) {
    DrawnFrame out;
    out.picture.width = 3;
    out.picture.height = 2;
    out.picture.depth_bits = 16;
    for (int i = 0; i < 6; ++i) {
        for (int c = 0; c < 4; ++c)
            out.picture.rgba.push_back(static_cast<std::uint8_t>(40 * i + c + number));
        out.picture.depth.push_back(static_cast<std::uint32_t>(9000 * i + number));
    }
    out.coverage = {{true, false, true, false, true, false}, {true, true, false, false, true, number == 0}};
    out.mask = {true, true, true, false, false, number == 1};
    return out;
}

void write(const fs::path& file, bool finished) {
    CaptureWriter out;
    ASSERT_EQ(out.open(file.string()), "");
    out.add(frame_of(0), 12.5);
    out.add(frame_of(1), 7);
    CaptureEnd end;
    end.frames = 2;
    end.mismatches = 5;
    end.missed = "one";
    end.stages = {{"window x", "", 7, 0.5, 0.25, -1, 2, 3, 4}};
    if (finished) {
        ASSERT_EQ(out.finish(end), "");
    }
}

TEST_F(Captures, AreReadAsTheyWereWritten) {
    write(file, true);
    CaptureReader in;
    ASSERT_EQ(in.open(file.string()), "");
    DrawnFrame frame;
    double time = 0;
    for (int i = 0; i < 2; ++i) {
        ASSERT_TRUE(in.next(frame, time));
        const DrawnFrame want = frame_of(i);
        EXPECT_EQ(time, i == 0 ? 12.5 : 7.0);
        EXPECT_EQ(frame.picture.width, 3);
        EXPECT_EQ(frame.picture.height, 2);
        EXPECT_EQ(frame.picture.depth_bits, 16);
        EXPECT_EQ(frame.picture.rgba, want.picture.rgba);
        EXPECT_EQ(frame.picture.depth, want.picture.depth);
        EXPECT_EQ(frame.coverage.snapped, want.coverage.snapped);
        EXPECT_EQ(frame.coverage.exact, want.coverage.exact);
        EXPECT_EQ(frame.mask, want.mask);
        EXPECT_FALSE(in.whole());
    }
    EXPECT_FALSE(in.next(frame, time));
    ASSERT_TRUE(in.whole());
    EXPECT_EQ(in.end().frames, 2u);
    EXPECT_EQ(in.end().mismatches, 5u);
    EXPECT_EQ(in.end().missed, "one");
    ASSERT_EQ(in.end().stages.size(), 1u);
    const StageError& stage = in.end().stages[0];
    EXPECT_STREQ(stage.stage, "window x");
    EXPECT_STREQ(stage.unit, "pixels");
    EXPECT_EQ(stage.count, 7u);
    EXPECT_EQ(stage.worst, 0.5);
    EXPECT_EQ(stage.rms, 0.25);
    EXPECT_EQ(stage.least, -1);
    EXPECT_EQ(stage.greatest, 2);
    EXPECT_EQ(stage.saturated, 3u);
    EXPECT_EQ(stage.flips, 4u);
}

TEST_F(Captures, OfAProcessThatDiesAreNotThere) {
    write(file, false);
    EXPECT_FALSE(fs::exists(file));
    CaptureReader in;
    EXPECT_NE(in.open(file.string()), "");
}

/// Wherever a capture is cut, its end is not found, and nothing else happens.
TEST_F(Captures, ThatAreCutAreNotWhole) {
    write(file, true);
    std::ifstream from(file, std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(from), {}};
    for (std::size_t length = 0; length < all.size(); ++length) {
        std::ofstream(file, std::ios::binary).write(all.data(), static_cast<std::streamsize>(length));
        CaptureReader in;
        DrawnFrame frame;
        double time = 0;
        int frames = 0;
        if (in.open(file.string()).empty())
            while (in.next(frame, time))
                ++frames;
        EXPECT_LE(frames, 2);
        EXPECT_FALSE(in.whole()) << length << " of " << all.size();
    }
}

TEST(Depths, OfTwentyFourBitsBecomeThoseOfSixteen) {
    DrawnPicture picture;
    picture.depth_bits = 24;
    picture.depth = {0xFFFFFF, 0x0100FF, 0x000100};
    coarsen(picture);
    EXPECT_EQ(picture.depth_bits, 16);
    EXPECT_EQ(picture.depth, (std::vector<std::uint32_t>{0xFFFF, 0x100, 1}));
    coarsen(picture);
    EXPECT_EQ(picture.depth, (std::vector<std::uint32_t>{0xFFFF, 0x100, 1}));
}

/// A watch sees what glReadPixels returns, and what was covered since the last frame.
TEST(FrameWatches, SeeWhatIsReadAndWhatWasDrawn) {
    const test::HeadlessGl gl(16, 12, {EGL_DEPTH_SIZE, 16});
    FrameWatch watch;
    raster::Counters counters;
    counters.observer = &watch;
    gl::observe(*gl::current_context(), &counters, false);
    glDisable(GL_DITHER);
    glEnable(GL_DEPTH_TEST);
    for (const float right : {0.0f, 1.0f}) {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glColor3f(1, 0.5f, 0.25f);
        glRectf(-1, -1, right, 1);
        DrawnPicture want = read_picture();
        coarsen(want);
        const DrawnFrame frame = watch.take(gl::current_context()->drawable.surface);
        EXPECT_EQ(frame.picture.rgba, want.rgba);
        EXPECT_EQ(frame.picture.depth, want.depth);
        EXPECT_EQ(frame.picture.depth_bits, want.depth_bits);
        const auto drawn = std::count(frame.mask.begin(), frame.mask.end(), true);
        EXPECT_EQ(drawn, right > 0 ? 16 * 12 : 8 * 12);
        EXPECT_EQ(frame.coverage.snapped, frame.mask);
        EXPECT_EQ(frame.mask[0], true) << "the lower left is drawn";
    }
    // Triangles that draw nothing are not a mismatch, because no span follows them.
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glRectf(-1, -1, 1, 1);
    const DrawnFrame masked = watch.take(gl::current_context()->drawable.surface);
    EXPECT_EQ(std::count(masked.mask.begin(), masked.mask.end(), true), 0);
    EXPECT_EQ(watch.mismatches(), 0u);
    gl::observe(*gl::current_context(), nullptr, false);
}

} // namespace
} // namespace spangle::trade
