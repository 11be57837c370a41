// One HTML file that needs no other: plots, advice, the table, and pictures with a slider between tiers.
#pragma once

#include <string>

#include "host_sim/trade/table.hpp"

namespace spangle::trade {

/// Names of the files in a folder of results.
std::string picture_name(const std::string& job, const std::string& what);
inline constexpr const char *accuracy_file = "/accuracy.csv", *cost_file = "/cost.csv",
                            *page_file = "/index.html", *picture_folder = "/pictures";

/// Writes the page of a folder that has the pictures. Returns what went wrong, or an empty string; `note`
/// says what the page lacks.
std::string write_page(const std::string& folder, const Table& accuracy, const Table& cost,
                       std::string& note);

} // namespace spangle::trade
