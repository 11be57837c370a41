// A record as the profile of a build: the settings of cmake/Features.cmake and cmake/Limits.cmake, and the
// list of fused spans.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host_sim/profile/record.hpp"

namespace spangle::profile {

struct Choice {
    std::string title;       ///< what was recorded, for the first line
    std::string list;        ///< the file of the fused spans, as the profile names it
    bool small = false;      ///< what is only faster is left out
    bool unclipped = false;  ///< clipping, and then perspective, are left out where nothing asked for them
    double least_share = 1.; ///< percent of all pixels that a key has at least, to be fused beside the chain
};

struct Profile {
    std::vector<std::string> features;                       ///< that are on
    std::vector<std::pair<std::string, std::string>> limits; ///< that are not as usual
    std::vector<raster::Key> fused;
    bool chain = true;
};

Profile make(const Record& record, const Choice& choice);

/// The two files: settings for SPANGLE_PROFILE, and the lines of SPANGLE_FUSED (empty: there is none).
std::string settings(const Profile& profile, const Record& record, const Choice& choice);
std::string fused_lines(const Profile& profile);

/// A range as the profile names it, and what it counts.
struct RangeText {
    const char *name, *counted;
};
RangeText text_of(gl::Range range);

/// A loop of its own can serve the key.
bool is_fusible(const raster::Key& key);

/// What is on in a key, for people: "balanced full depth(less) texture(rgb565 rgb nearest modulate)".
std::string words(const raster::Key& key);

} // namespace spangle::profile
