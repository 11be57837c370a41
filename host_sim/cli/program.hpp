// What is drawn, scene or model, as every command draws it.
#pragma once

#include <string>

#include "host_sim/cli/model.hpp"
#include "host_sim/cli/options.hpp"
#include "host_sim/cli/session.hpp"
#include "host_sim/trade/program.hpp"

namespace spangle::cli {

using trade::Program;

/// Finds what the options name; `model` keeps what is drawn of one. Empty, or what to do about it.
std::string make_program(const RunOptions& options, Model& model, Program& out);

/// Sets the program up in the session that is current.
void start(const Program& program, const Session& session, bool dither);

} // namespace spangle::cli
