// Tests the models of grey and colour OLED controllers by the datasheets' rules: byte streams go in; glass
// and violations come out.
#include <gtest/gtest.h>

#include "host_sim/controller/windowed_controller.hpp"
#include "tests/system/sim/oled_host.hpp"

namespace {

using namespace spangle::sim;
using Host = sim_test::OledHost<WindowedController, WindowedChip>;

constexpr GlassMount square{0, 0, 128, 128};

Rgb666 grey(int level) {
    const auto six = static_cast<std::uint8_t>(level << 2 | level >> 2);
    return {six, six, six};
}

Host grey_host(int remap = 0x40) {
    Host h(ssd1327, square);
    h.send(0xA0, {remap});
    h.fill(0, 64 * 128);
    h.send(0xAF);
    return h;
}

TEST(GreyController, AByteIsTwoPixelsTheLeftInTheLowNibble) {
    Host h = grey_host();
    h.data({0x21});
    EXPECT_EQ(h.seen(0, 0), grey(1));
    EXPECT_EQ(h.seen(1, 0), grey(2));
    Host swapped = grey_host(0x42);
    swapped.data({0x21});
    EXPECT_EQ(swapped.seen(0, 0), grey(2));
    EXPECT_EQ(swapped.seen(1, 0), grey(1));
}

TEST(GreyController, ColumnRemapTurnsAddressesAndNibblesStay) {
    Host h = grey_host(0x41);
    h.data({0x21});
    EXPECT_EQ(h.seen(126, 0), grey(1));
    EXPECT_EQ(h.seen(127, 0), grey(2));
    Host both = grey_host(0x43);
    both.data({0x21});
    EXPECT_EQ(both.seen(127, 0), grey(1));
    EXPECT_EQ(both.seen(126, 0), grey(2));
}

TEST(GreyController, WindowsFillAlongRowsOrColumns) {
    Host h = grey_host();
    h.send(0x15, {3, 4});
    h.send(0x75, {10, 11});
    h.data({0x11, 0x22, 0x33, 0x44});
    EXPECT_EQ(h.chip.value(8, 10), 2u);
    EXPECT_EQ(h.chip.value(6, 11), 3u);
    h.send(0xA0, {0x44});
    h.data({0x55, 0x66, 0x77, 0x88});
    EXPECT_EQ(h.chip.value(6, 10), 5u);
    EXPECT_EQ(h.chip.value(6, 11), 6u);
    EXPECT_EQ(h.chip.value(8, 10), 7u);
    EXPECT_EQ(h.chip.value(9, 11), 8u);
    EXPECT_EQ(h.broken(), "");
}

TEST(GreyController, LinesOfTheGlass) {
    Host h = grey_host();
    h.send(0x15, {0, 0});
    h.send(0x75, {5, 5});
    h.data({0xFF});
    EXPECT_EQ(h.seen(0, 5), grey(15));
    h.send(0xA0, {0x50});
    EXPECT_EQ(h.seen(0, 122), grey(15)) << "COM scan reversed";
    h.send(0xA0, {0x40});
    h.send(0xA1, {3});
    EXPECT_EQ(h.seen(0, 2), grey(15));
    h.send(0xA2, {1});
    EXPECT_EQ(h.seen(0, 1), grey(15));
    h.send(0xA1, {0}), h.send(0xA2, {0});
    h.send(0xA8, {4});
    EXPECT_EQ(h.seen(0, 5), grey(0)) << "five lines are driven";
    h.send(0xA8, {127}), h.send(0xA0, {0x00});
    EXPECT_EQ(h.seen(0, 5), grey(0)) << "the split forgotten";
    h.send(0xA0, {0x40}), h.send(0xA7);
    EXPECT_EQ(h.seen(0, 5), grey(0));
    EXPECT_EQ(h.seen(0, 6), grey(15));
    h.send(0xA6);
    EXPECT_EQ(h.seen(0, 5), grey(0));
    h.send(0xA5);
    EXPECT_EQ(h.seen(0, 6), grey(15));
    h.send(0xAE);
    EXPECT_EQ(h.seen(0, 6), grey(0));
    EXPECT_EQ(h.broken(), "");
}

TEST(GreyController, Ssd0323ShowsSixtyFourOfEightyLines) {
    Host h(ssd0323, {0, 0, 128, 64});
    h.commands({0xAE, 0x15, 0,    63,   0x75, 0,    63,   0x81, 0x40, 0x86, 0xA0, 0x52, 0xA1, 0,    0xA2,
                0x4C, 0xA4, 0xA8, 0x3F, 0xB1, 0x22, 0xB2, 0x46, 0xB3, 0x41, 0xB8, 1,    0x11, 0x22, 0x32,
                0x43, 0x54, 0x65, 0x76, 0xBC, 8,    0xBE, 0x1C, 0xBF, 0x0F, 0xAD, 3,    0xAF});
    h.fill(0, 64 * 64);
    h.data({0x21});
    h.fill(0, 64 * 64 - 1);
    EXPECT_EQ(h.seen(0, 63), grey(2)) << "left in the high nibble";
    EXPECT_EQ(h.seen(1, 63), grey(1));
    h.send(0xA2, {0x00});
    EXPECT_EQ(h.seen(0, 63), Rgb666({h.chip.cells()[4 * 128]})) << "four lines off";
    EXPECT_EQ(h.broken(), "7") << "two frames in one stream";
}

TEST(GreyController, RulesThatStreamsBreak) {
    Host h = grey_host();
    h.send(0x15, {0, 64});
    EXPECT_EQ(h.broken(), "6") << "64 addresses of two columns";
    h.send(0x75, {1, 0});
    EXPECT_EQ(h.broken(), "6");
    h.send(0x15, {0, 1}), h.send(0x75, {0, 0});
    h.data({1});
    h.send(0xA4);
    EXPECT_EQ(h.broken(), "7");
    h.send(0xAF, {1});
    EXPECT_EQ(h.broken(), "5") << "01h is no command";
    h.send(0x2F);
    h.data({1, 1});
    EXPECT_EQ(h.broken(), "16");
    h.period = 99;
    h.send(0xA4);
    EXPECT_EQ(h.broken(), "9");
    Host short_glass(ssd1327, {0, 0, 128, 96});
    short_glass.send(0x75, {96, 96}), short_glass.send(0x15, {0, 0});
    short_glass.data({1});
    EXPECT_EQ(short_glass.broken(), "6") << "no glass there";
}

Host color_host(int remap = 0x74) {
    Host h(ssd1351, square);
    h.period = 50;
    h.send(0xFD, {0x12}), h.send(0xFD, {0xB1});
    h.send(0xA2, {0}), h.send(0xA0, {remap});
    h.send(0xAF);
    return h;
}
constexpr Rgb666 red{63, 0, 0}, blue{0, 0, 63};

TEST(ColorOled, PixelsFollowTheWriteCommand) {
    Host h = color_host(0x64);
    h.send(0x15, {1, 2}), h.send(0x75, {3, 3});
    h.data({0xF8, 0x00});
    EXPECT_EQ(h.broken(), "5") << "without 5Ch";
    h.send(0x5C);
    h.data({0xF8, 0x00, 0x00, 0x1F});
    EXPECT_EQ(h.seen(1, 3), red);
    EXPECT_EQ(h.seen(2, 3), blue);
    EXPECT_EQ(h.broken(), "");
    h.send(0x5C); // the pointer is back where 15h put it
    h.data({0x00, 0x1F});
    h.send(0x5C); // another 5Ch leaves the pointer there
    h.data({0xF8, 0x00});
    EXPECT_EQ(h.seen(1, 3), blue);
    EXPECT_EQ(h.seen(2, 3), red);
    h.send(0xA0, {0x60});
    EXPECT_EQ(h.seen(2, 3), blue) << "the colours exchanged";
}

TEST(ColorOled, EveryAddressOrder) {
    for (int order = 0; order < 8; ++order) {
        const bool mv = (order & 1) != 0, mx = (order & 2) != 0, my = (order & 4) != 0;
        Host h = color_host(0x64 | (mv ? 1 : 0) | (mx ? 2 : 0) | (my ? 0x10 : 0));
        h.send(0x15, {10, 11}), h.send(0x75, {20, 21});
        h.send(0x5C);
        h.data({0, 1, 0, 2, 0, 3, 0, 4});
        const auto at = [&](int column, int row) { return h.chip.value(mx ? 127 - column : column, row); };
        EXPECT_EQ(at(10, 20), 1u) << order;
        EXPECT_EQ(at(11, 20), mv ? 3u : 2u) << order;
        EXPECT_EQ(at(10, 21), mv ? 2u : 3u) << order;
        EXPECT_EQ(at(11, 21), 4u) << order;
        EXPECT_EQ(h.seen(mx ? 117 : 10, my ? 107 : 20), (Rgb666{0, 0, 2})) << order;
    }
}

TEST(ColorOled, RegistersStayLockedWithoutTheKey) {
    Host h(ssd1351, square);
    h.period = 50;
    h.send(0xA2, {0});
    EXPECT_EQ(h.broken(), "15");
    h.send(0xFD, {0xB1}), h.send(0xA2, {0});
    h.send(0xFD, {0x12});
    h.send(0xBE, {5});
    EXPECT_EQ(h.broken(), "15") << "locked again";
    EXPECT_EQ(h.chip.value(0, 0), h.chip.value(0, 0));
}

TEST(ColorOled, AnOffsetOf60hIsThereUntilItIsCleared) {
    Host h(ssd1351, square);
    h.period = 50;
    h.send(0xA0, {0x64}), h.send(0xAF);
    h.send(0x15, {0, 0}), h.send(0x75, {0x60, 0x60}), h.send(0x5C);
    h.data({0xF8, 0x00});
    EXPECT_EQ(h.seen(0, 0), red);
    h.send(0xA4);
    EXPECT_EQ(h.seen(0, 0), Rgb666{}) << "this chip's A4h is all off";
    h.send(0xA6);
    EXPECT_EQ(h.seen(0, 0), red);
    h.send(0xCA, {0x3F});
    EXPECT_EQ(h.seen(0, 64), Rgb666{});
}

TEST(ColorOled, OneByteColoursAndSlips) {
    Host h(ssd1331, {0, 0, 96, 64});
    h.commands({0xA0, 0x20, 0x15, 0, 1, 0x75, 0, 0, 0xAF});
    h.data({0xE0, 0x03});
    EXPECT_EQ(h.seen(0, 0), red);
    EXPECT_EQ(h.seen(1, 0), blue);
    h.commands({0xA0, 0x60});
    h.data({0xF8, 0x00, 0x07, 0xE0});
    EXPECT_EQ(h.seen(1, 0), (Rgb666{0, 63, 0}));
    h.commands({0xA0, 0x64});
    EXPECT_EQ(h.seen(0, 0), blue);
    EXPECT_EQ(h.broken(), "");
    h.data({0xF8, 0x00, 0x07});
    h.commands({0xA4});
    EXPECT_EQ(h.broken(), "10 7");
    h.commands({0xA0, 0xA0});
    EXPECT_EQ(h.broken(), "12");
    h.period = 149;
    h.commands({0xA4});
    EXPECT_EQ(h.broken(), "9");
}

TEST(ColorOled, TheDrawingEngineIsBusyForAWhile) {
    Host h(ssd1331, {0, 0, 96, 64});
    h.commands({0xA0, 0x60, 0xAF, 0x25, 2, 3, 4, 5});
    EXPECT_EQ(h.seen(4, 5), Rgb666{});
    EXPECT_NE(h.chip.value(5, 5), 0u);
    h.commands({0xA4});
    EXPECT_EQ(h.broken(), "16");
    h.now += 1'000'000;
    h.commands({0xA4});
    EXPECT_EQ(h.broken(), "");
}

} // namespace
