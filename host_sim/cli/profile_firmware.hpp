// Measures the program as firmware for an emulated Cortex-M4, with the whole library and with the profile.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "host_sim/cli/profile_record.hpp"

namespace spangle::cli {

/// Runs host_sim/profile/firmware/measure.py, which keeps its own files in the folder; `out` is the object
/// that it prints. Scenes and models are measured as they are, and traces as programs that make the same
/// calls. If firmware cannot replay a trace, only the size of an image with its commands is measured. Returns
/// what went wrong, or an empty string.
std::string measure_firmware(const ProfileOptions& options, const TierRecord& chosen,
                             const std::filesystem::path& folder, nlohmann::json& out);

} // namespace spangle::cli
