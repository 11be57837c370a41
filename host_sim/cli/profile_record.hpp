// Records a program in the tiers of accuracy, and compares its pictures with those of the double reference.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host_sim/cli/profile.hpp"
#include "host_sim/profile/record.hpp"

namespace spangle::cli {

/// What a program asked for in one tier, and how far its pictures are from the reference.
struct TierRecord {
    std::string tier, picture_hash;
    profile::Record record;
    int frames = 0;
    double error = 0.0; ///< percent of pixels that differ in RGB565
    int max_lsb = 0;    ///< largest difference of a colour channel, in steps of RGB565
    double psnr_db = 99.0;
};

/// The name of what is recorded: that of the scene, or of the file.
std::string title_of(const ProfileOptions& options);

/// Records a scene or a model in this process; --dither becomes what the program set. Returns what went
/// wrong, or an empty string.
std::string record_drawn(ProfileOptions& options, std::vector<TierRecord>& out);

/// Records a trace, or a program of which a trace is made first. Each tier is a replay on the drop-in pair.
/// The option --trace becomes the recorded trace, which may lie in the folder.
std::string record_replayed(ProfileOptions& options, const std::filesystem::path& folder,
                            std::vector<TierRecord>& out);

} // namespace spangle::cli
