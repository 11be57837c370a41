// Modelled Linux machines, each with one display: behind spidev, an I2C adapter, an FTDI adapter, or on USB.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>
#include <spangle/sim/image.hpp>

#include "host_sim/board/module.hpp"
#include "host_sim/linux/gpio_chip.hpp"
#include "host_sim/linux/i2c_adapter.hpp"
#include "host_sim/linux/panel_module.hpp"
#include "host_sim/linux/spi_device.hpp"
#include "host_sim/usb/gud_device.hpp"
#include "host_sim/usb/usbfs.hpp"
#include "tests/unit/hal_usb/ftdi_rig.hpp"

namespace on_machine {

using namespace spangle;

/// A machine and its display while a command runs. At the end its glass is read.
struct Machine {
    sim::Kernel& kernel = sim::Kernel::instance();
    virtual ~Machine() = default;
    virtual sim::Image glass() = 0;
    virtual std::string wrong() = 0; ///< the rules that the bus broke, one a line
};

struct OnSpidev final : Machine {
    sim::GpioChip chip{"pinctrl-bcm2711", 54};
    sim::PanelModule module;
    sim::SpiDevice spi;

    OnSpidev() : module(hal::panels::ili9341_240x320, wiring(), chip, kernel), spi(module.serial()) {
        chip.attach(kernel, 0);
        spi.attach(kernel, "/dev/spidev0.0");
    }
    static sim::ModuleWiring wiring() {
        sim::ModuleWiring w;
        w.reset = 25;
        w.backlight = 18;
        w.te = 17;
        w.data_command = 24;
        return w;
    }
    sim::Image glass() override { return module.glass(boards::ili9341_spi.display.orientation); }
    std::string wrong() override {
        return module.violations_text() + (module.is_backlight_on() ? "" : "no light\n");
    }
};

struct OnI2c final : Machine {
    std::unique_ptr<sim::Controller> oled =
        sim::make_controller(hal::panels::ssd1306_128x64, hal::BusKind::i2c);
    sim::I2cAdapter adapter;

    explicit OnI2c(unsigned address = 0x3C) : adapter(address, oled.get()) {
        adapter.attach(kernel, "/dev/i2c-1");
    }
    sim::Image glass() override {
        kernel.advance(2 * oled->refresh_time());
        return sim::picture_of(oled->glass(kernel.now()), 128, 64);
    }
    std::string wrong() override { return adapter.wrong() + oled->violations_text(); }
};

struct OnFtdi final : Machine {
    sim::FtdiAdapter adapter{kernel};
    sim::UsbfsDevice usb{adapter};
    sim::PanelModule module;

    OnFtdi() : module(hal::panels::ili9341_240x320, ftdi_test::wiring_of({}), adapter.engine, kernel) {
        usb.attach(kernel, ftdi_test::path);
    }
    sim::Image glass() override { return module.glass(boards::ili9341_spi.display.orientation); }
    std::string wrong() override { return module.violations_text(); }
};

/// A GUD display that keeps what it showed before each request, because it goes dark when its program ends.
struct WatchedGud final : sim::UsbFunction {
    sim::GudDevice device;
    sim::Image last;

    std::vector<std::uint8_t> descriptors() const override { return device.descriptors(); }
    bool control(const sim::UsbSetup& setup, const std::uint8_t* out,
                 std::vector<std::uint8_t>& in) override {
        if (device.enabled())
            last = device.glass();
        return device.control(setup, out, in);
    }
    bool bulk_out(std::uint8_t endpoint, const std::uint8_t* bytes, std::size_t count) override {
        return device.bulk_out(endpoint, bytes, count);
    }
    bool bulk_in(std::uint8_t endpoint, std::size_t most, std::vector<std::uint8_t>& in) override {
        return device.bulk_in(endpoint, most, in);
    }
    void clear_halt() override { device.clear_halt(); }
};

struct OnUsb final : Machine {
    static constexpr const char* path = "/dev/bus/usb/001/002";
    WatchedGud watched;
    sim::UsbfsDevice usb{watched};

    OnUsb() { usb.attach(kernel, path); }
    sim::Image glass() override { return watched.last; }
    std::string wrong() override {
        return watched.device.violations() + (watched.device.enabled() ? "left on\n" : "");
    }
};

} // namespace on_machine
