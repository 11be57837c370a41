// Tests what initialisation puts on the wire, byte by byte, and every way in which it can fail.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/hal/fake_panel_bus.hpp"
#include <spangle/boards/boards.hpp>
#include <spangle/hal.hpp>

using namespace hal_test;

namespace {

std::string wire(const PanelConfig& config, BusCaps caps = spi()) {
    FakePanelBus bus(*config.panel, caps);
    PanelStorage<PanelSizes{.height = 320, .buffers = 2}> storage;
    PanelDisplay display(bus, config, storage.memory());
    const auto ready = display.init();
    EXPECT_TRUE(ready.ok()) << ready.error().rule;
    EXPECT_TRUE(bus.awake);
    EXPECT_TRUE(bus.on);
    return bus.log;
}

Error refused(PanelConfig config, BusCaps caps = spi(), int acquires = 1000) {
    FakePanelBus bus(panels::st7789_240x240, caps);
    bus.allow_acquires = acquires;
    PanelStorage<PanelSizes{.height = 240, .ops = 8}> storage;
    PanelDisplay display(bus, config, storage.memory());
    const auto ready = display.init();
    EXPECT_FALSE(ready.ok());
    EXPECT_FALSE(display.acquire().ok());
    EXPECT_FALSE(display.present().ok());
    return ready.error();
}

PanelConfig on(const PanelDesc& panel, Orientation orientation = {}) {
    PanelConfig config;
    config.panel = &panel;
    config.orientation = orientation;
    return config;
}

} // namespace

TEST(Init, Ili9341Landscape) {
    EXPECT_EQ(
        wire(on(panels::ili9341_240x320, {Rotation::r90})),
        "reset10 D120 CF 00 c1 30 ED 64 03 12 81 E8 85 00 78 CB 39 2c 00 34 02 F7 20 EA 00 00 C0 23 C1 10 "
        "C5 3e 28 C7 86 B1 00 1b B6 08 82 27 F2 00 26 01 "
        "E0 0f 31 2b 0c 0e 08 4e f1 37 07 10 03 0e 09 00 E1 00 0e 14 03 11 07 31 c1 48 08 0f 0c 31 36 0f "
        "36 28 3A 55 20 11 D120 2A 00 00 01 3f 2B 00 00 00 ef 2C rep76800 29 ");
}

TEST(Init, St7789Behind135x240) {
    EXPECT_EQ(wire(on(panels::st7789_135x240)),
              "reset10 D120 B0 00 e0 B7 35 BB 28 C2 01 ff C3 10 C4 20 D0 a4 a1 "
              "E0 d0 00 02 07 0a 28 32 44 42 06 0e 12 14 17 E1 d0 00 02 07 0a 28 31 54 47 0e 1c 17 1b 1e "
              "36 00 3A 55 21 11 D120 2A 00 34 00 ba 2B 00 28 01 17 2C rep32400 29 ");
}

TEST(Init, St7735GreenTab) {
    EXPECT_EQ(
        wire(on(panels::st7735_128x160_green)),
        "reset10 D120 B1 01 2c 2d B2 01 2c 2d B3 01 2c 2d 01 2c 2d B4 07 C0 a2 02 84 C1 c5 C2 0a 00 C3 8a 2a "
        "C4 8a ee C5 0e E0 02 1c 07 12 37 32 29 2d 29 25 2b 39 00 01 03 10 "
        "E1 03 1d 07 06 2e 2c 29 2d 2e 2e 37 3f 00 00 02 10 "
        "36 c8 3A 05 20 11 D120 2A 00 02 00 81 2B 00 01 00 a0 2C rep20480 29 ");
}

TEST(Init, WithoutAResetLineSendsSwreset) {
    PanelConfig config = on(panels::st7789_240x240);
    config.reset_line = false;
    EXPECT_EQ(wire(config).substr(0, 8), "01 D120 ");
}

TEST(Init, ThreeBytePixelsAreColmod66) {
    PanelConfig config = on(panels::st7789_240x240);
    config.format = PixelFormat::rgb888;
    EXPECT_NE(wire(config).find("3A 66 "), std::string::npos);
}

TEST(Init, DelaysOfAProgramAreKept) {
    static constexpr auto setup = init_program(cmd(0xB7, 0x35), delay_ms(50), cmd(0xBB, 0x28));
    PanelDesc panel = panels::st7789_240x240;
    panel.setup = setup;
    EXPECT_NE(wire(on(panel)).find("B7 35 D50 BB 28 36 00 "), std::string::npos);
}

TEST(Init, TheGlassComesOnBlack) {
    FakePanelBus bus(panels::st7789_135x240, spi());
    PanelStorage<PanelSizes{.height = 240}> storage;
    PanelDisplay display(bus, on(panels::st7789_135x240), storage.memory());
    ASSERT_TRUE(display.init().ok());
    long black = 0;
    for (std::uint32_t cell : bus.model.memory)
        black += cell == 0;
    EXPECT_EQ(black, 135 * 240);
    EXPECT_EQ(bus.model.overrun, 0);
}

TEST(Init, ShortOperationsCutTheBlackFillInWholePixels) {
    BusCaps caps = spi();
    caps.max_transfer = 1001;
    PanelConfig config = on(panels::st7789_240x240);
    FakePanelBus bus(panels::st7789_240x240, caps);
    PanelStorage<PanelSizes{.height = 240}> storage;
    PanelDisplay display(bus, config, storage.memory());
    ASSERT_TRUE(display.init().ok());
    EXPECT_EQ(bus.longest_op, 1000u);
    EXPECT_EQ(bus.repeats, 240 * 240);
}

TEST(Init, AnInitThatFailedLeavesTheDisplayClosed) {
    FakePanelBus bus(panels::st7789_240x240, spi());
    PanelStorage<PanelSizes{.height = 240}> storage;
    PanelDisplay display(bus, on(panels::st7789_240x240), storage.memory());
    for (long bytes : {0L, 5L, 60L, 80L, 20000L}) {
        bus.fail_after_bytes = bytes;
        EXPECT_EQ(display.init().error().fault, Fault::short_write) << bytes;
        EXPECT_EQ(display.acquire().error().fault, Fault::bad_argument);
        EXPECT_EQ(display.present().error().fault, Fault::bad_argument);
        EXPECT_EQ(display.status().error().fault, Fault::bad_argument);
        EXPECT_EQ(display.scanline().error().fault, Fault::bad_argument);
        EXPECT_EQ(display.read_back({0, 0, 1, 1}, nullptr).error().fault, Fault::bad_argument);
    }
    bus.refuse_submits = 1;
    EXPECT_EQ(display.init().error().fault, Fault::busy);
    EXPECT_TRUE(display.init().ok());
    EXPECT_TRUE(display.acquire().ok());
}

TEST(Init, RefusesWhatCannotWorkAndSaysWhy) {
    const PanelConfig good = on(panels::st7789_240x240);
    PanelConfig c = good;
    c.panel = nullptr;
    EXPECT_STREQ(refused(c).rule, "display: init without a panel");
    PanelDesc wrong = panels::st7789_240x240;
    wrong.offset.x = 1;
    EXPECT_STREQ(refused(on(wrong)).rule, "panel: the glass is wider than the memory behind it");
    c = good, c.format = PixelFormat::rgba8888;
    EXPECT_STREQ(refused(c).rule, "display: the panel does not take this pixel format on this bus");
    c = good, c.wait_te = true;
    EXPECT_STREQ(refused(c).rule, "display: waiting for TE, but the bus has no tearing-effect line");
    for (std::uint8_t buffers : {0, 3}) {
        c = good, c.buffers = buffers;
        EXPECT_STREQ(refused(c).rule, "display: a panel display has one or two buffers");
    }
    c = good, c.buffers = 2;
    EXPECT_STREQ(refused(c).rule, "display: the storage is smaller than the picture asks for");
    EXPECT_STREQ(refused(on(panels::st7789_240x320)).rule,
                 "display: the storage is smaller than the picture asks for");
    BusCaps caps = spi(4000000);
    c = on(panels::ssd1306_128x64);
    EXPECT_STREQ(refused(c, caps).rule, "display: the panel does not take this pixel format on this bus");
    c.wire = wires::mono, c.buffers = 2;
    EXPECT_STREQ(refused(c, caps).rule,
                 "display: a picture that is turned into another format needs one buffer");
    c.buffers = 1, c.wait_te = true;
    EXPECT_STREQ(refused(c, caps).rule, "display: waiting for TE, but the controller has no such output");
    c = on(panels::ssd1331_96x64), caps.kind = BusKind::i2c;
    EXPECT_STREQ(refused(c, caps).rule, "display: the panel does not take this pixel format on this bus");
    c = on(panels::hx8347_240x320), caps.kind = BusKind::i8080;
    EXPECT_STREQ(refused(c, caps).rule, "display: the storage is smaller than the picture asks for")
        << "a window and its pixels are ten operations";
    caps = spi();
    caps.write_hz = 0;
    EXPECT_STREQ(refused(good, caps).rule, "display: the bus has no write clock");
    caps = spi();
    caps.max_transfer = 3;
    EXPECT_EQ(refused(good, caps).fault, Fault::unsupported);
    caps.max_transfer = 8; // the gamma command needs 14 bytes
    EXPECT_STREQ(refused(good, caps).rule,
                 "display: a setup command is longer than one operation of the bus");
    EXPECT_STREQ(refused(good, spi(), 0).rule, "fake: out of DMA memory");
    c = good, c.read_back = true;
    caps = spi();
    caps.read_hz = 0;
    EXPECT_STREQ(refused(c, caps).rule, "display: reading back needs a read clock, but the bus cannot read");
}

TEST(Init, ChecksWhoAnswers) {
    struct {
        std::uint8_t id[3], status[4];
        Fault fault;
        std::uint32_t detail;
    } const cases[] = {
        {{0x85, 0x85, 0x52}, {0, 0x61, 0, 0}, Fault::none, 0},
        {{0x00, 0x00, 0x00}, {0, 0x61, 0, 0}, Fault::wrong_device, 0x000000}, // the answer of an ILI9341
        {{0x7C, 0x89, 0xF0}, {0, 0x61, 0, 0}, Fault::wrong_device, 0x7C89F0}, // the answer of an ST7735S
        {{0, 0, 0}, {0, 0, 0, 0}, Fault::no_answer, 0},
        {{0xFF, 0xFF, 0xFF}, {0xFF, 0xFF, 0xFF, 0xFF}, Fault::no_answer, 0xFFFFFF},
    };
    for (const auto& k : cases) {
        PanelConfig config = on(panels::st7789_240x240);
        config.read_back = true;
        FakePanelBus bus(*config.panel, spi());
        std::copy(k.id, k.id + 3, bus.id);
        std::copy(k.status, k.status + 4, bus.status);
        PanelStorage<PanelSizes{.height = 240}> storage;
        PanelDisplay display(bus, config, storage.memory());
        const auto ready = display.init();
        EXPECT_EQ(ready.error().fault, k.fault);
        EXPECT_EQ(ready.error().detail, k.detail);
    }
}

TEST(Init, BothKindsOfSt7735AndTheNamelessIli9341AreKnown) {
    const auto accepts = [](const PanelDesc& panel, std::uint8_t a, std::uint8_t b, std::uint8_t c) {
        FakePanelBus bus(panel, spi());
        bus.id[0] = a, bus.id[1] = b, bus.id[2] = c;
        ReadScratch scratch;
        return check_identity(bus, panel, scratch).ok();
    };
    EXPECT_TRUE(accepts(panels::st7735_128x160, 0x7C, 0x89, 0xF0));
    EXPECT_TRUE(accepts(panels::st7735_128x160, 0x5C, 0x88, 0xF0));
    EXPECT_FALSE(accepts(panels::st7735_128x160, 0x85, 0x85, 0x52));
    EXPECT_TRUE(accepts(panels::ili9341_240x320, 0, 0, 0));
    EXPECT_FALSE(accepts(panels::ili9341_240x320, 0x85, 0x85, 0x52));
}

TEST(Init, AnIdentityOfOneByteIsToldFromAFloatingLine) {
    FakePanelBus bus(panels::hx8357d_320x480, spi());
    ReadScratch scratch;
    bus.id_command = 0xD0;
    const auto fault = [&](std::uint8_t id, std::uint8_t status) {
        bus.id[0] = id;
        std::fill(bus.status, bus.status + 4, status);
        return check_identity(bus, panels::hx8357d_320x480, scratch).error().fault;
    };
    EXPECT_EQ(fault(0x99, 0x61), Fault::none);
    EXPECT_EQ(fault(0x98, 0x61), Fault::wrong_device);
    EXPECT_EQ(fault(0xFF, 0xFF), Fault::no_answer);
    EXPECT_EQ(fault(0x00, 0x00), Fault::no_answer);
}

TEST(Init, AnIdentityMayBeTheOnlyThingThatAnswers) {
    FakePanelBus bus(panels::hx8347_240x320, spi());
    bus.id_command = 0x00;
    ReadScratch scratch;
    const auto fault = [&](std::uint8_t id) {
        bus.log.clear();
        std::fill(bus.id, bus.id + 3, id);
        return check_identity(bus, panels::hx8347_240x320, scratch).error().fault;
    };
    EXPECT_EQ(fault(0x47), Fault::none);
    EXPECT_EQ(bus.log, "r00/0 ") << "no status registers are asked for";
    EXPECT_EQ(fault(0x75), Fault::wrong_device);
    EXPECT_EQ(fault(0xFF), Fault::no_answer);
    EXPECT_EQ(fault(0x00), Fault::no_answer);
    EXPECT_EQ(read_status(bus, panels::hx8347_240x320, scratch).error().fault, Fault::unsupported);
    EXPECT_EQ(read_scanline(bus, panels::hx8347_240x320, scratch).error().fault, Fault::unsupported);
}

/// Each command set opens a window with its own bytes; the window is a part of the picture.
TEST(Init, EachCommandSetNamesAWindowItsWay) {
    const struct {
        const PanelDesc& panel;
        Wire wire;
        Orientation orientation;
        const char* window;
    } table[] = {
        {panels::ssd1306_128x64, wires::mono, {}, "21 10 17 22 02 02 "},
        {panels::ssd1306_128x64, wires::mono, {Rotation::r90}, "21 10 17 22 02 02 "},
        {panels::sh1106_128x64, wires::mono, {}, "02 11 B2 "},
        {panels::ssd0303_96x16, wires::mono, {}, "04 13 B1 "},
        {panels::ssd1327_128x128, wires::grey4, {}, "15 08 0b 75 10 17 "},
        {panels::ssd1351_128x128, Wire{}, {}, "15 10 17 75 10 17 5C "},
        {panels::ssd1331_96x64, Wire{}, {}, "15 10 17 75 10 17 "},
        {panels::hx8347_240x320, Wire{}, {}, "02 00 03 10 04 00 05 17 06 00 07 10 08 00 09 17 22 "},
    };
    for (const auto& row : table) {
        PanelConfig config = on(row.panel, row.orientation);
        config.wire = row.wire;
        BusCaps caps = spi(4000000);
        caps.kind = row.panel.serial_bus;
        FakePanelBus bus(row.panel, caps);
        PanelStorage<PanelSizes{.height = 320, .buffers = 2}> storage;
        PanelDisplay display(bus, config, storage.memory());
        ASSERT_TRUE(display.init().ok()) << row.panel.name;
        ASSERT_TRUE(display.present().ok() && display.finish().ok()); // the first frame is sent whole
        bus.log.clear();
        const auto frame = display.acquire();
        const int top = &row.panel == &panels::ssd0303_96x16 ? 8 : 16;
        for (int y = top; y < top + 8; ++y)
            frame.value().extents->rows[y] = {16, 24};
        ASSERT_TRUE(display.present().ok());
        ASSERT_TRUE(display.finish().ok());
        EXPECT_EQ(bus.log, row.window) << row.panel.name;
        const bool low = row.panel.commands->parameters_are_commands;
        EXPECT_EQ(bus.last_list.front().parameters_are_commands, low) << row.panel.name;
    }
}

TEST(Init, OledsAreSetUpByTheirCommandSet) {
    const struct {
        const PanelDesc& panel;
        Wire wire;
        Orientation orientation;
        const char* settings;
    } table[] = {
        {panels::ssd1306_128x64, wires::mono, {}, "A1 C8 20 00 A6 21 00 7f 22 00 07 rep1024 AF "},
        {panels::ssd1306_128x64,
         wires::mono,
         {Rotation::r90, true},
         "A0 C0 20 01 A6 21 00 7f 22 00 07 rep1024 AF "},
        {panels::ssd1306_128x32,
         wires::mono,
         {Rotation::r180},
         "A0 C0 20 00 A6 21 00 7f 22 00 03 rep512 AF "},
        {panels::ssd0323_128x64, wires::grey4, {}, "A0 52 A4 15 00 3f 75 00 3f rep4096 AF "},
        {panels::ssd1351_128x128, Wire{}, {}, "A0 74 A6 15 00 7f 75 00 7f 5C rep16384 AF "},
        {panels::ssd1351_128x128, wires::rgb332, {}, "A0 34 A6 15 00 7f 75 00 7f 5C rep16384 AF "},
        {panels::ssd1331_96x64, Wire{}, {}, "A0 72 A4 15 00 5f 75 00 3f rep6144 AF "},
        {panels::ssd1331_96x64, Wire{}, {Rotation::r90}, "A0 71 A4 15 00 5f 75 00 3f rep6144 AF "},
    };
    for (const auto& row : table) {
        PanelConfig config = on(row.panel, row.orientation);
        config.wire = row.wire;
        FakePanelBus bus(row.panel, spi(4000000));
        PanelStorage<PanelSizes{.height = 320, .buffers = 2}> storage;
        PanelDisplay display(bus, config, storage.memory());
        ASSERT_TRUE(display.init().ok()) << row.panel.name;
        const std::string end = row.settings;
        ASSERT_GT(bus.log.size(), end.size());
        EXPECT_EQ(bus.log.substr(bus.log.size() - end.size()), end) << row.panel.name;
    }
}

TEST(Init, EveryNamedBoardComesUp) {
    for (const Board* board : boards::all) {
        const Extent size = place(*board->display.panel, board->display.orientation).size;
        PanelConfig config = board->display;
        config.read_back = false;
        FakePanelBus bus(*config.panel, bus_caps(*board));
        PanelStorage<PanelSizes{.height = 320, .buffers = 2}> storage;
        PanelDisplay display(bus, config, storage.memory());
        EXPECT_TRUE(display.init().ok()) << board->name;
        EXPECT_EQ(display.info().width, size.width);
        EXPECT_EQ(display.info().height, size.height);
    }
}

TEST(Init, ABoardDisplayBringsItsMemory) {
    FakePanelBus bus(panels::st7789_135x240, bus_caps(boards::st7789_135x240));
    BoardDisplay<boards::st7789_135x240> display(bus);
    ASSERT_TRUE(display.init().ok());
    EXPECT_EQ(display.info().width, 240);
    EXPECT_EQ(display.info().height, 135);
    EXPECT_TRUE(display.acquire().ok());
}
