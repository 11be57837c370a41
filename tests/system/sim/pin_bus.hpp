// Bus drivers that move pins one by one, as firmware without an SPI or FSMC unit does. Some of them are wrong
// on purpose.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include <spangle/hal/bus.hpp>

#include "host_sim/bus/pins.hpp"

namespace sim_test {

using namespace spangle;
using sim::Time;

/// Carries out lists while they are submitted. Derived classes know how a byte is sent.
class PinBus : public hal::Bus {
  public:
    PinBus(sim::Controller& controller, const hal::BusCaps& caps) : controller_(controller), caps_(caps) {}
    virtual ~PinBus() = default;

    hal::BusCaps caps() const override { return caps_; }
    hal::Result<hal::Buffer> acquire(std::size_t size) override {
        buffers_.push_back(std::make_unique<std::uint8_t[]>(size));
        return hal::Buffer{buffers_.back().get(), size};
    }
    hal::Result<hal::Token> submit(const hal::Op* ops, std::size_t count) override {
        select(true);
        for (std::size_t i = 0; i < count; ++i)
            run(ops[i]);
        select(false);
        return hal::Token{++token_};
    }
    bool done(hal::Token) const override { return true; }
    hal::Result<void> wait(hal::Token, std::uint32_t) override { return {}; }

    Time now = 0;
    /// A deliberate mistake: D/C is set for the next byte while the last byte still has a clock to come, as
    /// in a driver that does not wait for its shifter or DMA.
    bool data_pin_early = false;

  protected:
    sim::Controller& controller_;

    Time write_period() const { return 1'000'000'000u / caps_.write_hz; }
    Time read_period() const { return 1'000'000'000u / caps_.read_hz; }
    virtual void select(bool on) = 0;
    virtual void reset(bool low) = 0;
    virtual void put(std::uint8_t byte, bool data, bool next_data) = 0;
    virtual void turn_round(int dummy_bits) = 0;
    virtual std::uint8_t get() = 0;

  private:
    hal::BusCaps caps_;
    std::vector<std::unique_ptr<std::uint8_t[]>> buffers_;
    std::uint32_t token_ = 0;

    void run(const hal::Op& op) {
        using Kind = hal::Op::Kind;
        switch (op.kind) {
        case Kind::command:
            put(op.command, false, op.length != 0 && !op.parameters_are_commands);
            for (std::uint32_t i = 0; i < op.length; ++i)
                put(op.data[i], !op.parameters_are_commands,
                    i + 1 < op.length && !op.parameters_are_commands);
            break;
        case Kind::pixels:
        case Kind::repeat:
            for (std::uint32_t row = 0; row < op.rows; ++row)
                for (std::uint32_t i = 0; i < op.length; ++i)
                    put(op.data[std::ptrdiff_t(row) * (op.kind == Kind::pixels ? op.stride : 0) + i], true,
                        true);
            break;
        case Kind::delay:
            now += Time(op.micros) * 1000;
            break;
        case Kind::wait_te:
            for (const Time end = now + Time(op.micros) * 1000; now < end && !controller_.te(now);)
                now += 1000;
            break;
        case Kind::wait_line: // presents on these buses follow no beam
            break;
        case Kind::read: // when CS rises the chip releases the line and counts bits from zero
            put(op.command, false, true);
            turn_round(op.dummy_bits);
            std::generate_n(op.into, op.length, [this] { return get(); });
            select(false);
            select(true);
            break;
        case Kind::reset:
            reset(true);
            now += Time(op.micros) * 1000;
            reset(false);
            break;
        }
    }
};

class SerialPinBus final : public PinBus {
  public:
    using PinBus::PinBus;
    sim::SerialPins& pins() { return pins_; }
    /// Switches from SPI mode 0 to mode 3, in which the clock rests high.
    void rest_high() {
        rests_high_ = true;
        pins_.set(Pin::clock, true, now);
    }

  private:
    using Pin = sim::SerialPins::Pin;
    sim::SerialPins pins_{controller_};
    bool rests_high_ = false;

    void select(bool on) override {
        now += 20;
        pins_.set(Pin::select, !on, now);
        now += 20;
    }
    void reset(bool low) override { pins_.set(Pin::reset, !low, now); }
    bool bit(bool out, Time period) {
        pins_.set(Pin::clock, false, now);
        pins_.set(Pin::mosi, out, now);
        now += period / 2;
        const bool in = pins_.miso();
        pins_.set(Pin::clock, true, now);
        now += period - period / 2;
        if (!rests_high_)
            pins_.set(Pin::clock, false, now);
        return in;
    }
    void put(std::uint8_t byte, bool data, bool next_data) override {
        pins_.set(Pin::data, data, now);
        for (int i = 7; i >= 0; --i) {
            if (i == 0 && data_pin_early)
                pins_.set(Pin::data, next_data, now);
            bit((byte >> i & 1) != 0, write_period());
        }
    }
    void turn_round(int dummy_bits) override {
        pins_.set(Pin::data, true, now);
        now += read_period(); // the clock line changes its level
        for (int i = 0; i < dummy_bits; ++i)
            bit(false, read_period());
    }
    std::uint8_t get() override {
        unsigned byte = 0;
        for (int i = 0; i < 8; ++i)
            byte = byte << 1 | (bit(false, read_period()) ? 1u : 0u);
        return static_cast<std::uint8_t>(byte);
    }
};

class ParallelPinBus final : public PinBus {
  public:
    using PinBus::PinBus;
    sim::ParallelPins& pins() { return pins_; }

  private:
    using Pin = sim::ParallelPins::Pin;
    sim::ParallelPins pins_{controller_};

    void select(bool on) override { pins_.set(Pin::select, !on, ++now); }
    void reset(bool low) override { pins_.set(Pin::reset, !low, now); }
    void put(std::uint8_t byte, bool data, bool next_data) override {
        pins_.set(Pin::data, data, now);
        pins_.set(Pin::write, false, now);
        pins_.drive(byte);
        now += write_period() / 2;
        if (data_pin_early)
            pins_.set(Pin::data, next_data, now);
        pins_.set(Pin::write, true, now);
        now += write_period() - write_period() / 2;
    }
    void turn_round(int dummy_bits) override {
        pins_.set(Pin::data, true, now);
        for (int i = 0; i < dummy_bits / 8; ++i)
            get();
    }
    std::uint8_t get() override {
        pins_.set(Pin::read, false, now);
        now += read_period() - read_period() / 2;
        const std::uint8_t byte = pins_.answer();
        pins_.set(Pin::read, true, now);
        now += read_period() / 2;
        return byte;
    }
};

} // namespace sim_test
