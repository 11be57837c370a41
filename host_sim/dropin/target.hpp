// What frames are sent to: a simulated board, a panel behind a real bus, or a display on USB; and what it was
// given.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <spangle/hal/display.hpp>
#include <spangle/sim/board.hpp>

#include "host_sim/bringup/attach.hpp"
#include "host_sim/bringup/counted_bus.hpp"
#include "host_sim/bringup/wizard.hpp"

namespace spangle::dropin {

class Target {
  public:
    /// Opens it and starts its display. Empty, or why not.
    std::string open(const bringup::BusOptions& bus, const hal::Board& board);
    /// A real one is let go: a display on USB goes dark. Figures and pictures were asked for before.
    void close();

    /// Null: none is open.
    hal::Display* display() const { return display_; }
    /// Null: it is real.
    const sim::SimBoard* simulated() const { return attached_.simulated.get(); }
    /// A figure a line, then the rules that a simulated bus saw broken.
    std::string figures() const;

  private:
    using Clock = std::chrono::steady_clock;

    bringup::Attached attached_;
    std::optional<bringup::CountedBus> counted_;
    std::optional<bringup::Stand> stand_; ///< of a real panel
    hal::Display* display_ = nullptr;
    Clock::time_point started_;
    sim::BoardCounters before_; ///< what starting the display took

    sim::BoardCounters counters() const;
};

} // namespace spangle::dropin
