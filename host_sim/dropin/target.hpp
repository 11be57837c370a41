// The display that frames are sent to: a simulated board, a panel behind a real bus, or a display on USB. It
// counts what the display was sent.
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
    /// Opens the target and starts its display. Returns what went wrong, or an empty string.
    std::string open(const bringup::BusOptions& bus, const hal::Board& board);
    /// Releases a real display; a display on USB goes dark. Figures and pictures must be asked for before.
    void close();

    /// The display; null while none is open.
    hal::Display* display() const { return display_; }
    /// The simulated board; null for a real display.
    const sim::SimBoard* simulated() const { return attachment_.simulated.get(); }
    /// The figures of the run, one a line, then the rules that a simulated bus saw broken.
    std::string figures() const;

  private:
    using Clock = std::chrono::steady_clock;

    bringup::Attachment attachment_;
    std::optional<bringup::CountedBus> counted_bus_;
    std::optional<bringup::RealPanel> real_panel_; ///< the display of a real panel
    hal::Display* display_ = nullptr;
    Clock::time_point started_;
    sim::BoardCounters before_; ///< counters after the display was started

    sim::BoardCounters counters() const;
};

} // namespace spangle::dropin
