// Programs that others linked, as `spangle trade` measures them: traces, drawn by a retracer on the drop-in
// pair.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host_sim/trade/recording.hpp"

namespace spangle::cli {

/// A trace of apitrace. Empty, or why there is none.
std::string open_trace(const std::string& file, std::shared_ptr<trade::Recording>& out);

/// A program and its arguments, which is run once, when it is first drawn: what it draws by the clock is the
/// same then in every tier. `out` draws the trace of that run.
std::string open_program(const std::vector<std::string>& words, std::shared_ptr<trade::Recording>& out);

} // namespace spangle::cli
