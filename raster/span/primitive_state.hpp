// What the stages of some states are told of the primitive at hand beside its planes. Whoever draws keeps it
// and changes it from primitive to primitive; a state whose key asks for none of it never looks.
#pragma once

#include <cstdint>

namespace spangle::raster {

/// Coverage 1: areas of squares in products of n.16 and n.12 coordinates, twice as fine (area.hpp).
inline constexpr int coverage_bits = 29;
inline constexpr std::uint32_t full_coverage = 1u << coverage_bits;

/// Of what is recorded: it is drawn to all samples.
inline constexpr std::uint8_t every_sample = 0xFF;

struct PrimitiveState {
    /// Of the pixels of the row that is drawn, from the first drawn one on; null: all of them are covered.
    const std::uint32_t* coverage = nullptr;
    /// Added to the depth of each fragment, then clamped (GL 1.3, 3.5.5): 2^32 is the whole range less one
    /// code.
    std::int64_t depth_offset = 0;
#ifndef SPANGLE_FIRMWARE
    double reference_depth_offset = 0; ///< that of the double policy, 0 .. 1
#endif
    bool stippled = false;    ///< FragmentState::polygon_stipple applies
    bool antialiased = false; ///< it has a coverage, null or not; others of the same state have none
    std::uint8_t sample = 0;  ///< which one is drawn
    bool moved = false;       ///< of what is recorded: each sample gets what lies where it is
};

} // namespace spangle::raster
