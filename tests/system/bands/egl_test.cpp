// Tests windows in bands through EGL: attributes, lasting state, and failures.
#include <climits>

#include <spangle/message.hpp>

#include "tests/system/bands/banded.hpp"
#include "tests/system/egl/fake_display.hpp"

namespace spangle::test {
namespace {

EGLint band_height(Banded& window) {
    EGLint value = -1;
    EXPECT_EQ(eglQuerySurface(window.display, window.surface, EGL_BAND_HEIGHT_SPANGLE, &value),
              EGLBoolean{1});
    return value;
}

const Program nothing = {"nothing", [](int, int) {}, [](int) {}};

TEST(BandWindows, WishesAreRoundedUpToWhereBytesEnd) {
    hal::Board pages = boards::ssd1306_128x32;
    const struct {
        const hal::Board& board;
        Setting setting;
        EGLint height;
    } cases[] = {
        {boards::st7735_80x160, {}, 0},
        {boards::st7735_80x160, {.band_height = 1}, 1},
        {boards::st7735_80x160, {.band_height = INT_MAX}, 80},
        {boards::st7735_80x160, {.display_band = 24}, 24},
        {boards::st7735_80x160, {.display_band = 24, .band_height = 7}, 7},
        {boards::st7735_80x160, {.display_band = 1000}, 80},
        {pages, {.display_band = 16}, 16},
        {pages, {.display_band = 16, .band_height = 1}, 8},
        {pages, {.display_band = 16, .band_height = 9}, 16},
        {pages, {.band_height = 9}, 9}, // bands of depth; the display holds whole frames
    };
    for (const auto& c : cases) {
        Banded window(c.board, c.setting);
        EXPECT_EQ(band_height(window), c.height) << c.setting.display_band << ' ' << c.setting.band_height;
    }
}

TEST(BandWindows, WishesThatCannotBe) {
    hal::Board board = boards::st7735_80x160;
    board.display.band = 24;
    sim::SimBoard sim(board);
    const EGLDisplay display = eglGetDisplay(native(sim.display()));
    ASSERT_NE(eglInitialize(display, nullptr, nullptr), EGLBoolean{0});
    const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    ASSERT_NE(eglChooseConfig(display, wish, &config, 1, &count), EGLBoolean{0});
    for (const auto& [height, error] : {std::pair{25, EGL_BAD_MATCH}, {-1, EGL_BAD_PARAMETER}}) {
        const EGLint list[] = {EGL_BAND_HEIGHT_SPANGLE, height, EGL_NONE};
        EXPECT_EQ(eglCreateWindowSurface(display, config, 0, list), EGL_NO_SURFACE);
        EXPECT_EQ(eglGetError(), error);
    }
    eglTerminate(display);
}

TEST(BandWindows, DepthTakesTheMemoryOfABand) {
    std::size_t taken[3];
    std::size_t i = 0;
    for (const std::int32_t rows : {0, 40, 8}) {
        const std::size_t before = memory_use().used;
        const hal::Board& board = boards::st7735_80x160;
        Banded window(board, {.display_band = rows, .depth = 16, .stencil = 0, .accum = 16});
        eglMakeCurrent(window.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(window.display, window.context);
        taken[i++] = memory_use().used - before;
    }
    constexpr std::size_t row = 160 * (2 + 8); // bytes of depth and of accumulation
    // The rest is the table of batches that bands may leave out.
    const std::size_t batches = taken[1] + 40 * row - taken[0];
    EXPECT_GT(batches, 0U);
    EXPECT_LT(batches, 400U);
    EXPECT_EQ(taken[1] - taken[2], 32 * row);
}

/// Outside of a frame there are no pixels to draw or read, and nothing that eglSwapBuffers could show.
TEST(BandWindows, OutsideOfFramesThereIsNothing) {
    Banded window(boards::st7735_80x160, {.display_band = 8});
    glClearColor(1.F, 1.F, 1.F, 1.F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT);
    glRectf(-1.F, -1.F, 1.F, 1.F);
    glAccum(GL_LOAD, 1.F);
    glAccum(GL_RETURN, 1.F);
    GLubyte pixel[4] = {1, 2, 3, 4};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(pixel[0], 1);
    glCopyPixels(0, 0, 8, 8, GL_COLOR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 2, 2);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(eglSwapBuffers(window.display, window.surface), EGLBoolean{0});
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    GLint box[4];
    glGetIntegerv(GL_VIEWPORT, box);
    EXPECT_EQ(box[3], 80); // GL sees the whole window
}

/// A band reads and copies its own rows only.
TEST(BandWindows, RowsOfOtherBandsAreNotRead) {
    Banded window(boards::st7735_80x160, {.display_band = 16});
    int read = 0;
    const Program program = {"read", nothing.setup, [&](int) {
                                 glClearColor(1.F, 0.F, 0.F, 1.F);
                                 glClear(GL_COLOR_BUFFER_BIT);
                                 std::vector<GLubyte> column(80 * 4, 7);
                                 glReadPixels(3, 0, 1, 80, GL_RGBA, GL_UNSIGNED_BYTE, column.data());
                                 for (int y = 0; y < 80; ++y)
                                     if (column[static_cast<std::size_t>(4 * y)] == 255) {
                                         EXPECT_EQ(y / 16, 4 - read / 16);
                                         ++read;
                                     }
                             }};
    (void)window.show(program, 0);
    EXPECT_EQ(read, 80);
}

TEST(BandWindows, AFrameWantsAWindowThatStaysCurrent) {
    Banded window(boards::st7735_80x160, {.display_band = 16});
    EXPECT_FALSE(spangle::frame(EGL_NO_DISPLAY, [] {}));
    EXPECT_EQ(eglGetError(), EGL_BAD_DISPLAY);
    int calls = 0;
    EXPECT_FALSE(spangle::frame(window.display, [&] {
        ++calls;
        eglMakeCurrent(window.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }));
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    EXPECT_EQ(calls, 1);
    EXPECT_FALSE(spangle::frame(window.display, [&] { ++calls; }));
    EXPECT_EQ(eglGetError(), EGL_BAD_SURFACE);
    EXPECT_EQ(calls, 1);
    ASSERT_NE(eglMakeCurrent(window.display, window.surface, window.surface, window.context), EGLBoolean{0});
    EXPECT_TRUE(spangle::frame(window.display, [&] { ++calls; }));
    EXPECT_EQ(calls, 6);
}

/// A transfer fails somewhere in a frame. That frame reports the failure, and the next one sends the missing
/// pixels again.
TEST(BandWindows, WhatFailsIsSentAgain) {
    const Program program = program_of(scenes::hud);
    for (const std::uint8_t buffers : {std::uint8_t{1}, std::uint8_t{2}})
        for (int broken = 0; broken < 5; ++broken) {
            hal::Board board = boards::st7735_80x160;
            board.display.buffers = buffers;
            Banded window(board, {.display_band = 16});
            window.set_up(program);
            const std::string good = sim::hash(window.show(program, 0));
            int call = 0;
            const bool shown = spangle::frame(window.display, [&] {
                program.draw(1);
                if (call++ == broken)
                    window.sim.fail_next(hal::Fault::short_write);
            });
            const bool finished = window.sim.display().finish().ok();
            EXPECT_FALSE(shown && finished) << broken;
            EXPECT_EQ(sim::hash(window.show(program, 0)), good) << broken;
        }
}

/// If a failed transfer should have erased something, the next frame erases it, although it draws nothing
/// there.
TEST(BandWindows, WhatWasNotErasedIsErasedNext) {
    const Program blink = {"blink", nothing.setup, [](int f) {
                               glClearColor(0.F, 0.F, 0.F, 1.F);
                               glClear(GL_COLOR_BUFFER_BIT);
                               if (f == 0)
                                   glRectf(-0.5F, -1.F, 0.5F, 1.F);
                           }};
    for (const std::uint8_t buffers : {std::uint8_t{1}, std::uint8_t{2}})
        for (int broken = 0; broken < 5; ++broken) {
            hal::Board board = boards::st7735_80x160;
            board.display.buffers = buffers;
            Banded window(board, {.display_band = 16});
            const std::string black = sim::hash(window.show(blink, 1));
            EXPECT_NE(sim::hash(window.show(blink, 0)), black);
            int call = 0;
            const bool shown = spangle::frame(window.display, [&] {
                blink.draw(1);
                if (call++ == broken)
                    window.sim.fail_next(hal::Fault::short_write);
            });
            EXPECT_FALSE(window.sim.display().finish().ok() && shown) << broken;
            EXPECT_EQ(sim::hash(window.show(blink, 1)), black) << broken;
        }
}

TEST(BandWindows, DisplaysOfOneKindRefuseTheOther) {
    hal::Board board = boards::st7735_80x160;
    sim::SimBoard whole(board);
    board.display.band = 16;
    sim::SimBoard banded(board);
    ASSERT_TRUE(whole.display().init().ok());
    EXPECT_FALSE(banded.display().acquire_band(0, 16).ok()); // before init()
    EXPECT_FALSE(banded.display().present_band().ok());
    ASSERT_TRUE(banded.display().init().ok());
    EXPECT_FALSE(whole.display().acquire_band(0, 16).ok());
    EXPECT_FALSE(whole.display().present_band().ok());
    EXPECT_FALSE(banded.display().acquire().ok());
    EXPECT_FALSE(banded.display().present().ok());
    EXPECT_FALSE(banded.display().present_band().ok()); // nothing was acquired
    for (const auto& [first, rows] : {std::pair{-1, 3}, {0, 0}, {0, 17}, {70, 11}, {80, 1}, {INT_MAX, 1}})
        EXPECT_FALSE(banded.display().acquire_band(first, rows).ok()) << first << ' ' << rows;
    FakeDisplay fake;
    EXPECT_FALSE(fake.acquire_band(0, 1).ok());
    EXPECT_FALSE(fake.present_band().ok());
}

TEST(BandWindows, RulesOfDisplaysInBands) {
    const auto refused = [](auto change, hal::Board board = boards::st7735_80x160) {
        board.display.band = 8;
        board.has_te = true;
        change(board.display);
        const char* const rule = hal::flaw(board);
        if (board.display.band < 0)
            return rule != nullptr; // a board of that size cannot be built
        sim::SimBoard sim(board);
        const auto up = sim.display().init();
        EXPECT_EQ(up.ok(), rule == nullptr);
        return rule != nullptr && std::string(rule) == (up.ok() ? "" : up.error().rule);
    };
    using Config = hal::PanelConfig;
    EXPECT_FALSE(refused([](Config&) {}));
    EXPECT_TRUE(refused([](Config& c) { c.band = -8; }));
    EXPECT_TRUE(refused([](Config& c) { c.row_hash = true; }));
    EXPECT_TRUE(refused([](Config& c) { c.pacing = hal::Pacing::drop; }));
    EXPECT_TRUE(refused([](Config& c) { c.wait_te = true; }));
    EXPECT_TRUE(refused([](Config& c) { c.band = 12; }, boards::ssd1306_128x32));
    EXPECT_FALSE(refused([](Config&) {}, boards::ssd1306_128x32));
}

TEST(BandWindows, BuffersTakeTheMemoryOfABand) {
    hal::Board two = boards::st7735_80x160, pages = boards::ssd1306_128x32;
    two.display.buffers = 2;
    EXPECT_EQ(hal::bus_memory(two), 2U * 160 * 80 * 2);
    two.display.band = 8;
    EXPECT_EQ(hal::bus_memory(two), 2U * 160 * 8 * 2);
    pages.display.band = 8;
    const std::size_t pixels = 128 * 8 * 2, converted = 128 + 8;
    constexpr std::size_t unit = hal::BusMemory::alignment;
    EXPECT_EQ(hal::bus_memory(pages),
              (pixels + unit - 1) / unit * unit + (converted + unit - 1) / unit * unit);
}

/// A frame with another clear value ends after two of five bands, so it is unknown what each band holds.
TEST(BandWindows, AFrameThatEndsEarlyIsForgotten) {
    const Program program = {"clears", nothing.setup, [](int f) {
                                 glClearColor(f == 1 ? 1.F : 0.F, 0.F, 0.F, 1.F);
                                 glClear(GL_COLOR_BUFFER_BIT);
                             }};
    Banded window(boards::st7735_80x160, {.display_band = 16});
    const std::string good = sim::hash(window.show(program, 0));
    int call = 0;
    EXPECT_FALSE(spangle::frame(window.display, [&] {
        program.draw(1);
        if (++call == 3)
            eglMakeCurrent(window.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }));
    ASSERT_NE(eglMakeCurrent(window.display, window.surface, window.surface, window.context), EGLBoolean{0});
    EXPECT_EQ(sim::hash(window.show(program, 0)), good);
}

/// Bands are cleared to different values, or only some are cleared: each is sent as it is, by either display.
TEST(BandWindows, BandsClearedOneByOne) {
    int call = 0;
    const auto clear = [](float red) {
        glClearColor(red, 0.F, 0.F, 1.F);
        glClear(GL_COLOR_BUFFER_BIT);
    };
    const Program values = {"values", nothing.setup, [&](int f) { clear(call++ < 3 + f ? 1.F : 0.F); }};
    const Program some = {"some", nothing.setup, [&](int f) {
                              if (call++ == 1 + f)
                                  clear(1.F);
                              else
                                  glRectf(-1.F, -1.F, 1.F, 1.F);
                          }};
    for (const Program& program : {values, some})
        for (const Setting& setting : {Setting{.display_band = 16}, Setting{.band_height = 16}}) {
            Banded window(boards::st7735_80x160, setting);
            for (const int f : {0, 1, 0, 0}) {
                call = 0;
                const sim::Image memory = window.show(program, f);
                for (int band = 0; band < 5; ++band) {
                    const bool red = program.name == "values" ? band < 3 + f : band == 1 + f;
                    // The picture is turned by a quarter, so its rows are columns of the memory, from the
                    // right.
                    int wrong = 0;
                    for (int along = 0; along < 160; ++along)
                        for (int row = 16 * band; row < 16 * band + 16; ++row) {
                            const hal::Placement at = hal::place(*boards::st7735_80x160.display.panel,
                                                                 boards::st7735_80x160.display.orientation);
                            int column = row + at.offset.y, line = along + at.offset.x;
                            if ((at.madctl & hal::dcs::MX) != 0)
                                column = memory.width - 1 - column;
                            if ((at.madctl & hal::dcs::MY) != 0)
                                line = memory.height - 1 - line;
                            const std::uint8_t* const cell = memory.at(column, line);
                            const bool white = cell[1] > 128;
                            const bool is_red = cell[0] > 128 && !white;
                            wrong += is_red != red;
                        }
                    EXPECT_EQ(wrong, 0) << program.name << ", band " << band << ", frame " << f;
                }
            }
        }
}

/// Without memory of what the panel shows, bands are sent whole, and are right.
TEST(BandWindows, BandsAreSentWholeWhereNobodyRemembers) {
    const Program program = program_of(scenes::hud);
    hal::Board board = boards::st7735_80x160;
    const sim::Image expected = play(board, {.depth = 0, .stencil = 0, .accum = 0}, program, 2)[1];
    board.display.band = 16;
    sim::SimBoard sim(board);
    hal::PanelStorage<hal::PanelSizes{.height = 16, .ops = 16, .content = 0}> storage;
    hal::PanelDisplay panel(sim.bus(), board.display, storage.memory());
    const EGLDisplay display = eglGetDisplay(native(panel));
    ASSERT_NE(eglInitialize(display, nullptr, nullptr), EGLBoolean{0});
    const EGLint wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    ASSERT_NE(eglChooseConfig(display, wish, &config, 1, &count), EGLBoolean{0});
    const EGLSurface surface = eglCreateWindowSurface(display, config, 0, nullptr);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    ASSERT_NE(eglMakeCurrent(display, surface, surface, context), EGLBoolean{0});
    program.setup(160, 80);
    for (int f = 0; f < 2; ++f) {
        const std::uint64_t before = sim.counters().pixel_bytes;
        EXPECT_TRUE(spangle::frame(display, [&] { program.draw(f); }));
        EXPECT_EQ(sim.counters().pixel_bytes - before, 160U * 80 * 2);
    }
    EXPECT_EQ(sim::hash(sim.memory()), sim::hash(expected));
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglTerminate(display);
}

} // namespace
} // namespace spangle::test
