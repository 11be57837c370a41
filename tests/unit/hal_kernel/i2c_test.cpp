// Runs an OLED over the kernel's real i2c-dev: a bus of two lines, whose levels the trace tells.
#include <optional>

#include <gtest/gtest.h>
#include <spangle/boards/ssd1306_i2c.hpp>
#include <spangle/linux/i2c_bus.hpp>

#include "host_sim/board/module.hpp"
#include "host_sim/bus/i2c_pins.hpp"
#include "tests/unit/hal_kernel/line_trace.hpp"
#include "tests/unit/hal_linux/oled_picture.hpp"

namespace {

using namespace kernel_test;
using namespace spangle;

constexpr unsigned sda = 2, scl = 3, address = 0x3C;

struct KernelI2c : testing::Test {
    SimChip chip{SimChip::header_label, 54};
    LineTrace trace{chip, {sda}};
    std::unique_ptr<sim::Controller> oled =
        sim::make_controller(hal::panels::ssd1306_128x64, hal::BusKind::i2c);
    sim::I2cTarget target{*oled};
    sim::I2cPins pins{target, address};
    sim::PinHeader header{[this](std::uint64_t levels, sim::Time at) {
                              pins.set((levels >> scl & 1) != 0, (levels >> sda & 1) != 0, at);
                              now = at;
                          },
                          nullptr};
    std::uint64_t levels = ~std::uint64_t{0};
    sim::Time now = 0;
    hal::I2cConfig config = hal::i2c_config(boards::ssd1306_i2c, "/dev/i2c-1", address);
    std::optional<hal::I2cBus> bus;
    std::optional<hal::BoardDisplay<boards::ssd1306_i2c>> display;

    void start() {
        bus.emplace(config);
        const auto opened = bus->open();
        ASSERT_TRUE(opened.ok()) << opened.error().rule;
        display.emplace(*bus);
        const auto ready = display->init();
        ASSERT_TRUE(ready.ok()) << ready.error().rule;
    }
    void show() {
        const auto sent = display->present();
        ASSERT_TRUE(sent.ok()) << sent.error().rule;
        const auto arrived = display->finish();
        ASSERT_TRUE(arrived.ok()) << arrived.error().rule;
    }
    void expect_shown() {
        replay(trace.take(), header, levels);
        EXPECT_EQ(linux_test::dots_difference(*display, *oled, now), "");
        EXPECT_EQ(oled->violations_text(), "");
        EXPECT_EQ(pins.stray_messages(), 0u);
    }
};

TEST_F(KernelI2c, FramesArriveToTheBit) {
    ASSERT_NO_FATAL_FAILURE(start());
    ASSERT_TRUE(linux_test::draw_dots(*display, 1, {0, 0, 128, 64}));
    ASSERT_NO_FATAL_FAILURE(show());
    expect_shown();
    ASSERT_TRUE(linux_test::draw_dots(*display, 2, {17, 9, 40, 30}));
    ASSERT_NO_FATAL_FAILURE(show());
    expect_shown();
}

TEST_F(KernelI2c, ShortMessagesCarryTheSame) {
    config.message_bytes = 32;
    ASSERT_NO_FATAL_FAILURE(start());
    ASSERT_TRUE(linux_test::draw_dots(*display, 3, {0, 0, 128, 64}));
    ASSERT_NO_FATAL_FAILURE(show());
    expect_shown();
}

TEST_F(KernelI2c, AnotherAddressIsNotItsOwn) {
    config.address = 0x3D;
    ASSERT_NO_FATAL_FAILURE(start());
    replay(trace.take(), header, levels);
    EXPECT_GT(pins.stray_messages(), 0u);
}

} // namespace
