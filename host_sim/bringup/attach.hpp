// Opens the display that the command line names: a simulated board, a real panel behind a spidev, an I2C
// adapter or an FTDI adapter, or a GUD display on USB.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <spangle/hal/board.hpp>

namespace spangle::sim {
class SimBoard;
}

namespace spangle::bringup {

struct BusOptions {
    std::string board;  ///< name of the simulated board, or of one like the real panel; empty: the usual
    std::string spidev; ///< device file; empty: not used
    std::string dc, reset, light, te; ///< lines of a real panel, as CHIP:LINE
    std::string i2c;                  ///< device file; empty: not used
    unsigned address = 0x3C;          ///< address of the panel on I2C
    bool ftdi = false, gud = false;
    std::string usb_file;              ///< usbfs file of the USB device; empty: the first found
    std::uint32_t hz = 0, read_hz = 0; ///< clocks to write and to read with; 0: those of the board

    bool real() const { return !spidev.empty() || !i2c.empty() || ftdi || gud; }
    /// The name of the board, or that of the usual board on a bus of this kind.
    std::string board_name() const;
};

/// An open bus with a panel of this board, or a display that needs no bus, or why there is neither.
struct Attachment {
    std::string error;
    hal::Board board;                         ///< unused for a GUD display
    std::unique_ptr<sim::SimBoard> simulated; ///< null: the display is real
    std::shared_ptr<hal::Bus> bus;            ///< null for a GUD display, which needs no bus
    std::shared_ptr<hal::Display> display;    ///< a GUD display; null: a panel on the bus
    std::string where;                        ///< name of the device, for reports; empty: simulated
    bool reset = false;                       ///< the panel's reset line is wired
};

/// Why no panel of this board can hang where `options` say; empty if one can. This opens nothing.
std::string mismatch(const BusOptions& options, const hal::Board& board);
/// Opens what `options` name, as the board describes it. GUD displays are found by init().
Attachment attach(const BusOptions& options);
/// Opens what `options` name on a board that the caller describes.
Attachment attach(const BusOptions& options, const hal::Board& board);
const hal::Board* find_board(const std::string& name);

/// Whether a controller acknowledges an address of an I2C bus.
struct I2cAnswer {
    std::string error; ///< empty: `heard` is known
    bool heard = false;
};
I2cAnswer ask_i2c(const BusOptions& options, unsigned address);

} // namespace spangle::bringup
