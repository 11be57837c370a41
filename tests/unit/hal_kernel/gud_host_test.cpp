// Runs Spangle's GUD host on the real libusb, usbfs and usbcore, against the modelled device. The kernel's
// own driver has the device first.
#include <chrono>
#include <optional>

#include "tests/unit/hal_kernel/plugged_gud.hpp"
#include "tests/unit/hal_usb/gud_picture.hpp"

namespace {

using namespace kernel_test;
using namespace spangle;
using hal::Fault;
using Fate = sim::UsbFate;

struct GudHost : PluggedGud {
    hal::GudConfig config;
    std::optional<hal::GudDisplay> display;

    void start() {
        ASSERT_NO_FATAL_FAILURE(plug());
        display.emplace(config);
        const auto ready = display->init();
        ASSERT_TRUE(ready.ok()) << ready.error().rule;
    }
    bool draw(unsigned seed, Rect area, bool flat = false) {
        return gud_test::draw_pattern(*display, seed, area, flat);
    }
    bool draw(unsigned seed, bool flat = false) {
        const hal::DisplayInfo info = display->info();
        return draw(seed, {0, 0, info.width, info.height}, flat);
    }
    hal::Result<void> show() { return gud_test::show(*display); }
    std::string glass_difference() {
        const std::lock_guard lock(usb);
        return gud_test::glass_difference(*display, device);
    }
    /// `skip` bulk transfers pass, and the next `times` meet this fate.
    void meet(Fate fate, int skip, int times) {
        const std::lock_guard lock(usb);
        usb.fate = [=](std::size_t) mutable { return skip-- > 0 || times-- <= 0 ? Fate::normal : fate; };
    }
    void expect_mended() {
        meet(Fate::normal, 0, 0);
        const auto again = show();
        ASSERT_TRUE(again.ok()) << again.error().rule;
        EXPECT_EQ(glass_difference(), "");
    }
};

TEST(KernelGudHost, TakesTheDeviceFromTheKernelsDriverAndGivesItBack) {
    GudHost host;
    ASSERT_NO_FATAL_FAILURE(host.start());
    EXPECT_FALSE(exists(gud_card));
    EXPECT_EQ(host.glass_difference(), "");
    for (unsigned seed = 1; seed < 6; ++seed) {
        ASSERT_TRUE(host.draw(
            seed, {static_cast<std::int32_t>(seed * 7), 3, 200, static_cast<std::int32_t>(20 * seed)},
            seed % 2 == 0));
        const auto sent = host.show();
        ASSERT_TRUE(sent.ok()) << sent.error().rule;
        EXPECT_EQ(host.glass_difference(), "");
    }
    EXPECT_GT(host.device.counters().compressed, 0u);
    host.display.reset();
    await("take its device back", [] { return exists(gud_card); });
}

TEST(KernelGudHost, EveryFormat) {
    for (const std::uint8_t format :
         std::initializer_list<std::uint8_t>{0x01, 0x08, 0x20, 0x30, 0x40, 0x50, 0x80}) {
        SCOPED_TRACE(int{format});
        GudHost host;
        host.device.formats = {format};
        ASSERT_NO_FATAL_FAILURE(host.start());
        ASSERT_TRUE(host.draw(format));
        const auto sent = host.show();
        ASSERT_TRUE(sent.ok()) << sent.error().rule;
        EXPECT_EQ(host.glass_difference(), "");
    }
}

TEST(KernelGudHost, SmallBuffersStatusAfterSetAndFullUpdates) {
    for (const bool full : {false, true}) {
        GudHost host;
        host.device.status_on_set = true;
        host.device.full_update = full;
        host.device.lz4 = !full; // the kernel's driver refuses a device with both
        host.device.max_buffer_size = full ? 0 : 5000;
        ASSERT_NO_FATAL_FAILURE(host.start());
        ASSERT_TRUE(host.draw(9, {11, 7, 120, 90}));
        const auto sent = host.show();
        ASSERT_TRUE(sent.ok()) << sent.error().rule;
        EXPECT_EQ(host.glass_difference(), "");
        if (!full) {
            EXPECT_LE(host.device.counters().largest_buffer, 5000u);
        }
    }
}

TEST(KernelGudHost, AStallIsClearedAndTheBufferSentAgain) {
    GudHost host;
    ASSERT_NO_FATAL_FAILURE(host.start());
    for (const int skip : {0, 1, 3}) {
        ASSERT_TRUE(host.draw(1 + static_cast<unsigned>(skip)));
        host.meet(Fate::stall, skip, 1);
        const auto sent = host.show();
        EXPECT_TRUE(sent.ok()) << sent.error().rule;
        EXPECT_EQ(host.glass_difference(), "");
    }
    ASSERT_TRUE(host.draw(7));
    host.meet(Fate::stall, 0, 1000);
    EXPECT_EQ(host.show().error().fault, Fault::unsupported);
    host.expect_mended();
}

TEST(KernelGudHost, ASilentDeviceTimesOut) {
    GudHost host;
    host.config.bulk_timeout_ms = 150;
    ASSERT_NO_FATAL_FAILURE(host.start());
    ASSERT_TRUE(host.draw(1));
    host.meet(Fate::silent, 1, 1000);
    const auto start = std::chrono::steady_clock::now();
    const auto late = host.show();
    EXPECT_EQ(late.error().fault, Fault::timeout) << late.error().rule;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    host.expect_mended();
}

TEST(KernelGudHost, WhatIsCutOrGarbledIsSentAgain) {
    for (const Fate fate : {Fate::cut, Fate::error}) {
        GudHost host;
        ASSERT_NO_FATAL_FAILURE(host.start());
        ASSERT_TRUE(host.draw(1));
        host.meet(fate, 0, 1000);
        const auto failed = host.show();
        EXPECT_EQ(failed.error().fault, fate == Fate::cut ? Fault::short_write : Fault::gone)
            << failed.error().rule;
        host.expect_mended();
    }
}

TEST(KernelGudHost, PulledInTheMiddleAndPluggedAgain) {
    for (const int skip : {0, 2}) {
        GudHost host;
        ASSERT_NO_FATAL_FAILURE(host.start());
        ASSERT_TRUE(host.draw(1));
        ASSERT_TRUE(host.show().ok());
        ASSERT_TRUE(host.draw(2, {5, 5, 300, 200}));
        host.meet(Fate::unplug, skip, 1000);
        const auto gone = host.show();
        EXPECT_EQ(gone.error().fault, Fault::gone) << gone.error().rule;
        EXPECT_FALSE(host.display->connected());
        host.pull();
        EXPECT_EQ(host.show().error().fault, Fault::gone);
        host.device.power_cycle();
        host.meet(Fate::normal, 0, 0);
        ASSERT_NO_FATAL_FAILURE(host.plug());
        host.expect_mended(); // without init(), the first present that finds the device sends everything
        EXPECT_TRUE(host.display->connected());
    }
}

TEST(KernelGudHost, PulledWhileNothingIsUnderWay) {
    GudHost host;
    ASSERT_NO_FATAL_FAILURE(host.start());
    host.pull();
    ASSERT_TRUE(host.draw(4));
    EXPECT_EQ(host.show().error().fault, Fault::gone);
}

} // namespace
