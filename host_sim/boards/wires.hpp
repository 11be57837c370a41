// Reads what went over a display's wires from QEMU's trace of register writes (-trace
// memory_region_ops_write), and feeds a model of the controller at their end.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include <spangle/hal/board.hpp>
#include <spangle/sim/image.hpp>

#include "host_sim/controller/controller.hpp"

namespace spangle::sim {

/// A line that is a bit of a register. In a set-reset register the bit sets the line, and the bit 16 places
/// higher clears it; in others the bit is its level.
struct WirePin {
    std::uint64_t address = 0; ///< address of the register; 0: the line is not wired
    unsigned bit = 0;
    bool set_reset = false;
};

/// The place of a board's lines in its memory map. Levels are as wired; selected and reset are low.
struct Wiring {
    std::uint64_t data_register = 0; ///< register whose writes are sent
    WirePin select, data_command, reset;
    bool select_high = false;
    std::uint64_t pause_register = 0; ///< register of ticks that the program waits; 0: pauses are not seen
    std::uint64_t pause_hz = 1;
};

/// Reads one word of a wiring: "spi=0x40021008", "select=0x4002804c:0", "data=...",
/// "reset=ADDRESS:BIT:set_reset", "select_high=1", "pause=0xe000e014:25000000". Returns false for any other
/// word.
bool parse_wiring(const std::string& word, Wiring& wiring);

/// An event on the wires of a display.
struct WireEvent {
    enum class Kind : std::uint8_t { byte, select, release, data, command, reset_low, reset_high, pause };
    Kind kind;
    std::uint32_t value; ///< the byte, or nanoseconds of a pause
};

std::vector<WireEvent> read_trace(std::istream& trace, const Wiring& wiring);

/// The model of the controller that receives the events.
class WiredPanel {
  public:
    WiredPanel(const hal::Board& board, const Wiring& wiring, std::vector<WireEvent> events);

    /// Takes events until so many bytes were sent, start bytes not counted. Returns false if the events end
    /// before.
    bool advance(std::uint64_t payload);
    /// Whether all events were taken.
    bool at_end() const;
    Image glass();
    /// The violations, a line each. Without pauses, rules about times are left out.
    std::string violations() const;

  private:
    void take(const WireEvent& event);

    const hal::Board& board_;
    bool has_pauses_;
    std::unique_ptr<Controller> controller_;
    std::vector<WireEvent> events_;
    std::size_t next_ = 0;
    /// In ns since power-on, which was a millisecond before the first event.
    Time current_time_ = 1000000;
    bool is_selected_ = false, is_data_ = false, is_started_ = false;
    std::uint64_t payload_ = 0;
};

} // namespace spangle::sim
