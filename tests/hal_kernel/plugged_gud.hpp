// A modelled GUD display plugged into the kernel's virtual USB controller.
#pragma once

#include <cerrno>
#include <cstring>
#include <mutex>
#include <string>

#include <gtest/gtest.h>

#include "host_sim/usb/gud_device.hpp"
#include "host_sim/usb/usbip.hpp"
#include "tests/hal_kernel/files.hpp"

namespace kernel_test {

struct PluggedGud {
    static constexpr char card[] = "/dev/dri/card0";

    spangle::sim::GudDevice device;
    spangle::sim::UsbipDevice usb{device};

    PluggedGud() { size(320, 240); }
    ~PluggedGud() {
        try {
            dismiss_driver();
            pull();
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
    }

    void size(std::uint16_t width, std::uint16_t height) {
        device.modes = {{6000, width, height, true}};
        device.limits = {width, width, height, height};
    }
    /// The kernel's own driver is the first that finds it.
    void plug() {
        ASSERT_TRUE(usb.plug()) << std::strerror(errno);
        await("bring its gud driver up", [] { return exists(card); });
    }
    /// The kernel's driver waits up to three seconds for a transfer that was under way.
    void pull() {
        usb.unplug();
        await(
            "let go of the device", [] { return !exists(card) && !exists("/sys/bus/usb/devices/2-1"); },
            std::chrono::seconds(10));
    }
    std::string violations() {
        const std::lock_guard lock(usb);
        return device.violations();
    }

  private:
    /// While the device still answers.
    static void dismiss_driver() {
        if (exists("/sys/bus/usb/drivers/gud/2-1:1.0"))
            write_text("/sys/bus/usb/drivers/gud/unbind", "2-1:1.0");
    }
};

} // namespace kernel_test
