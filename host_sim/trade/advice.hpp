// Advice in words on which tier to choose, from the numbers of a sweep.
#pragma once

#include <string>
#include <vector>

#include "host_sim/trade/table.hpp"

namespace spangle::trade {

/// Advice for one program in one format.
struct Advice {
    std::string scene, format;
    std::string take; ///< name of a tier
    std::string why;  ///< the reason, in a sentence or two
};

/// Advice for each job of accuracy.csv; cost.csv may lack rows, or all of them.
std::vector<Advice> advise(const Table& accuracy, const Table& cost);

/// The row of `table` with that job and tier, or null.
const Table::Row* find_row(const Table& table, const std::string& job, const std::string& tier);

} // namespace spangle::trade
