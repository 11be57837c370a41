// Turns a record into the profile of a build: the settings of cmake/Features.cmake and cmake/Limits.cmake,
// and the list of fused spans.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host_sim/profile/record.hpp"

namespace spangle::profile {

struct Choice {
    std::string title;       ///< name of what was recorded, for the first line of the profile
    std::string list;        ///< file of the fused spans, as the profile names it
    bool small = false;      ///< leaves out what only makes drawing faster
    bool unclipped = false;  ///< leaves out clipping, and then perspective, where nothing asked for them
    double least_share = 1.; ///< least percent of all pixels for which a key is fused beside the chain
};

struct Profile {
    std::vector<std::string> features;                       ///< names of the features that are on
    std::vector<std::pair<std::string, std::string>> limits; ///< limits that differ from the usual, by name
    std::vector<raster::Key> fused;
    bool chain = true;
};

Profile make(const Record& record, const Choice& choice);

/// The texts of the two files: settings for SPANGLE_PROFILE, and the lines of SPANGLE_FUSED (empty: no such
/// file).
std::string settings(const Profile& profile, const Record& record, const Choice& choice);
std::string fused_lines(const Profile& profile);

/// The name of a range in the profile, and what the range counts.
struct RangeText {
    const char *name, *counted;
};
RangeText text_of(gl::Range range);

/// Whether a fused span can draw what the key says.
bool is_fusible(const raster::Key& key);

/// The key in words, for people: "balanced full depth(less) texture(rgb565 rgb nearest modulate)".
std::string words(const raster::Key& key);

} // namespace spangle::profile
