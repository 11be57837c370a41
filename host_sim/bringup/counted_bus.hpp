// Counts what a real bus is given, as a simulated bus counts it at its wires.
#pragma once

#include <cstdint>

#include <spangle/hal/bus.hpp>

namespace spangle::bringup {

class CountedBus final : public hal::Bus {
  public:
    explicit CountedBus(hal::Bus& bus) : bus_(bus) {}

    std::uint64_t bytes() const { return bytes_; }
    std::uint64_t commands() const { return commands_; }
    std::uint64_t pixel_bytes() const { return pixel_bytes_; }

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
    std::uint64_t bytes_ = 0, commands_ = 0, pixel_bytes_ = 0;

    void note(const hal::Op& op) {
        using Kind = hal::Op::Kind;
        const bool command = op.kind == Kind::command || op.kind == Kind::read || op.kind == Kind::wait_line;
        if (command)
            ++commands_, ++bytes_;
        if (op.kind == Kind::command)
            bytes_ += op.length;
        const bool pixels = op.kind == Kind::pixels || op.kind == Kind::repeat;
        const std::uint64_t sent = pixels ? std::uint64_t{op.length} * op.rows : 0;
        bytes_ += sent;
        pixel_bytes_ += sent;
    }
};

} // namespace spangle::bringup
