// The program as firmware for an emulated Cortex-M4: the whole library held against the profile.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "host_sim/cli/profile_record.hpp"

namespace spangle::cli {

/// Runs host_sim/profile/firmware/measure.py, with files of its own in the folder; `out` is the object that
/// it prints. Scenes and models are measured as they are, and traces as programs that make the same calls. Of
/// a trace that firmware cannot replay the size is measured of an image that holds its commands. Empty, or
/// what went wrong.
std::string measure_firmware(const ProfileOptions& options, const Recorded& chosen,
                             const std::filesystem::path& folder, nlohmann::json& out);

} // namespace spangle::cli
