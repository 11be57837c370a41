// The options that name a display, alike in every command that has them.
#pragma once

#include <CLI/CLI.hpp>

#include "host_sim/bringup/attach.hpp"

namespace spangle::cli {

/// What names the display: a simulated board, or a real one. `more` is added to what --board says of itself.
/// The option --board.
CLI::Option* add_bus_options(CLI::App& command, bringup::BusOptions& bus, const char* more = "");

} // namespace spangle::cli
