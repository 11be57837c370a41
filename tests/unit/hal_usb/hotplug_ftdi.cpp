// Finds an FTDI adapter through the real libusb and libudev, sets it up with the real libftdi1, and drives a
// panel at its pins. Tests how the adapter comes and goes (layer C).
#include <chrono>

#include "tests/unit/hal_usb/ftdi_rig.hpp"
#include "tests/unit/hal_usb/plugged_in.hpp"

namespace {

using namespace ftdi_test;
using hal::Fault;
using umockdev_test::PluggedIn;

/// Moves the adapter's clock with the machine's, because the host really sleeps here.
class InRealTime final : public sim::UsbFunction {
  public:
    explicit InRealTime(Rig& rig) : rig_(rig) {}
    std::vector<std::uint8_t> descriptors() const override { return rig_.adapter.descriptors(); }
    bool control(const sim::UsbSetup& setup, const std::uint8_t* out,
                 std::vector<std::uint8_t>& in) override {
        return catch_up(), rig_.adapter.control(setup, out, in);
    }
    bool bulk_out(std::uint8_t endpoint, const std::uint8_t* bytes, std::size_t count) override {
        return catch_up(), rig_.adapter.bulk_out(endpoint, bytes, count);
    }
    bool bulk_in(std::uint8_t endpoint, std::size_t most, std::vector<std::uint8_t>& in) override {
        return catch_up(), rig_.adapter.bulk_in(endpoint, most, in);
    }
    void clear_halt() override {}

  private:
    using Clock = std::chrono::steady_clock;
    Rig& rig_;
    Clock::time_point last_ = Clock::now();

    void catch_up() {
        const auto now = Clock::now();
        rig_.kernel.advance(static_cast<sim::Time>(std::chrono::nanoseconds(now - last_).count()));
        last_ = now;
    }
};

struct FtdiHotplug : testing::Test {
    UMockdevTestbed* bed = umockdev_testbed_new();
    Rig rig;
    InRealTime adapter{rig};

    ~FtdiHotplug() override { g_object_unref(bed); }
    /// Makes a bus on whichever adapter there is.
    void make_bus() {
        rig.config.device_file = nullptr;
        rig.bus.emplace(rig.config);
        rig.make_display();
    }
    /// Closes the display and the bus before the adapter goes.
    void close() {
        rig.display.reset();
        rig.bus.reset();
    }
    void expect_frame(unsigned seed) {
        ASSERT_TRUE(rig.draw(seed));
        const auto sent = rig.display->present();
        ASSERT_TRUE(sent.ok()) << sent.error().rule;
        EXPECT_EQ(rig.glass_difference(), "");
    }
};

TEST_F(FtdiHotplug, FindsTheAdapterAndDraws) {
    PluggedIn plugged(bed, adapter, 1);
    make_bus();
    const auto opened = rig.bus->open();
    ASSERT_TRUE(opened.ok()) << opened.error().rule;
    EXPECT_EQ(rig.adapter.latency_ms(), 1u);
    ASSERT_TRUE(rig.display->init().ok());
    expect_frame(1);
    close();
}

TEST_F(FtdiHotplug, TheChannelThatWasAskedFor) {
    rig.adapter.two_channels = true;
    rig.adapter.channel = 1;
    rig.config.channel = 1;
    PluggedIn plugged(bed, adapter, 1);
    make_bus();
    ASSERT_TRUE(rig.bus->open().ok());
    ASSERT_TRUE(rig.display->init().ok());
    expect_frame(2);
    close();
}

TEST_F(FtdiHotplug, PulledAndPluggedAgain) {
    make_bus();
    const auto none = rig.bus->open();
    EXPECT_EQ(none.error().fault, Fault::gone);
    EXPECT_STREQ(none.error().rule, "FTDI adapter: open: none is plugged in; lsusb lists what is");
    {
        PluggedIn plugged(bed, adapter, 1);
        ASSERT_TRUE(rig.bus->open().ok());
        ASSERT_TRUE(rig.display->init().ok());
        expect_frame(3);
        plugged.pull();
        ASSERT_TRUE(rig.draw(4));
        EXPECT_EQ(rig.display->present().error().fault, Fault::gone);
    }
    EXPECT_EQ(rig.bus->open().error().fault, Fault::gone);
    rig.adapter.power_cycle();
    rig.module.power_cycle();
    PluggedIn again(bed, adapter, 2); // the bus gives it another number
    ASSERT_TRUE(rig.bus->open().ok());
    ASSERT_TRUE(rig.display->init().ok());
    ASSERT_TRUE(rig.display->present().ok()); // sends the whole picture, though nothing is new
    EXPECT_EQ(rig.glass_difference(), "");
    close();
}

} // namespace
