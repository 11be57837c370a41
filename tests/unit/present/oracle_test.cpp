// After every present the panel's memory must equal the surface, whatever a program cleared, masked or left
// alone through GL.
#include <functional>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/boards/boards.hpp>
#include <spangle/native.hpp>

#include "tests/unit/present/watched_display.hpp"

namespace {

using namespace spangle;

/// What a program does in its frames, with a source of random numbers.
struct Habit {
    const char* name;
    void (*frame)(std::mt19937& random, int frame);
};

float part(std::mt19937& random) {
    return static_cast<float>(random() % 1000) / 1000.0f;
}

bool once_in(std::mt19937& random, unsigned n) {
    return random() % n == 0;
}

void clear_to(float shade) {
    glClearColor(shade, 1.0f - shade, 0.25f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

/// Draws a few primitives of every kind at random places.
void draw(std::mt19937& random) {
    const auto corner = [&] { glVertex2f(part(random) * 2.2f - 1.1f, part(random) * 2.2f - 1.1f); };
    constexpr GLenum kinds[] = {GL_TRIANGLES, GL_LINES, GL_POINTS, GL_QUADS};
    for (unsigned n = random() % 4; n > 0; --n) {
        glColor3f(part(random), part(random), part(random));
        const GLenum kind = kinds[random() % 4];
        glPointSize(1.0f + 9.0f * part(random));
        glBegin(kind);
        for (int v = 0; v < 12; ++v)
            corner();
        glEnd();
    }
    glRecti(0, 0, once_in(random, 4) ? 1 : 0, 1);
}

void scissor(std::mt19937& random) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(static_cast<int>(random() % 70), static_cast<int>(random() % 150),
              static_cast<int>(random() % 90), static_cast<int>(random() % 90));
}

void no_clear(std::mt19937& random, int) {
    draw(random);
}

void same_clear(std::mt19937& random, int) {
    clear_to(0.5f);
    draw(random);
}

void new_clear_color(std::mt19937& random, int frame) {
    clear_to(frame % 3 == 0 ? 0.0f : part(random));
    draw(random);
}

/// Returns one of a few shades, so that a partial clear may have the colour of the full clear before it.
float shade(std::mt19937& random) {
    return once_in(random, 3) ? part(random) : once_in(random, 2) ? 0.0f : 0.5f;
}

void scissored_clear(std::mt19937& random, int frame) {
    if (frame % 3 == 0)
        clear_to(0.5f);
    draw(random);
    scissor(random);
    clear_to(shade(random));
    glDisable(GL_SCISSOR_TEST);
    draw(random);
}

void color_mask(std::mt19937& random, int frame) {
    glColorMask(once_in(random, 2), once_in(random, 2), once_in(random, 2), GL_TRUE);
    clear_to(shade(random));
    draw(random);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (frame % 4 == 0)
        clear_to(0.5f);
}

void clear_in_mid_frame(std::mt19937& random, int) {
    draw(random);
    clear_to(once_in(random, 3) ? part(random) : 0.5f);
    draw(random);
    if (once_in(random, 2)) {
        clear_to(0.5f);
        draw(random);
    }
}

void nothing(std::mt19937&, int) {}

void anything(std::mt19937& random, int frame);

constexpr Habit habits[] = {{"no clear", no_clear},
                            {"same clear", same_clear},
                            {"new clear colour", new_clear_color},
                            {"scissored clear", scissored_clear},
                            {"colour mask", color_mask},
                            {"clear in mid-frame", clear_in_mid_frame},
                            {"nothing drawn", nothing},
                            {"anything", anything}};

void anything(std::mt19937& random, int frame) {
    habits[random() % 7].frame(random, frame);
}

class Window {
  public:
    Window(hal::Display& target, bool single) : display_(eglGetDisplay(native(target))) {
        const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                               EGL_NONE};
        const EGLint list[] = {EGL_RENDER_BUFFER, single ? EGL_SINGLE_BUFFER : EGL_BACK_BUFFER, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        EXPECT_TRUE(eglInitialize(display_, nullptr, nullptr));
        EXPECT_TRUE(eglChooseConfig(display_, wish, &config, 1, &count));
        surface_ = eglCreateWindowSurface(display_, config, 0, list);
        const EGLContext context = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
        EXPECT_TRUE(eglMakeCurrent(display_, surface_, surface_, context));
    }
    ~Window() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display_);
    }
    bool swap() { return eglSwapBuffers(display_, surface_) != EGL_FALSE; }

  private:
    EGLDisplay display_;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

/// Plays frames of one habit. Frames are also dithered, so that a clear has no single colour.
void hold(const hal::Board& board, const Habit& habit, bool single) {
    SCOPED_TRACE(std::string(habit.name) + (single ? ", single-buffered" : "") + ", " +
                 std::to_string(board.display.buffers) + " buffers" +
                 (board.display.row_hash ? ", row hash" : ""));
    constexpr int frames = 30;
    sim::SimBoard sim(board);
    test::WatchedDisplay watched(sim, board);
    std::mt19937 random(board.display.buffers * 97u + (single ? 7u : 0u));
    {
        Window window(watched, single);
        for (int frame = 0; frame < frames && !testing::Test::HasFailure(); ++frame) {
            habit.frame(random, frame);
            if (single)
                glFlush();
            else
                EXPECT_TRUE(window.swap());
        }
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
    EXPECT_EQ(sim.violations_text(), "");
    EXPECT_GE(watched.compared, frames);
}

TEST(DamageOracle, PanelMemoryEqualsSurfaceAfterEveryPresent) {
    for (const Habit& habit : habits)
        for (const unsigned variant : {0u, 1u, 2u, 3u, 4u}) {
            hal::Board board = boards::st7735_128x160;
            board.display.buffers = static_cast<std::uint8_t>(1 + variant % 2);
            board.display.row_hash = variant >= 2;
            if (variant == 4) {
                board.display.orientation = {hal::Rotation::r270};
                board.display.buffers = 2;
                board.display.scan_order = true;
            }
            hold(board, habit, false);
        }
}

TEST(DamageOracle, PanelMemoryEqualsSurfaceAfterEveryFlush) {
    for (const Habit& habit : habits)
        hold(boards::st7735_128x160, habit, true);
}

} // namespace
