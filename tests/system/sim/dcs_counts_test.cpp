// Tests how DCS controllers count, with the model and the driver: pixels of 12 bits in windows of every
// parity, and lines of the scan until the line to which TE is set (44h).
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>

#include "host_sim/board/module.hpp"
#include "host_sim/controller/dcs_controller.hpp"

namespace {

using namespace spangle;
using namespace spangle::sim;

/// An ST7789 that is awake, and the clock of its writes.
struct Awake {
    DcsController chip;
    Time now = 0;

    Awake() : chip(chip_of(hal::panels::st7789_240x320), GlassMount{0, 0, 240, 320}, false) {
        chip.reset(true, now);
        chip.reset(false, now += 20'000);
        now += 120'000'000;
        send({0x11});
        now += 120'000'000;
        send({0x29});
    }
    /// Sends a command with its parameters or pixels.
    void send(const std::vector<int>& bytes) {
        chip.select(true, now);
        for (std::size_t i = 0; i < bytes.size(); ++i)
            chip.write(static_cast<std::uint8_t>(bytes[i]), i != 0, now += 800, 100);
        chip.select(false, now);
    }
    void window(int width, int height) {
        send({0x2A, 0, 3, 0, 3 + width - 1});
        send({0x2B, 0, 5, 0, 5 + height - 1});
    }
    Rgb666 cell(int n, int width) const {
        return chip.cells()[static_cast<std::size_t>((5 + n / width) * 240 + 3 + n % width)];
    }
    std::vector<Rule> rules() const {
        std::vector<Rule> out;
        for (const Violation& v : chip.violations())
            out.push_back(v.rule);
        return out;
    }
};

/// Returns twelve bits that differ between pixel n of a frame and its neighbours.
unsigned twelve(int n, int frame) {
    return (static_cast<unsigned>(n) * 0x35B + static_cast<unsigned>(frame) * 0x9E1 + 0x123) & 0xFFF;
}
/// Packs pixels as RRRRGGGG BBBBRRRR GGGGBBBB; `rest` is the half of a byte behind an odd pixel.
std::vector<int> packed(int count, int frame, unsigned rest) {
    std::vector<unsigned> nibbles;
    for (int n = 0; n < count; ++n)
        for (const unsigned shift : {8u, 4u, 0u})
            nibbles.push_back(twelve(n, frame) >> shift & 15);
    if (nibbles.size() % 2 != 0)
        nibbles.push_back(rest);
    std::vector<int> out = {0x2C};
    for (std::size_t i = 0; i < nibbles.size(); i += 2)
        out.push_back(static_cast<int>(nibbles[i] << 4 | nibbles[i + 1]));
    return out;
}
Rgb666 wide(unsigned value) {
    const auto six = [](unsigned four) { return static_cast<std::uint8_t>(four << 2 | four >> 2); };
    return {six(value >> 8), six(value >> 4 & 15), six(value & 15)};
}

/// Each size is sent twice: what is left of an odd frame must not become the first pixel of the next.
TEST(TwelveBits, WindowsOfEveryCountAreFilled) {
    for (int width = 1; width <= 9; ++width)
        for (int height = 1; height <= 4; ++height) {
            Awake st;
            st.send({0x3A, 0x53});
            for (int frame = 0; frame < 2; ++frame) {
                const int count = width * height;
                st.window(width, height);
                st.send(packed(count, frame, frame == 0 ? 0xF : 0x0));
                st.send({0x00});
                for (int n = 0; n < count; ++n)
                    ASSERT_EQ(st.cell(n, width), wide(twelve(n, frame)))
                        << width << "x" << height << " pixel " << n;
            }
            EXPECT_EQ(st.chip.violations_text(), "") << width << "x" << height;
        }
}

/// One byte too few leaves pixels out, and one too many begins or fills a pixel beyond the window. Both are
/// violations.
TEST(TwelveBits, AByteTooFewOrTooManyIsTold) {
    for (int count = 1; count <= 12; ++count)
        for (const int slip : {-1, 1}) {
            Awake st;
            st.send({0x3A, 0x53});
            st.window(count, 1);
            std::vector<int> bytes = packed(count, 0, 0);
            slip < 0 ? bytes.pop_back() : bytes.push_back(0xA5);
            if (bytes.size() == 1)
                continue; // nothing was sent
            st.send(bytes);
            st.send({0x00});
            EXPECT_FALSE(st.rules().empty()) << count << " pixels, " << slip << " byte";
        }
}

/// The driver sends damage of every size and place, of surfaces that become 12 bits on the wire. The panel
/// then shows the surface everywhere, and a window takes a byte and a half for each pixel, rounded up.
TEST(TwelveBits, TheDriverSendsDamageOfEveryCount) {
    hal::Board board = boards::st7789_240;
    board.display.wire = hal::wires::rgb444;
    ASSERT_EQ(hal::flaw(board), nullptr);
    SimBoard sim(board);
    ASSERT_TRUE(sim.display().init().ok());
    ASSERT_TRUE(sim.display().acquire().ok() &&
                sim.display().present().ok()); // the first frame is sent whole
    unsigned seed = 1;
    for (int width = 1; width <= 7; ++width)
        for (int height = 1; height <= 5; ++height)
            for (const int left : {10, 11}) {
                const BoardCounters before = sim.counters();
                const auto frame = sim.display().acquire();
                ASSERT_TRUE(frame.ok());
                for (int y = 20; y < 20 + height; ++y) {
                    for (int x = left; x < left + width; ++x) {
                        seed = seed * 1664525u + 1013904223u;
                        std::uint8_t* const p = frame.value().pixels + y * frame.value().stride + 2 * x;
                        p[0] = static_cast<std::uint8_t>(seed >> 24),
                        p[1] = static_cast<std::uint8_t>(seed >> 16);
                    }
                    frame.value().extents->rows[y] = {static_cast<std::int16_t>(left),
                                                      static_cast<std::int16_t>(left + width)};
                }
                const std::uint8_t* const pixels = frame.value().pixels;
                const std::int32_t stride = frame.value().stride;
                ASSERT_TRUE(sim.display().present().ok());
                ASSERT_TRUE(sim.display().finish().ok());
                const auto count = static_cast<std::uint64_t>(width * height);
                EXPECT_EQ(sim.counters().pixel_bytes - before.pixel_bytes, (count * 3 + 1) / 2)
                    << width << "x" << height;
                const Image glass = sim.scan_out();
                for (int y = 20; y < 20 + height; ++y)
                    for (int x = left; x < left + width; ++x) {
                        const std::uint8_t* const p = pixels + y * stride + 2 * x;
                        const unsigned word = p[0] * 256u + p[1];
                        const std::uint8_t* const shown = glass.at(x, y);
                        // The wire keeps the high bits of components and drops the rest, so components may
                        // differ by one step.
                        ASSERT_LE(std::abs(static_cast<int>(shown[0] >> 4) - static_cast<int>(word >> 12)),
                                  1);
                        ASSERT_LE(
                            std::abs(static_cast<int>(shown[1] >> 4) - static_cast<int>(word >> 7 & 15)), 1);
                        ASSERT_LE(
                            std::abs(static_cast<int>(shown[2] >> 4) - static_cast<int>(word >> 1 & 15)), 1);
                    }
            }
    EXPECT_EQ(sim.violations_text(), "");
}

/// TE is high as long as the scan is in the line that 44h names, and in no other line.
TEST(TearingLine, IsTheOneThatWasNamed) {
    Awake st;
    const Time line_time = st.chip.line_time(), frame = st.chip.refresh_time();
    const int lines = static_cast<int>(frame / line_time);
    ASSERT_GT(lines, 320);
    st.send({0x35, 0x00});
    for (const int line : {1, 2, 3, 127, 128, 255, 256, 257, 318, 319, 320, lines - 1}) {
        st.send({0x44, line >> 8, line & 255});
        const Time start = (st.now / frame + 2) * frame, at = start + static_cast<Time>(line) * line_time;
        EXPECT_FALSE(st.chip.te(at - 1)) << line;
        EXPECT_TRUE(st.chip.te(at)) << line;
        EXPECT_TRUE(st.chip.te(at + line_time - 1)) << line;
        EXPECT_FALSE(st.chip.te(at + line_time)) << line;
        st.now = at;
        EXPECT_EQ(st.chip.scan_line(st.now), line) << "as 45h has it";
        int high = 0;
        for (int other = 0; other < lines; ++other)
            high += st.chip.te(start + frame + static_cast<Time>(other) * line_time + line_time / 2);
        EXPECT_EQ(high, 1) << line;
        st.now = start + 2 * frame;
    }
}

/// Line 0 means the blanking, as after a reset. TE never rises for a line beyond the scan, nor without TEON.
TEST(TearingLine, Zero) {
    Awake st;
    const Time line_time = st.chip.line_time(), frame = st.chip.refresh_time();
    const int lines = static_cast<int>(frame / line_time);
    const auto high_lines = [&] {
        const Time start = (st.now / frame + 1) * frame;
        int first = -1, count = 0;
        for (int line = 0; line < lines; ++line)
            if (st.chip.te(start + static_cast<Time>(line) * line_time + line_time / 2))
                first = count++ == 0 ? line : first;
        st.now = start + frame;
        return std::pair{first, count};
    };
    EXPECT_EQ(high_lines().second, 0);
    st.send({0x35, 0x00});
    EXPECT_EQ(high_lines(), (std::pair{320, lines - 320}));
    st.send({0x44, 1, 0});
    EXPECT_EQ(high_lines(), (std::pair{256, 1}));
    st.send({0x44, lines >> 8, lines & 255});
    EXPECT_EQ(high_lines().second, 0);
    st.send({0x44, 0, 0});
    EXPECT_EQ(high_lines(), (std::pair{320, lines - 320}));
    st.send({0x34});
    EXPECT_EQ(high_lines().second, 0);
}

} // namespace
