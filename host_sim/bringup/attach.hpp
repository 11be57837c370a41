// The bus that a panel hangs on, as the command line names it: a simulated board's, a spidev, or an FTDI
// adapter.
#pragma once

#include <memory>
#include <string>

#include <spangle/hal/board.hpp>

namespace spangle::sim {
class SimBoard;
}

namespace spangle::bringup {

struct BusOptions {
    std::string board = "ili9341"; ///< simulated; or whose bus and panel the real one is like
    std::string spidev;            ///< device file; empty: none
    std::string dc, reset, light;  ///< CHIP:LINE of a spidev's panel
    bool ftdi = false;
    std::string usb_file;              ///< the adapter's usbfs file; empty: the first there is
    std::uint32_t hz = 0, read_hz = 0; ///< 0: the board's
};

/// An open bus with a panel of this board, or why there is none.
struct Attached {
    std::string error;
    const hal::Board* board = nullptr;
    std::unique_ptr<sim::SimBoard> simulated; ///< null: a real bus
    std::shared_ptr<hal::Bus> bus;
    bool reset = false; ///< the panel's reset is wired
};

Attached attach(const BusOptions& options);
const hal::Board* find_board(const std::string& name);

} // namespace spangle::bringup
