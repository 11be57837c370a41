// One run: a scene or a model, some frames, on a simulated board or off screen; with everything that was
// asked for.
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
    sim::Image picture;     ///< the last frame: the glass of a board, or the off-screen picture
    sim::Image difference;  ///< with --compare
    std::string violations; ///< rules the bus broke; none is normal
    std::string notes;      ///< what a model was drawn without
};

RunResult run(const RunOptions& options);

} // namespace spangle::cli
