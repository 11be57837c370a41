// Bands are drawn by callback or from a record. The glass must hold what it holds of whole frames.
#include "gl/context/features.hpp"
#include "tests/system/bands/banded.hpp"
#include "tests/system/bands/programs.hpp"

namespace spangle::test {
namespace {

constexpr int frames = 2; // the second frame is sent as damage

/// Returns the board with its picture turned.
hal::Board turned(hal::Board board, hal::Orientation orientation) {
    board.display.orientation = orientation;
    return board;
}

/// Returns band heights to try, in rows at which the display can begin a band. The last height holds the
/// whole picture.
std::vector<std::int32_t> heights_of(const hal::Board& board) {
    const std::int32_t unit = hal::band_unit(board.display), all = hal::picture_size(board.display).height;
    std::vector<std::int32_t> heights;
    for (const std::int32_t h : {1, 3, 8, 16, all}) {
        const std::int32_t rows = (h + unit - 1) / unit * unit;
        if (heights.empty() || heights.back() < rows)
            heights.push_back(rows);
    }
    return heights;
}

void expect_same(const hal::Board& board, const Program& program, const Setting& setting,
                 const std::vector<sim::Image>& whole) {
    for (const EGLint record : {0, 1 << 21}) {
        if (record != 0 && setting.display_band == 0)
            continue; // a record needs a display that holds bands
        Setting with = setting;
        with.record = record;
        const std::vector<sim::Image> banded = play(board, with, program, frames);
        ASSERT_EQ(banded.size(), whole.size());
        for (std::size_t f = 0; f < whole.size(); ++f)
            EXPECT_EQ(sim::hash(banded[f]), sim::hash(whole[f]))
                << program.name << " on " << board.name << ", bands of " << setting.display_band << " and "
                << setting.band_height << " rows, a record of " << record << ", frame " << f;
    }
}

TEST(BandHeights, ScenesAreTheSameAtEveryHeight) {
    for (const scenes::Scene& scene : scenes::all()) {
        const hal::Board& board = boards::st7735_80x160;
        const std::vector<sim::Image> whole = play(board, {}, program_of(scene), frames);
        for (const std::int32_t height : heights_of(board))
            expect_same(board, program_of(scene), {.display_band = height}, whole);
    }
}

TEST(BandHeights, StatesAreTheSameAtEveryHeight) {
    for (const Program& program : programs()) {
        const hal::Board& board = boards::st7735_80x160;
        const std::vector<sim::Image> whole = play(board, {}, program, frames);
        for (const std::int32_t height : heights_of(board))
            expect_same(board, program, {.display_band = height}, whole);
    }
}

/// Batches of every mode that bands may leave out.
TEST(BandHeights, BatchesAreTheSameAtEveryHeight) {
    for (const Program& program : batch_programs()) {
        const hal::Board& board = boards::st7735_80x160;
        const std::vector<sim::Image> whole = play(board, {}, program, frames);
        for (const std::int32_t height : heights_of(board))
            expect_same(board, program, {.display_band = height}, whole);
#if SPANGLE_FEATURE_MULTISAMPLE
        expect_same(board, program, {.display_band = 8, .samples = 4},
                    play(board, {.samples = 4}, program, frames));
#endif
    }
}

/// Pages of eight rows, pairs of columns, three bytes a pixel; one bus buffer and two; eight orientations.
TEST(BandHeights, FormatsAndOrientations) {
    const Program program = program_of(scenes::hud);
    for (hal::Board board : {boards::ssd1306_128x32, boards::ssd0323_spi, boards::st7735_80x160})
        for (const hal::Orientation orientation : hal::orientations) {
            board = turned(board, orientation);
            const std::vector<sim::Image> whole = play(board, {}, program, frames);
            for (const std::int32_t height : heights_of(board)) {
                expect_same(board, program, {.display_band = height}, whole);
                if (board.display.wire.converts())
                    continue;
                hal::Board two = board;
                two.display.buffers = 2;
                expect_same(two, program, {.display_band = height}, whole);
            }
        }
}

/// The viewport belongs to GL's window, whichever way the panel's rows run. A quad that is larger ends where
/// a scissor box of that place would cut it.
TEST(BandHeights, ViewportsTurnWithThePicture) {
    const auto quad = [](int) {
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_QUADS);
        for (const auto& [x, y] : {std::pair{-3.F, -3.F}, {3.F, -3.F}, {3.F, 3.F}, {-3.F, 3.F}})
            glVertex2f(x, y);
        glEnd();
    };
    const Program viewport = {"viewport", [](int, int) { glViewport(20, 13, 25, 30); }, quad};
    const Program scissor = {"scissor",
                             [](int w, int h) {
                                 glViewport(0, 0, w, h);
                                 glScissor(20, 13, 25, 30);
                                 glEnable(GL_SCISSOR_TEST);
                             },
                             quad};
    for (const hal::Orientation orientation : hal::orientations) {
        const hal::Board board = turned(boards::st7735_80x160, orientation);
        const std::vector<sim::Image> cut = play(board, {}, scissor, frames);
        EXPECT_EQ(sim::hash(play(board, {}, viewport, frames)[1]), sim::hash(cut[1]));
        for (const std::int32_t height : heights_of(board))
            expect_same(board, viewport, {.display_band = height}, cut);
    }
}

/// Surfaces in the panel's own formats: pages, four-bit greys, 12 and 18 bits.
TEST(BandHeights, NarrowSurfaces) {
    const Program program = program_of(scenes::hud);
    hal::Board mono = boards::ssd1306_128x32, grey = boards::ssd0323_spi, wide = boards::ili9488_spi;
    mono.display.wire = grey.display.wire = {};
    mono.display.format = PixelFormat::mono;
    grey.display.format = PixelFormat::grey4;
    wide.display.format = PixelFormat::rgb666;
    for (const hal::Board& board : {mono, grey, wide}) {
        const std::vector<sim::Image> whole = play(board, {}, program, frames);
        for (const std::int32_t height : heights_of(board))
            expect_same(board, program, {.display_band = height}, whole);
    }
}

/// The display holds whole frames, and only depth has bands; or the display's bands are higher than depth's.
TEST(BandHeights, DepthAloneInBands) {
    const hal::Board& board = boards::st7735_80x160;
    for (const scenes::Scene* scene : {&scenes::gears, &scenes::hud}) {
        const Program program = program_of(*scene);
        const std::vector<sim::Image> whole = play(board, {}, program, frames);
        for (const std::int32_t height : {1, 7, 80})
            expect_same(board, program, {.band_height = height}, whole);
        expect_same(board, program, {.display_band = 32, .band_height = 5}, whole);
    }
}

#if SPANGLE_FEATURE_MULTISAMPLE

/// The multisample buffer has the rows of one band, too.
TEST(BandHeights, SamplesInBands) {
    hal::Board mono = boards::ssd1306_128x32;
    mono.display.wire = {};
    mono.display.format = PixelFormat::mono;
    for (const hal::Board& board : {boards::st7735_80x160, mono})
        for (const Program& program : programs()) {
            const std::vector<sim::Image> whole = play(board, {.samples = 4}, program, frames);
            for (const std::int32_t height : heights_of(board))
                expect_same(board, program, {.display_band = height, .samples = 4}, whole);
            expect_same(board, program, {.band_height = 7, .samples = 4}, whole);
        }
}

#endif

/// A band begins black, with depth, stencil and accumulation 0, whatever the band above left behind.
TEST(BandHeights, EveryBandBeginsTheSame) {
    const Program never_clears = {"never clears",
                                  [](int w, int h) {
                                      glViewport(0, 0, w, h);
                                      glEnable(GL_DEPTH_TEST);
                                      glDepthFunc(GL_GEQUAL);
                                      glEnable(GL_BLEND);
                                      glBlendFunc(GL_ONE, GL_ONE);
                                  },
                                  [](int f) {
                                      glColor3f(0.2F, 0.3F, 0.1F);
                                      for (const float z : {0.9F, -0.5F, 0.F}) {
                                          glBegin(GL_TRIANGLES);
                                          glVertex3f(-0.9F + 0.1F * static_cast<float>(f), -0.9F, z);
                                          glVertex3f(0.8F, -0.7F, z);
                                          glVertex3f(0.1F, 0.93F, z);
                                          glEnd();
                                      }
                                      glAccum(GL_ACCUM, 1.F);
                                      glAccum(GL_RETURN, 1.F);
                                  }};
    for (const EGLint samples : {0, SPANGLE_FEATURE_MULTISAMPLE ? 4 : 0}) {
        const hal::Board& board = boards::st7735_80x160;
        const std::vector<sim::Image> one =
            play(board, {.display_band = 80, .samples = samples}, never_clears, frames);
        for (const std::int32_t height : {1, 8, 33})
            expect_same(board, never_clears, {.display_band = height, .samples = samples}, one);
    }
}

/// The second frame of an unchanged scene sends as many bytes as a whole frame would: only what changed, or
/// nothing.
TEST(BandHeights, WhatDoesNotChangeIsNotSent) {
    const Program still = {"still", [](int w, int h) { glViewport(0, 0, w, h); },
                           [](int f) {
                               glClearColor(0.F, 0.F, f < 2 ? 0.F : 1.F, 0.F);
                               glClear(GL_COLOR_BUFFER_BIT);
                               glRectf(-0.5F, -0.5F, f == 1 ? 0.25F : 0.F, 0.25F);
                           }};
    for (const Setting& setting :
         {Setting{}, Setting{.display_band = 8}, Setting{.display_band = 80}, Setting{.band_height = 8}}) {
        Banded window(boards::st7735_80x160, setting);
        window.set_up(still);
        std::uint64_t bytes[4];
        for (int f = 0; f < 4; ++f) {
            const std::uint64_t before = window.sim.counters().pixel_bytes;
            (void)window.show(still, f);
            bytes[f] = window.sim.counters().pixel_bytes - before;
        }
        EXPECT_LT(bytes[1], 160U * 80 * 2 / 2);
        EXPECT_EQ(bytes[1], 60U * 30 * 2);  // bytes of the rectangle at both places
        EXPECT_EQ(bytes[2], 160U * 80 * 2); // all bytes, because the clear value is another one
        EXPECT_LT(bytes[3], 160U * 80 * 2 / 4);
    }
}

TEST(BandHeights, TheCallbackIsCalledOnceForEachBand) {
    const Program program = program_of(scenes::clear);
    for (const auto& [setting, calls] : {std::pair{Setting{}, 1},
                                         {Setting{.display_band = 8}, 10},
                                         {Setting{.display_band = 33}, 3},
                                         {Setting{.band_height = 80}, 1},
                                         {Setting{.display_band = 33, .band_height = 20}, 4}}) {
        Banded window(boards::st7735_80x160, setting);
        window.set_up(program);
        (void)window.show(program, 0);
        EXPECT_EQ(window.draws, calls);
    }
}

} // namespace
} // namespace spangle::test
