// A simulated display of any kind: a panel behind a bus, or memory that is scanned.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <spangle/hal/board.hpp>
#include <spangle/hal/mapped_display.hpp>
#include <spangle/sim/image.hpp>

namespace spangle::sim {

class Desk {
  public:
    virtual ~Desk() = default;
    virtual hal::Display& display() = 0;
    virtual Image glass() = 0;
    /// The rules of the bus that were broken, a line each.
    virtual std::string violations() const { return ""; }
};

std::unique_ptr<Desk> make_desk(const hal::Board& board);
/// The display has two buffers of its own.
std::unique_ptr<Desk> make_desk(const hal::MappedConfig& config);

} // namespace spangle::sim
