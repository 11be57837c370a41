// Runs a scene or a model for some frames, on a simulated board, on a real display or off screen. Reports the
// figures that the options ask for.
#pragma once

#include <functional>
#include <string>

#include <spangle/sim/image.hpp>

#include "host_sim/cli/options.hpp"
#include "host_sim/cli/report.hpp"

namespace spangle::cli {

struct RunResult {
    std::string error; ///< empty on success, else one line that says what to do
    Report report;
    /// Why the dump of the wires is not in its file; empty if it is, or if none was asked for.
    std::string unwritten;
    sim::Image picture;     ///< the last frame: the glass of a simulated board, or the picture as drawn
    sim::Image difference;  ///< with --compare: what differs from the reference
    std::string violations; ///< rules that the bus broke; normally empty
    std::string notes;      ///< parts of a model that were left out
};

RunResult run(const RunOptions& options);

} // namespace spangle::cli
