// Tests surfaces of indices on panels that take colours. A present looks the colours up, and a new colour is
// sent wherever it is visible, and nowhere else.
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

namespace {

#if SPANGLE_FEATURE_COLOR_INDEX

using namespace spangle;

hal::Board indexed_board(bool row_hash = false, hal::Wire wire = hal::wires::rgb666) {
    hal::Board board = boards::ili9341_spi;
    board.display.format = PixelFormat::index8;
    board.display.wire = wire;
    board.display.buffers = 1;
    board.display.wait_te = board.display.poll_line = board.display.scan_order = false;
    board.display.row_hash = row_hash;
    return board;
}

/// A simulated board with a palette, whose presents return their bytes on the wire.
struct Rig {
    sim::SimBoard sim;
    hal::Display& display;
    std::uint8_t palette[256][3];
    hal::DisplayInfo info;

    explicit Rig(const hal::Board& board) : sim(board), display(sim.display()) {
        EXPECT_TRUE(display.init().ok());
        info = display.info();
        for (int i = 0; i < 256; ++i)
            for (int c = 0; c < 3; ++c)
                palette[i][c] = hal::initial_color(i).c[c];
    }
    hal::Frame frame() {
        const auto f = display.acquire();
        EXPECT_TRUE(f.ok());
        return f.value();
    }
    void put(int x, int y, int index) {
        const hal::Frame f = frame();
        f.pixels[y * f.stride + x] = static_cast<std::uint8_t>(index);
        RowSpan& row = f.extents->rows[y];
        row = {std::min(row.begin, static_cast<std::int16_t>(x)),
               std::max(row.end, static_cast<std::int16_t>(x + 1))};
    }
    void color(int index, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
        const std::uint8_t rgb[3] = {r, g, b};
        std::copy(rgb, rgb + 3, palette[index]);
        ASSERT_TRUE(display.set_palette(index, 1, rgb).ok());
    }
    std::uint64_t present() {
        const std::uint64_t before = sim.counters().pixel_bytes;
        EXPECT_TRUE(display.present().ok());
        EXPECT_TRUE(display.finish().ok());
        return sim.counters().pixel_bytes - before;
    }
    /// Returns the first pixel of the glass that does not have the palette's colour, on 666 within a step;
    /// empty if there is none.
    std::string difference() {
        const hal::Frame f = frame();
        const sim::Image glass = sim.glass();
        for (int y = 0; y < info.height; ++y)
            for (int x = 0; x < info.width; ++x)
                for (int c = 0; c < 3; ++c)
                    if (std::abs(glass.at(x, y)[c] - palette[f.pixels[y * f.stride + x]][c]) > 5)
                        return "pixel " + std::to_string(x) + ", " + std::to_string(y) + " is " +
                               std::to_string(glass.at(x, y)[c]) + ", not " +
                               std::to_string(palette[f.pixels[y * f.stride + x]][c]);
        return "";
    }
};

TEST(PalettesOfPanels, ShowEveryIndexInItsColour) {
    Rig rig(indexed_board());
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            rig.put(x, y, y * 4 + x / 16);
    rig.present();
    EXPECT_EQ(rig.difference(), "") << "through the initial palette";
    std::uint8_t rgb[256][3];
    std::mt19937 random(3);
    for (auto& color : rgb)
        for (std::uint8_t& c : color)
            c = static_cast<std::uint8_t>(random());
    std::copy(&rgb[0][0], &rgb[0][0] + 768, &rig.palette[0][0]);
    ASSERT_TRUE(rig.display.set_palette(0, 256, &rgb[0][0]).ok());
    rig.present();
    EXPECT_EQ(rig.difference(), "");
    EXPECT_EQ(rig.sim.violations_text(), "");
}

/// A pixel takes three bytes. Pixels that show a new colour are sent once, and no others.
TEST(PalettesOfPanels, ANewColourIsDamageWhereItShows) {
    for (const bool row_hash : {false, true}) {
        Rig rig(indexed_board(row_hash));
        rig.present();
        rig.put(10, 20, 7);
        rig.put(13, 20, 7);
        rig.put(200, 100, 7);
        rig.put(50, 60, 9);
        rig.present();
        const std::uint64_t idle = row_hash ? 48 : 0; // bytes of the cell that the row hash refreshes
        rig.color(8, 1, 2, 3);
        EXPECT_LE(rig.present(), idle) << "no pixel shows it";
        rig.color(7, 255, 128, 0);
        const std::uint64_t sent = rig.present();
        EXPECT_GE(sent, 3u * 5);
        EXPECT_LE(sent, 3u * (row_hash ? 48 : 5) + idle)
            << "two rows, from the first to the last pixel that shows it";
        EXPECT_EQ(rig.difference(), "") << row_hash;
        rig.color(7, 255, 128, 0);
        EXPECT_LE(rig.present(), idle) << "the colour it has";
        rig.color(9, 0, 0, 255);
        rig.color(9, hal::initial_color(9).c[0], hal::initial_color(9).c[1], hal::initial_color(9).c[2]);
        rig.present();
        EXPECT_EQ(rig.difference(), "") << "there and back";
    }
}

/// Whatever is drawn and recoloured, the glass shows the surface through the palette after every present.
TEST(PalettesOfPanels, TheGlassShowsThePaletteAfterEveryPresent) {
    for (const bool row_hash : {false, true}) {
        std::mt19937 random(12);
        Rig rig(indexed_board(row_hash));
        for (int present = 0; present < 60; ++present) {
            for (unsigned n = random() % 40; n > 0; --n)
                rig.put(static_cast<int>(random() % 320), static_cast<int>(random() % 240),
                        static_cast<int>(random() % 8));
            for (unsigned n = random() % 3; n > 0; --n)
                rig.color(static_cast<int>(random() % 9), static_cast<std::uint8_t>(random()),
                          static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()));
            rig.present();
            ASSERT_EQ(rig.difference(), "") << present << ' ' << row_hash;
        }
    }
}

/// A colour that was set before a failed transfer still reaches the glass.
TEST(PalettesOfPanels, SurviveAFailedTransfer) {
    Rig rig(indexed_board());
    rig.put(3, 3, 5);
    rig.present();
    rig.color(5, 255, 255, 255);
    rig.sim.fail_next(hal::Fault::timeout);
    (void)rig.display.present();
    (void)rig.display.finish();
    (void)rig.display.present();
    (void)rig.display.finish();
    EXPECT_EQ(rig.difference(), "");
}

/// In bands the old pixels are drawn over, so a new colour damages everything.
TEST(PalettesOfPanels, OfFramesInBands) {
    hal::Board board = indexed_board();
    board.display.band = 16;
    Rig rig(board);
    const auto draw = [&] {
        for (int first = 0; first < rig.info.height; first += 16) {
            const auto band = rig.display.acquire_band(first, 16);
            ASSERT_TRUE(band.ok()) << band.error().rule;
            for (int y = 0; y < 16; ++y)
                for (int x = 100; x < 140; ++x)
                    band.value().pixels[y * band.value().stride + x] = static_cast<std::uint8_t>(first / 16);
            for (int y = 0; y < 16; ++y)
                band.value().extents->rows[y] = {100, 140};
            ASSERT_TRUE(rig.display.present_band().ok());
        }
        ASSERT_TRUE(rig.display.finish().ok());
        const sim::Image glass = rig.sim.glass();
        for (int y = 0; y < rig.info.height; ++y)
            for (int x = 0; x < rig.info.width; ++x)
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(glass.at(x, y)[c], rig.palette[x >= 100 && x < 140 ? y / 16 : 0][c], 5)
                        << x << ' ' << y;
    };
    draw();
    rig.color(0, 10, 90, 200); // the colour outside of everything drawn
    draw();
    rig.color(3, 255, 255, 0);
    draw();
}

TEST(PalettesOfPanels, WhatCannotBe) {
    hal::Board board = indexed_board();
    board.display.wire = {};
    sim::SimBoard unwired(board);
    EXPECT_EQ(unwired.display().init().error().fault, hal::Fault::unsupported) << "indices do not travel";
    const std::uint8_t rgb[3] = {};
    sim::SimBoard early(indexed_board());
    EXPECT_EQ(early.display().set_palette(0, 1, rgb).error().fault, hal::Fault::unsupported) << "before init";
    sim::SimBoard colors(boards::ili9341_spi);
    ASSERT_TRUE(colors.display().init().ok());
    EXPECT_EQ(colors.display().set_palette(0, 1, rgb).error().fault, hal::Fault::unsupported);
    static hal::PanelStorage<hal::PanelSizes{.height = 320}> storage;
    const hal::Board described = indexed_board();
    hal::PanelDisplay display(early.bus(), described.display, storage.memory());
    EXPECT_EQ(display.init().error().fault, hal::Fault::bad_argument) << "no memory for a palette";
}

#endif

} // namespace
