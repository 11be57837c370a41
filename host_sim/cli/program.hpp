// What is drawn, scene or model, as every command draws it.
#pragma once

#include <functional>
#include <string>

#include "host_sim/cli/model.hpp"
#include "host_sim/cli/options.hpp"
#include "host_sim/cli/session.hpp"

namespace spangle::cli {

struct Program {
    std::string name;
    std::function<void(int, int)> setup;
    std::function<void(int)> draw;
};

/// Finds what the options name; `model` keeps what is drawn of one. Empty, or what to do about it.
std::string make_program(const RunOptions& options, Model& model, Program& out);

/// Sets the program up in the session that is current.
void start(const Program& program, const Session& session, bool dither);

} // namespace spangle::cli
