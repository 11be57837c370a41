// spangle probe, card and wizard: bringing up a panel, simulated or real.
#pragma once

#include <string>

#include "host_sim/bringup/attach.hpp"

namespace spangle::cli {

struct BringupOptions {
    bringup::BusOptions bus;
    std::string wrong;       ///< card: one setting that is not as it should be
    std::string shot;        ///< PNG of the simulated glass
    std::string glass;       ///< wizard: WIDTHxHEIGHT of the glass
    bool list_wrong = false; ///< card: the table of what can be wrong
};

/// Each prints what it found, or one line on standard error: the exit status.
int probe(const BringupOptions& options);
int card(const BringupOptions& options);
int wizard(const BringupOptions& options);

} // namespace spangle::cli
