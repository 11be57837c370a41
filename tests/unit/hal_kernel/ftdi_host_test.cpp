// Runs Spangle's bus for FTDI adapters on the real libftdi, libusb, usbfs and usbcore, against the modelled
// adapter and panel.
#include <chrono>
#include <cstring>
#include <mutex>
#include <optional>

#include "host_sim/usb/usbip.hpp"
#include "tests/unit/hal_kernel/files.hpp"
#include "tests/unit/hal_usb/ftdi_rig.hpp"

namespace {

using namespace kernel_test;
using namespace spangle;
using hal::Fault;

struct FtdiHost {
    sim::Kernel clock; ///< the machine's clock, for the adapter and the panel
    sim::FtdiAdapter adapter{clock};
    sim::PanelModule module{test::tiny_panel, ftdi_test::wiring_of({}), adapter.engine, clock};
    sim::UsbipDevice usb{adapter};
    hal::FtdiConfig config;
    std::optional<hal::FtdiBus> bus;
    hal::PanelStorage<hal::PanelSizes{.height = 320, .buffers = 2}> storage;
    std::optional<test::OwnedDisplay> display;

    FtdiHost() {
        usb.fate = [this](std::size_t) {
            catch_up();
            return sim::UsbFate::normal;
        };
        config.write_hz = 15000000;
        config.read_hz = 6000000;
    }

    static bool there() { return exists("/sys/bus/usb/devices/2-1:1.0"); }
    void plug() {
        ASSERT_TRUE(usb.plug()) << std::strerror(errno);
        await("find the adapter", there);
    }
    void pull() {
        usb.unplug();
        await("let go of the adapter", [] { return !exists("/sys/bus/usb/devices/2-1"); });
    }
    void start() {
        ASSERT_NO_FATAL_FAILURE(plug());
        bus.emplace(config);
        ASSERT_NO_FATAL_FAILURE(open());
        hal::PanelConfig panel;
        panel.panel = &test::tiny_panel;
        panel.read_back = true; // init() reads the panel's identity through the whole stack
        display.emplace(*bus, panel, storage.memory());
        const auto ready = display->init();
        ASSERT_TRUE(ready.ok()) << ready.error().rule;
    }
    void open() {
        const auto opened = bus->open();
        ASSERT_TRUE(opened.ok()) << opened.error().rule;
    }
    hal::Result<void> show() {
        const auto presented = display->present();
        return presented ? display->finish() : presented;
    }
    std::string glass_difference() {
        const std::lock_guard lock(usb);
        return test::glass_difference(*display, module.glass({})) + module.violations_text() +
               adapter.violations();
    }

  private:
    void catch_up() {
        const auto now = static_cast<sim::Time>(
            std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count());
        if (now > clock.now())
            clock.advance(now - clock.now());
    }
};

TEST(KernelFtdiHost, FramesArriveToTheBit) {
    FtdiHost host;
    ASSERT_NO_FATAL_FAILURE(host.start());
    for (unsigned seed = 1; seed < 5; ++seed) {
        ASSERT_TRUE(test::draw_pattern(*host.display, seed, {static_cast<std::int32_t>(seed), 2, 17, 11}));
        const auto sent = host.show();
        ASSERT_TRUE(sent.ok()) << sent.error().rule;
        EXPECT_EQ(host.glass_difference(), "");
    }
}

TEST(KernelFtdiHost, PulledAndPluggedAgain) {
    FtdiHost host;
    ASSERT_NO_FATAL_FAILURE(host.start());
    host.pull();
    ASSERT_TRUE(test::draw_pattern(*host.display, 7));
    EXPECT_EQ(host.show().error().fault, Fault::gone);
    EXPECT_EQ(host.bus->open().error().fault, Fault::gone) << "nothing is plugged in";
    host.adapter.power_cycle();
    host.module.power_cycle();
    ASSERT_NO_FATAL_FAILURE(host.plug());
    ASSERT_NO_FATAL_FAILURE(host.open());
    ASSERT_TRUE(host.display->init().ok());
    const auto sent = host.show();
    ASSERT_TRUE(sent.ok()) << sent.error().rule;
    EXPECT_EQ(host.glass_difference(), "");
}

} // namespace
