// A modelled Linux machine with a display module on its GPIO header, and the Spangle bus that drives it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "host_sim/linux/gpio_chip.hpp"
#include "host_sim/linux/panel_module.hpp"
#include "host_sim/linux/spi_device.hpp"
#include "tests/unit/hal_linux/transports.hpp"

namespace linux_test {

using namespace spangle;

/// The modelled machine. There is one kernel, so only one machine exists at a time.
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

    /// The next `times` calls that `which` selects fail with this errno.
    void fail(int error, int times, std::function<bool(const sim::Call&)> which) {
        kernel.set_judge([=, left = times](const sim::Call& call) mutable {
            const bool hit = left > 0 && which(call);
            left -= hit ? 1 : 0;
            return sim::CallVerdict{hit ? error : 0};
        });
    }
    void no_faults() { kernel.set_judge(nullptr); }
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
        display.emplace(bus(), panel_of(options), storage_.memory());
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
    /// Returns an empty text if the glass shows the frame and no rule was broken, else what is wrong.
    std::string glass_difference() {
        const std::string wrong = test::glass_difference(*display, module.glass(options_.orientation));
        return wrong.empty() ? module.violations_text() : wrong;
    }

  private:
    RigOptions options_;
    hal::PanelStorage<hal::PanelSizes{.height = 320, .buffers = 2}> storage_;

    void make_spidev(Transport t) { spidev.emplace(spidev_of(t, options_)); }
    void make_gpio(Transport t) { gpio.emplace(gpio_of(t, options_)); }
};

} // namespace linux_test
