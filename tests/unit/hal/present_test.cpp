// After every successful present the panel's memory must equal the surface. Only damage may be sent: what did
// not change is not sent.
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/hal/fake_panel_bus.hpp"
#include <spangle/hal/panel_display.hpp>
#include <spangle/panels.hpp>

using namespace hal_test;

namespace {

constexpr PanelDesc tiny =
    panel({.name = "tiny",
           .memory = {48, 64},
           .glass = {36, 50},
           .offset = {5, 9},
           .mount = dcs::MX,
           .order = ColorOrder::bgr,
           .inverted = true,
           .serial = {.rgb565 = 0x55, .rgb666 = 0x66},
           .parallel = {.rgb565 = 0x55, .rgb666 = 0x66},
           .setup = {},
           .timing = {.practical_serial_mhz = 100, .frame_us = 10000, .scan_lines = 70, .porch_lines = 6},
           .identity = {.id = 0x858552},
           .quirks = {}});

/// Draws clears and rectangles as a rasterizer does, and leaves the extents that a display reads.
struct Painter {
    Frame frame;
    DisplayInfo info;

    void fill(const Rect& r, std::uint32_t value) {
        const int bytes = format_info(info.format).bytes_per_pixel;
        for (int y = r.y; y < r.y + r.h; ++y)
            for (int x = r.x; x < r.x + r.w; ++x)
                for (int b = 0; b < bytes; ++b)
                    frame.pixels[y * frame.stride + x * bytes + b] =
                        static_cast<std::uint8_t>(value >> 8 * (bytes - 1 - b));
    }
    void draw(const Rect& r, std::uint32_t value) {
        fill(r, value);
        for (int y = r.y; y < r.y + r.h; ++y) {
            RowSpan& row = frame.extents->rows[y];
            row.begin = static_cast<std::int16_t>(std::min<int>(row.begin, r.x));
            row.end = static_cast<std::int16_t>(std::max<int>(row.end, r.x + r.w));
        }
    }
    void clear(std::uint32_t value) {
        fill({0, 0, info.width, info.height}, value);
        for (int y = 0; y < info.height; ++y)
            frame.extents->rows[y] = RowSpan{};
        frame.extents->cleared = true;
        frame.extents->clear_value = value;
    }
};

struct Bench {
    FakePanelBus bus;
    PanelStorage<PanelSizes{
        .height = 64, .buffers = 2, .ops = 8, .hashed_width = 64, .turned = true, .held = true}>
        storage; // eight operations: most frames take several lists
    PanelDisplay display;
    PanelConfig config;

    Bench(PanelConfig c, BusCaps caps = spi())
        : bus(tiny, caps), display(bus, c, storage.memory()), config(c) {}

    Painter acquire() {
        const auto frame = display.acquire();
        EXPECT_TRUE(frame.ok()) << frame.error().rule;
        return {frame.value(), display.info()};
    }

    std::uint32_t surface(const Frame& frame, int x, int y) const {
        const int bytes = format_info(config.format).bytes_per_pixel;
        std::uint32_t value = 0;
        for (int b = 0; b < bytes; ++b)
            value = value << 8 | frame.pixels[y * frame.stride + x * bytes + b];
        return value;
    }

    /// Returns the pixel of the panel's memory behind (x, y) of the picture, at the address where the
    /// controller writes it.
    std::uint32_t on_panel(int x, int y) const {
        const Placement placed = place(tiny, config.orientation);
        int column = x + placed.offset.x, row = y + placed.offset.y;
        if (placed.madctl & 0x20)
            std::swap(column, row);
        if (placed.madctl & 0x40)
            column = tiny.memory.width - 1 - column;
        if (placed.madctl & 0x80)
            row = tiny.memory.height - 1 - row;
        return bus.model.at(column, row);
    }

    ::testing::AssertionResult shows(const Frame& frame) const {
        const DisplayInfo info = display.info();
        for (int y = 0; y < info.height; ++y)
            for (int x = 0; x < info.width; ++x)
                if (on_panel(x, y) != surface(frame, x, y))
                    return ::testing::AssertionFailure()
                           << "(" << x << "," << y << "): panel " << on_panel(x, y) << ", surface "
                           << surface(frame, x, y);
        if (bus.model.stray != 0)
            return ::testing::AssertionFailure() << "writes outside the memory";
        if (bus.model.overrun != 0)
            return ::testing::AssertionFailure() << "more pixels than the window holds";
        return ::testing::AssertionSuccess();
    }
};

int pick(std::mt19937& random, int below) {
    return static_cast<int>(random() % static_cast<unsigned>(below));
}

Rect random_rect(std::mt19937& random, const DisplayInfo& info) {
    const int x = pick(random, info.width), y = pick(random, info.height);
    return {x, y, 1 + pick(random, info.width - x), 1 + pick(random, info.height - y)};
}

void random_frame(std::mt19937& random, Painter painter) {
    const std::uint32_t clears[] = {0x0000, 0x1234, 0xF00F};
    if (painter.frame.age == 0 && pick(random, 2) != 0)
        painter.clear(clears[pick(random, 3)]);
    for (int n = pick(random, 5); n > 0; --n) {
        if (pick(random, 3) == 0)
            painter.clear(clears[pick(random, 8) == 0 ? pick(random, 3) : 0]);
        else
            painter.draw(random_rect(random, painter.info), random());
    }
}

/// Causes one fault, or none.
void upset(std::mt19937& random, FakePanelBus& bus) {
    switch (pick(random, 12)) {
    case 0:
        bus.refuse_submits = 1 + pick(random, 2);
        break;
    case 1:
    case 2:
        bus.fail_after_bytes = pick(random, 3000);
        break;
    case 3:
        bus.late_waits = 1 + pick(random, 3);
        break;
    default:
        break;
    }
}

PanelConfig config(Orientation o, int buffers, PixelFormat format = PixelFormat::rgb565_be) {
    PanelConfig c;
    c.panel = &tiny;
    c.orientation = o;
    c.format = format;
    c.buffers = static_cast<std::uint8_t>(buffers);
    return c;
}

struct Tally {
    long frames = 0, failures = 0;
};

void run_oracle(PanelConfig c, BusCaps caps, unsigned seed, bool faults, int frames, Tally& tally) {
    Bench bench(c, caps);
    ASSERT_TRUE(bench.display.init().ok());
    std::mt19937 random(seed);
    for (int n = 0; n < frames; ++n) {
        const auto frame = bench.display.acquire();
        if (!frame.ok()) { // a late transfer still reads the buffer
            ASSERT_EQ(frame.error().fault, Fault::busy);
            bench.bus.run_pending();
            continue;
        }
        random_frame(random, {frame.value(), bench.display.info()});
        if (faults)
            upset(random, bench.bus);
        const Result<void> sent = bench.display.present();
        ++tally.frames;
        if (!sent.ok()) {
            ++tally.failures;
            ASSERT_STRNE(sent.error().rule, "");
            continue;
        }
        if (c.buffers == 2 && faults && !bench.display.finish().ok()) {
            ++tally.failures; // the failure is reported now, and the next present sends the frame again
            continue;
        }
        if (c.buffers == 1 || pick(random, 2) == 0) {
            ASSERT_TRUE(bench.display.finish().ok());
            ASSERT_TRUE(bench.shows(frame.value())) << "frame " << n;
        }
    }
}

} // namespace

TEST(Present, PanelEqualsSurfaceInAllOrientations) {
    Tally tally;
    unsigned seed = 1;
    for (const Orientation o : orientations)
        for (int buffers = 1; buffers <= 2; ++buffers)
            for (const PixelFormat format : {PixelFormat::rgb565_be, PixelFormat::rgb888})
                run_oracle(config(o, buffers, format), spi(), ++seed, false, 120, tally);
    EXPECT_EQ(tally.frames, 8 * 2 * 2 * 120);
    EXPECT_EQ(tally.failures, 0);
}

TEST(Present, TurnedFramesEqualTheSurface) {
    Tally tally;
    unsigned seed = 1;
    for (const Orientation o : orientations)
        for (const bool hash : {false, true})
            for (const PixelFormat format : {PixelFormat::rgb565_be, PixelFormat::rgb888}) {
                PanelConfig c = config(o, 2, format);
                c.scan_order = true;
                c.row_hash = hash;
                run_oracle(c, spi(), ++seed, false, 100, tally);
                run_oracle(c, spi(), ++seed, true, 100, tally);
            }
    EXPECT_GT(tally.failures, 100);
}

/// The bus is always slower than the program here. Frames that are put off must not be lost.
TEST(Present, FramesPutOffAreCarriedByTheNext) {
    for (const Pacing pacing : {Pacing::drop, Pacing::coalesce})
        for (unsigned seed = 1; seed <= 24; ++seed) {
            PanelConfig c = config(orientations[seed % 8], 2);
            c.pacing = pacing;
            c.scan_order = seed % 3 == 0;
            c.row_hash = seed % 4 == 0;
            Bench bench(c);
            ASSERT_TRUE(bench.display.init().ok());
            std::mt19937 random(seed);
            std::uint32_t put_off = 0;
            for (int n = 0; n < 150; ++n) {
                const auto frame = bench.display.acquire();
                ASSERT_TRUE(frame.ok()) << frame.error().rule;
                random_frame(random, {frame.value(), bench.display.info()});
                ASSERT_TRUE(bench.display.present().ok());
                const bool sent = bench.display.counters().put_off == put_off;
                put_off = bench.display.counters().put_off;
                const int what = pick(random, 4);
                if (what == 0) { // the transfer ends by itself
                    bench.bus.run_pending();
                    if (sent) {
                        ASSERT_TRUE(bench.shows(frame.value())) << "frame " << n;
                    }
                    ASSERT_TRUE(bench.display.poll().ok());
                } else if (what == 1) {
                    ASSERT_TRUE(bench.display.finish().ok());
                    if (sent || pacing == Pacing::coalesce) {
                        ASSERT_TRUE(bench.shows(frame.value())) << "frame " << n << " of seed " << seed;
                    }
                }
            }
            EXPECT_GT(put_off, 20u);
        }
}

TEST(Present, ADroppedFrameIsNotOwedACoalescedOneIs) {
    for (const Pacing pacing : {Pacing::drop, Pacing::coalesce}) {
        PanelConfig c = config({}, 2);
        c.pacing = pacing;
        Bench bench(c);
        ASSERT_TRUE(bench.display.init().ok());
        bench.acquire().clear(0x1111);
        ASSERT_TRUE(bench.display.present().ok());
        Painter second = bench.acquire();
        second.clear(0x2222);
        ASSERT_TRUE(bench.display.present().ok()); // the first frame is still on the wire
        EXPECT_EQ(bench.display.counters().put_off, 1u);
        EXPECT_EQ(bench.display.counters().sent, 1u);
        const Painter again = bench.acquire();
        EXPECT_EQ(again.frame.pixels, second.frame.pixels);
        EXPECT_EQ(again.frame.age, 1) << "the frame that was put off";
        ASSERT_TRUE(bench.display.finish().ok());
        EXPECT_EQ(bench.on_panel(3, 3), pacing == Pacing::drop ? 0x1111u : 0x2222u);
        // The frame that was put off is drawn over, so it is no longer the presented frame and is not sent.
        bench.acquire().clear(0x3333);
        ASSERT_TRUE(bench.display.present().ok());
        bench.acquire().clear(0x4444);
        ASSERT_TRUE(bench.display.present().ok());
        bench.acquire().draw({0, 0, 2, 2}, 0x5555);
        ASSERT_TRUE(bench.display.finish().ok());
        EXPECT_EQ(bench.on_panel(3, 3), 0x3333u);
        ASSERT_TRUE(bench.display.present().ok());
        ASSERT_TRUE(bench.display.finish().ok());
        EXPECT_EQ(bench.on_panel(3, 3), 0x4444u);
        EXPECT_EQ(bench.on_panel(1, 1), 0x5555u);
        bench.acquire().clear(0x6666);
        ASSERT_TRUE(bench.display.present().ok());
        bench.acquire().clear(0x7777);
        ASSERT_TRUE(bench.display.present().ok());
        bench.acquire().clear(0x8888); // a clear is drawing, too
        ASSERT_TRUE(bench.display.finish().ok());
        EXPECT_EQ(bench.on_panel(3, 3), 0x6666u);
    }
}

TEST(Present, ASwapIntervalOfZeroNeverWaits) {
    Bench bench(config({}, 2));
    ASSERT_TRUE(bench.display.init().ok());
    bench.display.swap_interval(0);
    for (int n = 0; n < 3; ++n) {
        bench.acquire().clear(static_cast<std::uint32_t>(n));
        ASSERT_TRUE(bench.display.present().ok());
    }
    EXPECT_EQ(bench.display.counters().put_off, 2u);
    bench.display.swap_interval(1);
    bench.acquire().clear(9);
    ASSERT_TRUE(bench.display.present().ok());
    EXPECT_EQ(bench.display.counters().put_off, 2u);
    ASSERT_TRUE(bench.display.finish().ok());
    EXPECT_EQ(bench.on_panel(0, 0), 9u);
}

TEST(Present, WhatIsOnTheWireIsNotHandedOut) {
    Bench bench(config({}, 2));
    ASSERT_TRUE(bench.display.init().ok());
    for (int n = 0; n < 5; ++n) {
        Painter painter = bench.acquire();
        const std::uint8_t* const on_wire =
            bench.bus.last_list.empty() ? nullptr : bench.bus.last_list.back().data;
        painter.clear(static_cast<std::uint32_t>(n));
        if (n > 0) {
            EXPECT_NE(on_wire, painter.frame.pixels);
        }
        ASSERT_TRUE(bench.display.present().ok());
    }
}

TEST(Present, AFrameThatIsSentWhileTheNextIsDrawnIsOneList) {
    Bench bench(config({}, 2)); // eight operations are enough for two windows
    ASSERT_TRUE(bench.display.init().ok());
    for (int n = 0; n < 2; ++n) {
        bench.acquire().clear(0);
        ASSERT_TRUE(bench.display.present().ok());
    }
    Painter painter = bench.acquire();
    painter.clear(0);
    for (int y = 0; y < 48; y += 7)
        painter.draw({y % 30, y, 3, 2}, 0x1234);
    ASSERT_TRUE(bench.display.finish().ok());
    const int submits = bench.bus.submits;
    ASSERT_TRUE(bench.display.present().ok());
    EXPECT_EQ(bench.bus.submits, submits + 1);
    EXPECT_LE(bench.bus.last_list.size(), 8u);
    ASSERT_TRUE(bench.display.finish().ok());
    EXPECT_TRUE(bench.shows(painter.frame));
}

TEST(Present, NoFaultLosesDamage) {
    Tally tally;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        PanelConfig c = config(orientations[seed % 8], 1 + static_cast<int>(seed % 2));
        c.row_hash = seed % 3 == 0;
        run_oracle(c, spi(), seed, true, 200, tally);
    }
    EXPECT_GT(tally.failures, 500) << "faults did not happen";
}

TEST(Present, ShortOperationsOfTheBusAreRespected) {
    for (std::uint32_t most : {4u, 5u, 7u, 64u, 73u, 200u}) {
        BusCaps caps = spi();
        caps.max_transfer = most;
        Tally tally;
        run_oracle(config({Rotation::r90, false}, 1), caps, most, false, 30, tally);
        Bench bench(config({}, 1, PixelFormat::rgb888), caps);
        ASSERT_TRUE(bench.display.init().ok());
        Painter painter = bench.acquire();
        painter.draw({1, 1, 30, 40}, 0x123456);
        ASSERT_TRUE(bench.display.present().ok());
        EXPECT_LE(bench.bus.longest_op, most);
        EXPECT_EQ(bench.bus.cut_pixels, 0);
        EXPECT_TRUE(bench.shows(painter.frame));
    }
}

TEST(Present, UnchangedClearSendsOldAndNewPlaces) {
    Bench bench(config({}, 1));
    ASSERT_TRUE(bench.display.init().ok());
    for (int n = 0; n < 2; ++n) {
        Painter painter = bench.acquire();
        painter.clear(0x1111);
        painter.draw({2, 3, 4, 5}, 0xABCD);
        ASSERT_TRUE(bench.display.present().ok());
    }
    bench.bus.pixel_bytes = 0;
    Painter painter = bench.acquire();
    painter.clear(0x1111);
    painter.draw({20, 30, 6, 7}, 0x5678);
    ASSERT_TRUE(bench.display.present().ok());
    EXPECT_EQ(bench.bus.pixel_bytes, (4 * 5 + 6 * 7) * 2);
    EXPECT_TRUE(bench.shows(painter.frame));
}

TEST(Present, ChangedClearSendsEverything) {
    Bench bench(config({}, 1));
    ASSERT_TRUE(bench.display.init().ok());
    for (std::uint32_t value : {0x1111u, 0x2222u}) {
        bench.bus.pixel_bytes = 0;
        Painter painter = bench.acquire();
        painter.clear(value);
        ASSERT_TRUE(bench.display.present().ok());
        EXPECT_EQ(bench.bus.pixel_bytes, 36 * 50 * 2);
    }
}

TEST(Present, NothingTouchedSendsNothing) {
    for (int buffers = 1; buffers <= 2; ++buffers) {
        Bench bench(config({}, buffers));
        ASSERT_TRUE(bench.display.init().ok());
        for (int n = 0; n < 3; ++n) {
            Painter painter = bench.acquire();
            painter.clear(0x1111);
            ASSERT_TRUE(bench.display.present().ok());
        }
        ASSERT_TRUE(bench.display.finish().ok());
        const int submits = bench.bus.submits;
        Painter painter = bench.acquire();
        painter.clear(0x1111);
        ASSERT_TRUE(bench.display.present().ok());
        EXPECT_EQ(bench.bus.submits, submits) << buffers << " buffers";
    }
}

TEST(Present, TwoBuffersWithoutClearSendTheLastFrameToo) {
    Bench bench(config({}, 2));
    ASSERT_TRUE(bench.display.init().ok());
    for (int n = 0; n < 2; ++n) { // after two frames the contents of both buffers are known
        bench.acquire().clear(0x1111);
        ASSERT_TRUE(bench.display.present().ok());
    }
    Painter first = bench.acquire();
    EXPECT_EQ(first.frame.age, 2);
    first.draw({0, 0, 3, 3}, 0xAAAA);
    ASSERT_TRUE(bench.display.present().ok());
    ASSERT_TRUE(bench.display.finish().ok());
    bench.bus.pixel_bytes = 0;
    Painter second = bench.acquire();
    second.draw({10, 20, 2, 2}, 0xBBBB);
    ASSERT_TRUE(bench.display.present().ok());
    ASSERT_TRUE(bench.display.finish().ok());
    EXPECT_EQ(bench.bus.pixel_bytes, (3 * 3 + 2 * 2) * 2);
    EXPECT_TRUE(bench.shows(second.frame));
}

TEST(Present, BufferAgeIsTheNumberOfBuffersOnceTheyAreDrawn) {
    for (int buffers = 1; buffers <= 2; ++buffers) {
        Bench bench(config({}, buffers));
        ASSERT_TRUE(bench.display.init().ok());
        std::uint8_t* last = nullptr;
        for (int n = 0; n < 4; ++n) {
            const Frame frame = bench.acquire().frame;
            EXPECT_EQ(frame.age, n < buffers ? 0 : buffers);
            EXPECT_EQ(frame.pixels == last, buffers == 1 && n > 0);
            EXPECT_EQ(bench.acquire().frame.pixels, frame.pixels) << "the same until present";
            last = frame.pixels;
            ASSERT_TRUE(bench.display.present().ok());
        }
    }
}

TEST(Present, OneListWhenItFits) {
    FakePanelBus bus(tiny, spi());
    PanelStorage<PanelSizes{.height = 50}> storage;
    PanelDisplay display(bus, config({}, 1), storage.memory());
    ASSERT_TRUE(display.init().ok());
    const int submits = bus.submits;
    bus.log.clear();
    ASSERT_TRUE(display.present().ok());
    EXPECT_EQ(bus.submits, submits + 1);
    EXPECT_EQ(bus.log, "2C ")
        << "the window is the one the black fill used: CASET and RASET are not sent again";
    EXPECT_EQ(bus.last_list.back().rows, 1u) << "full rows go out as one block";
}

TEST(Present, WindowIsSentAgainAfterAFault) {
    FakePanelBus bus(tiny, spi());
    PanelStorage<PanelSizes{.height = 50}> storage;
    PanelDisplay display(bus, config({}, 1), storage.memory());
    ASSERT_TRUE(display.init().ok());
    bus.fail_after_bytes = 100;
    const Result<void> sent = display.present();
    EXPECT_EQ(sent.error().fault, Fault::short_write);
    bus.log.clear();
    ASSERT_TRUE(display.present().ok());
    EXPECT_EQ(bus.log, "2A 00 07 00 2a 2B 00 09 00 3a 2C "); // MX: column 7 is 48 - (36 + 5)
}

TEST(Present, QuirkSendsTheWindowEachTime) {
    PanelDesc clone = tiny;
    clone.quirks.resend_window = true;
    PanelConfig c = config({}, 1);
    c.panel = &clone;
    FakePanelBus bus(tiny, spi());
    PanelStorage<PanelSizes{.height = 50}> storage;
    PanelDisplay display(bus, c, storage.memory());
    ASSERT_TRUE(display.init().ok());
    bus.log.clear();
    ASSERT_TRUE(display.present().ok());
    EXPECT_EQ(bus.log, "2A 00 07 00 2a 2B 00 09 00 3a 2C ");
}

TEST(Present, LateTransferKeepsTheFrame) {
    Bench bench(config({}, 1));
    ASSERT_TRUE(bench.display.init().ok());
    Painter painter = bench.acquire();
    painter.draw({0, 0, 4, 4}, 0x7777);
    bench.bus.late_waits = 1;
    EXPECT_EQ(bench.display.present().error().fault, Fault::timeout);
    EXPECT_EQ(bench.display.acquire().error().fault, Fault::busy);
    bench.bus.late_waits = 1;
    EXPECT_EQ(bench.display.init().error().fault, Fault::busy);
    bench.bus.run_pending();
    EXPECT_EQ(bench.acquire().frame.pixels, painter.frame.pixels);
    painter.draw({5, 5, 4, 4}, 0x8888);
    bench.bus.pixel_bytes = 0;
    ASSERT_TRUE(bench.display.present().ok());
    EXPECT_EQ(bench.bus.pixel_bytes, 36 * 50 * 2) << "what a late transfer carried is not trusted";
    EXPECT_TRUE(bench.shows(painter.frame));
}

TEST(Present, InitRecoversAPanelThatLostItsPower) {
    Bench bench(config({}, 2));
    ASSERT_TRUE(bench.display.init().ok());
    Painter painter = bench.acquire();
    painter.clear(0x1111);
    painter.draw({3, 3, 9, 9}, 0x4242);
    ASSERT_TRUE(bench.display.present().ok());
    ASSERT_TRUE(bench.display.finish().ok());
    std::fill(bench.bus.model.memory.begin(), bench.bus.model.memory.end(), 0xBAD);
    ASSERT_TRUE(bench.display.init().ok());
    Painter next = bench.acquire();
    next.clear(0x1111);
    ASSERT_TRUE(bench.display.present().ok());
    ASSERT_TRUE(bench.display.finish().ok());
    EXPECT_TRUE(bench.shows(next.frame));
}

TEST(Present, ExtentsOutsideThePictureAreClipped) {
    Bench bench(config({}, 1));
    ASSERT_TRUE(bench.display.init().ok());
    ASSERT_TRUE(bench.display.present().ok());
    bench.bus.pixel_bytes = 0;
    Painter painter = bench.acquire();
    painter.frame.extents->rows[7] = {-5, 3};
    painter.frame.extents->rows[20] = {30, 999};
    painter.frame.extents->rows[30] = {40, 50};
    ASSERT_TRUE(bench.display.present().ok());
    EXPECT_EQ(bench.bus.pixel_bytes, (3 + 6) * 2);
    EXPECT_TRUE(bench.shows(painter.frame));
}

TEST(Present, TheBeamIsAskedForByReadingItsLine) {
    PanelConfig c = config({}, 1);
    c.poll_line = true;
    Bench bench(c, spi(2000000));
    ASSERT_TRUE(bench.display.init().ok());
    bench.bus.line_waits = 0; // init() looked at some refreshes
    ASSERT_TRUE(bench.display.present().ok());
    EXPECT_EQ(bench.bus.line_waits, 1);
    const Op wait = bench.bus.last_list.front();
    EXPECT_EQ(wait.kind, Op::Kind::wait_line);
    EXPECT_EQ(wait.command, 0x45);
    EXPECT_EQ(wait.dummy_bits, 1);
    EXPECT_EQ(wait.length, 10u) << "the glass begins in row 9";
    EXPECT_EQ(wait.stride, 70);
    EXPECT_EQ(bench.display.counters().lagged, 1u);
    bench.bus.te_missing = true;
    bench.acquire().draw({0, 0, 1, 1}, 1);
    EXPECT_EQ(bench.display.present().error().fault, Fault::timeout);
    bench.bus.te_missing = false;
    EXPECT_TRUE(bench.display.present().ok());
    BusCaps deaf = spi();
    deaf.read_hz = 0;
    Bench refused(c, deaf);
    EXPECT_STREQ(refused.display.init().error().rule,
                 "display: polling the scanned line, but the bus cannot read");
}

/// The datasheet says 10 ms. The measured period of TE counts, unless it is farther off than any panel's.
TEST(Present, TheRefreshIsMeasured) {
    const struct {
        std::uint32_t period_us;
        long lines_us;
    } cases[] = {{10000, 10000}, {10300, 10300}, {11500, 11500}, {20000, 10000}, {5000, 10000}, {0, 10000}};
    for (const auto& c : cases) {
        PanelConfig cfg = config({}, 1);
        cfg.wait_te = true;
        BusCaps caps = spi(2000000);
        caps.has_te = true;
        Bench bench(cfg, caps);
        bench.bus.te_period_us = c.period_us;
        bench.bus.te_now_us = 0u - 30000; // the clock wraps in between
        ASSERT_TRUE(bench.display.init().ok());
        bench.bus.delay_us = 0;
        ASSERT_TRUE(bench.display.present().ok());
        EXPECT_NEAR(static_cast<double>(bench.bus.delay_us),
                    static_cast<double>(c.lines_us * (6 + 9 + 1 + 8)) / 70 - 3, 1)
            << c.period_us;
    }
    // A short list of operations looks at fewer refreshes.
    PanelConfig cfg = config({}, 1);
    cfg.poll_line = true;
    PanelStorage<PanelSizes{.height = 64, .ops = 8}> small;
    FakePanelBus bus(*cfg.panel, spi());
    PanelDisplay display(bus, cfg, small.memory());
    ASSERT_TRUE(display.init().ok());
    EXPECT_EQ(bus.line_waits, 8);
    // Without TE init() still succeeds; the next present reports the fault.
    bus.te_missing = true;
    EXPECT_TRUE(display.init().ok());
}

TEST(Present, FollowsOrLeadsTheBeam) {
    struct {
        std::uint32_t hz;
        Orientation orientation;
        long delay_us;
        const char* why;
    } const cases[] = {
        {40000000, {Rotation::r0}, 0, "0.7 ms of pixels fit in 10 ms: lead"},
        {2000000,
         {Rotation::r0},
         10000 * (6 + 9 + 1 + 8) / 70 - 3,
         "14.4 ms do not: blanking, the glass's offset, its first row, eight lines, less 4 us of RAMWR"},
        {2000000, {Rotation::r90}, 0, "columns are not scan order"},
        {2000000, {Rotation::r180}, 0, "rows from the bottom are not scan order"},
    };
    for (const auto& c : cases) {
        PanelConfig cfg = config(c.orientation, 1);
        cfg.wait_te = true;
        BusCaps caps = spi(c.hz);
        caps.has_te = true;
        Bench bench(cfg, caps);
        ASSERT_TRUE(bench.display.init().ok());
        EXPECT_TRUE(bench.bus.te_on);
        EXPECT_EQ(bench.bus.te_waits, 8) << "refreshes are measured, as many as the list has room for";
        bench.bus.te_waits = 0;
        bench.bus.delay_us = 0;
        ASSERT_TRUE(bench.display.present().ok());
        EXPECT_EQ(bench.bus.te_waits, 1) << c.why;
        EXPECT_EQ(bench.bus.delay_us, c.delay_us) << c.why;
        bench.bus.te_missing = true;
        bench.acquire().draw({0, 0, 1, 1}, 1);
        EXPECT_EQ(bench.display.present().error().fault, Fault::timeout);
        bench.bus.te_missing = false;
        EXPECT_TRUE(bench.display.present().ok());
        EXPECT_TRUE(bench.shows(bench.acquire().frame));
    }
}
