// Tests how a GUD display is found, comes and goes on a whole machine (layer C).
#include <spangle/usb/gud_display.hpp>

#include "host_sim/usb/gud_device.hpp"
#include "tests/unit/hal_usb/plugged_in.hpp"

namespace {

using namespace umockdev_test;
using hal::Fault;

struct Hotplug : testing::Test {
    UMockdevTestbed* bed = umockdev_testbed_new();
    sim::GudDevice device, other;
    hal::GudConfig config;

    Hotplug() {
        device.modes = {{1000, 24, 16, true}};
        device.limits = {24, 24, 16, 16};
        other = device;
        other.vendor = 0x1d6b; // a hub with such an interface by chance
        other.product = 0x0002;
    }
    ~Hotplug() override { g_object_unref(bed); }

    static hal::Result<void> show(hal::GudDisplay& display, std::uint8_t value) {
        const auto frame = display.acquire();
        if (!frame)
            return frame.error();
        std::fill(frame.value().pixels, frame.value().pixels + 24 * 16 * 2, value);
        std::fill(frame.value().extents->rows, frame.value().extents->rows + 16, RowSpan{0, 24});
        const auto presented = display.present();
        return presented ? display.finish() : presented;
    }
    static bool shows(const sim::GudDevice& d, std::uint8_t value) {
        const sim::Image glass = d.glass();
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 24; ++x)
                if (glass.at(x, y)[0] != (value >> 3) * 255 / 31)
                    return false;
        return d.violations().empty();
    }
};

TEST_F(Hotplug, FindsADisplayAmongOtherDevices) {
    for (const auto& [vendor, product] : {std::pair{0x1d50, 0x614d}, {0x16d0, 0x10a9}, {0x1209, 0x4fb3}}) {
        device.vendor = static_cast<std::uint16_t>(vendor);
        device.product = static_cast<std::uint16_t>(product);
        PluggedIn hub(bed, other, 1), plugged(bed, device, 2);
        hal::GudDisplay display;
        const auto ready = display.init();
        ASSERT_TRUE(ready.ok()) << ready.error().rule;
        EXPECT_TRUE(show(display, 0xF0).ok());
        EXPECT_TRUE(shows(device, 0xF0));
        EXPECT_EQ(other.counters().requests, 0u) << "nobody asked the other device anything";
    }
}

TEST_F(Hotplug, TakesTheOneThatWasAskedFor) {
    other.vendor = 0x4242;
    PluggedIn first(bed, device, 1), second(bed, other, 2);
    config.vendor = 0x4242;
    config.product = 0x0002;
    hal::GudDisplay display(config);
    ASSERT_TRUE(display.init().ok());
    EXPECT_TRUE(show(display, 0x88).ok());
    EXPECT_TRUE(shows(other, 0x88));
    EXPECT_EQ(device.counters().requests, 0u);
}

TEST_F(Hotplug, PulledAndPluggedAgain) {
    PluggedIn hub(bed, other, 1);
    hal::GudDisplay display;
    const auto none = display.init();
    EXPECT_EQ(none.error().fault, Fault::gone);
    EXPECT_STREQ(none.error().rule, "USB display: open: none is plugged in; lsusb lists what is");
    {
        PluggedIn plugged(bed, device, 2);
        ASSERT_TRUE(display.init().ok());
        ASSERT_TRUE(show(display, 0x18).ok());
        plugged.pull();
        EXPECT_EQ(show(display, 0x28).error().fault, Fault::gone);
        EXPECT_FALSE(display.connected());
    }
    EXPECT_EQ(show(display, 0x38).error().fault, Fault::gone);
    device.power_cycle();
    PluggedIn again(bed, device, 3); // the bus gives it another number
    ASSERT_TRUE(display.present().ok() && display.finish().ok());
    EXPECT_TRUE(shows(device, 0x38));
    EXPECT_TRUE(display.connected());
}

} // namespace
