// Programs that others linked, as `spangle trade` measures them: a retracer draws their traces on the drop-in
// pair.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host_sim/trade/recording.hpp"

namespace spangle::cli {

/// Opens a trace of apitrace. Returns what went wrong, or an empty string.
std::string open_trace(const std::string& file, std::shared_ptr<trade::Recording>& out);

/// Takes a program and its arguments. The program runs once, when it is first drawn; `out` draws the trace of
/// that run. So drawing that depends on the clock is the same in every tier.
std::string open_program(const std::vector<std::string>& words, std::shared_ptr<trade::Recording>& out);

} // namespace spangle::cli
