// A modelled Linux machine with an FTDI adapter, a display module at the adapter's pins, and the Spangle bus
// that drives it.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <spangle/hal/panel_display.hpp>
#include <spangle/panels.hpp>
#include <spangle/usb/ftdi_bus.hpp>

#include "host_sim/linux/panel_module.hpp"
#include "host_sim/usb/ftdi_adapter.hpp"
#include "host_sim/usb/usbfs.hpp"
#include "tests/support/panel_pattern.hpp"

namespace ftdi_test {

using namespace spangle;

inline constexpr char path[] = "/dev/bus/usb/001/003";

struct RigOptions {
    const hal::PanelDesc* panel = &test::tiny_panel;
    hal::Orientation orientation = {};
    std::uint32_t write_hz = 15000000, read_hz = 6000000;
    std::uint8_t buffers = 1;
    bool asynchronous = false, wait_te = false, read_back = false;
    hal::FtdiPins pins = {};
};

/// Returns the wiring of a panel at these pins.
inline sim::ModuleWiring wiring_of(const hal::FtdiPins& pins) {
    const auto line = [](std::uint8_t pin) {
        return pin == hal::FtdiPins::none ? sim::ModuleWiring::open : unsigned{pin};
    };
    sim::ModuleWiring w;
    w.clock = sim::MpsseEngine::clock_pin;
    w.data[0] = sim::MpsseEngine::out_pin;
    w.answer = sim::MpsseEngine::in_pin;
    w.select = line(pins.select);
    w.data_command = line(pins.data_command);
    w.reset = line(pins.reset);
    w.backlight = line(pins.backlight);
    w.te = pins.te ? sim::MpsseEngine::wait_pin : sim::ModuleWiring::open;
    return w;
}

class Rig {
  public:
    explicit Rig(const RigOptions& options = {})
        : module(*options.panel, wiring_of(pins_of(options)), adapter.engine, kernel), options_(options) {
        config.device_file = path;
        config.write_hz = options.write_hz;
        config.read_hz = options.read_hz;
        config.pins = pins_of(options);
        config.asynchronous = options.asynchronous;
    }
    Rig(const Rig&) = delete;
    Rig& operator=(const Rig&) = delete;
    ~Rig() {
        display.reset();
        bus.reset();
        EXPECT_EQ(kernel.open_files(), 0) << "files were left open";
        kernel.forget_all();
    }

    sim::Kernel& kernel = sim::Kernel::instance();
    sim::FtdiAdapter adapter{kernel};
    sim::UsbfsDevice usb{adapter};
    sim::PanelModule module;
    hal::FtdiConfig config;
    std::optional<hal::FtdiBus> bus;
    std::optional<test::OwnedDisplay> display;

    /// Plugs the adapter in, and opens the bus.
    hal::Result<void> open() {
        if (!bus) {
            usb.attach(kernel, path);
            bus.emplace(config);
        }
        return bus->open();
    }
    hal::Result<void> start() {
        if (const auto opened = open(); !opened)
            return opened;
        make_display();
        return display->init();
    }
    void make_display() {
        hal::PanelConfig panel;
        panel.panel = options_.panel;
        panel.orientation = options_.orientation;
        panel.buffers = options_.buffers;
        panel.read_back = options_.read_back;
        panel.wait_te = options_.wait_te;
        display.emplace(*bus, panel, storage_.memory());
    }
    /// Plugs the adapter in again; adapter and panel have lost their state.
    void plug_in_again() {
        adapter.power_cycle();
        module.power_cycle();
        usb.plug();
    }

    bool draw(unsigned seed, Rect area) { return test::draw_pattern(*display, seed, area); }
    bool draw(unsigned seed) { return test::draw_pattern(*display, seed); }
    /// Returns an empty text if the glass shows the frame and no rule was broken, else what is wrong.
    std::string glass_difference() {
        const std::string wrong = test::glass_difference(*display, module.glass(options_.orientation));
        return wrong + module.violations_text() + adapter.violations();
    }

  private:
    RigOptions options_;
    hal::PanelStorage<hal::PanelSizes{.height = 320, .buffers = 2}> storage_;

    static hal::FtdiPins pins_of(const RigOptions& options) {
        hal::FtdiPins pins = options.pins;
        pins.te = options.wait_te;
        return pins;
    }
};

} // namespace ftdi_test
