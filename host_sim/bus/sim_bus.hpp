// A hal::Bus whose wires end in a model of a controller, in virtual time. The clocks of processor and wire
// run apart, so that a transfer can be under way while the next frame is drawn.
#pragma once

#include <memory>
#include <vector>

#include <spangle/hal/bus.hpp>

#include "host_sim/bus/i2c_target.hpp"
#include "host_sim/bus/trace.hpp"
#include "host_sim/controller/controller.hpp"

namespace spangle::sim {

struct BusCounters {
    std::uint64_t bytes = 0; ///< bytes on the bus, commands included
    std::uint64_t commands = 0;
    std::uint64_t pixel_bytes = 0;
    std::uint64_t transfers = 0;
    Time busy_ns = 0; ///< ns in which the wire was in use, without delays and waits
};

class SimBus final : public hal::Bus {
  public:
    SimBus(Controller& controller, const hal::BusCaps& caps);

    hal::BusCaps caps() const override { return caps_; }
    hal::Result<hal::Buffer> acquire(std::size_t size) override;
    hal::Result<hal::Token> submit(const hal::Op* ops, std::size_t count) override;
    bool done(hal::Token token) const override;
    hal::Result<void> wait(hal::Token token, std::uint32_t timeout_micros) override;

    const BusCounters& counters() const { return counters_; }
    Time now() const { return now_; }
    /// Lets time pass in which the processor does something else, mostly drawing.
    void pass(Time ns) { now_ += ns; }
    /// Lets time pass until the wire has nothing left to carry.
    void settle() { now_ = wire_end_ > now_ ? wire_end_ : now_; }
    void listen(Listener* listener) { listener_ = listener; }

    /// Makes the next transfer fail this way; short_write loses its second half.
    void fail_next(hal::Fault fault) { next_fault_ = fault; }
    /// Makes the wire lose byte `n`, counted from now.
    void drop_byte(std::uint64_t n) { drop_at_ = counters_.bytes + n; }

  private:
    struct WatchedBuffer {
        const std::uint8_t* data;
        std::uint32_t length, rows;
        std::int32_t stride;
        std::uint64_t checksum;
    };

    Controller& controller_;
    I2cTarget target_{controller_};
    hal::BusCaps caps_;
    std::vector<std::unique_ptr<std::uint8_t[]>> buffers_;
    BusCounters counters_;
    Listener* listener_ = nullptr;
    Time now_ = 0, wire_end_ = 0; ///< ns: the processor's time; end of what the wire was given
    Time owed_wire_time_ = 0;     ///< time of the wire not yet passed, in units of 1 ns / write_hz
    std::uint32_t last_token_ = 0;
    Time token_end_ = 0;
    std::vector<WatchedBuffer> watched_buffers_;
    hal::Fault next_fault_ = hal::Fault::none;
    std::uint64_t drop_at_ = ~std::uint64_t{0};
    bool is_in_message_ = false, message_is_data_ = false;
    bool is_unacknowledged_ = false; ///< no target acknowledged an address

    /// Period of SCK, WRX or SCL in ns; an I2C byte takes a ninth clock for its acknowledge.
    unsigned period_ns() const {
        const std::uint64_t second = is_i2c() ? 1'000'000'000ull * 8 / 9 : 1'000'000'000ull;
        return static_cast<unsigned>((second + caps_.write_hz / 2) / caps_.write_hz);
    }
    bool is_i2c() const { return caps_.kind == hal::BusKind::i2c; }
    /// Whether bytes travel in messages that begin with a byte in the place of D/C.
    bool is_framed() const { return is_i2c() || caps_.kind == hal::BusKind::spi_start; }
    void send(std::uint8_t byte, bool data);
    bool carry(std::uint8_t byte, bool data);
    void chip_select(bool selected);
    void begin_message(bool data);
    void end_message();
    void send_condition(void (Listener::*which)(Time, unsigned));
    void run(const hal::Op& op);
    void read(const hal::Op& op);
    void wait_line(const hal::Op& op);
    void wait_te(const hal::Op& op);
    static std::uint64_t checksum(const WatchedBuffer& w);
};

} // namespace spangle::sim
