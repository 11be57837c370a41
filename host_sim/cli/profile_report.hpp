// What a recorded program asks for, and what its profile is: for people, and for programs.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "host_sim/cli/profile_record.hpp"
#include "host_sim/profile/emit.hpp"

namespace spangle::cli {

struct ProfileReport {
    std::string title;
    const std::vector<Recorded>* all;
    const Recorded* chosen; ///< of them, the profile's
    const profile::Profile* made;
    nlohmann::json firmware; ///< of the two builds on the emulated board
                             ///< (host_sim/profile/firmware/measure.py); null: none
};

nlohmann::json to_json(const ProfileReport& report);
std::string to_text(const ProfileReport& report);

} // namespace spangle::cli
