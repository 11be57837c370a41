// A bus without interrupts: submit() returns when the last byte is on the [wire](docs/glossary.md#wire). The
// simplest thing that works on a new microcontroller. With DmaBus a program can draw while it sends.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/bus.hpp>
#include <spangle/hal/bus_memory.hpp>

namespace spangle::hal {

/// One SPI, 8080 or I2C block and the lines beside it, as a board wires them. Every call returns when it is
/// done, or with the fault it ended with.
class PolledPort {
  public:
    /// Says that commands or data follow, until the next begin() or end(). It does so by chip select and the
    /// D/C line, by a start byte behind chip select, or by an I2C message and its control byte.
    virtual Fault begin(bool data) = 0;
    /// Writes `count` bytes, which are data or commands as begin() has said.
    virtual Fault write(const std::uint8_t* bytes, std::uint32_t count) = 0;
    /// Reads the answer to a command of the same message.
    virtual Fault read(std::uint8_t dummy_bits, std::uint8_t* into, std::uint32_t count) = 0;
    /// Ends the message after its last bit: chip select rises, or STOP.
    virtual void end() = 0;
    /// Drives the reset line low, or high.
    virtual void reset(bool low) = 0;
    /// Lets at least `micros` microseconds pass.
    virtual void pause(std::uint32_t micros) = 0;

  protected:
    ~PolledPort() = default;
};

/// Makes a PolledPort of a type whose functions have these names and are not virtual. FrameDisplay calls such
/// a type itself.
template <class Wires> class PolledPortOf final : public PolledPort, public Wires {
  public:
    using Wires::Wires;

    Fault begin(bool data) override { return Wires::begin(data); }
    Fault write(const std::uint8_t* bytes, std::uint32_t count) override {
        return Wires::write(bytes, count);
    }
    Fault read(std::uint8_t dummy_bits, std::uint8_t* into, std::uint32_t count) override {
        return Wires::read(dummy_bits, into, count);
    }
    void end() override { Wires::end(); }
    void reset(bool low) override { Wires::reset(low); }
    void pause(std::uint32_t micros) override { Wires::pause(micros); }
};

/// A Bus over a PolledPort.
class PolledBus final : public Bus {
  public:
    /// `port` and `memory` must outlive the bus. It starts nothing.
    PolledBus(PolledPort& port, const BusCaps& caps, Buffer memory)
        : port_(port), caps_(caps), buffers_(memory) {}

    BusCaps caps() const override { return caps_; }
    Result<Buffer> acquire(std::size_t size) override { return buffers_.take(size); }
    /// A list that fails half-way ends there, and wait() returns the fault.
    Result<Token> submit(const Op* ops, std::size_t count) override;
    bool done(Token) const override { return true; }
    Result<void> wait(Token token, std::uint32_t timeout_micros) override;

    /// The number of bytes of commands, parameters and pixels sent so far, modulo 2^32.
    std::uint32_t bytes() const { return bytes_; }

  private:
    Fault run(const Op& op);
    Fault send(bool data, const std::uint8_t* bytes, std::uint32_t count);
    Fault send_pixels(const Op& op);
    Fault send_repeat(const Op& op);
    Fault read(const Op& op);
    void end_message();

    PolledPort& port_;
    BusCaps caps_;
    BusMemory buffers_;
    bool open_ = false, data_ = false; ///< true: a message is under way; true: it carries data
    std::uint32_t last_token_ = 0;
    std::uint32_t bytes_ = 0;
    Fault outcome_ = Fault::none; ///< outcome of the last list
};

} // namespace spangle::hal
