// A GUD display plugged into a modelled Linux machine, and the Spangle host that drives it.
#pragma once

#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <spangle/usb/gud_display.hpp>

#include "host_sim/linux/kernel.hpp"
#include "host_sim/usb/usbfs.hpp"
#include "tests/unit/hal_usb/gud_picture.hpp"

namespace gud_test {

using namespace spangle;

inline constexpr char path[] = "/dev/bus/usb/001/002";

struct GudRig {
    sim::Kernel& kernel = sim::Kernel::instance();
    sim::GudDevice device;
    sim::UsbfsDevice usb{device};
    hal::GudConfig config;
    std::optional<hal::GudDisplay> display;

    GudRig() {
        config.device_file = path;
        small();
    }
    GudRig(const GudRig&) = delete;
    GudRig& operator=(const GudRig&) = delete;
    ~GudRig() {
        display.reset();
        EXPECT_EQ(kernel.open_files(), 0) << "files were left open";
        kernel.forget_all();
    }

    void size(std::uint16_t width, std::uint16_t height) {
        device.modes = {{1000, width, height, true}};
        device.limits = {width, width, height, height};
    }
    void small() { size(40, 30); }

    hal::Result<void> start() {
        usb.attach(kernel, path);
        display.emplace(config);
        return display->init();
    }

    bool draw(unsigned seed, Rect area, bool flat = false) {
        return draw_pattern(*display, seed, area, flat);
    }
    bool draw(unsigned seed, bool flat = false) {
        const hal::DisplayInfo info = display->info();
        return draw(seed, {0, 0, info.width, info.height}, flat);
    }
    hal::Result<void> show() { return gud_test::show(*display); }
    std::string glass_difference() { return gud_test::glass_difference(*display, device); }
};

} // namespace gud_test
