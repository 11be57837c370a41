// The ways in which a display module is connected to a Linux machine, and the configuration of Spangle's bus
// for each.
#pragma once

#include <algorithm>
#include <ostream>

#include <spangle/hal/panel_display.hpp>
#include <spangle/linux/gpio_bus.hpp>
#include <spangle/linux/spidev_bus.hpp>

#include "host_sim/linux/panel_module.hpp"
#include "tests/support/panel_pattern.hpp"

namespace linux_test {

using namespace spangle;

using test::tiny_panel;

inline constexpr char spi_path[] = "/dev/spidev0.0";
inline constexpr char chip_path[] = "/dev/gpiochip0";
inline constexpr char chip_label[] = "pinctrl-bcm2711";

/// The bus that the module is connected to.
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

/// Returns the usual lines of boards: reset 25, D/C 24, backlight 18, TE 23.
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

/// A chip can be named by its path or by its label; some pins use the path, some the label.
inline hal::PanelPins pins_of(bool te, const char* path = chip_path, const char* label = chip_label) {
    hal::PanelPins pins;
    pins.reset = {path, 25};
    pins.backlight = {label, 18};
    if (te)
        pins.te = {path, 23};
    return pins;
}

struct RigOptions {
    const char *path = chip_path, *label = chip_label; ///< path and label of the chip with the lines
    const hal::PanelDesc* panel = &tiny_panel;
    hal::Orientation orientation = {};
    std::uint32_t spi_hz = 40000000;
    std::uint8_t buffers = 1;
    bool asynchronous = false, wait_te = false, read_back = false, poll_line = false;
};

inline hal::PanelConfig panel_of(const RigOptions& options) {
    hal::PanelConfig config;
    config.panel = options.panel;
    config.orientation = options.orientation;
    config.buffers = options.buffers;
    config.read_back = options.read_back;
    config.wait_te = options.wait_te;
    config.poll_line = options.poll_line;
    return config;
}

inline hal::SpidevConfig spidev_of(Transport t, const RigOptions& options) {
    hal::SpidevConfig config;
    config.device = spi_path;
    config.write_hz = options.spi_hz;
    config.read_hz = t != Transport::spi3_packed ? 6000000 : 0;
    config.mode = t == Transport::spi_mode3 ? 3 : 0;
    if (t == Transport::spi || t == Transport::spi_mode3)
        config.dc = {options.label, 24};
    config.pins = pins_of(options.wait_te, options.path, options.label);
    config.asynchronous = options.asynchronous;
    return config;
}

inline hal::GpioBusConfig gpio_of(Transport t, const RigOptions& options) {
    const sim::ModuleWiring w = wiring_of(t);
    hal::GpioBusConfig config;
    config.wiring = t == Transport::gpio4    ? hal::GpioWiring::serial4
                    : t == Transport::gpio3  ? hal::GpioWiring::serial3
                    : t >= Transport::gpio16 ? hal::GpioWiring::parallel16
                                             : hal::GpioWiring::parallel8;
    config.chip = options.path;
    config.select = w.select;
    config.data_command = w.data_command;
    config.clock = w.clock;
    config.answer = t == Transport::gpio3 ? 0 : w.answer;
    std::copy(w.data.begin(), w.data.end(), config.data);
    config.pins = pins_of(options.wait_te, options.path, options.label);
    config.asynchronous = options.asynchronous;
    return config;
}

} // namespace linux_test
