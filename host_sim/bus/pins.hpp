// A controller at its pins: takes levels at virtual times, and hands bits and bytes to the model. Pins are
// held to a rule that bytes cannot break: D/C may not change while a byte is under way.
#pragma once

#include <cstdint>
#include <limits>

#include "host_sim/controller/controller.hpp"

namespace spangle::sim {

/// Measures the time between edges of a clock. The first edge after a pause of unknown length has no period.
class ClockPeriod {
  public:
    void restart() { has_edge_ = false; }
    unsigned note_edge(Time now) {
        const Time since = now - last_edge_;
        const bool known = has_edge_ && since < unknown;
        last_edge_ = now;
        has_edge_ = true;
        return known ? static_cast<unsigned>(since) : unknown;
    }
    static constexpr unsigned unknown = std::numeric_limits<unsigned>::max();

  private:
    Time last_edge_ = 0;
    bool has_edge_ = false;
};

/// 4-wire SPI with a D/C pin (MIPI DBI type C, option 3). Bits are taken at rising clocks, D/C with the last
/// bit of a byte; answers change at falling clocks. SPI modes 0 and 3 both do so, and differ only in where
/// the clock rests. 3-wire SPI (option 1) has words of nine bits, D/C first. While the controller answers, it
/// takes no bits.
class SerialPins {
  public:
    enum class Pin : std::uint8_t { reset, select, data, clock, mosi };

    explicit SerialPins(Controller& controller, bool three_wire = false)
        : controller_(controller), is_three_wire_(three_wire) {}
    /// Sets the level of a pin; times never go back. Reset and select are low when active, and both start
    /// high; the other pins start low.
    void set(Pin pin, bool level, Time now);
    /// The level of the answer line, which is low while nobody drives it.
    bool miso() const { return miso_; }

  private:
    Controller& controller_;
    bool is_three_wire_;
    bool levels_[5] = {true, true, false, false, false};
    bool miso_ = false, is_answering_ = false;
    unsigned shift_register_ = 0, bit_count_ = 0, shortest_period_ = ClockPeriod::unknown;
    ClockPeriod clock_period_;

    bool level(Pin pin) const { return levels_[static_cast<unsigned>(pin)]; }
    void begin_byte();
    void clock_rises(Time now);
    void clock_falls();
};

/// The 8080 bus (MIPI DBI type B) of 8 or 16 lines. Bytes are taken at rising WRX; answers stand on the lines
/// from falling to rising RDX. On 16 lines a cycle carries two bytes of pixels, the first on D[15:8], or one
/// byte of anything else. The dummy cycle of an answer counts as one of eight bits.
class ParallelPins {
  public:
    enum class Pin : std::uint8_t { reset, select, data, write, read };

    explicit ParallelPins(Controller& controller, unsigned lines = 8)
        : controller_(controller), is_16_bits_(lines == 16) {}
    void set(Pin pin, bool level, Time now);
    /// Sets the value that the host drives onto the data lines.
    void drive(unsigned value) { data_lines_ = value; }
    /// The value that the controller drives onto the data lines; 0 while RDX is high.
    unsigned answer() const { return answer_; }

  private:
    Controller& controller_;
    bool levels_[5] = {true, true, false, true, true};
    bool is_16_bits_;
    unsigned data_lines_ = 0, answer_ = 0;
    std::uint8_t command_ = 0;    ///< the last command
    bool is_dummy_cycle_ = false; ///< the next read cycle is the first of an answer
    ClockPeriod write_cycle_, read_cycle_;

    bool level(Pin pin) const { return levels_[static_cast<unsigned>(pin)]; }
    bool two_bytes() const;
    void write(Time now);
    void read(bool high, Time now);
};

} // namespace spangle::sim
