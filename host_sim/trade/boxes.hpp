// Compares measured figures with what each tier promises.
#pragma once

#include <string>
#include <vector>

#include "host_sim/trade/table.hpp"

namespace spangle::trade {

/// A sentence for each promise that this row of accuracy.csv breaks. Promises are about undithered pictures.
/// A tier that the user composed promises its coverage and depth only.
std::vector<std::string> missed_boxes(const Table& table, const Table::Row& row);

} // namespace spangle::trade
