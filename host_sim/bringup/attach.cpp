#include "host_sim/bringup/attach.hpp"

#include <cstdlib>

#include <spangle/boards/boards.hpp>
#include <spangle/sim/board.hpp>
#if SPANGLE_HAS_LINUX
#include <spangle/linux/spidev_bus.hpp>
#endif
#if SPANGLE_HAS_USB
#include <spangle/usb/ftdi_bus.hpp>
#endif

namespace spangle::bringup {
namespace {

#if SPANGLE_HAS_LINUX
/// "gpiochip0:24", "/dev/gpiochip0:24" or "pinctrl-bcm2711:24"; the chip's name stays with the caller.
bool read_line(const std::string& text, std::string& chip, hal::LineRef& line) {
    if (text.empty())
        return true;
    const std::size_t colon = text.rfind(':');
    char* end = nullptr;
    if (colon == std::string::npos || colon == 0 || colon + 1 == text.size())
        return false;
    line.offset = static_cast<unsigned>(std::strtoul(text.c_str() + colon + 1, &end, 10));
    chip = text.substr(0, colon);
    if (chip.rfind("gpiochip", 0) == 0)
        chip = "/dev/" + chip;
    line.chip = chip.c_str();
    return *end == '\0';
}

/// A spidev and the names its configuration points to.
struct Spidev {
    BusOptions options;
    std::string chips[3];
    std::unique_ptr<hal::SpidevBus> bus;
};

void attach_spidev(const BusOptions& options, Attached& out) {
    auto held = std::make_shared<Spidev>();
    held->options = options;
    hal::LineRef dc;
    hal::PanelPins pins;
    if (!read_line(options.dc, held->chips[0], dc) || !read_line(options.reset, held->chips[1], pins.reset) ||
        !read_line(options.light, held->chips[2], pins.backlight)) {
        out.error = "lines are CHIP:NUMBER, as gpiochip0:24";
        return;
    }
    hal::SpidevConfig config = hal::spidev_config(*out.board, held->options.spidev.c_str(), dc, pins);
    config.write_hz = options.hz != 0 ? options.hz : config.write_hz;
    config.read_hz = options.read_hz != 0 ? options.read_hz : config.read_hz;
    held->bus = std::make_unique<hal::SpidevBus>(config);
    if (const auto opened = held->bus->open(); !opened)
        out.error = opened.error().rule;
    out.reset = pins.reset.wired();
    out.bus = std::shared_ptr<hal::Bus>(held, held->bus.get());
}
#else
void attach_spidev(const BusOptions&, Attached& out) {
    out.error = "this build has no spidev";
}
#endif

#if SPANGLE_HAS_USB
struct Ftdi {
    BusOptions options;
    std::unique_ptr<hal::FtdiBus> bus;
};

void attach_ftdi(const BusOptions& options, Attached& out) {
    auto held = std::make_shared<Ftdi>();
    held->options = options;
    hal::FtdiConfig config = hal::ftdi_config(*out.board);
    config.device_file = options.usb_file.empty() ? nullptr : held->options.usb_file.c_str();
    config.write_hz = options.hz != 0 ? options.hz : config.write_hz;
    config.read_hz = options.read_hz != 0 ? options.read_hz : config.read_hz;
    held->bus = std::make_unique<hal::FtdiBus>(config);
    if (const auto opened = held->bus->open(); !opened)
        out.error = opened.error().rule;
    out.reset = true;
    out.bus = std::shared_ptr<hal::Bus>(held, held->bus.get());
}
#else
void attach_ftdi(const BusOptions&, Attached& out) {
    out.error = "this build has no libusb";
}
#endif

} // namespace

const hal::Board* find_board(const std::string& name) {
    for (const hal::Board* board : boards::all)
        if (name == board->name || std::string(board->name).rfind(name + "-", 0) == 0)
            return board;
    return nullptr;
}

Attached attach(const BusOptions& options) {
    Attached out;
    out.board = find_board(options.board);
    if (out.board == nullptr)
        out.error = "no board '" + options.board + "'; `spangle boards` lists them";
    else if (!options.spidev.empty())
        attach_spidev(options, out);
    else if (options.ftdi)
        attach_ftdi(options, out);
    else {
        out.simulated = std::make_unique<sim::SimBoard>(*out.board);
        out.bus = std::shared_ptr<hal::Bus>(&out.simulated->bus(), [](hal::Bus*) {});
        out.reset = out.board->display.reset_line;
    }
    return out;
}

} // namespace spangle::bringup
