// What a run draws on: a simulated board, a real panel, a display on USB, or a picture off screen; and what
// that counted.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include <spangle/hal/panel_display.hpp>
#include <spangle/sim/board.hpp>

#include "host_sim/bringup/attach.hpp"
#include "host_sim/bringup/counted_bus.hpp"
#include "host_sim/bringup/wizard.hpp"
#include "host_sim/cli/options.hpp"
#include "host_sim/cli/report.hpp"
#include "host_sim/cli/session.hpp"
#include "host_sim/cli/whole_frames.hpp"

namespace spangle::cli {

class Screen {
  public:
    /// Finds what the options name, and opens a session on it. Empty, or what to do about it.
    std::string open(const RunOptions& options, Session& session);

    /// Null: real, or off screen.
    sim::SimBoard* simulated() { return attached_.simulated.get(); }
    /// Frames are presented; else they are drawn only.
    bool presents() const { return display_ != nullptr; }
    /// Counts and clocks begin here.
    void start();
    /// Everything that was presented is shown. Empty, or why not.
    std::string finish();
    /// What is told of it, after finish().
    void describe(const RunOptions& options, const Session& session, Report& report) const;

  private:
    using Clock = std::chrono::steady_clock;
    struct Counts {
        std::uint64_t bytes = 0, commands = 0, pixel_bytes = 0;
        sim::Time busy_ns = 0, now = 0;
    };

    bringup::Attached attached_;
    std::optional<bringup::CountedBus> counted_;
    std::optional<bringup::Stand> stand_; ///< of a real panel
    std::optional<WholeFrames> whole_;    ///< where this build does not tell what was drawn
    hal::Display* display_ = nullptr;
    Counts before_;
    Clock::time_point started_, finished_;

    Counts counts() const;
    bool real() const { return !attached_.where.empty(); }
    std::string open_display(const RunOptions& options);
};

} // namespace spangle::cli
