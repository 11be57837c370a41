// spangle probe, card and wizard: bring up a panel, simulated or real.
#pragma once

#include <string>

#include "host_sim/bringup/attach.hpp"

namespace spangle::cli {

struct BringupOptions {
    bringup::BusOptions bus;
    std::string wrong;       ///< card: the one setting that is made wrong
    std::string shot;        ///< file for a PNG of the simulated glass
    std::string glass;       ///< wizard: WIDTHxHEIGHT of the glass, pixels
    bool list_wrong = false; ///< card: prints the table of what can be wrong
};

/// Each prints what it found, or one line on standard error, and returns the exit status.
int probe(const BringupOptions& options);
int card(const BringupOptions& options);
int wizard(const BringupOptions& options);

} // namespace spangle::cli
