// With two buffers the next frame is drawn while the last one is sent. Virtual time shows it, and the bus
// checks every rule, above all that nothing draws into memory that is being sent.
#include <gtest/gtest.h>
#include <spangle/GL/gl.h>
#include <spangle/boards/boards.hpp>

#include "tests/support/scene_player.hpp"
#include "tests/unit/present/watched_display.hpp"

namespace {

using namespace spangle;
using sim::Time;

struct Ran {
    Time time = 0, wire = 0; ///< ns of all frames: in total, and on the wire
    std::uint32_t put_off = 0;
};

/// Plays frames for whose drawing the processor takes the time `drawing`.
Ran run(hal::Board board, const char* scene, int frames, Time drawing) {
    sim::SimBoard sim(board);
    test::WatchedDisplay watched(sim, board);
    watched.compare = board.display.pacing == hal::Pacing::block;
    Time from = 0, wire = 0;
    EXPECT_TRUE(test::play(watched, *scenes::find(scene), frames, [&] {
        if (from == 0) {
            from = sim.now();
            wire = sim.counters().busy_ns;
        }
        sim.pass(drawing);
    }));
    const auto& display = static_cast<const hal::PanelDisplay&>(sim.display());
    const Ran ran = {sim.now() - from, sim.counters().busy_ns - wire, display.counters().put_off};
    EXPECT_TRUE(sim.display().finish().ok());
    EXPECT_EQ(sim.violations_text(), "");
    return ran;
}

TEST(Overlap, DrawingAndSendingTakeTheLongerOfTheTwo) {
    constexpr int frames = 30;
    constexpr Time ms = 1000000, drawing = 15 * ms;
    hal::Board board = boards::ili9341_spi;
    const Ran one = run(board, "S6", frames, drawing);
    EXPECT_GE(one.time, frames * drawing + one.wire * 95 / 100) << "one after the other";
    board.display.buffers = 2;
    const Ran two = run(board, "S6", frames, drawing);
    const Time longer = std::max(frames * drawing, two.wire);
    EXPECT_GE(two.time, longer * 95 / 100);
    EXPECT_LE(two.time, longer + 40 * ms) << "the last frame is still on the wire";
    EXPECT_LT(two.time, one.time * 65 / 100);
    // Turned frames overlap as well, because they are sent from a buffer of their own.
    board.display.scan_order = true;
    const Ran turned = run(board, "S6", frames, drawing);
    EXPECT_LE(turned.time, std::max(frames * drawing, turned.wire) + 40 * ms);
}

/// A program that is faster than its bus either waits for the bus, or puts frames off.
TEST(Overlap, FramesAreBlockedOrPutOff) {
    constexpr int frames = 40;
    constexpr Time ms = 1000000, drawing = 4 * ms;
    hal::Board board = boards::ili9341_spi;
    board.display.buffers = 2;
    const Ran blocked = run(board, "S6", frames, drawing);
    EXPECT_EQ(blocked.put_off, 0u);
    EXPECT_GE(blocked.time, frames * 3 * drawing) << "17 ms of wire a frame";
    for (const hal::Pacing pacing : {hal::Pacing::drop, hal::Pacing::coalesce}) {
        board.display.pacing = pacing;
        const Ran free = run(board, "S6", frames, drawing);
        EXPECT_GT(free.put_off, 20u);
        EXPECT_LE(free.time, frames * drawing * 105 / 100) << "presents do not wait";
    }
}

TEST(Overlap, TheLastCoalescedFrameIsShownAtFinish) {
    hal::Board board = boards::st7735_128x160;
    board.display.buffers = 2;
    for (const hal::Pacing pacing : {hal::Pacing::drop, hal::Pacing::coalesce}) {
        board.display.pacing = pacing;
        sim::SimBoard sim(board);
        const EGLDisplay display = eglGetDisplay(native(sim.display()));
        const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                               EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
        ASSERT_TRUE(eglChooseConfig(display, wish, &config, 1, &count));
        const EGLSurface window = eglCreateWindowSurface(display, config, 0, nullptr);
        const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        ASSERT_TRUE(eglMakeCurrent(display, window, window, context));
        for (int frame = 0; frame < 5; ++frame) {
            glClearColor(frame == 4 ? 1.0f : 0.0f, frame == 4 ? 0.0f : 1.0f, 0.0f, 1.0f);
            glClear(GL_COLOR_BUFFER_BIT);
            ASSERT_TRUE(eglSwapBuffers(display, window));
            EGLint age = 0;
            ASSERT_TRUE(eglQuerySurface(display, window, EGL_BUFFER_AGE_EXT, &age));
            EXPECT_EQ(age, frame == 0 ? 0 : 1) << "all but the first go into the same buffer";
        }
        glFinish();
        const sim::Image glass = sim.glass();
        EXPECT_EQ(glass.at(5, 5)[0] > 200, pacing == hal::Pacing::coalesce) << "red is the last";
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display);
    }
}

} // namespace
