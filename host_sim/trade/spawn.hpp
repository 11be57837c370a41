// Another program, run to its end, and what it said.
#pragma once

#include <string>
#include <vector>

namespace spangle::trade {

inline constexpr int no_program = 127, could_not_run = 126; ///< statuses, as shells have them

/// The status it ends with. `said`: its standard output, and behind that its standard error.
int spawn(const std::vector<std::string>& words, std::string& said);

} // namespace spangle::trade
