// The program as firmware for an emulated Cortex-M4: the whole library held against the profile.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "host_sim/cli/profile_record.hpp"

namespace spangle::cli {

/// Runs host_sim/profile/firmware/measure.py; `out` is the object that it prints. Of a scene everything is
/// measured; of what has no source here, the size of an image that holds its commands. Empty, or what went
/// wrong.
std::string measure_firmware(const ProfileOptions& options, const Recorded& chosen, nlohmann::json& out);

} // namespace spangle::cli
