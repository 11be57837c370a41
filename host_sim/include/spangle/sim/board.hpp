// A simulated board: a model of its display's controller, its bus and its display driver behind one name.
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

/// What went over the bus since power-on, as the controller model counted it.
struct BoardCounters {
    std::uint64_t bytes = 0; ///< bytes on the bus, commands and parameters included
    /// The number of commands.
    std::uint64_t commands = 0;
    /// The number of bytes that were pixels.
    std::uint64_t pixel_bytes = 0;
    /// The number of [op lists](docs/glossary.md#op) that were submitted.
    std::uint64_t transfers = 0;
    Time busy_ns = 0; ///< ns in which the wire was in use
};

/// A board of the simulator, powered on. It belongs to one thread. Its clock is virtual.
class SimBoard {
  public:
    /// Builds the module that `board` describes. The description is copied; the panel that it names must
    /// outlive the simulated board.
    explicit SimBoard(const hal::Board& board);
    /// Ends the simulation. A record of the wires that is still open is completed.
    ~SimBoard();
    /// A board is not copied.
    SimBoard(const SimBoard&) = delete;
    /// A board is not assigned.
    SimBoard& operator=(const SimBoard&) = delete;

    /// The display, which has the driver that also runs on the real board. Use it as
    /// eglGetDisplay(spangle::native(board.display())).
    hal::Display& display();
    /// The bus between the display's driver and the controller model.
    hal::Bus& bus();

    /// The picture that a viewer sees, upright. The panel is first sent all that is on the
    /// [wire](docs/glossary.md#wire), and then scans its memory for two refreshes; both take [virtual
    /// time](docs/glossary.md#virtual-time). Outside round [glass](docs/glossary.md#glass) the picture is
    /// transparent black: alpha 0.
    Image glass() const;
    /// The whole rectangle that the controller scans: glass() without hiding what round glass hides.
    Image scan_out() const;
    /// The controller's whole frame memory, as MADCTL 00h addresses it.
    Image memory() const;

    /// What went over the bus so far.
    BoardCounters counters() const;
    /// What became of the presented frames: sent, put off, and how they met the scan.
    hal::PresentCounters presents() const;
    /// What the bus did that the data sheet forbids, in order of time.
    const Violations& violations() const;
    /// All [violations](docs/glossary.md#violation), a line each; empty when the bus kept every rule.
    std::string violations_text() const;
    /// The virtual time: nanoseconds since power-on.
    Time now() const;
    /// Lets the processor work for `ns` nanoseconds of virtual time.
    void pass(Time ns);

    /// Records the wires from here on, in a file of at most `most_bytes` bytes; 0: half a gigabyte. Returns
    /// why the file cannot be written, or an empty string.
    std::string record_vcd(const std::string& path, std::uint64_t most_bytes = 0);
    /// What became of a record of the wires. `error` says what went wrong, or is empty. `full` says that the
    /// limit was reached; the dump then ends at `end`, in ns. The file has its name from end_vcd() on; the
    /// board's destructor ends a record, too.
    struct Recorded {
        /// What went wrong; empty: nothing did.
        std::string error;
        /// Whether the dump reached its limit of bytes.
        bool full = false;
        /// When the dump ends, in nanoseconds since power-on.
        Time end = 0;
    };
    /// Ends the record of the wires.
    Recorded end_vcd();
    /// Makes the next transfer fail this way.
    void fail_next(hal::Fault fault);
    /// Makes the wire lose byte n, counted from now.
    void drop_byte(std::uint64_t n);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace spangle::sim
