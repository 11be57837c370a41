// What can be wrong in the description of a panel, one thing at a time, for pictures of how each looks.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include <spangle/hal/bus.hpp>

#include "host_sim/bringup/wizard.hpp"

namespace spangle::bringup {

/// The faults that the wires of a panel can have.
enum class Line : std::uint8_t { sound, no_data_command, too_fast };

struct Wrong {
    const char* name;
    const char* fix; ///< what mends the fault
    void (*spoil)(Guess& guess);
    bool swapped = false; ///< the bytes of each pixel are exchanged
    Line line = Line::sound;
};

inline constexpr Wrong nothing_wrong = {"", "nothing", [](Guess&) {}};

/// A bus whose wires are not sound. Either D/C stays low, so that pixels become commands; or the clock is
/// faster than the panel takes, so that some bytes of the pixels are lost.
class SpoiltBus final : public hal::Bus {
  public:
    SpoiltBus(hal::Bus& bus, Line line) : bus_(bus), line_(line) {}

    hal::BusCaps caps() const override { return bus_.caps(); }
    hal::Result<hal::Buffer> acquire(std::size_t size) override { return bus_.acquire(size); }
    hal::Result<hal::Token> submit(const hal::Op* ops, std::size_t count) override;
    bool done(hal::Token token) const override { return bus_.done(token); }
    hal::Result<void> wait(hal::Token token, std::uint32_t micros) override {
        return bus_.wait(token, micros);
    }

  private:
    void drop_pixels(const hal::Op& op);
    void change_operation(const hal::Op& op);

    hal::Bus& bus_;
    Line line_;
    std::uint32_t noise_state_ = 1;
    std::vector<hal::Op> ops_;
    std::deque<std::vector<std::uint8_t>> changed_bytes_; ///< data of the changed operations
};

std::span<const Wrong> wrongs();
const Wrong* find_wrong(const std::string& name);

} // namespace spangle::bringup
