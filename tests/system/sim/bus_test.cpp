// Tests the simulated bus and boards: what they count, how they fail, what they show.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

namespace {

using namespace spangle;

/// Fills the frame with a pattern that depends on `seed`, marks all rows, presents.
bool present(sim::SimBoard& board, unsigned seed) {
    const hal::DisplayInfo info = board.display().info();
    const auto frame = board.display().acquire();
    if (!frame.ok())
        return false;
    const int bytes = format_info(info.format).bytes_per_pixel;
    for (int y = 0; y < info.height; ++y)
        for (int x = 0; x < info.width; ++x) {
            std::uint8_t* const at = frame.value().pixels + y * frame.value().stride + bytes * x;
            const unsigned word =
                (static_cast<unsigned>(x) * 40503u ^ static_cast<unsigned>(y) * 9973u) + seed * 2654435761u;
            if (bytes == 2) {
                at[0] = static_cast<std::uint8_t>(word >> 8);
                at[1] = static_cast<std::uint8_t>(word);
            } else {
                at[0] = static_cast<std::uint8_t>(word >> 11 << 3);
                at[1] = static_cast<std::uint8_t>(word >> 5 << 2);
                at[2] = static_cast<std::uint8_t>(word << 3);
            }
        }
    for (int y = 0; y < info.height; ++y)
        frame.value().extents->rows[y] = {0, static_cast<std::int16_t>(info.width)};
    return board.display().present().ok();
}

bool glass_shows(sim::SimBoard& board, unsigned seed) {
    const sim::Image glass = board.scan_out();
    for (int y = 0; y < glass.height; ++y)
        for (int x = 0; x < glass.width; ++x) {
            const unsigned word =
                (static_cast<unsigned>(x) * 40503u ^ static_cast<unsigned>(y) * 9973u) + seed * 2654435761u;
            const std::uint8_t* const p = glass.at(x, y);
            if ((p[0] >> 3) != (word >> 11 & 31) || (p[1] >> 2) != (word >> 5 & 63) ||
                (p[2] >> 3) != (word & 31))
                return false;
        }
    return true;
}

TEST(Board, GlassEqualsSurfaceInEveryOrientation) {
    for (const hal::Board* board : boards::all)
        for (const hal::Orientation o : hal::orientations) {
            if (board->display.wire.converts())
                continue; // wire_panels_test.cpp tests these formats
            hal::Board turned = *board;
            turned.display.orientation = o;
            sim::SimBoard sim(turned);
            ASSERT_TRUE(sim.display().init().ok()) << board->name;
            for (unsigned seed = 1; seed < 3; ++seed) {
                ASSERT_TRUE(present(sim, seed));
                EXPECT_TRUE(glass_shows(sim, seed))
                    << board->name << " rotation " << int(o.rotation) << (o.mirrored ? " mirrored" : "");
            }
            EXPECT_EQ(sim.violations_text(), "") << board->name;
        }
}

TEST(Board, AFailedTransferIsReportedAndLosesNothing) {
    for (const hal::Fault fault :
         {hal::Fault::short_write, hal::Fault::timeout, hal::Fault::no_answer, hal::Fault::gone}) {
        sim::SimBoard sim(boards::st7789_240);
        ASSERT_TRUE(sim.display().init().ok());
        ASSERT_TRUE(present(sim, 1));
        sim.fail_next(fault);
        EXPECT_FALSE(present(sim, 2)) << int(fault);
        if (fault != hal::Fault::timeout) {
            EXPECT_FALSE(glass_shows(sim, 2)) << int(fault) << ": not all of it arrived";
        }
        const auto again = sim.display().acquire();
        // A late transfer may still read the frame, so the frame is not given to the program.
        EXPECT_EQ(again.ok(), fault != hal::Fault::timeout) << int(fault);
        if (!again.ok()) {
            sim.pass(2'000'000'000); // until the late transfer is over
            ASSERT_TRUE(sim.display().acquire().ok());
        }
        // Nothing new is drawn; the present sends again what failed.
        ASSERT_TRUE(sim.display().present().ok()) << int(fault);
        EXPECT_TRUE(glass_shows(sim, 2)) << int(fault);
    }
}

TEST(Board, CountsBytesAndCommands) {
    sim::SimBoard sim(boards::ili9341_spi);
    ASSERT_TRUE(sim.display().init().ok());
    const sim::BoardCounters before = sim.counters();
    ASSERT_TRUE(present(sim, 3));
    const sim::BoardCounters after = sim.counters();
    EXPECT_EQ(after.pixel_bytes - before.pixel_bytes, 320u * 240u * 2u);
    EXPECT_LE(after.bytes - before.bytes, 320u * 240u * 2u + 11u);
    EXPECT_NEAR(static_cast<double>(after.busy_ns - before.busy_ns),
                static_cast<double>(after.bytes - before.bytes) * 8 * 25, 2e4)
        << "40 MHz";
}

/// Of a GC9A01's 240x240 pixels only those on the disc are seen, whichever way it is turned. The controller
/// scans out all of them.
TEST(Board, RoundGlassHidesItsCorners) {
    for (const hal::Orientation o : hal::orientations) {
        hal::Board board = boards::gc9a01;
        board.display.orientation = o;
        sim::SimBoard sim(board);
        ASSERT_TRUE(sim.display().init().ok());
        ASSERT_TRUE(present(sim, 5));
        const sim::Image glass = sim.glass(), whole = sim.scan_out();
        int hidden = 0;
        for (int y = 0; y < 240; ++y)
            for (int x = 0; x < 240; ++x) {
                // The centre of the glass lies between four pixels.
                const bool on = (2 * x - 239) * (2 * x - 239) + (2 * y - 239) * (2 * y - 239) <= 240 * 240;
                hidden += on ? 0 : 1;
                ASSERT_EQ(glass.at(x, y)[3], on ? 255 : 0) << x << ", " << y;
                ASSERT_TRUE(!on || std::equal(glass.at(x, y), glass.at(x, y) + 3, whole.at(x, y)));
                ASSERT_EQ(whole.at(x, y)[3], 255);
            }
        EXPECT_NEAR(hidden, 240 * 240 * (1 - 0.7854), 60);
        EXPECT_TRUE(glass_shows(sim, 5)) << "what is hidden is there";
    }
    sim::SimBoard square(boards::st7789_240);
    ASSERT_TRUE(square.display().init().ok());
    EXPECT_EQ(square.glass(), square.scan_out());
    for (const hal::PanelDesc* panel : hal::panels::all)
        EXPECT_EQ(panel->round, panel->controller == hal::Controller::gc9a01) << panel->name;
}

/// A byte takes nine clocks, START and STOP one each (UM10204, 3.1). A frame is a message of seven commands,
/// and a message of an address, a control byte and 1,024 bytes of pixels.
TEST(Board, I2cTakesTheClocksOfItsMessages) {
    sim::SimBoard sim(boards::ssd1306_i2c);
    ASSERT_TRUE(sim.display().init().ok());
    const sim::BoardCounters before = sim.counters();
    const auto frame = sim.display().acquire();
    ASSERT_TRUE(frame.ok());
    std::fill_n(frame.value().pixels, 1024, std::uint8_t{0x5A});
    for (int y = 0; y < 64; ++y)
        frame.value().extents->rows[y] = {0, 128};
    ASSERT_TRUE(sim.display().present().ok());
    const sim::BoardCounters after = sim.counters();
    const std::uint64_t bytes = after.bytes - before.bytes, messages = 2;
    EXPECT_EQ(bytes, 1024u + 2 + 6 + 2);
    EXPECT_NEAR(static_cast<double>(after.busy_ns - before.busy_ns),
                static_cast<double>(bytes * 9 + messages * 2) * 2500, 100.0);
}

TEST(Board, ALostByteShows) {
    sim::SimBoard sim(boards::ili9341_spi);
    ASSERT_TRUE(sim.display().init().ok());
    sim.drop_byte(1000);
    ASSERT_TRUE(present(sim, 1));
    ASSERT_TRUE(present(sim, 2));
    bool reported = false;
    for (const sim::Violation& v : sim.violations())
        reported = reported || v.rule == sim::Rule::half_pixel;
    EXPECT_TRUE(reported) << sim.violations_text();
}

TEST(Board, ABufferChangedOnTheWireShows) {
    sim::SimBoard sim(boards::ili9341_spi);
    const auto buffer = sim.bus().acquire(64);
    ASSERT_TRUE(buffer.ok());
    hal::Op op;
    op.kind = hal::Op::Kind::pixels;
    op.data = buffer.value().bytes;
    op.length = 64;
    const auto token = sim.bus().submit(&op, 1);
    ASSERT_TRUE(token.ok());
    EXPECT_FALSE(sim.bus().done(token.value()));
    buffer.value().bytes[5] ^= 1;
    ASSERT_TRUE(sim.bus().wait(token.value(), 1000).ok());
    ASSERT_FALSE(sim.violations().empty());
    EXPECT_EQ(sim.violations().back().rule, sim::Rule::buffer_changed);
    EXPECT_FALSE(sim.bus().wait(hal::Token{99}, 1000).ok());
}

TEST(Board, WiresAreRecorded) {
    const std::string path = testing::TempDir() + "wires-" + std::to_string(getpid()) + ".vcd";
    {
        sim::SimBoard sim(boards::st7735_128x160);
        ASSERT_EQ(sim.record_vcd(path), "");
        ASSERT_TRUE(sim.display().init().ok());
    }
    std::ifstream in(path);
    std::string line;
    long long last = -1;
    int clocks = 0;
    bool header = true, ordered = true;
    while (std::getline(in, line)) {
        if (line == "$upscope $end")
            header = false;
        if (!header && line[0] == '#') {
            ordered = ordered && std::stoll(line.substr(1)) >= last;
            last = std::stoll(line.substr(1));
        }
        clocks += line == "1k" ? 1 : 0;
    }
    EXPECT_TRUE(ordered);
    EXPECT_GT(clocks, 8 * 100);
    EXPECT_EQ(clocks % 8, 0);
    EXPECT_NE(sim::SimBoard(boards::st7735_128x160).record_vcd("/no/such/folder/x.vcd"), "");
    std::remove(path.c_str());
}

TEST(Picture, FilesHashesAndDifferences) {
    sim::Image a(3, 2);
    a.at(1, 1)[0] = 0;
    const std::string path = testing::TempDir() + "picture-" + std::to_string(getpid()) + ".png";
    ASSERT_EQ(sim::write_png(a, path), "");
    sim::Image b;
    ASSERT_EQ(sim::read_png(path, b), "");
    EXPECT_EQ(a, b);
    EXPECT_EQ(sim::hash(a), sim::hash(b));
    b.at(0, 0)[2] = 240; // two steps of blue
    EXPECT_NE(sim::hash(a), sim::hash(b));
    const sim::Difference d = sim::compare_565(a, b);
    EXPECT_EQ(d.pixels, 6u);
    EXPECT_EQ(d.identical, 5u);
    EXPECT_EQ(d.max_lsb, 1);
    EXPECT_LT(d.psnr_db, 60.0);
    EXPECT_EQ(sim::to_ascii(a), "###\n#c#\n");
    EXPECT_NE(sim::difference_picture(a, b).at(0, 0)[0], sim::difference_picture(a, b).at(2, 0)[0]);
    EXPECT_NE(sim::write_png(a, "/no/such/folder/x.png"), "");
    EXPECT_NE(sim::read_png("/no/such/file.png", b), "");
    std::remove(path.c_str());
}

} // namespace
