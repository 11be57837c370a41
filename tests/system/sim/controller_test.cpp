// Tests the controller model by the rules of the datasheets: byte streams go in; memory, glass, answers and
// violations come out.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host_sim/controller/dcs_controller.hpp"

namespace {

using namespace spangle::sim;

constexpr Time us = 1000, ms = 1000 * us;

/// A host that sends bytes on a serial bus at 10 MHz (100 ns a bit), with the pauses that the datasheet asks
/// for.
struct Host {
    DcsController chip;
    Time now = 0;
    unsigned period = 100;

    explicit Host(const Chip& c, GlassMount glass = {})
        : chip(c, glass.width != 0 ? glass : GlassMount{0, 0, c.width, c.height}, false) {
        reset(20 * us);
        now += 120 * ms;
    }
    void reset(Time low) {
        chip.reset(true, now);
        now += low;
        chip.reset(false, now);
    }
    void byte(std::uint8_t value, bool data) {
        now += 8 * period;
        chip.write(value, data, now, period);
    }
    void send(std::uint8_t command, std::initializer_list<int> parameters = {}) {
        chip.select(true, now);
        byte(command, false);
        for (const int p : parameters)
            byte(static_cast<std::uint8_t>(p), true);
        chip.select(false, now);
    }
    void wake(int colmod = 0x55) {
        send(0x11);
        now += 120 * ms;
        send(0x3A, {colmod});
        send(0x29);
    }
    void window(int xs, int xe, int ys, int ye) {
        send(0x2A, {xs >> 8, xs & 255, xe >> 8, xe & 255});
        send(0x2B, {ys >> 8, ys & 255, ye >> 8, ye & 255});
    }
    void pixels(std::uint8_t command, const std::vector<int>& words) {
        chip.select(true, now);
        byte(command, false);
        for (const int w : words) {
            byte(static_cast<std::uint8_t>(w >> 8), true);
            byte(static_cast<std::uint8_t>(w), true);
        }
        chip.select(false, now);
    }
    std::vector<int> read(std::uint8_t command, int dummy_bits, int bytes, unsigned clock = 200) {
        chip.select(true, now);
        byte(command, false);
        for (int i = 0; i < dummy_bits; ++i)
            chip.read_bit(now += clock, clock);
        std::vector<int> out;
        for (int i = 0; i < bytes; ++i)
            out.push_back(chip.read_byte(now += 8 * clock, clock));
        chip.select(false, now);
        return out;
    }
    bool reported(Rule rule) const {
        return std::any_of(chip.violations().begin(), chip.violations().end(),
                           [rule](const Violation& v) { return v.rule == rule; });
    }
    Rgb666 cell(int column, int row) const {
        return chip.memory()[static_cast<std::size_t>(row * chip.chip().width + column)];
    }
};

constexpr int red = 0xF800, green = 0x07E0, blue = 0x001F;
constexpr Rgb666 red18{62, 0, 0}, green18{0, 63, 0}, blue18{0, 0, 62};

TEST(Controller, RightStreamsBreakNoRule) {
    for (const Chip& chip : chips) {
        Host h(chip);
        const bool takes_565 = (chip.serial_depths & depths({5})) != 0;
        h.wake(takes_565 ? 0x55 : 0x66);
        h.window(3, 4, 5, 6);
        if (takes_565)
            h.pixels(0x2C, {red, green, blue, 0});
        else
            h.send(0x2C, {0xFC, 0, 0, 0, 0xFC, 0, 0, 0, 0xFC, 0, 0, 0});
        h.send(0x00);
        EXPECT_TRUE(h.chip.violations().empty()) << chip.name << ": " << h.chip.violations().front().text;
    }
}

/// The four corners of a 2 x 2 window are where MADCTL puts them (ST7735R datasheet 9.11).
TEST(Controller, EveryAddressOrder) {
    for (int order = 0; order < 8; ++order) {
        const bool my = (order & 4) != 0, mx = (order & 2) != 0, mv = (order & 1) != 0;
        Host h(chips[0]);
        h.wake();
        h.send(0x36, {(my ? 0x80 : 0) | (mx ? 0x40 : 0) | (mv ? 0x20 : 0)});
        h.window(10, 11, 20, 21);
        h.pixels(0x2C, {red, green, blue, 0xFFFF});
        const auto at = [&](int x, int y) {
            const int c = mv ? y : x, r = mv ? x : y;
            return h.cell(mx ? 239 - c : c, my ? 319 - r : r);
        };
        EXPECT_EQ(at(10, 20), red18) << order;
        EXPECT_EQ(at(11, 20), green18) << order;
        EXPECT_EQ(at(10, 21), blue18) << order;
        EXPECT_EQ(at(11, 21), (Rgb666{62, 63, 62})) << order;
    }
}

TEST(Controller, TheWindowWrapsAndContinues) {
    Host h(chips[0]);
    h.wake();
    h.window(0, 1, 0, 0);
    h.pixels(0x2C, {red});
    h.pixels(0x3C, {green}); // continues at the pointer
    EXPECT_EQ(h.cell(0, 0), red18);
    EXPECT_EQ(h.cell(1, 0), green18);
    h.pixels(0x2C, {blue}); // starts at the window's start again
    EXPECT_EQ(h.cell(0, 0), blue18);
    h.pixels(0x2C, {red, red, green}); // wraps to the window's start
    EXPECT_EQ(h.cell(0, 0), green18);
    EXPECT_EQ(h.cell(1, 0), red18);
}

TEST(Controller, ColorModes) {
    Host h(chips[0]);
    h.wake();
    h.send(0x3A, {0x66});
    h.window(0, 0, 0, 0);
    h.send(0x2C, {0xFC, 0x04, 0x80});
    EXPECT_EQ(h.cell(0, 0), (Rgb666{63, 1, 32}));
    Host st(chips[1]); // EPF after reset: red and blue repeat green's low bit
    st.wake();
    st.window(0, 1, 0, 0);
    st.pixels(0x2C, {0xF81F, 0xF83F});
    EXPECT_EQ(st.cell(0, 0), (Rgb666{62, 0, 62}));
    EXPECT_EQ(st.cell(1, 0), (Rgb666{63, 1, 63}));
}

TEST(Controller, TwelveBitPairs) {
    Host st(chips[1]);
    st.wake();
    st.send(0x3A, {0x53});
    st.window(0, 2, 0, 0);
    st.send(0x2C, {0xF0, 0x00, 0xF0, 0x00, 0xF0}); // three pixels: a pair and half of one
    st.send(0x00);
    EXPECT_EQ(st.cell(0, 0), (Rgb666{63, 0, 0}));
    EXPECT_EQ(st.cell(1, 0), (Rgb666{0, 63, 0}));
    EXPECT_EQ(st.cell(2, 0), (Rgb666{0, 0, 63}));
    EXPECT_TRUE(st.chip.violations().empty()) << st.chip.violations().front().text;
    st.send(0x2C, {0x12, 0x34, 0x56, 0x78}); // one byte of the next pair
    st.send(0x00);
    EXPECT_TRUE(st.reported(Rule::half_pixel));
    Host ili(chips[0]); // this chip has no 12-bit format
    ili.send(0x3A, {0x53});
    EXPECT_TRUE(ili.reported(Rule::color_format));
}

TEST(Controller, ResetsKeepMemoryAndRestoreRegisters) {
    Host h(chips[0]);
    h.wake();
    h.window(7, 7, 7, 7);
    h.pixels(0x2C, {red});
    h.send(0x36, {0x48});
    h.send(0x01);
    h.now += 5 * ms;
    EXPECT_EQ(h.cell(7, 7), red18);
    EXPECT_FALSE(h.chip.is_awake());
    EXPECT_EQ(h.read(0x0B, 0, 1)[0], 0x00);
    EXPECT_EQ(h.read(0x0C, 0, 1)[0], 0x66);
    h.now += 120 * ms;
    h.wake();
    h.pixels(0x2C, std::vector<int>(241, green)); // the window is the whole memory again
    EXPECT_EQ(h.cell(239, 0), green18);
    EXPECT_EQ(h.cell(0, 1), green18);
}

TEST(Controller, AnswersWhatItIs) {
    Host st(chips[1]);
    EXPECT_EQ(st.read(0x04, 1, 3), (std::vector<int>{0x85, 0x85, 0x52}));
    EXPECT_EQ(st.read(0x0A, 0, 1)[0], 0x08);
    st.wake();
    EXPECT_EQ(st.read(0x0A, 0, 1)[0], 0x9C);
    EXPECT_EQ(st.read(0x0F, 0, 1)[0], 0xC0);
    st.send(0x21);
    EXPECT_EQ(st.read(0x0D, 0, 1)[0], 0x20);
    st.send(0x35, {1});
    EXPECT_EQ(st.read(0x0E, 0, 1)[0], 0xC0);
    EXPECT_EQ(st.read(0x0C, 0, 1)[0], 0x55);
    st.window(4, 5, 9, 9);
    st.pixels(0x2C, {red, green});
    EXPECT_EQ(st.read(0x2E, 16, 6), (std::vector<int>{0xF8, 0, 0, 0x04, 0xFC, 0x04})); // EPF: green's low bit
    EXPECT_EQ(st.read(0x3E, 16, 3), (std::vector<int>{0xF8, 0, 0})) << "the window is read over and over";
    EXPECT_EQ(st.read(0xDB, 0, 1)[0], 0x85);
    EXPECT_EQ(st.read(0xDC, 0, 1)[0], 0x52);
    EXPECT_TRUE(st.chip.violations().empty());
    st.send(0x04);
    EXPECT_FALSE(st.chip.read_bit(st.now, 200)) << "CS rose: the line is let go";
    const std::vector<int> line = st.read(0x45, 1, 2);
    EXPECT_NEAR(line[0] << 8 | line[1], st.chip.scan_line(st.now), 1);
}

TEST(Controller, GlassShowsOnlyWhatIsOn) {
    GlassMount mount{2, 1, 3, 2};
    mount.mirror_columns = true;
    Host h(chips[2], mount);
    const auto seen = [&h] {
        h.now += 60 * ms;
        return h.chip.glass(h.now);
    };
    EXPECT_EQ(seen()[0], Rgb666{});
    h.wake();
    h.window(2, 4, 1, 2);
    h.pixels(0x2C, {red, green, blue, 0, 0, 0});
    EXPECT_EQ(seen()[0], blue18); // mirrored: memory column 4 is leftmost
    EXPECT_EQ(seen()[2], red18);
    h.send(0x36, {0x08}); // BGR takes effect at scan-out
    EXPECT_EQ(seen()[0], (Rgb666{62, 0, 0}));
    h.send(0x21);
    EXPECT_EQ(seen()[0], (Rgb666{1, 63, 63}));
    h.send(0x20);
    h.send(0x28);
    EXPECT_EQ(seen()[0], Rgb666{});
}

TEST(Controller, IdleModeShowsEightColors) {
    Host h(chips[0]);
    h.wake();
    h.window(0, 1, 0, 0);
    h.pixels(0x2C, {0x83F0, 0x7C0F}); // components 32, 31, 32 and 30, 32, 30 of 63
    h.send(0x39);
    h.now += 60 * ms;
    EXPECT_EQ(h.chip.glass(h.now)[0], (Rgb666{63, 0, 63}));
    EXPECT_EQ(h.chip.glass(h.now)[1], (Rgb666{0, 63, 0}));
    h.send(0x38);
    h.now += 60 * ms;
    EXPECT_EQ(h.chip.glass(h.now)[0], (Rgb666{32, 31, 32}));
}

TEST(Controller, ScrollsAndShowsParts) {
    Host h(chips[0]);
    h.wake();
    for (int row = 0; row < 4; ++row) {
        h.window(0, 239, row, row);
        h.pixels(0x2C, std::vector<int>(240, row == 0 ? red : row == 1 ? green : blue));
    }
    const auto first = [&h](int row) {
        h.now += 60 * ms;
        return h.chip.glass(h.now)[static_cast<std::size_t>(row) * 240];
    };
    EXPECT_EQ(first(0), red18);
    h.send(0x33, {0, 0, 320 >> 8, 320 & 255, 0, 0});
    h.send(0x37, {0, 1});
    EXPECT_EQ(first(0), green18);
    h.send(0x33, {0, 1, 317 >> 8, 317 & 255, 0, 2}); // the first row stays, the next 317 rotate
    h.send(0x37, {0, 2});
    EXPECT_EQ(first(0), red18);
    EXPECT_EQ(first(1), blue18);
    EXPECT_EQ(first(317), green18);
    h.send(0x13); // NORON ends scrolling, too
    EXPECT_EQ(first(0), red18);
    EXPECT_EQ(first(1), green18);
    h.send(0x30, {0, 1, 0, 1});
    h.send(0x12);
    EXPECT_EQ(first(0), Rgb666{});
    EXPECT_EQ(first(1), green18);
}

const Chip& chip_named(const std::string& name) {
    return *std::find_if(std::begin(chips), std::end(chips), [&](const Chip& c) { return c.name == name; });
}

TEST(Controller, AnswersForWhatItIs) {
    using Bytes = std::vector<int>;
    EXPECT_EQ(Host(chip_named("ILI9342C")).read(0x04, 1, 3)[0], 0xE3);
    EXPECT_EQ(Host(chip_named("ILI9488")).read(0x04, 1, 3), (Bytes{0x54, 0x80, 0x66}));
    EXPECT_EQ(Host(chip_named("GC9A01")).read(0x04, 1, 3), (Bytes{0x00, 0x9A, 0x01}));
    EXPECT_EQ(Host(chip_named("ILI9341")).read(0xD3, 8, 3), (Bytes{0x00, 0x93, 0x41}));
    EXPECT_EQ(Host(chip_named("ILI9486")).read(0xD3, 8, 3), (Bytes{0x00, 0x94, 0x86}));
    EXPECT_EQ(Host(chip_named("ST7796S")).read(0xD3, 8, 3), (Bytes{0x00, 0x77, 0x96}));
    EXPECT_EQ(Host(chip_named("HX8357D")).read(0xD0, 0, 1), (Bytes{0x99}));
    EXPECT_EQ(Host(chip_named("GC9A01")).read(0xD3, 8, 3), (Bytes{0, 0, 0})) << "has no such register";
    EXPECT_EQ(Host(chip_named("ILI9488")).read(0xD0, 0, 1), (Bytes{0}));
}

/// ILI9486 and ILI9488 take 16-bit pixels on a parallel bus only.
TEST(Controller, DepthsDependOnTheBus) {
    for (const char* name : {"ILI9486", "ILI9488"}) {
        Host serial(chip_named(name));
        serial.send(0x11);
        serial.now += 120 * ms;
        serial.send(0x3A, {0x55});
        EXPECT_TRUE(serial.reported(Rule::color_format)) << name;
        serial.chip.forget_violations();
        serial.window(0, 0, 0, 1);
        serial.pixels(0x2C, {red, green});
        EXPECT_TRUE(serial.reported(Rule::half_pixel) ||
                    (serial.send(0x00), serial.reported(Rule::color_format)))
            << "two bytes a pixel fill no window of three";
        serial.send(0x3A, {0x66});
        serial.chip.forget_violations();
        serial.send(0x2C, {0xFC, 0x04, 0x08, 0x00, 0xFC, 0x0C});
        serial.send(0x00);
        EXPECT_TRUE(serial.chip.violations().empty());
        EXPECT_EQ(serial.cell(0, 0), (Rgb666{63, 1, 2}));
        EXPECT_EQ(serial.cell(0, 1), (Rgb666{0, 63, 3}));

        DcsController parallel(chip_named(name), {0, 0, 320, 480}, true);
        parallel.select(true, 0);
        Time now = 200 * ms;
        const auto send = [&](std::uint8_t byte, bool data) { parallel.write(byte, data, now += 100, 100); };
        send(0x11, false);
        now += 120 * ms;
        send(0x3A, false), send(0x55, true);
        for (const int axis : {0x2A, 0x2B}) {
            send(static_cast<std::uint8_t>(axis), false);
            for (int i = 0; i < 4; ++i)
                send(0, true);
        }
        send(0x2C, false), send(0xF8, true), send(0x00, true), send(0x00, false);
        EXPECT_TRUE(parallel.violations().empty()) << parallel.violations().front().text;
        EXPECT_EQ(parallel.memory()[0], red18);
    }
}

TEST(Controller, MakersRegistersWaitForTheirKey) {
    using Bytes = std::vector<std::uint8_t>;
    Host open(chip_named("ILI9341"));
    open.send(0xC0, {0x23});
    open.send(0x00);
    EXPECT_EQ(open.chip.maker_register(0xC0), Bytes{0x23});

    Host st(chip_named("ST7796S"));
    const auto writes = [](Host& h, int value) {
        h.chip.forget_violations();
        h.send(0xC1, {value});
        h.send(0x00);
        const bool took = h.chip.maker_register(0xC1) == Bytes{static_cast<std::uint8_t>(value)};
        EXPECT_NE(took, h.reported(Rule::locked_register));
        return took;
    };
    EXPECT_FALSE(writes(st, 1));
    st.send(0xF0, {0x96});
    EXPECT_FALSE(writes(st, 2)) << "the second key before the first";
    st.send(0xF0, {0xC3});
    EXPECT_FALSE(writes(st, 3)) << "half of the key";
    st.send(0xF0, {0x96});
    EXPECT_TRUE(writes(st, 4));
    st.send(0xF0, {0xC3});
    EXPECT_TRUE(writes(st, 5)) << "a key that is turned again changes nothing";
    st.send(0xF0, {0x3C});
    EXPECT_FALSE(writes(st, 6));
    EXPECT_EQ(st.chip.maker_register(0xC1), Bytes{5}) << "what was written behind the lock is lost";
    st.reset(20 * us);
    EXPECT_TRUE(st.chip.maker_register(0xC1).empty());

    Host gc(chip_named("GC9A01"));
    EXPECT_FALSE(writes(gc, 1));
    gc.send(0xEF);
    EXPECT_FALSE(writes(gc, 2));
    gc.send(0xFE);
    gc.send(0xEF);
    EXPECT_TRUE(writes(gc, 3));

    Host hx(chip_named("HX8357D"));
    hx.send(0xB9, {0xFF, 0x83});
    EXPECT_FALSE(writes(hx, 1)) << "the key is cut short";
    hx.send(0xB9, {0xFF, 0x83, 0x57});
    EXPECT_TRUE(writes(hx, 2));
    hx.reset(20 * us);
    EXPECT_FALSE(writes(hx, 3)) << "reset locks";
}

TEST(Controller, AnSt7796sReadsAsItWasWritten) {
    Host h(chip_named("ST7796S"));
    h.wake();
    h.window(0, 0, 0, 1);
    h.pixels(0x2C, {0xA987, blue});
    EXPECT_EQ(h.read(0x2E, 8, 4), (std::vector<int>{0xA9, 0x87, 0x00, 0x1F}));
    h.send(0x00);
    EXPECT_TRUE(h.chip.violations().empty()) << h.chip.violations().front().text;
    h.read(0x2E, 0, 4);
    h.send(0x00);
    EXPECT_TRUE(h.reported(Rule::read)) << "the dummy clocks were taken for a pixel's";
    h.send(0x3A, {0x66});
    EXPECT_EQ(h.read(0x2E, 8, 6), (std::vector<int>{0xA8, 0x30, 0x38, 0x00, 0x00, 0xF8}));
}

TEST(Controller, PinsChooseTheMemoryOfAnSt7735) {
    const Chip& st = chip_named("ST7735");
    EXPECT_EQ(with_memory_size(st, {132, 162}).width, 132);
    const Chip small = with_memory_size(st, {128, 160});
    EXPECT_EQ(small.height, 160);
    EXPECT_EQ(with_memory_size(st, {128, 128}).width, 0);
    Host h(small);
    h.wake();
    h.send(0x36, {0xC0}); // mirrored both ways: the first pixel goes to the last cell of this memory
    h.window(0, 0, 0, 0);
    h.pixels(0x2C, {red});
    EXPECT_EQ(h.cell(127, 159), red18);
}

TEST(Scan, RatesAndTearingEffect) {
    const double rate[] = {70.3, 59.3, 80.6, 93.4, 60, 60, 60, 60, 60};
    for (unsigned i = 0; i < std::size(chips); ++i) {
        const Chip& c = chips[i];
        EXPECT_NEAR(1e9 / (static_cast<double>(c.line_ns) * (c.height + c.porch_lines)), rate[i], 0.3)
            << c.name;
    }
    Host h(chips[0]);
    h.wake();
    EXPECT_FALSE(h.chip.te(h.now)) << "TE is off after reset";
    h.send(0x35, {0});
    int high = 0;
    const Time frame = Time(chips[0].line_ns) * 324;
    for (Time t = 0; t < 1000; ++t)
        high += h.chip.te(h.now + t * frame / 1000) ? 1 : 0;
    EXPECT_NEAR(high, 12, 2) << "blanking is 4 of 324 lines";
    h.now += frame;
    EXPECT_EQ(h.chip.frames_scanned(10 * frame), 10u);
}

TEST(Rules, TooEarly) {
    Host a(chips[0]);
    a.reset(20 * us);
    a.now += 1 * ms; // 5 ms are required
    a.send(0x00);
    EXPECT_TRUE(a.reported(Rule::too_early));
    Host b(chips[0]);
    b.wake();
    b.send(0x10);
    b.now += 6 * ms;
    b.send(0x11); // 120 ms after SLPIN are required
    EXPECT_TRUE(b.reported(Rule::too_early));
    Host c(chips[0]);
    c.send(0x01);
    c.now += 1 * ms;
    c.send(0x29);
    EXPECT_TRUE(c.reported(Rule::too_early));
}

TEST(Rules, ResetPulse) {
    Host h(chips[0]);
    h.reset(5 * us);
    EXPECT_TRUE(h.reported(Rule::reset_pulse));
}

TEST(Rules, WriteInSleep) {
    Host h(chips[0]);
    h.window(0, 0, 0, 0);
    h.send(0x3A, {0x55});
    h.pixels(0x2C, {red});
    EXPECT_TRUE(h.reported(Rule::write_in_sleep));
}

TEST(Rules, ParameterCount) {
    Host few(chips[0]), many(chips[0]);
    few.send(0x2A, {0, 1, 0});
    few.send(0x00);
    EXPECT_TRUE(few.reported(Rule::parameter_count));
    many.send(0x36, {0, 0});
    many.send(0x00);
    EXPECT_TRUE(many.reported(Rule::parameter_count));
}

TEST(Rules, Window) {
    Host crossed(chips[0]), beyond(chips[0]), hidden(chips[1], {0, 0, 240, 240});
    crossed.send(0x2A, {0, 9, 0, 8});
    EXPECT_TRUE(crossed.reported(Rule::window));
    beyond.send(0x2B, {0, 0, 1, 0x40}); // row 320 of 320 rows
    EXPECT_TRUE(beyond.reported(Rule::window));
    hidden.wake();
    hidden.window(0, 0, 240, 240); // a row of the memory that the glass does not show
    EXPECT_FALSE(hidden.reported(Rule::window));
    hidden.pixels(0x2C, {red});
    EXPECT_TRUE(hidden.reported(Rule::window));
}

TEST(Rules, PixelCountAndHalfPixels) {
    Host less(chips[0]), half(chips[0]), twice(chips[0]);
    twice.wake();
    twice.window(0, 1, 0, 0);
    twice.pixels(0x2C, {red, red});
    twice.send(0x00);
    EXPECT_FALSE(twice.reported(Rule::pixel_count));
    twice.pixels(0x2C, {red, red, green, green});
    twice.send(0x00);
    EXPECT_TRUE(twice.reported(Rule::pixel_count));
    less.wake();
    less.window(0, 3, 0, 0);
    less.pixels(0x2C, {red, red, red});
    less.send(0x00);
    EXPECT_TRUE(less.reported(Rule::pixel_count));
    half.wake();
    half.window(0, 3, 0, 0);
    half.send(0x2C, {1, 2, 3});
    half.send(0x00);
    EXPECT_TRUE(half.reported(Rule::half_pixel));
}

TEST(Rules, ClocksAndColorFormat) {
    Host fast(chips[0]), mix(chips[0]), quick(chips[0]);
    fast.period = 5;
    fast.send(0x00);
    EXPECT_TRUE(fast.reported(Rule::write_clock));
    mix.wake();
    mix.window(0, 3, 0, 2);
    mix.chip.select(true, mix.now);
    mix.byte(0x2C, false);
    for (int i = 0; i < 36; ++i)
        mix.byte(0, true); // three bytes a pixel, but COLMOD says two
    mix.send(0x00);
    EXPECT_TRUE(mix.reported(Rule::color_format));
    quick.read(0x04, 1, 3, 50); // 150 ns is the shortest clock
    EXPECT_TRUE(quick.reported(Rule::read));
}

TEST(Rules, ManyBytesTooFastAreOneMistake) {
    Host h(chips[0]);
    h.wake();
    h.period = 5;
    h.window(0, 239, 0, 0);
    h.pixels(0x2C, std::vector<int>(240, red));
    EXPECT_EQ(h.chip.violations().size(), 3u) << "one for each command";
}

TEST(Rules, MissingDummyClocks) {
    for (const Chip& chip : chips) {
        Host right(chip), id(chip), pixels(chip);
        right.read(0x04, 1, 3);
        right.read(0x2E, chip.pixel_dummy_bits, 3);
        EXPECT_FALSE(right.reported(Rule::read)) << chip.name;
        id.read(0x04, 0, 3);
        EXPECT_TRUE(id.reported(Rule::read)) << chip.name;
        pixels.read(0x2E, 0, 3);
        EXPECT_TRUE(pixels.reported(Rule::read)) << chip.name;
    }
}

TEST(Rules, Tear) {
    Host h(chips[0]);
    h.wake();
    h.send(0x35, {0});
    h.window(0, 239, 0, 319);
    h.period = 16; // a frame takes 19.7 ms and the beam 14.2 ms, so the beam overtakes
    h.pixels(0x2C, std::vector<int>(240 * 320, red));
    EXPECT_TRUE(h.reported(Rule::tear));
}

} // namespace
