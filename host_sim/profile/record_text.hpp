// A record as text, with a line for each thing that was recorded. The drop-in pair writes the text in the
// process of a program, and the command line reads it.
#pragma once

#include <string>

#include "host_sim/profile/record.hpp"

namespace spangle::profile {

std::string to_text(const Record& record);

/// Reads what to_text() wrote. Returns why the text is no record of this version, or an empty string.
std::string from_text(const std::string& text, Record& out);

} // namespace spangle::profile
