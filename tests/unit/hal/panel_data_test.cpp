// Tests the data of panels and boards: programs as bytes, and descriptions that must not compile.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <type_traits>

#include <spangle/boards/boards.hpp>
#include <spangle/hal/board.hpp>
#include <spangle/panels.hpp>

using namespace spangle;
using namespace spangle::hal;

TEST(InitProgram, IsBytesInFlash) {
    constexpr auto program = init_program(cmd(0xC0, 0x23), cmd(0x11), delay_ms(120), cmd(0xC5, 0x3E, 0x28));
    static_assert(program == ProgramBytes<11>{0xC0, 1, 0x23, 0x11, 0, 12, 0xFF, 0xC5, 2, 0x3E, 0x28});
    Program at = program;
    EXPECT_EQ(at.next().params[0], 0x23);
    EXPECT_EQ(*at.next().command, 0x11);
    const Program::Step pause = at.next();
    EXPECT_EQ(pause.delay_micros, 120000u);
    EXPECT_EQ(pause.count, 0);
    const Program::Step last = at.next();
    EXPECT_EQ(*last.command, 0xC5);
    EXPECT_EQ(last.count, 2);
    EXPECT_EQ(last.params[1], 0x28);
    EXPECT_TRUE(at.empty());
}

TEST(InitProgram, DelaysRoundUp) {
    EXPECT_EQ(Program(delay_ms(1)).next().delay_micros, 10000u);
    EXPECT_EQ(Program(delay_ms(11)).next().delay_micros, 20000u);
}

TEST(InitProgram, CutShortIsSeen) {
    static constexpr ProgramBytes<3> cut = {0xC0, 2, 0x23};
    static constexpr ProgramBytes<1> lone = {0xC0};
    EXPECT_FALSE(well_formed(cut));
    EXPECT_FALSE(well_formed(lone));
    EXPECT_TRUE(well_formed(panels::ili9341::setup));
    PanelDesc panel = panels::ili9341_240x320;
    panel.setup = cut;
    EXPECT_STREQ(flaw(panel), "panel: the setup program is cut short");
}

TEST(PanelData, FlawsAreNamed) {
    const auto flawed = [](auto change) {
        PanelDesc panel = panels::st7789_135x240;
        change(panel);
        const char* rule = flaw(panel);
        return std::string(rule != nullptr ? rule : "");
    };
    EXPECT_EQ(flawed([](PanelDesc&) {}), "");
    EXPECT_EQ(flawed([](PanelDesc& p) { p.offset.x = 105; }), "");
    EXPECT_EQ(flawed([](PanelDesc& p) { p.offset.x = 106; }),
              "panel: the glass is wider than the memory behind it");
    EXPECT_EQ(flawed([](PanelDesc& p) { p.offset.y = 81; }),
              "panel: the glass is taller than the memory behind it");
    EXPECT_EQ(flawed([](PanelDesc& p) { p.offset.y = -1; }), "panel: the offset is negative");
    EXPECT_EQ(flawed([](PanelDesc& p) { p.glass.width = 0; }), "panel: the glass has no size");
    EXPECT_EQ(flawed([](PanelDesc& p) { p.memory.height = 0; }), "panel: the memory has no size");
    EXPECT_EQ(flawed([](PanelDesc& p) { p.memory.width = 4097; }),
              "panel: the memory is larger than 4096 x 4096");
    EXPECT_EQ(flawed([](PanelDesc& p) { p.mount = dcs::MV; }), "panel: a mount is made of MX and MY only");
    EXPECT_EQ(flawed([](PanelDesc& p) { p.timing.reset_low_us = 9; }),
              "panel: a reset pulse is at least 10 us");
    for (const auto wrong : {Extent{129, 64}, Extent{128, 60}}) {
        PanelDesc panel = panels::sh1106_128x64;
        panel.glass = wrong;
        const char* const rule = flaw(panel);
        if (wrong.height == 60)
            EXPECT_STREQ(rule, "panel: memory, glass and offset end where bytes of pixels do");
        else
            EXPECT_EQ(rule, nullptr) << "columns of one bit have no neighbours";
        panel = panels::ssd1327_128x128;
        panel.glass = {wrong.width, 128};
        panel.memory.width = 130;
        EXPECT_EQ(flaw(panel) == nullptr, wrong.width == 128);
    }
    for (const auto bytes : {std::uint8_t{0}, std::uint8_t{4}})
        EXPECT_EQ(flawed([bytes](PanelDesc& p) { p.identity.bytes = bytes; }),
                  "panel: an identity has one to three bytes");
}

namespace {

template <int X> constexpr PanelDesc shifted() {
    PanelDesc p = panels::st7789_135x240;
    p.offset.x = X;
    return p;
}
template <int X>
concept DescribesAPanel = requires {
    typename std::integral_constant<int, panel(shifted<X>()).glass.width>;
};

template <unsigned Hz> constexpr Board clocked() {
    Board b = boards::ili9341_spi;
    b.write_hz = Hz;
    return b;
}
template <unsigned Hz>
concept DescribesABoard = requires {
    typename std::integral_constant<unsigned, board(clocked<Hz>()).write_hz>;
};

} // namespace

TEST(PanelData, WrongDescriptionsDoNotCompile) {
    EXPECT_TRUE(DescribesAPanel<105>);
    EXPECT_FALSE(DescribesAPanel<106>);
    EXPECT_TRUE(DescribesABoard<80000000>);
    EXPECT_FALSE(DescribesABoard<80000001>);
}

TEST(BoardData, FlawsAreNamed) {
    const auto flawed = [](auto change) {
        Board board = boards::ili9341_spi;
        change(board);
        const char* rule = flaw(board);
        return std::string(rule != nullptr ? rule : "");
    };
    EXPECT_EQ(flawed([](Board&) {}), "");
    EXPECT_EQ(flawed([](Board& b) { b.display.format = PixelFormat::rgb888; }), "");
    EXPECT_EQ(flawed([](Board& b) { b.display.format = PixelFormat::rgb565_le; }),
              "display: the panel does not take this pixel format on this bus");
    EXPECT_EQ(flawed([](Board& b) { b.display.buffers = 3; }),
              "display: a panel display has one or two buffers");
    EXPECT_EQ(flawed([](Board& b) { b.read_hz = 0; }),
              "display: reading back needs a read clock, but the bus cannot read");
    EXPECT_EQ(flawed([](Board& b) { b.display.wait_te = true; }),
              "display: waiting for TE, but the bus has no tearing-effect line");
    EXPECT_EQ(flawed([](Board& b) { b.write_hz = 0; }), "display: the bus has no write clock");
    EXPECT_EQ(flawed([](Board& b) { b.write_hz = 80000000; }), "");
    EXPECT_EQ(flawed([](Board& b) { b.write_hz = 80000001; }),
              "display: the bus's write clock is faster than this panel is known to take");
    EXPECT_EQ(flawed([](Board& b) {
                  b.bus = BusKind::i8080, b.write_hz = 15200000, b.read_hz = 0, b.display.read_back = false;
              }),
              "display: the bus's write clock is faster than this panel is known to take");
    EXPECT_EQ(flawed([](Board& b) { b.read_hz = 6700000; }),
              "display: the bus's read clock is faster than the panel's datasheet allows");
}

TEST(BoardData, FlawsOfOledsAreNamed) {
    const auto flawed = [](auto change) {
        Board board = boards::ssd1306_i2c;
        change(board);
        const char* rule = flaw(board);
        return std::string(rule != nullptr ? rule : "");
    };
    EXPECT_EQ(flawed([](Board&) {}), "");
    EXPECT_EQ(flawed([](Board& b) { b.display.wire = {}; }),
              "display: the panel does not take this pixel format on this bus");
    EXPECT_EQ(flawed([](Board& b) { b.display.buffers = 2; }),
              "display: a picture that is turned into another format needs one buffer");
    EXPECT_EQ(flawed([](Board& b) { b.display.wait_te = b.has_te = true; }),
              "display: waiting for TE, but the controller has no such output");
    EXPECT_EQ(flawed([](Board& b) { b.write_hz = 1000000; }), "");
    EXPECT_EQ(flawed([](Board& b) { b.write_hz = 1000001; }),
              "display: the bus's write clock is faster than this panel is known to take");
    EXPECT_EQ(flawed([](Board& b) { b.display.panel = &panels::ssd1331_96x64, b.display.wire = {}; }),
              "display: the panel does not take this pixel format on this bus");
    EXPECT_EQ(flawed([](Board& b) { b.bus = BusKind::spi_start; }),
              "display: the panel does not take this pixel format on this bus");
}

TEST(BoardData, AnIli9488OnSpiTakesOnlyThreeBytePixels) {
    for (const PanelDesc* panel : {&panels::ili9488_320x480, &panels::ili9486_320x480}) {
        Board board = boards::ili9488_spi;
        board.display.panel = panel;
        board.write_hz = 20000000;
        EXPECT_EQ(flaw(board), nullptr);
        board.display.format = PixelFormat::rgb565_be;
        EXPECT_STREQ(flaw(board), "display: the panel does not take this pixel format on this bus");
        board.bus = BusKind::i8080, board.read_hz = 2000000;
        EXPECT_EQ(flaw(board), nullptr);
    }
}

/// Module makers choose where the glass is in memory. No other data could show a wrong offset.
TEST(PanelData, OffsetsAreTheModuleMakers) {
    const struct {
        const PanelDesc& panel;
        int x, y;
    } facts[] = {
        {panels::st7789_240x280, 0, 20},      {panels::st7789_240x240, 0, 0},
        {panels::st7789_172x320, 34, 0},      {panels::st7789_170x320, 35, 0},
        {panels::st7789_135x240, 52, 40},     {panels::st7735_128x160, 0, 0},
        {panels::st7735_128x160_green, 2, 1}, {panels::st7735_128x128_green, 2, 1},
        {panels::st7735_128x128_red, 2, 3},   {panels::st7735_80x160, 24, 0},
        {panels::st7735_80x160_26, 26, 1},
    };
    for (const auto& fact : facts) {
        EXPECT_EQ(fact.panel.offset.x, fact.x) << fact.panel.name;
        EXPECT_EQ(fact.panel.offset.y, fact.y) << fact.panel.name;
    }
}

TEST(PanelData, TheTableIsUniqueAndSound) {
    std::set<std::string> names;
    for (const PanelDesc* panel : panels::all) {
        EXPECT_TRUE(names.insert(panel->name).second) << panel->name;
        EXPECT_EQ(flaw(*panel), nullptr) << panel->name;
        EXPECT_EQ(panel->identity.id & ~panel->identity.mask, 0u) << panel->name << ": can never answer";
        if (panel->commands->tearing.empty())
            continue; // without TE nothing waits for the panel's scan
        EXPECT_NEAR(panel->timing.frame_us, 14000, 5000) << panel->name << ": "
                                                         << "56 to 111 Hz";
        EXPECT_GT(panel->timing.scan_lines, panel->memory.height) << panel->name;
        EXPECT_EQ(panel->timing.scan_lines - panel->timing.porch_lines, panel->memory.height) << panel->name;
    }
    EXPECT_EQ(names.size(), 28u);
}

TEST(BoardData, NamesAreUniqueAndSound) {
    std::set<std::string> names;
    for (const Board* board : boards::all) {
        EXPECT_TRUE(names.insert(board->name).second) << board->name;
        EXPECT_EQ(flaw(*board), nullptr) << board->name;
        const BusCaps caps = bus_caps(*board);
        EXPECT_EQ(caps.kind, board->bus);
        EXPECT_NEAR(caps.write_hz, board->bus == BusKind::i2c ? board->write_hz / 9.0 * 8 : board->write_hz,
                    1);
        EXPECT_EQ(caps.bits_per_cycle, board->bus == BusKind::i8080 ? 8 : 1);
        EXPECT_EQ(caps.has_te, board->has_te);
    }
    for (const char* wanted :
         {"ili9341-spi", "ili9341-8080", "st7789-240", "st7789-135x240", "st7735-128x160"})
        EXPECT_TRUE(names.count(wanted)) << wanted;
}

TEST(PanelData, RefreshFollowsFromTheRegisters) {
    EXPECT_NEAR(1e6 / panels::ili9341_240x320.timing.frame_us, 615000.0 / (27 * 324), 0.05);
    EXPECT_NEAR(1e6 / panels::st7789_240x320.timing.frame_us, 1e7 / ((250 + 16 * 15) * 344), 0.05);
    EXPECT_NEAR(1e6 / panels::st7735_128x160.timing.frame_us, 850000.0 / (42 * (160 + 89)), 0.05);
}
