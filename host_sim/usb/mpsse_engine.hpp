// FTDI's Multi-Protocol Synchronous Serial Engine: a stream of bytes becomes levels of sixteen pins, and
// answers. From FTDI's AN_108, the part that SPI in mode 0 takes; commands beyond it are answered as bad
// ones.
#pragma once

#include <string>
#include <vector>

#include "host_sim/bus/pin_header.hpp"
#include "host_sim/linux/kernel.hpp"

namespace spangle::sim {

class MpsseEngine : public PinHeader {
  public:
    static constexpr unsigned pins = 16; ///< ADBUS0 to 7, ACBUS0 to 7
    static constexpr unsigned clock_pin = 0, out_pin = 1, in_pin = 2, wait_pin = 5;

    /// Bits take time of this clock.
    explicit MpsseEngine(Kernel& clock) : clock_(clock) {}

    /// As when the mode is set: pins are inputs, clocks as at first. What waits in the buffers stays.
    void restart();
    void purge(bool stream, bool answers);
    void feed(const std::uint8_t* bytes, std::size_t count);
    /// At most `most` bytes of what the host may read now.
    std::vector<std::uint8_t> take_answers(std::size_t most);
    /// Time passes for a stream that waits for its pin.
    void idle();

    std::uint32_t clock_hz() const;
    std::uint64_t levels() const;
    /// What no SPI panel can make sense of.
    const std::string& violations() const { return violations_; }
    std::size_t longest_burst() const { return longest_burst_; }
    std::uint64_t bad_commands() const { return bad_commands_; }

  private:
    Kernel& clock_;
    std::vector<std::uint8_t> stream_; ///< not yet done
    std::vector<std::uint8_t> answers_;
    unsigned outputs_ = 0, values_ = 0;
    unsigned divisor_ = 0;
    bool full_base_ = false, loopback_ = true;
    std::size_t longest_burst_ = 0;
    std::uint64_t bad_commands_ = 0;
    std::string violations_;

    /// Bytes that the command at `at` takes, or 0: it must wait, for bytes or for its pin.
    std::size_t run(std::size_t at);
    void run_all();
    bool wait_for(bool high);
    std::size_t write_bytes(std::size_t at);
    void read_bytes(std::size_t at);
    std::uint8_t exchange(std::uint8_t out);
    void set_pins(unsigned shift, std::uint8_t values, std::uint8_t outputs);
    std::uint8_t get_pins(unsigned shift);
    void changed();
    void drive(unsigned pin, bool high);
    bool level(unsigned pin);
};

} // namespace spangle::sim
