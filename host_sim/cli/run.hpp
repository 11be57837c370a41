// One run: a scene or a model, some frames, on a simulated board, a real display or off screen; with
// everything that was asked for.
#pragma once

#include <functional>
#include <string>

#include <spangle/sim/image.hpp>

#include "host_sim/cli/options.hpp"
#include "host_sim/cli/report.hpp"

namespace spangle::cli {

struct RunResult {
    std::string error; ///< empty on success: else one line that says what to do
    Report report;
    std::string unwritten; ///< empty: the dump of the wires is in its file, if one was asked for
    sim::Image picture;    ///< the last frame: the glass of a simulated board, or the picture as it was drawn
    sim::Image difference; ///< with --compare
    std::string violations; ///< rules the bus broke; none is normal
    std::string notes;      ///< what a model was drawn without
};

RunResult run(const RunOptions& options);

} // namespace spangle::cli
