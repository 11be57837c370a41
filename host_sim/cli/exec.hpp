// `spangle exec` and `spangle replay`: programs that others linked, drawn by the drop-in pair.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "host_sim/bringup/attach.hpp"

namespace spangle::cli {

struct ExecOptions {
    bringup::BusOptions bus; ///< the board, simulated or real; "none": no board
    std::string precision = "exact", size, format = "rgba", shot;
    long frames = 0;
    bool stats = false, json = false;
    std::vector<std::string> program; ///< and its arguments; of replay: the trace
};

CLI::App* add_exec(CLI::App& app, ExecOptions& options);
CLI::App* add_replay(CLI::App& app, ExecOptions& options);

/// Runs it to its end. The status to exit with: the program's own, where it began.
int exec(const ExecOptions& options);
int replay(ExecOptions options);

} // namespace spangle::cli
