// What a picture is sent to, as the command line names it: a simulated board, a real panel behind a spidev,
// an I2C adapter or an FTDI adapter, or a GUD display on USB.
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
    std::string board;  ///< simulated; or whose bus and panel the real one is like; empty: the usual
    std::string spidev; ///< device file; empty: none
    std::string dc, reset, light, te; ///< CHIP:LINE of a real panel
    std::string i2c;                  ///< device file; empty: none
    unsigned address = 0x3C;          ///< on I2C
    bool ftdi = false, gud = false;
    std::string usb_file;              ///< that device's usbfs file; empty: the first there is
    std::uint32_t hz = 0, read_hz = 0; ///< 0: the board's

    bool real() const { return !spidev.empty() || !i2c.empty() || ftdi || gud; }
    /// The board's name, or that of the usual one on such a bus.
    std::string board_name() const;
};

/// An open bus with a panel of this board, or a display that needs none, or why there is neither.
struct Attached {
    std::string error;
    hal::Board board;                         ///< not of a GUD display
    std::unique_ptr<sim::SimBoard> simulated; ///< null: it is real
    std::shared_ptr<hal::Bus> bus;            ///< null: a GUD display
    std::shared_ptr<hal::Display> display;    ///< a GUD display; null: the bus carries to a panel
    std::string where;                        ///< the device, for reports; empty: simulated
    bool reset = false;                       ///< the panel's reset is wired
};

/// Why no panel of this board can hang where `options` say, or nothing. Nothing is opened.
std::string mismatch(const BusOptions& options, const hal::Board& board);
/// Opens what `options` name, as the board says; GUD displays are found by init().
Attached attach(const BusOptions& options);
/// The same with a board of the caller's making.
Attached attach(const BusOptions& options, const hal::Board& board);
const hal::Board* find_board(const std::string& name);

/// An address of an I2C bus and whether a controller there acknowledges it.
struct I2cAnswer {
    std::string error; ///< empty: it is known
    bool heard = false;
};
I2cAnswer ask_i2c(const BusOptions& options, unsigned address);

} // namespace spangle::bringup
