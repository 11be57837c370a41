// A board on the desk that is not there: controller model, bus and display driver behind one name.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <spangle/hal/board.hpp>
#include <spangle/hal/bus.hpp>
#include <spangle/hal/display.hpp>
#include <spangle/hal/panel_display.hpp>
#include <spangle/sim/image.hpp>
#include <spangle/sim/violations.hpp>

namespace spangle::sim {

struct BoardCounters {
    std::uint64_t bytes = 0; ///< on the bus, commands and parameters included
    std::uint64_t commands = 0;
    std::uint64_t pixel_bytes = 0;
    std::uint64_t transfers = 0;
    Time busy_ns = 0; ///< the wire was in use
};

class SimBoard {
  public:
    explicit SimBoard(const hal::Board& board);
    ~SimBoard();
    SimBoard(const SimBoard&) = delete;
    SimBoard& operator=(const SimBoard&) = delete;

    /// For eglGetDisplay(spangle::native(board.display())): the driver that also runs on the real board.
    hal::Display& display();
    hal::Bus& bus();

    /// What the user sees, upright: the glass after the panel was sent all that is on the wire and has
    /// scanned its memory out. Looking takes that time and two refreshes (virtual). Beside round glass the
    /// picture is transparent black: alpha 0.
    Image glass() const;
    /// The same with what round glass hides: the whole rectangle that the controller scans out.
    Image scan_out() const;
    /// The controller's whole frame memory as MADCTL 00h addresses it.
    Image memory() const;

    BoardCounters counters() const;
    /// What became of the frames presented.
    hal::PresentCounters presents() const;
    const Violations& violations() const;
    /// All violations, a line each; empty when the bus kept every rule.
    std::string violations_text() const;
    Time now() const;
    /// The processor works for a while (virtual time).
    void pass(Time ns);

    /// Records the wires from here on, in a file of at most so many bytes; 0: half a gigabyte. Empty, or why
    /// the file cannot be written.
    std::string record_vcd(const std::string& path, std::uint64_t most_bytes = 0);
    /// The file is whole and has its name, as it also has when the board goes. `error` is empty, or says what
    /// went wrong; `full`: the limit was reached, and the dump ends at `end`.
    struct Recorded {
        std::string error;
        bool full = false;
        Time end = 0;
    };
    Recorded end_vcd();
    /// The next transfer fails this way.
    void fail_next(hal::Fault fault);
    /// The wire loses byte n counted from now.
    void drop_byte(std::uint64_t n);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace spangle::sim
