// Reports what a recorded program asks for and what its profile holds, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "host_sim/cli/profile_record.hpp"
#include "host_sim/profile/emit.hpp"

namespace spangle::cli {

struct ProfileReport {
    std::string title;
    const std::vector<TierRecord>* all;
    const TierRecord* chosen; ///< the element of `all` that the profile is made for
    const profile::Profile* made;
    nlohmann::json firmware; ///< figures of both builds on the emulated board
                             ///< (host_sim/profile/firmware/measure.py); null: not measured
};

nlohmann::json to_json(const ProfileReport& report);
std::string to_text(const ProfileReport& report);

} // namespace spangle::cli
