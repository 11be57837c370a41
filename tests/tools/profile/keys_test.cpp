// Images must count for each state key what the recorder counts, which draws by rows only.
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "gl/context/context.hpp"
#include "gl/context/watch.hpp"
#include "host_sim/profile/emit.hpp"
#include "host_sim/profile/firmware/counting.hpp"
#include "host_sim/profile/recorder.hpp"
#include "tests/tools/bench/headless.hpp"
#include "tests/tools/bench/picture_hash.hpp"
#include "tests/tools/profile/counted.hpp"
#include "tests/tools/profile/programs/program.hpp"

#if SPANGLE_WATCHED

namespace spangle {

namespace {

constexpr int width = 160, height = 120;

using Pixels = std::map<std::string, std::uint64_t>;

Pixels recorded(const programs::Program& program) {
    bench::Headless gl;
    EXPECT_TRUE(gl.open(width, height, EGL_PRECISION_BALANCED_SPANGLE));
    Pixels out;
    {
        profile::Recorder recorder(*gl::current_context());
        program.setup(width, height);
        program.draw(1);
        program.draw(2);
        for (const profile::KeyUse& use : recorder.finish().keys)
            if (use.pixels != 0)
                out[profile::words(use.key)] += use.pixels;
    }
    gl.close();
    return out;
}

struct Counts {
    Pixels pixels;
    std::uint64_t calls = 0, ticks = 0, of_nothing = 0;
    std::uint32_t picture = 0;
};

/// Reports each state when it is compiled. Images wrap the compiling function and need no watcher.
struct Hook final : gl::Watcher {
    void command(gl::Context&, const gl::CommandText&, const gl::Arg*, unsigned) override {}
    void compiled(gl::Context& context, const raster::FragmentState& fragment,
                  raster::DrawState& state) override {
        measure::count_state(fragment, context.drawable.surface, state);
    }
    void reached(gl::Range, std::uint32_t) override {}
};

/// Returns what images of firmware count of the frames from `first` on. Earlier frames are drawn and not
/// counted.
Counts counted(const programs::Program& program, int first) {
    bench::Headless gl;
    EXPECT_TRUE(gl.open(width, height, EGL_PRECISION_BALANCED_SPANGLE));
    measure::forget_counts();
    measure::said.clear();
    Hook hook;
    gl::watch(*gl::current_context(), &hook);
    program.setup(width, height);
    for (int frame = 1; frame < first; ++frame)
        program.draw(frame);
    for (int frame = first; frame < 3; ++frame) {
        measure::begin_frame();
        program.draw(frame);
        measure::end_frame();
    }
    measure::print_counts();
    Counts out;
    out.picture = bench::picture_hash(width, height);
    gl::watch(*gl::current_context(), nullptr);
    gl.close();
    std::istringstream lines(measure::said);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string key;
        std::uint64_t calls = 0, pixels = 0, ticks = 0;
        words >> key >> calls >> pixels >> ticks >> std::ws;
        EXPECT_EQ(key, "key");
        std::getline(words, key);
        if (key == "key" || key.empty()) {
            out.of_nothing += calls;
            EXPECT_EQ(pixels, 0u);
        } else if (pixels != 0) {
            out.pixels[key] += pixels;
        }
        out.calls += calls;
        out.ticks += ticks;
    }
    return out;
}

/// Lines of one colour are drawn as paths, pixel by pixel.
const programs::Program paths{"paths",
                              [](int, int) {
                                  glDisable(GL_DITHER);
                                  glShadeModel(GL_FLAT);
                              },
                              [](int frame) {
                                  glBegin(GL_LINES);
                                  for (int i = 0; i < 9; ++i) {
                                      glVertex2f(-0.9f, 0.1f * static_cast<float>(i));
                                      glVertex2f(0.9f, -0.2f * static_cast<float>(i * frame % 4));
                                  }
                                  glEnd();
                              }};

TEST(KeyCounts, AreTheRecorders) {
    std::vector<const programs::Program*> all(std::begin(programs::all), std::end(programs::all));
    all.push_back(&paths);
    for (const programs::Program* program : all) {
        const Counts counts = counted(*program, 1);
        EXPECT_EQ(counts.pixels, recorded(*program)) << program->name;
        EXPECT_FALSE(counts.pixels.empty()) << program->name;
    }
}

TEST(KeyCounts, AreOfTheFramesThatAreCounted) {
    const Pixels both = counted(programs::wires, 1).pixels, last = counted(programs::wires, 2).pixels;
    ASSERT_FALSE(last.empty());
    for (const auto& [key, pixels] : last)
        EXPECT_LT(pixels, both.at(key)) << key;
}

TEST(KeyCounts, TakeTheTimeOfEachCall) {
    const Counts counts = counted(programs::lit_perspective, 1);
    EXPECT_EQ(counts.of_nothing, 2u * 256u) << "calls that draw nothing tell what counting takes";
    EXPECT_GT(counts.calls, counts.of_nothing);
    EXPECT_EQ(counts.ticks, counts.calls * measure::ticks_of_a_look);
}

TEST(KeyCounts, ChangeNoPixel) {
    for (const programs::Program* program : programs::all) {
        bench::Headless gl;
        ASSERT_TRUE(gl.open(width, height, EGL_PRECISION_BALANCED_SPANGLE));
        program->setup(width, height);
        program->draw(1);
        program->draw(2);
        const std::uint32_t picture = bench::picture_hash(width, height);
        gl.close();
        EXPECT_EQ(counted(*program, 1).picture, picture) << program->name;
    }
}

} // namespace

} // namespace spangle

#endif
