// Tests the models of one-bit OLED controllers by the datasheets' rules: byte streams go in; glass and
// violations come out.
#include <gtest/gtest.h>

#include "host_sim/controller/mono_controller.hpp"
#include "tests/system/sim/oled_host.hpp"

namespace {

using namespace spangle::sim;
using Host = sim_test::OledHost<MonoController, MonoChip>;

constexpr Rgb666 lit{63, 63, 63}, dark{};
constexpr GlassMount full{0, 0, 128, 64}, upright{0, 0, 128, 64, true, true};

/// Returns a host with the usual set-up of modules, and a dark memory.
Host lit_host(GlassMount glass = full) {
    Host h(ssd1306, glass);
    h.commands({0xAE, 0xA8, glass.height - 1, 0xDA, glass.height > 32 ? 0x12 : 0x02, 0x8D, 0x14, 0x20, 0x00});
    h.commands({0x21, 0, 127, 0x22, 0, glass.height / 8 - 1});
    h.fill(0, 128 * glass.height / 8);
    h.commands({0xAF});
    return h;
}

TEST(MonoController, ABitIsAPixelTheLowestOnTop) {
    Host h = lit_host();
    h.data({0x01, 0x80, 0x18}); // the pointer is back at the start
    h.commands({0xE3});
    EXPECT_EQ(h.seen(0, 0), lit);
    EXPECT_EQ(h.seen(0, 1), dark);
    EXPECT_EQ(h.seen(1, 7), lit);
    EXPECT_EQ(h.seen(1, 6), dark);
    EXPECT_EQ(h.seen(2, 3), lit);
    EXPECT_EQ(h.seen(2, 4), lit);
    EXPECT_EQ(h.broken(), "7") << "the window was left in its middle";
}

TEST(MonoController, ThreeWaysToAddress) {
    Host h = lit_host();
    h.commands({0x21, 10, 11, 0x22, 2, 3});
    h.data({1, 2, 4, 8}); // horizontal mode: columns, then pages
    EXPECT_TRUE(h.chip.bit(10, 16) && h.chip.bit(11, 17) && h.chip.bit(10, 26) && h.chip.bit(11, 27));
    h.commands({0x20, 0x01}); // vertical mode: pages, then columns
    h.data({16, 32, 64, 128});
    EXPECT_TRUE(h.chip.bit(10, 20) && h.chip.bit(10, 29) && h.chip.bit(11, 22) && h.chip.bit(11, 31));
    EXPECT_FALSE(h.chip.bit(10, 16));
    h.commands({0x20, 0x02, 0xB5, 0x0F, 0x17});
    h.data({0x42});
    EXPECT_TRUE(h.chip.bit(0x7F, 41) && h.chip.bit(0x7F, 46));
    EXPECT_EQ(h.broken(), "");
}

TEST(MonoController, RemapsAreWhereTheySay) {
    Host h = lit_host();
    h.commands({0x21, 5, 5, 0x22, 0, 0});
    h.data({1});
    h.commands({0xA1}); // changes later bytes only
    EXPECT_EQ(h.seen(5, 0), lit);
    h.data({2});
    EXPECT_EQ(h.seen(122, 1), lit);
    EXPECT_EQ(h.seen(5, 0), lit);
    h.commands({0xC8}); // takes effect at once
    EXPECT_EQ(h.seen(122, 62), lit);
    EXPECT_EQ(h.seen(5, 63), lit);
    h.commands({0x41}); // the glass begins one line further down
    EXPECT_EQ(h.seen(122, 63), lit);
    h.commands({0x40, 0xD3, 0x02});
    EXPECT_EQ(h.seen(5, 1), lit) << "63 - 1 + 2 = line 0";
    EXPECT_EQ(h.broken(), "");
}

TEST(MonoController, AModuleTurnedAroundIsUprightWithBothRemaps) {
    Host h = lit_host(upright);
    h.commands({0xA1, 0xC8});
    h.data({1});
    EXPECT_EQ(h.seen(0, 0), lit);
}

TEST(MonoController, LitOnlyWhenOnAndPumped) {
    Host h = lit_host();
    h.commands({0xA7});
    EXPECT_EQ(h.seen(9, 9), lit);
    h.commands({0x8D, 0x10});
    EXPECT_EQ(h.seen(9, 9), dark);
    h.commands({0x8D, 0x14, 0xAE});
    EXPECT_EQ(h.seen(9, 9), dark);
    h.commands({0xAF, 0xA6});
    EXPECT_EQ(h.seen(9, 9), dark);
    h.commands({0xA5});
    EXPECT_EQ(h.seen(9, 9), lit);
    h.commands({0xA4});
    EXPECT_EQ(h.seen(9, 9), dark);
    h.reset(100'000);
    EXPECT_FALSE(h.chip.display_on());
    EXPECT_EQ(h.broken(), "");
}

TEST(MonoController, RowsComeShuffledWithTheWrongPins) {
    Host h = lit_host();
    h.data({0x02}); // sets row 1 of the page
    h.commands({0xDA, 0x02});
    EXPECT_EQ(h.seen(0, 2), lit);
    EXPECT_EQ(h.seen(0, 1), dark);
    Host low = lit_host({0, 0, 128, 32});
    low.data({0x02});
    EXPECT_EQ(low.seen(0, 1), lit);
    low.commands({0xA8, 0x0F});
    EXPECT_EQ(low.seen(0, 16), dark);
    low.commands({0xDA, 0x12});
    EXPECT_EQ(low.seen(0, 1), dark) << "row 2 is driven there";
}

TEST(MonoController, RulesThatStreamsBreak) {
    Host h = lit_host();
    h.reset(2'000);
    EXPECT_EQ(h.broken(), "2");
    h.commands({0x20, 0x00, 0x21, 0});
    h.data({1});
    EXPECT_EQ(h.broken(), "5") << "21h waits for its end column";
    h.commands({0x90});
    EXPECT_EQ(h.broken(), "7 5") << "no such command; and the byte above was one of 1024";
    h.commands({0x21, 9, 8});
    EXPECT_EQ(h.broken(), "6");
    h.commands({0x21, 0, 128});
    EXPECT_EQ(h.broken(), "6");
    h.commands({0x22, 0, 8});
    EXPECT_EQ(h.broken(), "6");
    h.commands({0xB1});
    EXPECT_EQ(h.broken(), "6") << "pages are named in page mode only";
    h.commands({0x01});
    EXPECT_EQ(h.broken(), "6");
    h.commands({0xA8, 0x0E});
    EXPECT_EQ(h.broken(), "6");
    h.commands({0x21, 0, 1, 0x22, 0, 0});
    h.data({1, 2, 3});
    EXPECT_EQ(h.broken(), "7");
    h.commands({0x21, 0, 1, 0x22, 0, 0, 0x2F});
    h.data({1, 2});
    EXPECT_EQ(h.broken(), "16") << "the memory is moving";
    h.commands({0x2E});
    h.data({1, 2});
    EXPECT_EQ(h.broken(), "");
    h.period = 49;
    h.commands({0xE3});
    EXPECT_EQ(h.broken(), "9");
}

TEST(MonoController, I2cHasAClockOfItsOwn) {
    Host h(ssd1306, full, OledBus::i2c);
    h.period = 1000; // faster than the rated 400 kHz; modules are known to work so
    h.commands({0xE3});
    EXPECT_EQ(h.broken(), "");
    h.period = 999;
    h.commands({0xE3});
    EXPECT_EQ(h.broken(), "9");
    Host slow(sh1106, {2, 0, 128, 64}, OledBus::i2c);
    slow.period = 2400;
    slow.commands({0xE3});
    EXPECT_EQ(slow.broken(), "9");
}

TEST(MonoController, Sh1106HasPagesOnlyAndGlassFromColumn2) {
    Host h(sh1106, {2, 0, 128, 64});
    h.commands({0xB3, 0x02, 0x10});
    h.fill(0xFF, 128);
    h.commands({0xAF});
    EXPECT_EQ(h.seen(0, 24), lit);
    EXPECT_EQ(h.seen(127, 31), lit);
    EXPECT_EQ(h.broken(), "") << "128 bytes from column 2 on are a row of glass";
    h.commands({0x20, 0x21, 0x22});
    EXPECT_EQ(h.broken(), "5 5 5") << "no such commands";
    h.commands({0xB0, 0x00, 0x10});
    h.data({1});
    EXPECT_EQ(h.broken(), "6") << "no glass there";
    h.commands({0x03, 0x18});
    h.data({1});
    h.data({1});
    EXPECT_EQ(h.broken(), "6 7") << "columns 131 and 132";
    h.commands({0x04, 0x18});
    EXPECT_EQ(h.broken(), "6");
    h.commands({0xAD, 0x8A});
    EXPECT_EQ(h.seen(0, 24), dark) << "the converter is off";
    h.commands({0xAD, 0x8B, 0xA1, 0x02, 0x10, 0xB0});
    h.data({1});
    EXPECT_TRUE(h.chip.bit(129, 0));
}

TEST(MonoController, ReadModifyWriteComesBack) {
    Host h(sh1106, {2, 0, 128, 64});
    h.commands({0xB0, 0x05, 0x10, 0xE0});
    h.data({1, 1, 1});
    h.commands({0xEE});
    h.data({2});
    EXPECT_TRUE(h.chip.bit(5, 1));
    EXPECT_FALSE(h.chip.bit(5, 0));
    h.commands({0xEE});
    h.data({2});
    EXPECT_TRUE(h.chip.bit(6, 1)) << "it ended before";
}

TEST(MonoController, Ssd0303ShowsSixteenRowsFromColumn36) {
    Host h(ssd0303, {36, 0, 96, 16});
    h.commands({0xA8, 0x0F, 0xDA, 0x02, 0xB1, 0x04, 0x12, 0xAF});
    h.data({0x80});
    EXPECT_EQ(h.seen(0, 15), lit);
    EXPECT_EQ(h.broken(), "");
    h.commands({0xB2, 0x04, 0x12});
    h.data({0x80});
    EXPECT_EQ(h.broken(), "6") << "no glass below page 1";
}

TEST(MonoController, WhatIsNotSelectedOrInResetIsNotHeard) {
    Host h = lit_host();
    h.chip.write(0xA5, false, h.now, 250);
    EXPECT_EQ(h.seen(9, 9), dark);
    h.chip.reset(true, h.now);
    h.commands({0xAF, 0xA5});
    h.chip.reset(false, h.now + 100'000);
    EXPECT_FALSE(h.chip.display_on());
}

} // namespace
