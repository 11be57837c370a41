// A modelled GUD display plugged into the kernel's virtual USB controller.
#pragma once

#include <cerrno>
#include <cstring>
#include <mutex>
#include <string>

#include <gtest/gtest.h>

#include "host_sim/usb/gud_device.hpp"
#include "host_sim/usb/usbip.hpp"
#include "tests/unit/hal_kernel/gud_driver.hpp"

namespace kernel_test {

struct PluggedGud {
    static constexpr char name[] = "2-1"; ///< the first port of vhci-hcd's first bus

    spangle::sim::GudDevice device;
    spangle::sim::UsbipDevice usb{device};

    PluggedGud() {
        size(320, 240);
        device.tells_by_length = false; // the kernel's driver may compress to the same length
    }
    ~PluggedGud() {
        try {
            dismiss_gud_driver(name);
            pull();
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
    }

    void size(std::uint16_t width, std::uint16_t height) {
        device.modes = {{6000, width, height, true}};
        device.limits = {width, width, height, height};
    }
    /// Plugs the device in; the kernel's own driver finds it first.
    void plug() {
        ASSERT_TRUE(usb.plug()) << std::strerror(errno);
        await_gud_driver();
    }
    void pull() {
        usb.unplug();
        await_no_device(name);
    }
    std::string violations() {
        const std::lock_guard lock(usb);
        return device.violations();
    }
};

} // namespace kernel_test
