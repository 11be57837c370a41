#include "host_sim/cli/bus_options.hpp"

namespace spangle::cli {

CLI::Option* add_bus_options(CLI::App& command, bringup::BusOptions& bus, const char* more) {
    CLI::Option* const board = command.add_option(
        "--board", bus.board,
        std::string("the simulated board (ili9341); with a real bus: whose panel it is like (with --i2c: "
                    "ssd1306-i2c)") +
            more);
    command.add_option("--spidev", bus.spidev, "a real panel behind this spidev, as /dev/spidev0.0");
    command.add_option("--dc", bus.dc, "its D/C line, CHIP:NUMBER as gpiochip0:24; none: 3-wire");
    command.add_option("--reset", bus.reset, "its reset line");
    command.add_option("--light", bus.light, "its backlight's line");
    command.add_option("--te", bus.te, "its tearing-effect line");
    command.add_option("--i2c", bus.i2c, "a real panel behind this I2C adapter, as /dev/i2c-1");
    command.add_option("--address", bus.address, "its address there")
        ->check(CLI::Range(0x03u, 0x77u))
        ->default_str("0x3C");
    command.add_flag("--ftdi", bus.ftdi, "a real panel at an FT232H");
    command.add_flag("--gud", bus.gud, "a real display on USB that speaks GUD");
    command.add_option("--usb", bus.usb_file, "that adapter's or display's file in /dev/bus/usb");
    command.add_option("--hz", bus.hz, "write clock of a real bus, instead of the board's");
    command.add_option("--read-hz", bus.read_hz, "read clock, instead of the board's");
    return board;
}

} // namespace spangle::cli
