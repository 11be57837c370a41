#include "host_sim/bringup/attach.hpp"

#include <cstdlib>

#include <fmt/format.h>

#include <spangle/boards/boards.hpp>
#include <spangle/hal/op_list.hpp>
#include <spangle/sim/board.hpp>
#if SPANGLE_HAS_LINUX
#include <spangle/linux/i2c_bus.hpp>
#include <spangle/linux/spidev_bus.hpp>
#endif
#if SPANGLE_HAS_USB
#include <spangle/usb/ftdi_bus.hpp>
#include <spangle/usb/gud_display.hpp>
#endif

namespace spangle::bringup {
namespace {

#if SPANGLE_HAS_LINUX
/// Reads a line as "gpiochip0:24", "/dev/gpiochip0:24" or "pinctrl-bcm2711:24". `chip` keeps the chip's name,
/// to which `line` points.
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

/// A bus of Linux with the lines beside it, and the names to which its configuration points.
template <class Bus> struct WithLines {
    BusOptions options;
    std::string chips[4];
    hal::LineRef dc;
    hal::PanelPins pins;
    std::unique_ptr<Bus> bus;

    explicit WithLines(const BusOptions& o) : options(o) {}
    bool read_lines() {
        return read_line(options.dc, chips[0], dc) && read_line(options.reset, chips[1], pins.reset) &&
               read_line(options.light, chips[2], pins.backlight) && read_line(options.te, chips[3], pins.te);
    }
};
constexpr const char* bad_line = "lines are CHIP:NUMBER, as gpiochip0:24";

/// Opens the bus of `held`, and hands both over to `out`.
template <class Held> void open(const std::shared_ptr<Held>& held, Attachment& out) {
    if (const auto opened = held->bus->open(); !opened)
        out.error = opened.error().rule;
    out.bus = std::shared_ptr<hal::Bus>(held, held->bus.get());
}

void attach_spidev(const BusOptions& options, Attachment& out) {
    auto held = std::make_shared<WithLines<hal::SpidevBus>>(options);
    if (!held->read_lines()) {
        out.error = bad_line;
        return;
    }
    hal::SpidevConfig config =
        hal::spidev_config(out.board, held->options.spidev.c_str(), held->dc, held->pins);
    config.write_hz = options.hz != 0 ? options.hz : config.write_hz;
    config.read_hz = options.read_hz != 0 ? options.read_hz : config.read_hz;
    held->bus = std::make_unique<hal::SpidevBus>(config);
    out.reset = held->pins.reset.wired();
    open(held, out);
}

void attach_i2c(const BusOptions& options, Attachment& out) {
    auto held = std::make_shared<WithLines<hal::I2cBus>>(options);
    if (!held->read_lines()) {
        out.error = bad_line;
        return;
    }
    hal::I2cConfig config = hal::i2c_config(out.board, held->options.i2c.c_str(),
                                            static_cast<std::uint8_t>(options.address), held->pins);
    config.clock_hz = options.hz != 0 ? options.hz : config.clock_hz;
    held->bus = std::make_unique<hal::I2cBus>(config);
    out.reset = held->pins.reset.wired();
    open(held, out);
}
#else
void attach_spidev(const BusOptions&, Attachment& out) {
    out.error = "this build has no spidev";
}
void attach_i2c(const BusOptions&, Attachment& out) {
    out.error = "this build has no i2c-dev";
}
#endif

#if SPANGLE_HAS_USB
struct Ftdi {
    BusOptions options;
    std::unique_ptr<hal::FtdiBus> bus;
};

void attach_ftdi(const BusOptions& options, Attachment& out) {
    auto held = std::make_shared<Ftdi>();
    held->options = options;
    hal::FtdiConfig config = hal::ftdi_config(out.board);
    config.device_file = options.usb_file.empty() ? nullptr : held->options.usb_file.c_str();
    config.write_hz = options.hz != 0 ? options.hz : config.write_hz;
    config.read_hz = options.read_hz != 0 ? options.read_hz : config.read_hz;
    config.pins.te = out.board.has_te;
    held->bus = std::make_unique<hal::FtdiBus>(config);
    out.reset = true;
    if (const auto opened = held->bus->open(); !opened)
        out.error = opened.error().rule;
    out.bus = std::shared_ptr<hal::Bus>(held, held->bus.get());
}

struct Gud {
    BusOptions options;
    std::unique_ptr<hal::GudDisplay> display;
};

void attach_gud(const BusOptions& options, Attachment& out) {
    auto held = std::make_shared<Gud>();
    held->options = options;
    hal::GudConfig config;
    config.device_file = options.usb_file.empty() ? nullptr : held->options.usb_file.c_str();
    held->display = std::make_unique<hal::GudDisplay>(config);
    out.display = std::shared_ptr<hal::Display>(held, held->display.get());
}
#else
void attach_ftdi(const BusOptions&, Attachment& out) {
    out.error = "this build has no libusb";
}
void attach_gud(const BusOptions&, Attachment& out) {
    out.error = "this build has no libusb";
}
#endif

} // namespace

std::string mismatch(const BusOptions& options, const hal::Board& board) {
    const int kinds = (options.spidev.empty() ? 0 : 1) + (options.i2c.empty() ? 0 : 1) +
                      (options.ftdi ? 1 : 0) + (options.gud ? 1 : 0);
    if (kinds > 1)
        return "spidev, I2C, FTDI and GUD name one display each; leave out all but one";
    const bool i2c = board.bus == hal::BusKind::i2c, wide = board.bus == hal::BusKind::i8080;
    if (!options.i2c.empty() && !i2c)
        return fmt::format("board {} does not hang on I2C; take one that does, as ssd1306-i2c", board.name);
    if ((!options.spidev.empty() || options.ftdi) && (i2c || wide))
        return fmt::format("board {} does not hang on SPI; take one that does, as ili9341-spi", board.name);
    if (options.ftdi && board.bus == hal::BusKind::spi_start)
        return fmt::format("board {} takes start bytes, which an FTDI adapter does not send; use a spidev",
                           board.name);
    return "";
}

std::string BusOptions::board_name() const {
    return !board.empty() ? board : !i2c.empty() ? "ssd1306-i2c" : "ili9341";
}

const hal::Board* find_board(const std::string& name) {
    for (const hal::Board* board : boards::all)
        if (name == board->name || std::string(board->name).rfind(name + "-", 0) == 0)
            return board;
    return nullptr;
}

Attachment attach(const BusOptions& options, const hal::Board& board) {
    Attachment out;
    out.board = board;
    out.error = mismatch(options, board);
    if (!out.error.empty())
        return out;
    if (!options.spidev.empty()) {
        out.where = options.spidev;
        attach_spidev(options, out);
    } else if (!options.i2c.empty()) {
        out.where = fmt::format("{} address {:02X}h", options.i2c, options.address);
        attach_i2c(options, out);
    } else if (options.ftdi) {
        out.where = options.usb_file.empty() ? "FTDI adapter" : "FTDI adapter " + options.usb_file;
        attach_ftdi(options, out);
    } else if (options.gud) {
        out.where = options.usb_file.empty() ? "USB" : options.usb_file;
        attach_gud(options, out);
    } else {
        out.simulated = std::make_unique<sim::SimBoard>(board);
        out.bus = std::shared_ptr<hal::Bus>(&out.simulated->bus(), [](hal::Bus*) {});
        out.reset = board.display.reset_line;
    }
    return out;
}

Attachment attach(const BusOptions& options) {
    const hal::Board* const board = find_board(options.board_name());
    if (board != nullptr)
        return attach(options, *board);
    Attachment out;
    out.error = "no board '" + options.board_name() + "'; `spangle boards` lists them";
    return out;
}

/// Asks an I2C address with E3h, which does nothing on any of these controllers (SSD1306 datasheet, 9;
/// SH1106, SSD1327 and SSD0303 alike).
I2cAnswer ask_i2c(const BusOptions& options, unsigned address) {
    constexpr std::uint8_t no_operation = 0xE3;
    constexpr std::uint32_t patience_us = 1000000;
    BusOptions there = options;
    there.address = address;
    const Attachment on = attach(there);
    if (!on.error.empty())
        return {on.error};
    hal::Op op;
    op.kind = hal::Op::Kind::command;
    op.command = no_operation;
    const auto token = on.bus->submit(&op, 1);
    const auto done = token ? on.bus->wait(token.value(), patience_us) : hal::Result<void>(token.error());
    if (!done && done.error().fault != hal::Fault::no_answer)
        return {done.error().rule};
    return {"", done.ok()};
}

} // namespace spangle::bringup
