// Counts what a real bus is given, as a simulated bus counts it at its wires.
#pragma once

#include <cstdint>

#include <spangle/hal/bus.hpp>

namespace spangle::bringup {

class CountedBus final : public hal::Bus {
  public:
    explicit CountedBus(hal::Bus& bus) : bus_(bus) {}

    std::uint64_t bytes() const { return byte_count_; }
    std::uint64_t commands() const { return command_count_; }
    std::uint64_t pixel_bytes() const { return pixel_byte_count_; }

    hal::BusCaps caps() const override { return bus_.caps(); }
    hal::Result<hal::Buffer> acquire(std::size_t size) override { return bus_.acquire(size); }
    hal::Result<hal::Token> submit(const hal::Op* ops, std::size_t count) override {
        const auto token = bus_.submit(ops, count);
        for (std::size_t i = 0; token.ok() && i < count; ++i)
            note(ops[i]);
        return token;
    }
    bool done(hal::Token token) const override { return bus_.done(token); }
    hal::Result<void> wait(hal::Token token, std::uint32_t micros) override {
        return bus_.wait(token, micros);
    }

  private:
    hal::Bus& bus_;
    std::uint64_t byte_count_ = 0, command_count_ = 0, pixel_byte_count_ = 0;

    void note(const hal::Op& op) {
        using Kind = hal::Op::Kind;
        const bool command = op.kind == Kind::command || op.kind == Kind::read || op.kind == Kind::wait_line;
        if (command)
            ++command_count_, ++byte_count_;
        if (op.kind == Kind::command)
            byte_count_ += op.length;
        const bool pixels = op.kind == Kind::pixels || op.kind == Kind::repeat;
        const std::uint64_t sent = pixels ? std::uint64_t{op.length} * op.rows : 0;
        byte_count_ += sent;
        pixel_byte_count_ += sent;
    }
};

} // namespace spangle::bringup
