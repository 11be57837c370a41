// The target of a run: a simulated board, a real panel, a display on USB, or a picture off screen. It also
// counts the bytes that were sent to it.
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
    /// Finds what the options name, and opens a session on it. Returns what to do about a problem, or an
    /// empty string.
    std::string open(const RunOptions& options, Session& session);

    /// The simulated board; null for a real display, and off screen.
    sim::SimBoard* simulated() { return attachment_.simulated.get(); }
    /// Whether frames are presented; off screen they are only drawn.
    bool presents() const { return display_ != nullptr; }
    /// Starts the counters and clocks.
    void start();
    /// Waits until everything that was presented is shown. Returns what went wrong, or an empty string.
    std::string finish();
    /// Fills the report with what was counted; call it after finish().
    void describe(const RunOptions& options, const Session& session, Report& report) const;

  private:
    using Clock = std::chrono::steady_clock;
    struct Counts {
        std::uint64_t bytes = 0, commands = 0, pixel_bytes = 0;
        sim::Time busy_ns = 0, now = 0;
    };

    bringup::Attachment attachment_;
    std::optional<bringup::CountedBus> counted_bus_;
    std::optional<bringup::RealPanel> real_panel_; ///< the display of a real panel
    std::optional<WholeFrames> whole_frames_;      ///< presents whole frames, if the build tells no damage
    hal::Display* display_ = nullptr;
    Counts counts_before_;
    Clock::time_point start_time_, finish_time_;

    Counts read_counts() const;
    bool real() const { return !attachment_.where.empty(); }
    std::string open_display(const RunOptions& options);
};

} // namespace spangle::cli
