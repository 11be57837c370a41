// A model of FTDI's Multi-Protocol Synchronous Serial Engine, which turns a stream of bytes into levels of
// sixteen pins and answers. It knows the part of FTDI's AN_108 that SPI in mode 0 takes, and answers other
// commands as bad ones.
#pragma once

#include <string>
#include <vector>

#include "host_sim/bus/pin_header.hpp"
#include "host_sim/linux/kernel.hpp"

namespace spangle::sim {

class MpsseEngine : public PinHeader {
  public:
    static constexpr unsigned pins = 16; ///< number of pins: ADBUS0 to 7, ACBUS0 to 7
    static constexpr unsigned clock_pin = 0, out_pin = 1, in_pin = 2, wait_pin = 5;

    /// `clock` is the clock on which bits take time.
    explicit MpsseEngine(Kernel& clock) : kernel_(clock) {}

    /// Starts the engine as when its mode is set: pins are inputs, and clocks have their first rates. Bytes
    /// that wait in the buffers stay.
    void restart();
    void purge_buffers(bool stream, bool answers);
    void feed(const std::uint8_t* bytes, std::size_t count);
    /// Takes at most `most` bytes of the answers that the host may read now.
    std::vector<std::uint8_t> take_answers(std::size_t most);
    /// Lets a stream that waits for its pin look again.
    void retry_waiting_stream();

    std::uint32_t clock_hz() const;
    std::uint64_t levels() const;
    /// Sequences that no SPI panel can understand, one a line.
    const std::string& violations() const { return violations_; }
    std::size_t longest_burst() const { return longest_burst_; }
    std::uint64_t bad_commands() const { return bad_commands_; }

  private:
    Kernel& kernel_;
    std::vector<std::uint8_t> pending_commands_; ///< bytes of commands that were not executed yet
    std::vector<std::uint8_t> answers_;
    unsigned output_mask_ = 0, pin_values_ = 0;
    unsigned divisor_ = 0;
    bool is_60_mhz_ = false, has_loopback_ = true;
    std::size_t longest_burst_ = 0;
    std::uint64_t bad_commands_ = 0;
    std::string violations_;

    /// Runs the command at `at` and returns the number of its bytes. Returns 0 if it must wait, for bytes or
    /// for its pin.
    std::size_t run(std::size_t at);
    void run_all();
    bool wait_for(bool high);
    std::size_t write_bytes(std::size_t at);
    void read_bytes(std::size_t at);
    std::uint8_t exchange_byte(std::uint8_t out);
    void set_pins(unsigned shift, std::uint8_t values, std::uint8_t outputs);
    std::uint8_t get_pins(unsigned shift);
    void changed();
    void drive(unsigned pin, bool high);
    bool level(unsigned pin);
};

} // namespace spangle::sim
