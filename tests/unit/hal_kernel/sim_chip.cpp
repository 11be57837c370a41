#include "tests/unit/hal_kernel/sim_chip.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <sys/stat.h>
#include <unistd.h>

#include "tests/unit/hal_kernel/files.hpp"

namespace kernel_test {
namespace {

const std::string folder = "/sys/kernel/config/gpio-sim/chip";
const std::string bank = folder + "/bank0";
struct LineBus {
    std::string driver, device, file;
};
const LineBus buses[] = {{"/sys/bus/platform/drivers/spi_gpio/", "spi_gpio.0", "/dev/spidev0.0"},
                         {"/sys/bus/platform/drivers/i2c-gpio/", "i2c-gpio.1", "/dev/i2c-1"}};

/// A bus whose probe waited for the chip is bound by itself. A bus that an earlier test unbound must be bound
/// here.
void bind(const LineBus& bus) {
    if (!exists(bus.driver + bus.device))
        try {
            write_text(bus.driver + "bind", bus.device);
        } catch (const std::runtime_error&) { // the kernel bound the bus in between
        }
    await("make the bus's device file", [&] { return exists(bus.file); });
}

} // namespace

SimChip::SimChip(const std::string& label, unsigned lines) : label_(label) {
    mkdir(folder.c_str(), 0755);
    mkdir(bank.c_str(), 0755);
    write_text(bank + "/num_lines", std::to_string(lines));
    write_text(bank + "/label", label);
    write_text(folder + "/live", "1");
    const std::string name = read_text(bank + "/chip_name");
    path_ = "/dev/" + name;
    lines_folder_ = "/sys/devices/platform/" + read_text(folder + "/dev_name") + "/" + name + "/sim_gpio";
    await("make the chip's device file", [&] { return exists(path_); });
    if (has_buses())
        std::for_each(std::begin(buses), std::end(buses), bind);
}

SimChip::~SimChip() {
    if (present_)
        remove();
    rmdir(bank.c_str());
    rmdir(folder.c_str());
}

void SimChip::remove() {
    present_ = false;
    for (const LineBus& bus : buses)
        if (has_buses())
            write_text(bus.driver + "unbind", bus.device);
    write_text(folder + "/live", "0");
}

unsigned SimChip::first_number() const {
    for (const auto& chip : std::filesystem::directory_iterator("/sys/class/gpio")) {
        const std::string label = chip.path().string() + "/label";
        if (exists(label) && read_text(label) == label_)
            return static_cast<unsigned>(std::stoul(read_text(chip.path().string() + "/base")));
    }
    throw std::runtime_error("no chip of that label in /sys/class/gpio");
}

bool SimChip::level(unsigned line) const {
    return read_text(lines_folder_ + std::to_string(line) + "/value") == "1";
}

void SimChip::pull(unsigned line, bool high) {
    write_text(lines_folder_ + std::to_string(line) + "/pull", high ? "pull-up" : "pull-down");
}

} // namespace kernel_test
