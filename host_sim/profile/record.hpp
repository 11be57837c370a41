// What a program asked for while it was recorded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "gl/context/range.hpp"
#include "raster/span/key.hpp"

namespace spangle::profile {

/// A state key that was drawn with, or may be. The states of a draw have a key for each kind of primitive.
struct KeyUse {
    raster::Key key;
    std::uint64_t pixels = 0; ///< pixels of the spans that were drawn with the key
    bool fused = false;       ///< this build has a fused span for the key
    bool needed = false;      ///< a build without the chain needs a fused span for the key
};

inline constexpr unsigned light_follows_colors = 8; ///< a bit of Record::light_kinds, for COLOR_MATERIAL

struct Record {
    std::map<std::string, std::uint64_t> commands; ///< number of calls by family: glVertex, glColor, ...
    std::set<std::string> features;                ///< features of cmake/Features.cmake that were asked for
    std::vector<KeyUse> keys;

    // Limits that were reached, in the units of cmake/Limits.cmake.
    int modelview_stack = 1, projection_stack = 1, texture_stack = 1, list_nesting = 2;
    int lights = 1, texture_units = 0, texture_levels = 1;
    unsigned light_kinds = 0, array_types = 0, primitives = 0, tiers = 0;
    unsigned color_formats = 0, depth_formats = 1, texture_formats = 0;
    bool full_lighting = false;
    std::uint32_t reached[gl::range_count] = {}; ///< largest number of each range (gl/context/ranges.inc)
    std::size_t arena_peak = 0;                  ///< most bytes that the library took on this host

    std::uint32_t reach(gl::Range range) const { return reached[static_cast<unsigned>(range)]; }
    std::uint64_t pixels() const {
        std::uint64_t sum = 0;
        for (const KeyUse& use : keys)
            sum += use.pixels;
        return sum;
    }
};

} // namespace spangle::profile
