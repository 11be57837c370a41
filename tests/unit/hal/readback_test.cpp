// Tests reads: commands, dummy clocks, byte order, and the window after a read.
#include <gtest/gtest.h>

#include "tests/unit/hal/fake_panel_bus.hpp"
#include <spangle/hal.hpp>

using namespace hal_test;

namespace {

BusCaps parallel() {
    BusCaps caps;
    caps.write_hz = 15000000;
    caps.read_hz = 2000000;
    caps.bits_per_cycle = 8;
    return caps;
}

struct Reader {
    FakePanelBus bus;
    PanelStorage<PanelSizes{.height = 320}> storage;
    PanelDisplay display;

    Reader(const PanelDesc& panel, BusCaps caps)
        : bus(panel, caps), display(bus, config(panel), storage.memory()) {
        EXPECT_TRUE(display.init().ok());
        bus.log.clear();
    }
    static PanelConfig config(const PanelDesc& panel) {
        PanelConfig c;
        c.panel = &panel;
        return c;
    }
};

} // namespace

TEST(Readback, StatusOverSerialHasOneDummyClockForLongRegisters) {
    Reader reader(panels::st7789_240x240, spi());
    const auto status = reader.display.status();
    ASSERT_TRUE(status.ok());
    EXPECT_EQ(reader.bus.log, "r04/1 r09/1 r0A/0 r0B/0 r0C/0 r0D/0 r0E/0 r0F/0 ");
    EXPECT_EQ(status.value().id, 0x858552u);
    EXPECT_EQ(status.value().status, 0x00610000u);
    EXPECT_EQ(status.value().power_mode, 0x9C);
    EXPECT_EQ(status.value().madctl, 0x00);
}

TEST(Readback, StatusOverParallelHasADummyByteAlways) {
    Reader reader(panels::st7789_240x240, parallel());
    ASSERT_TRUE(reader.display.status().ok());
    EXPECT_EQ(reader.bus.log, "r04/8 r09/8 r0A/8 r0B/8 r0C/8 r0D/8 r0E/8 r0F/8 ");
}

TEST(Readback, ScanlineIsBigEndian) {
    Reader reader(panels::ili9341_240x320, spi());
    const auto line = reader.display.scanline();
    ASSERT_TRUE(line.ok());
    EXPECT_EQ(line.value(), 0x0123);
    EXPECT_EQ(reader.bus.log, "r45/1 ");
}

TEST(Readback, PixelsComeFromTheirWindowAfterThePanelsDummyBits) {
    struct {
        const PanelDesc* panel;
        const char* log;
    } const cases[] = {
        {&panels::ili9341_240x320, "2A 00 03 00 07 2B 00 04 00 05 r2E/8 "},
        {&panels::st7789_135x240, "2A 00 37 00 3b 2B 00 2c 00 2d r2E/16 "},
        {&panels::st7735_128x160_green, "2A 00 05 00 09 2B 00 05 00 06 r2E/9 "},
    };
    for (const auto& k : cases) {
        Reader reader(*k.panel, spi());
        std::uint8_t rgb[5 * 2 * 3 + 1];
        rgb[30] = 0x5A;
        ASSERT_TRUE(reader.display.read_back({3, 4, 5, 2}, rgb).ok());
        EXPECT_EQ(reader.bus.log, k.log);
        EXPECT_EQ(rgb[29], 29);
        EXPECT_EQ(rgb[30], 0x5A);
        reader.bus.log.clear();
        ASSERT_TRUE(reader.display.present().ok());
        EXPECT_EQ(reader.bus.log.substr(0, 3), "2A ") << "the window moved: it must be sent again";
    }
}

TEST(Readback, OutsideThePictureIsRefused) {
    Reader reader(panels::st7789_240x240, spi());
    std::uint8_t rgb[3];
    for (const Rect& r : {Rect{-1, 0, 1, 1}, Rect{0, -1, 1, 1}, Rect{240, 0, 1, 1}, Rect{0, 240, 1, 1},
                          Rect{0, 0, 0, 1}, Rect{0, 0, 1, -4}, Rect{1, 0, 240, 1}, Rect{0, 1, 1, 240},
                          Rect{1, 0, INT32_MAX, 1}, Rect{INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX}})
        EXPECT_EQ(reader.display.read_back(r, rgb).error().fault, Fault::bad_argument);
    EXPECT_EQ(reader.bus.log, "");
}

TEST(Readback, WithoutAReadClockOrALineThatAnswersItIsUnsupported) {
    BusCaps caps = spi();
    caps.read_hz = 0;
    Reader reader(panels::st7789_240x240, caps);
    EXPECT_EQ(reader.display.status().error().fault, Fault::unsupported);
    EXPECT_EQ(reader.display.scanline().error().fault, Fault::unsupported);
    PanelDesc mute = panels::st7789_240x240;
    mute.quirks.no_read_back = true;
    Reader other(mute, spi());
    EXPECT_STREQ(other.display.status().error().rule, "panel: the controller never drives its data line");
}

TEST(Readback, FaultsComeBackAsValues) {
    Reader reader(panels::st7789_240x240, spi());
    reader.bus.refuse_submits = 1;
    EXPECT_EQ(reader.display.status().error().fault, Fault::busy);
    reader.bus.late_waits = 1;
    EXPECT_EQ(reader.display.scanline().error().fault, Fault::timeout);
    EXPECT_TRUE(reader.display.scanline().ok());
}

TEST(OpList, ALongerListThanItsStorageIsRefusedWhole) {
    FakePanelBus bus(panels::st7789_240x240, spi());
    Op ops[2];
    OpParams params[2];
    OpList list(ops, params, 2);
    list.command_byte(0x36, 0x48);
    list.command_pair(0x2A, 0x0102, 0x0304);
    EXPECT_TRUE(list.submit(bus).ok());
    EXPECT_EQ(params[1].bytes[0], 1);
    EXPECT_EQ(params[1].bytes[3], 4);
    list.command_byte(0x3A, 0x55);
    list.delay(5);
    EXPECT_EQ(list.size(), 2u);
    EXPECT_EQ(list.submit(bus).error().fault, Fault::bad_argument);
    EXPECT_EQ(bus.submits, 1);
    list.clear();
    list.delay(5);
    EXPECT_TRUE(list.submit(bus).ok());
}

TEST(OpList, DurationIsWhatTheWireTakes) {
    BusCaps caps = spi(8000000); // a byte takes one microsecond
    caps.read_hz = 1000000;
    caps.command_cost_ns = 3000;
    Op ops[8];
    OpParams params[8];
    OpList list(ops, params, 8);
    std::uint8_t bytes[4] = {};
    list.pixels(bytes, 100, 7, 200);
    EXPECT_EQ(list.duration(caps), 700u);
    list.repeat_black(2, 1000);
    EXPECT_EQ(list.duration(caps), 2700u);
    list.delay(120000);
    list.reset(10);
    list.wait_te(40);
    EXPECT_EQ(list.duration(caps), 122750u);
    list.command_pair(0x2A, 0, 1); // takes 3 us of overhead and five bytes
    EXPECT_EQ(list.duration(caps), 122750u + 3 + 5);
    list.read(0x04, 1, bytes, 3); // one byte is sent, then 25 clocks at the read clock
    EXPECT_EQ(list.duration(caps), 122758u + 3 + 1 + 25);
    list.delay(UINT32_MAX);
    EXPECT_EQ(list.duration(caps), UINT32_MAX);
    EXPECT_EQ(wire_time(BusCaps{}, 1), UINT32_MAX);
    caps.bits_per_cycle = 8;
    EXPECT_EQ(wire_time(caps, 8000000), 1000000u);
    EXPECT_EQ(wire_time(caps, UINT64_MAX / 16), UINT32_MAX);
}
