// The options that name a display, which are the same for every command that has them.
#pragma once

#include <CLI/CLI.hpp>

#include "host_sim/bringup/attach.hpp"

namespace spangle::cli {

/// Adds the options that name a display, simulated or real. `more` is appended to the help text of --board.
/// Returns the option --board.
CLI::Option* add_bus_options(CLI::App& command, bringup::BusOptions& bus, const char* more = "");

} // namespace spangle::cli
