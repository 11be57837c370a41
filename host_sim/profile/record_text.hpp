// A record as text, a line for each thing that was recorded: the drop-in pair writes it in the process of a
// program, and the command line reads it.
#pragma once

#include <string>

#include "host_sim/profile/record.hpp"

namespace spangle::profile {

std::string to_text(const Record& record);

/// Reads what to_text() wrote. Empty, or why the text is no record of this version.
std::string from_text(const std::string& text, Record& out);

} // namespace spangle::profile
