// The report of a profile as one HTML page that needs no other file.
#pragma once

#include <string>

#include "host_sim/cli/profile_report.hpp"

namespace spangle::cli {

std::string to_page(const ProfileReport& report);

} // namespace spangle::cli
