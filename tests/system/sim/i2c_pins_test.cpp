// Tests an I2C target at its two lines: START, bits, addresses, and bytes that are lost.
#include <cstdio>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <spangle/boards/boards.hpp>
#include <unistd.h>

#include "host_sim/board/module.hpp"
#include "host_sim/bus/i2c_pins.hpp"
#include "host_sim/bus/sim_bus.hpp"
#include "tests/support/panel_pattern.hpp"

namespace {

using namespace spangle;
using namespace spangle::sim;

/// A controller that logs what reaches it.
struct Heard final : Controller {
    Heard() : Controller("I2C", {}) {}
    std::string text;
    unsigned period = 0;

    void reset(bool, Time) override {}
    void select(bool selected, Time) override { text += selected ? "[" : "]"; }
    void write(std::uint8_t byte, bool data, Time, unsigned period_ns) override {
        text += (data ? "d" : "c") + hex_text(byte) + " ";
        period = period_ns;
    }
    std::vector<Rgb666> glass(Time) override { return {}; }
    std::vector<Rgb666> cells() const override { return {}; }
    MemorySize memory_size() const override { return {}; }
    Time line_time() const override { return 1; }
    Time refresh_time() const override { return 0; }
};

struct I2cLines : testing::Test {
    Heard heard;
    I2cTarget target{heard};
    I2cPins pins{target, 0x3C};
    Time now = 1000;
    bool scl = true, sda = true;

    void drive(bool clock, bool data) {
        scl = clock, sda = data;
        pins.set(scl, sda, now += 1250);
    }
    void start() {
        drive(scl, true);
        drive(true, true);
        drive(true, false);
        drive(false, false);
    }
    void bit(bool level) {
        drive(false, level);
        drive(true, level);
        drive(true, level);
        drive(false, level);
    }
    void byte(unsigned value) {
        for (unsigned i = 8; i-- != 0;)
            bit((value >> i & 1) != 0);
        bit(false); // the target acknowledges
    }
    void stop() {
        drive(false, false);
        drive(true, false);
        drive(true, true);
    }
};

TEST_F(I2cLines, AMessageIsAddressedAndEnds) {
    start();
    byte(0x78);
    byte(0x40);
    byte(0xA5);
    byte(0x5A);
    stop();
    start();
    byte(0x78);
    byte(0x00);
    byte(0xAE);
    stop();
    EXPECT_EQ(heard.text, "[dA5h d5Ah ][cAEh ]");
    EXPECT_EQ(heard.period, 5000u);
    EXPECT_EQ(pins.stray_messages(), 0u);
}

TEST_F(I2cLines, ARepeatedStartEndsTheMessageBefore) {
    start();
    byte(0x78);
    byte(0x00);
    byte(0xAE);
    start();
    byte(0x78);
    byte(0x40);
    byte(0x01);
    stop();
    EXPECT_EQ(heard.text, "[cAEh ][d01h ]");
    EXPECT_EQ(pins.stray_messages(), 0u);
}

TEST_F(I2cLines, OtherAddressesAndReadsAreNotItsOwn) {
    for (const unsigned first : {0x7Au, 0x79u}) {
        start();
        byte(first);
        byte(0x00);
        byte(0xAE);
        stop();
    }
    EXPECT_EQ(heard.text, "");
    EXPECT_EQ(pins.stray_messages(), 2u);
}

TEST_F(I2cLines, AByteThatIsCutShortIsAStray) {
    start();
    byte(0x78);
    byte(0x40);
    bit(true);
    bit(false);
    bit(true);
    stop();
    EXPECT_EQ(heard.text, "[]");
    EXPECT_EQ(pins.stray_messages(), 1u);
}

/// A dump of SCL and SDA holds the messages of an I2C target: replayed edge by edge it fills another
/// controller with the same picture.
TEST(I2cDump, Replays) {
    const std::string path = testing::TempDir() + "i2c-" + std::to_string(getpid()) + ".vcd";
    for (const hal::Board* board : {&boards::ssd1306_i2c, &boards::ssd1327_i2c, &boards::sh1106_i2c}) {
        const auto sent = make_controller(*board->display.panel, board->bus),
                   again = make_controller(*board->display.panel, board->bus);
        SimBus bus(*sent, hal::bus_caps(*board));
        {
            VcdFile vcd(path, board->bus);
            bus.listen(&vcd);
            hal::PanelStorage<hal::PanelSizes{.height = 128, .ops = 2048}> storage;
            struct Panel final : hal::PanelDisplay {
                using hal::PanelDisplay::PanelDisplay;
            } display(bus, board->display, storage.memory());
            ASSERT_TRUE(display.init().ok());
            ASSERT_TRUE(test::draw_pattern(display, 7));
            ASSERT_TRUE(display.present().ok());
            ASSERT_EQ(vcd.commit(), "");
        }
        I2cTarget target(*again);
        I2cPins pins(target, 0x3C);
        std::ifstream file(path);
        std::string line;
        Time now = 0;
        bool scl = true, sda = true;
        int starts = 0, stops = 0; // the line falls or rises while the clock is high
        while (std::getline(file, line)) {
            if (line[0] == '#')
                now = std::stoull(line.substr(1));
            else if (line == "0k" || line == "1k" || line == "0s" || line == "1s") {
                if (line[1] == 's' && scl && now != 0)
                    ++(line[0] == '0' ? starts : stops);
                (line[1] == 'k' ? scl : sda) = line[0] == '1';
                pins.set(scl, sda, now);
            } else if (line == "0r" || line == "1r")
                again->reset(line[0] == '0', now);
        }
        EXPECT_GT(starts, 2) << board->name;
        EXPECT_EQ(stops, starts) << board->name << ": each message ends";
        EXPECT_EQ(pins.stray_messages(), 0u) << board->name;
        EXPECT_EQ(again->violations_text(), "") << board->name;
        EXPECT_EQ(again->cells(), sent->cells()) << board->name;
    }
    std::remove(path.c_str());
}

} // namespace
