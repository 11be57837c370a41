// `spangle exec` and `spangle replay`: run programs that others linked, for which the drop-in pair draws.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "host_sim/bringup/attach.hpp"

namespace spangle::cli {

struct ExecOptions {
    bringup::BusOptions bus; ///< the board to show frames on, simulated or real; "none": no board
    std::string precision = "exact", size, format = "rgba", shot;
    long frames = 0;
    bool stats = false, json = false;
    std::vector<std::string> program; ///< the program and its arguments; of replay: the trace
};

CLI::App* add_exec(CLI::App& app, ExecOptions& options);
CLI::App* add_replay(CLI::App& app, ExecOptions& options);

/// Runs the program to its end. Returns the exit status, which is the program's own if it began.
int exec(const ExecOptions& options);
int replay(ExecOptions options);

} // namespace spangle::cli
