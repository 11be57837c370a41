// Tests memory-mapped displays in virtual time: a present is a new address, and GL never draws into memory
// that is scanned.
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

#include "host_sim/board/scanned_memory.hpp"
#include "tests/support/scene_player.hpp"

namespace {

using namespace spangle;
using hal::Fault;
using hal::Pacing;

constexpr std::int32_t width = 8, height = 12, stride = 20;

struct Rig {
    std::vector<std::uint8_t> memory[3];
    std::vector<RowSpan> rows = std::vector<RowSpan>(height);
    sim::ScannedMemory port{width, PixelFormat::rgb565_le, stride, {height, 4, 1000}};
    hal::MappedConfig config;
    std::unique_ptr<hal::MappedDisplay> display;
    std::vector<int> seen; ///< the frame that each refresh showed; -1: parts of two
    std::uint64_t row_ns = 500;

    explicit Rig(int buffers, Pacing pacing = Pacing::block) {
        config.width = width;
        config.height = height;
        config.stride = stride;
        config.touched = rows.data();
        config.pacing = pacing;
        config.refresh_us = 100;
        for (int i = 0; i < buffers; ++i) {
            memory[i].assign(stride * height, 0xEE);
            config.buffers[i] = memory[i].data();
        }
        port.on_refresh = [this](const sim::Image& glass) {
            const int first = glass.at(0, 0)[1];
            bool whole = true;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    whole = whole && glass.at(x, y)[1] == first;
            seen.push_back(whole ? (first * 63 + 127) / 255 : -1);
        };
        display = std::make_unique<hal::MappedDisplay>(port, config);
    }
    /// Fills the frame with this many steps of green, row by row, while the scan goes on.
    void draw(int number) {
        const auto frame = display->acquire();
        ASSERT_TRUE(frame.ok()) << frame.error().rule;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                frame.value().pixels[y * frame.value().stride + 2 * x] =
                    static_cast<std::uint8_t>(number << 5);
                frame.value().pixels[y * frame.value().stride + 2 * x + 1] =
                    static_cast<std::uint8_t>(number >> 3);
            }
            frame.value().extents->rows[y] = {0, width};
            port.advance(row_ns);
        }
    }
    void show(int number) {
        draw(number);
        const auto shown = display->present();
        ASSERT_TRUE(shown.ok()) << shown.error().rule;
    }
    int torn() const { return static_cast<int>(std::count(seen.begin(), seen.end(), -1)); }
    /// Returns the frames that some refresh showed, without the black one.
    std::set<int> frames() const {
        std::set<int> all(seen.begin(), seen.end());
        all.erase(-1);
        all.erase(0);
        return all;
    }
};

TEST(Mapped, ShowsBlackThenFrames) {
    Rig rig(2);
    EXPECT_EQ(rig.display->acquire().error().fault, Fault::bad_argument);
    EXPECT_EQ(rig.display->present().error().fault, Fault::bad_argument);
    EXPECT_TRUE(rig.display->finish().ok());
    ASSERT_TRUE(rig.display->init().ok());
    rig.port.advance(rig.port.period());
    EXPECT_EQ(rig.seen, std::vector<int>{0});
    rig.show(5);
    ASSERT_TRUE(rig.display->finish().ok());
    EXPECT_EQ(rig.port.scanned(), rig.memory[1].data()) << "the address is the flip";
    rig.port.advance(rig.port.period());
    EXPECT_EQ(rig.seen.back(), 5);
    const hal::DisplayInfo info = rig.display->info();
    EXPECT_EQ(info.width, width);
    EXPECT_EQ(info.height, height);
    EXPECT_FALSE(info.keeps_buffer);
    EXPECT_TRUE(Rig(1).display->info().keeps_buffer);
}

TEST(Mapped, OneBufferTearsTwoDoNot) {
    for (const std::uint64_t row_ns : {300u, 700u, 1500u, 4000u}) {
        Rig one(1), two(2), three(3);
        for (Rig* rig : {&one, &two, &three}) {
            rig->row_ns = row_ns;
            ASSERT_TRUE(rig->display->init().ok());
            for (int i = 1; i <= 40; ++i)
                rig->show(i);
            rig->port.advance(4 * rig->port.period());
        }
        EXPECT_GT(one.torn(), 0) << "drawn into while it is scanned";
        EXPECT_EQ(two.torn(), 0);
        EXPECT_EQ(three.torn(), 0);
        EXPECT_EQ(two.frames().size(), 40u) << "none is lost: presents wait";
        EXPECT_EQ(three.frames().size(), 40u);
    }
}

TEST(Mapped, ThreeBuffersOverlapDrawingAndWaiting) {
    std::uint64_t took[2];
    for (const int buffers : {2, 3}) {
        Rig rig(buffers);
        rig.row_ns = 1000; // drawing a frame takes three quarters of a refresh
        ASSERT_TRUE(rig.display->init().ok());
        rig.show(1);
        const std::uint64_t before = rig.port.now();
        rig.draw(2); // two buffers: the first is scanned until the refresh ends
        took[buffers - 2] = rig.port.now() - before;
    }
    EXPECT_EQ(took[1], 1000u * height) << "no wait";
    EXPECT_GT(took[0], took[1]);
}

TEST(Mapped, PacingOfThreeBuffers) {
    for (const Pacing pacing : {Pacing::coalesce, Pacing::drop}) {
        Rig rig(3, pacing);
        rig.row_ns = 100; // a refresh is as long as ten frames
        ASSERT_TRUE(rig.display->init().ok());
        const std::uint64_t before = rig.port.now();
        for (int i = 1; i <= 60; ++i)
            rig.show(i);
        EXPECT_EQ(rig.port.now() - before, 60u * height * 100) << "nobody waits";
        rig.port.advance(3 * rig.port.period());
        EXPECT_EQ(rig.torn(), 0);
        EXPECT_LT(rig.frames().size(), 10u);
        EXPECT_GT(rig.frames().size(), 3u);
        EXPECT_EQ(rig.seen.back() == 60, pacing == Pacing::coalesce) << "the newest, or the oldest";
    }
    Rig rig(3);
    ASSERT_TRUE(rig.display->init().ok());
    rig.display->swap_interval(0);
    rig.row_ns = 100;
    const std::uint64_t before = rig.port.now();
    for (int i = 1; i <= 9; ++i)
        rig.show(i);
    EXPECT_EQ(rig.port.now() - before, 9u * height * 100);
    rig.port.advance(3 * rig.port.period());
    EXPECT_EQ(rig.seen.back(), 9);
}

TEST(Mapped, AgesAreThoseOfTheBuffers) {
    for (const int buffers : {1, 2, 3}) {
        Rig rig(buffers);
        ASSERT_TRUE(rig.display->init().ok());
        for (int i = 1; i < 12; ++i) {
            const auto frame = rig.display->acquire();
            ASSERT_TRUE(frame.ok());
            if (frame.value().age > 0) {
                EXPECT_EQ(frame.value().pixels[0], static_cast<std::uint8_t>((i - frame.value().age) << 5))
                    << "what that frame drew";
            }
            EXPECT_EQ(frame.value().age > 0, i > (buffers == 1 ? 1 : 2)) << "the first free one: " << i;
            rig.show(i);
            rig.port.advance(2 * rig.port.period());
        }
    }
}

TEST(Mapped, DroppedFramesAreDrawnOverAndCleanedWhole) {
    Rig rig(3, Pacing::drop);
    ASSERT_TRUE(rig.display->init().ok());
    std::size_t cleaned = 0;
    rig.port.on_clean = [&](const std::uint8_t*, std::size_t bytes) { cleaned += bytes; };
    rig.row_ns = 1;
    rig.show(1);
    rig.show(2); // frame 1 still waits
    const std::uint8_t* const dropped = rig.display->acquire().value().pixels;
    EXPECT_EQ(rig.display->acquire().value().age, 1);
    rig.port.advance(2 * rig.port.period());
    cleaned = 0;
    EXPECT_EQ(rig.display->acquire().value().pixels, dropped);
    ASSERT_TRUE(rig.display->present().ok()); // nothing new was drawn
    EXPECT_EQ(cleaned, std::size_t{width} * 2 * height) << "what the dropped frame had drawn";
    EXPECT_TRUE(rig.display->present().ok()) << "nothing acquired: nothing to show";
}

TEST(Mapped, TheCacheIsCleanedOfWhatWasDrawn) {
    Rig rig(2);
    std::vector<std::pair<std::ptrdiff_t, std::size_t>> pieces;
    const std::uint8_t* base = rig.memory[0].data();
    rig.port.on_clean = [&](const std::uint8_t* from, std::size_t bytes) {
        pieces.push_back({from - base, bytes});
    };
    ASSERT_TRUE(rig.display->init().ok());
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_EQ(pieces[0], (std::pair<std::ptrdiff_t, std::size_t>{0, stride * height}));
    pieces.clear();
    const auto frame = rig.display->acquire().value();
    base = frame.pixels;
    frame.extents->rows[3] = {2, 5};
    frame.extents->rows[4] = {0, 1};
    ASSERT_TRUE(rig.display->present().ok());
    EXPECT_EQ(pieces,
              (std::vector<std::pair<std::ptrdiff_t, std::size_t>>{{3 * stride + 4, 6}, {4 * stride, 2}}));
    pieces.clear();
    const auto next = rig.display->acquire().value();
    base = next.pixels;
    EXPECT_EQ(next.extents->rows[3].begin, RowSpan{}.begin) << "nothing touched yet";
    next.extents->cleared = true;
    ASSERT_TRUE(rig.display->present().ok());
    EXPECT_EQ(pieces, (std::vector<std::pair<std::ptrdiff_t, std::size_t>>{{0, stride * height}}));
    pieces.clear();
    rig.config.touched = nullptr; // without a record everything is taken as touched
    hal::MappedDisplay plain(rig.port, rig.config);
    ASSERT_TRUE(plain.init().ok());
    pieces.clear();
    base = plain.acquire().value().pixels;
    ASSERT_TRUE(plain.present().ok());
    EXPECT_EQ(pieces, (std::vector<std::pair<std::ptrdiff_t, std::size_t>>{{0, stride * height}}));
}

/// Hardware looks up eight-bit pixels while it scans them, so a new colour shows without a present.
TEST(Mapped, PalettesInHardware) {
    for (const PixelFormat format : {PixelFormat::index8, PixelFormat::rgb332}) {
        if (!is_drawable(format))
            continue;
        std::vector<std::uint8_t> memory(16 * 16);
        hal::MappedConfig config;
        config.width = config.height = 16;
        config.format = format;
        config.buffers[0] = memory.data();
        sim::ScannedMemory port(16, format, 16, {16, 4, 1000});
        sim::Image last;
        port.on_refresh = [&](const sim::Image& glass) { last = glass; };
        hal::MappedDisplay display(port, config);
        ASSERT_TRUE(display.init().ok());
        const auto frame = display.acquire();
        ASSERT_TRUE(frame.ok());
        for (int i = 0; i < 256; ++i)
            frame.value().pixels[i] = static_cast<std::uint8_t>(i);
        ASSERT_TRUE(display.present().ok());
        port.advance(2 * port.period());
        for (int i = 0; i < 256; ++i)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(last.at(i % 16, i / 16)[c], hal::initial_color(i).c[c]) << i;
        const std::uint8_t rgb[6] = {10, 20, 30, 40, 50, 60};
        const auto set = display.set_palette(5, 2, rgb);
        port.advance(2 * port.period());
        if (format == PixelFormat::rgb332) {
            EXPECT_EQ(set.error().fault, Fault::unsupported) << "its colours are no palette's";
            EXPECT_EQ(last.at(6, 0)[1], hal::initial_color(6).c[1]);
            continue;
        }
        ASSERT_TRUE(set.ok());
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(last.at(5, 0)[c], rgb[c]);
            EXPECT_EQ(last.at(6, 0)[c], rgb[3 + c]);
            EXPECT_EQ(last.at(7, 0)[c], hal::initial_color(7).c[c]);
        }
        EXPECT_EQ(display.set_palette(255, 2, rgb).error().fault, Fault::bad_argument);
        EXPECT_STREQ(display.set_palette(-1, 2, rgb).error().rule,
                     "memory-mapped display: indices of a palette are 0 to 255");
    }
}

TEST(Mapped, AScanThatStandsStillIsATimeout) {
    Rig rig(2);
    ASSERT_TRUE(rig.display->init().ok());
    rig.show(1);
    rig.port.stands_still = true;
    const std::uint64_t before = rig.port.now();
    EXPECT_EQ(rig.display->finish().error().fault, Fault::timeout);
    EXPECT_LE(rig.port.now() - before, 300'000u) << "two refreshes, and no more patience";
    EXPECT_EQ(rig.display->acquire().error().fault, Fault::timeout);
    EXPECT_STREQ(rig.display->acquire().error().rule,
                 "memory-mapped display: the scan-out does not take the next frame");
    rig.port.stands_still = false;
    rig.show(2);
    ASSERT_TRUE(rig.display->finish().ok());
    rig.port.advance(rig.port.period());
    EXPECT_EQ(rig.seen.back(), 2);
}

TEST(Mapped, WrongDescriptionsAreRefused) {
    const auto refused = [](auto change) {
        Rig rig(2);
        change(rig.config);
        hal::MappedDisplay display(rig.port, rig.config);
        const auto r = display.init();
        EXPECT_EQ(rig.memory[0][0], 0xEE) << "nothing was touched";
        return r.error().fault == Fault::bad_argument;
    };
    EXPECT_TRUE(refused([](hal::MappedConfig& c) { c.width = 0; }));
    EXPECT_TRUE(refused([](hal::MappedConfig& c) { c.height = 40000; }));
    EXPECT_TRUE(refused([](hal::MappedConfig& c) { c.stride = 15; }));
    EXPECT_TRUE(refused([](hal::MappedConfig& c) { c.buffers[0] = nullptr; }));
    EXPECT_TRUE(refused([](hal::MappedConfig& c) { c.format = PixelFormat::mono; })) << "pages";
    EXPECT_TRUE(refused([](hal::MappedConfig& c) { c.format = PixelFormat::rgb444; })) << "half bytes";
    EXPECT_TRUE(refused([](hal::MappedConfig& c) {
        c.buffers[2] = c.buffers[1];
        c.buffers[1] = nullptr;
    }));
}

TEST(Mapped, ScenesAreWhatABoardShows) {
    const scenes::Scene& scene = *scenes::find("S6");
    sim::SimBoard board(boards::ili9341_spi);
    ASSERT_TRUE(test::play(board.display(), scene, 3));
    std::vector<std::uint8_t> memory[2];
    std::vector<RowSpan> rows(240);
    hal::MappedConfig config;
    config.width = 320;
    config.height = 240;
    config.touched = rows.data();
    for (int i = 0; i < 2; ++i) {
        memory[i].resize(320 * 240 * 2);
        config.buffers[i] = memory[i].data();
    }
    sim::ScannedMemory port(320, config.format, 640, {240, 10, 50000});
    sim::Image last;
    port.on_refresh = [&](const sim::Image& glass) { last = glass; };
    hal::MappedDisplay display(port, config);
    ASSERT_TRUE(test::play(display, scene, 3));
    ASSERT_TRUE(display.finish().ok());
    port.advance(port.period());
    EXPECT_EQ(sim::compare_565(last, board.glass()).identical_percent(), 100.0);
}

} // namespace
