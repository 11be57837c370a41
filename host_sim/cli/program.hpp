// Finds the scene or model that a command draws, so that all commands draw it alike.
#pragma once

#include <string>

#include "host_sim/cli/model.hpp"
#include "host_sim/cli/options.hpp"
#include "host_sim/cli/session.hpp"
#include "host_sim/trade/program.hpp"

namespace spangle::cli {

using trade::Program;

/// Finds the program that the options name. `model` keeps the model that `out` draws, if there is one.
/// Returns what to do about a problem, or an empty string.
std::string make_program(const RunOptions& options, Model& model, Program& out);

/// Sets the program up in the session that is current, and switches dithering.
void start(const Program& program, const Session& session, bool dither);

} // namespace spangle::cli
