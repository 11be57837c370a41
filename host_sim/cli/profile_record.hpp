// Records a program in the tiers of accuracy, and holds its pictures against those of the double reference.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host_sim/cli/profile.hpp"
#include "host_sim/profile/record.hpp"

namespace spangle::cli {

/// One tier: what the program asked for, and how far its pictures are from the reference.
struct Recorded {
    std::string tier, picture_hash;
    profile::Record record;
    int frames = 0;
    double error = 0.0; ///< percent of pixels that are other ones in RGB565
    int max_lsb = 0;    ///< largest difference of a channel, in steps of RGB565
    double psnr_db = 99.0;
};

/// What is recorded, as people call it: the scene, or the name of a file.
std::string title_of(const ProfileOptions& options);

/// A scene or a model, in this process; --dither becomes what the program set. Empty, or what went wrong.
std::string record_drawn(ProfileOptions& options, std::vector<Recorded>& out);

/// A trace, or a program of which a trace is made first; each tier is a replay on the drop-in pair. The
/// option
/// --trace becomes the trace that was recorded, which may lie in the folder.
std::string record_replayed(ProfileOptions& options, const std::filesystem::path& folder,
                            std::vector<Recorded>& out);

} // namespace spangle::cli
