// A bus of microcontrollers: the peripheral moves each piece by DMA, and its interrupts carry a list from one
// operation to the next while the program draws.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include <spangle/hal/bus.hpp>
#include <spangle/hal/bus_memory.hpp>

namespace spangle::hal {

/// One SPI or 8080 block with its DMA channel, timer and lines, as a board's port makes it. `write`, `read`,
/// `pause` and `wait_te` start something and return; when it is over, an interrupt calls DmaBus::step(),
/// never the call itself. The bytes stay where they are until then.
class DmaPort {
  public:
    /// A write is over when its last bit is on the wire: D/C may change then.
    virtual void write(bool data, const std::uint8_t* bytes, std::uint32_t count) = 0;
    /// Reads `count` bytes of an answer into `into`, behind `dummy_bits` clocks.
    virtual void read(std::uint8_t dummy_bits, std::uint8_t* into, std::uint32_t count) = 0;
    /// Lets at least `micros` microseconds pass.
    virtual void pause(std::uint32_t micros) = 0;
    /// Waits for the edge, and ends with step(Fault::none); or after `at_most_micros`, with
    /// step(Fault::timeout).
    virtual void wait_te(std::uint32_t at_most_micros) = 0;

    /// Lowers chip select, or raises it. This call and those below are done when they return.
    virtual void select(bool selected) = 0;
    /// Drives the reset line low, or high.
    virtual void reset(bool low) = 0;
    virtual std::uint32_t micros() = 0; ///< microseconds, which wrap at 2^32
    virtual void sleep() {}             ///< sleeps until an interrupt, or not at all

  protected:
    ~DmaPort() = default;
};

/// Memory that the port's DMA reaches, for buffers and for one list.
struct DmaMemory {
    /// Memory of the buffers, aligned to DmaBus::alignment.
    std::uint8_t* bytes = nullptr;
    /// Bytes of the memory of the buffers.
    std::size_t size = 0;
    /// Memory for the list under way.
    Op* ops = nullptr;
    /// The longest list that the bus takes, in operations.
    std::size_t op_count = 0;
};

/// A Bus over a DmaPort. Lists longer than DmaMemory::op_count are refused with
/// Fault::bad_argument.
class DmaBus final : public Bus {
  public:
    /// Where buffers begin: at multiples of so many bytes.
    static constexpr std::size_t alignment = BusMemory::alignment;

    /// `port` and what `memory` points to must outlive the bus. It starts nothing.
    DmaBus(DmaPort& port, const BusCaps& caps, const DmaMemory& memory)
        : port_(port), caps_(caps), memory_(memory), buffers_({memory.bytes, memory.size}) {}

    BusCaps caps() const override { return caps_; }
    Result<Buffer> acquire(std::size_t size) override { return buffers_.take(size); }
    Result<Token> submit(const Op* ops, std::size_t count) override;
    bool done(Token token) const override;
    Result<void> wait(Token token, std::uint32_t timeout_micros) override;

    /// Called from the port's interrupt: what was started is done, or failed.
    void step(Fault fault = Fault::none);

  private:
    bool start_part(const Op& op);
    bool start_pixels(const Op& op);
    bool start_repeat(const Op& op);
    bool start_wait_line(const Op& op);
    void write(bool data, const std::uint8_t* bytes, std::uint32_t count);
    void end(Fault fault);

    DmaPort& port_;
    BusCaps caps_;
    DmaMemory memory_;
    BusMemory buffers_;

    // The list under way. The interrupt owns the following members while `running_`.
    std::size_t count_ = 0, at_ = 0;
    std::uint32_t part_ = 0;  ///< number of parts of the current operation that were started
    std::uint32_t since_ = 0; ///< time in microseconds at which a wait_line began
    std::uint8_t answer_[2] = {}, pattern_[48] = {};
    Fault outcome_ = Fault::none;

    std::uint32_t last_token_ = 0;
    std::atomic<bool> running_ = false;
};

} // namespace spangle::hal
