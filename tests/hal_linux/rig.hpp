// A Linux machine with a display module on its GPIO header, and the bus of ours that drives it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include <gtest/gtest.h>
#include <spangle/hal/panel_display.hpp>
#include <spangle/linux/gpio_bus.hpp>
#include <spangle/linux/spidev_bus.hpp>
#include <spangle/panels.hpp>

#include "host_sim/linux/gpio_chip.hpp"
#include "host_sim/linux/panel_module.hpp"
#include "host_sim/linux/spi_device.hpp"
#include "tests/panel_pattern.hpp"

namespace linux_test {

using namespace spangle;

using test::tiny_panel;

inline constexpr char spi_path[] = "/dev/spidev0.0";
inline constexpr char chip_path[] = "/dev/gpiochip0";
inline constexpr char chip_label[] = "pinctrl-bcm2711";

/// The modelled machine. One at a time: there is one kernel.
struct Machine {
    sim::Kernel& kernel = sim::Kernel::instance();
    sim::GpioChip chip{chip_label, 54};

    Machine() { chip.attach(kernel, 0); }
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;
    ~Machine() {
        EXPECT_EQ(kernel.open_files(), 0) << "files were left open";
        kernel.forget_all();
    }

    /// The next `times` calls that `which` picks fail with this errno.
    void fail(int error, int times, std::function<bool(const sim::Call&)> which) {
        kernel.set_judge([=, left = times](const sim::Call& call) mutable {
            const bool hit = left > 0 && which(call);
            left -= hit ? 1 : 0;
            return sim::Verdict{hit ? error : 0};
        });
    }
    void no_faults() { kernel.set_judge(nullptr); }
};

/// Where the module hangs.
enum class Transport {
    spi,
    spi_mode3,
    spi3,
    spi3_packed,
    gpio4,
    gpio3,
    gpio8,
    gpio8_read,
    gpio16,
    gpio16_read
};

inline constexpr Transport every_transport[] = {
    Transport::spi,    Transport::spi_mode3,  Transport::spi3,  Transport::spi3_packed,
    Transport::gpio4,  Transport::gpio3,      Transport::gpio8, Transport::gpio8_read,
    Transport::gpio16, Transport::gpio16_read};

inline bool is_spidev(Transport t) {
    return t <= Transport::spi3_packed;
}
inline bool is_parallel(Transport t) {
    return t >= Transport::gpio8;
}
inline bool can_read(Transport t) {
    return t != Transport::spi3_packed && t != Transport::gpio8 && t != Transport::gpio16;
}

inline const char* name_of(Transport t) {
    constexpr const char* names[] = {"spi",   "spi_mode3", "spi3",       "spi3_packed", "gpio4",
                                     "gpio3", "gpio8",     "gpio8_read", "gpio16",      "gpio16_read"};
    return names[static_cast<unsigned>(t)];
}
inline void PrintTo(Transport t, std::ostream* out) {
    *out << name_of(t);
}

/// Lines as boards have them: reset 25, D/C 24, backlight 18, TE 23.
inline sim::ModuleWiring wiring_of(Transport t) {
    using Bus = sim::ModuleWiring::Bus;
    sim::ModuleWiring w;
    w.reset = 25;
    w.backlight = 18;
    w.te = 23;
    w.data_command = t == Transport::spi3 || t == Transport::spi3_packed || t == Transport::gpio3
                         ? sim::ModuleWiring::open
                         : 24;
    if (is_spidev(t)) {
        w.bus = w.data_command == 24 ? Bus::spi4 : Bus::spi3;
        return w;
    }
    w.select = 8;
    w.clock = 11;
    if (is_parallel(t)) {
        w.bus = t >= Transport::gpio16 ? Bus::parallel16 : Bus::parallel8;
        w.answer = can_read(t) ? 9 : sim::ModuleWiring::open;
        for (unsigned i = 0; i < 16; ++i)
            w.data[i] = 30 + i;
    } else {
        w.bus = t == Transport::gpio4 ? Bus::spi4 : Bus::spi3;
        w.data[0] = 10;
        w.answer = t == Transport::gpio4 ? 9 : sim::ModuleWiring::open;
    }
    return w;
}

inline hal::PanelPins pins_of(bool te) {
    hal::PanelPins pins;
    pins.reset = {chip_path, 25};
    pins.backlight = {chip_label, 18};
    if (te)
        pins.te = {chip_path, 23};
    return pins;
}

struct RigOptions {
    const hal::PanelDesc* panel = &tiny_panel;
    hal::Orientation orientation = {};
    std::uint32_t spi_hz = 40000000;
    std::uint8_t buffers = 1;
    bool asynchronous = false, wait_te = false, read_back = false, poll_line = false;
};

class Rig {
  public:
    explicit Rig(Transport transport, const RigOptions& options = {})
        : module(*options.panel, wiring_of(transport), machine.chip, machine.kernel), spi(module.serial()),
          options_(options) {
        spi.nine_bit_words = transport != Transport::spi3_packed;
        spi.attach(machine.kernel, spi_path);
        if (is_spidev(transport))
            make_spidev(transport);
        else
            make_gpio(transport);
        hal::PanelConfig config;
        config.panel = options.panel;
        config.orientation = options.orientation;
        config.buffers = options.buffers;
        config.read_back = options.read_back;
        config.wait_te = options.wait_te;
        config.poll_line = options.poll_line;
        display.emplace(bus(), config, storage_.memory());
    }

    Machine machine;
    sim::PanelModule module;
    sim::SpiDevice spi;
    std::optional<hal::SpidevBus> spidev;
    std::optional<hal::GpioBus> gpio;
    std::optional<test::OwnedDisplay> display;

    hal::TransferBus& bus() {
        return spidev ? static_cast<hal::TransferBus&>(*spidev) : static_cast<hal::TransferBus&>(*gpio);
    }
    hal::Result<void> open() { return spidev ? spidev->open() : gpio->open(); }
    const char* device() const { return spidev ? spi_path : chip_path; }

    /// Opens the bus and initialises the panel.
    void start() {
        const auto opened = open();
        ASSERT_TRUE(opened.ok()) << opened.error().rule;
        const auto ready = display->init();
        ASSERT_TRUE(ready.ok()) << ready.error().rule;
    }

    bool draw(unsigned seed, Rect area) { return test::draw_pattern(*display, seed, area); }
    bool draw(unsigned seed) { return test::draw_pattern(*display, seed); }
    /// The glass shows the frame, and nobody broke a rule. Else what is wrong.
    std::string glass_difference() {
        const std::string wrong = test::glass_difference(*display, module.glass(options_.orientation));
        return wrong.empty() ? module.violations_text() : wrong;
    }

  private:
    RigOptions options_;
    hal::PanelStorage<320, 2> storage_;

    void make_spidev(Transport t) {
        hal::SpidevConfig config;
        config.device = spi_path;
        config.write_hz = options_.spi_hz;
        config.read_hz = t != Transport::spi3_packed ? 6000000 : 0;
        config.mode = t == Transport::spi_mode3 ? 3 : 0;
        if (t == Transport::spi || t == Transport::spi_mode3)
            config.dc = {chip_label, 24};
        config.pins = pins_of(options_.wait_te);
        config.asynchronous = options_.asynchronous;
        spidev.emplace(config);
    }

    void make_gpio(Transport t) {
        const sim::ModuleWiring w = wiring_of(t);
        hal::GpioBusConfig config;
        config.wiring = t == Transport::gpio4    ? hal::GpioWiring::serial4
                        : t == Transport::gpio3  ? hal::GpioWiring::serial3
                        : t >= Transport::gpio16 ? hal::GpioWiring::parallel16
                                                 : hal::GpioWiring::parallel8;
        config.chip = chip_path;
        config.select = w.select;
        config.data_command = w.data_command;
        config.clock = w.clock;
        config.answer = t == Transport::gpio3 ? 0 : w.answer;
        std::copy(w.data.begin(), w.data.end(), config.data);
        config.pins = pins_of(options_.wait_te);
        config.asynchronous = options_.asynchronous;
        gpio.emplace(config);
    }
};

} // namespace linux_test
