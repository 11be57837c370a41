// Traces as programs in C++ (host_sim/profile/firmware/replay.py) must draw what a retracer draws of them on
// the drop-in pair.
#include <cstdlib>

#include <gtest/gtest.h>

#include <spangle/GL/gl.h>

#include "host_sim/cli/replays.hpp"
#include "host_sim/trade/choice.hpp"
#include "host_sim/trade/measure.hpp"
#include "host_sim/trade/offscreen.hpp"

namespace spangle::measure {

void replay_checker(int frame);
void replay_light(int frame);

} // namespace spangle::measure

namespace spangle::trade {

namespace {

struct Traced {
    const char* name;
    void (*frame)(int);
};

class Replay : public testing::TestWithParam<Traced> {};

TEST_P(Replay, DrawsTheBytesOfItsTrace) {
    const Traced& traced = GetParam();
    if (std::system("command -v eglretrace >/dev/null") != 0)
        GTEST_SKIP() << "there is no eglretrace; ./dev setup --programs installs it";
    setenv("SPANGLE_DROPIN", DROPIN, 1);
    std::shared_ptr<Recording> recording;
    ASSERT_EQ(cli::open_trace(std::string(TRACES "/") + traced.name + ".trace", recording), "");
    Setting setting;
    setting.frames = 2;
    setting.dither = true; // the initial state of contexts
    ASSERT_EQ(recording->settle(setting), "");
    CaptureReader pictures;
    ASSERT_EQ(recording->capture(PixelFormat::rgb565_be, EGL_PRECISION_BALANCED_SPANGLE, setting, pictures),
              "");
    const Program program{traced.name, [](int, int) {}, traced.frame, true}; // depths of 24 bits
    Offscreen screen;
    ASSERT_EQ(screen.open(program, setting.width, setting.height, PixelFormat::rgb565_be,
                          EGL_PRECISION_BALANCED_SPANGLE, true),
              "");
    for (int f = 0; f < 2; ++f) {
        DrawnFrame drawn;
        double time = 0;
        ASSERT_TRUE(pictures.next(drawn, time));
        program.draw(f);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        DrawnPicture own = read_picture();
        for (std::uint32_t& depth : own.depth)
            depth >>= 8; // captures keep 16 bits
        EXPECT_TRUE(own.rgba == drawn.picture.rgba) << f;
        EXPECT_TRUE(own.depth == drawn.picture.depth) << f;
    }
}

INSTANTIATE_TEST_SUITE_P(Traces, Replay,
                         testing::Values(Traced{"redbook_checker", measure::replay_checker},
                                         Traced{"redbook_light", measure::replay_light}),
                         [](const auto& info) { return std::string(info.param.name); });

} // namespace

} // namespace spangle::trade
