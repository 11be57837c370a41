// Data about the current primitive, besides its planes, that stages of some states read. The drawing code
// owns the object and changes it from primitive to primitive. States whose key needs none of the data never
// read it.
#pragma once

#include <cstdint>

namespace spangle::raster {

/// Fraction bits of coverage, where 1 is a whole pixel. Areas are products of n.16 and n.12 coordinates,
/// counted in halves (area.hpp).
inline constexpr int coverage_bits = 29;
inline constexpr std::uint32_t full_coverage = 1u << coverage_bits;

/// Stands for all samples in a recorded primitive.
inline constexpr std::uint8_t every_sample = 0xFF;

struct PrimitiveState {
    /// Coverage of the pixels of the current row, from its first drawn pixel on. Null means that all pixels
    /// are covered fully.
    const std::uint32_t* coverage = nullptr;
    /// Added to the depth of each fragment, which is then clamped (GL 1.3, 3.5.5). The whole range of depths
    /// is 2^32 minus one code.
    std::int64_t depth_offset = 0;
#ifndef SPANGLE_FIRMWARE
    double reference_depth_offset = 0; ///< depth_offset in the double policy, where the whole range is 1
#endif
    bool stippled = false; ///< FragmentState::polygon_stipple applies
    /// The primitive has coverage, even where `coverage` is null. Other primitives of the same state have
    /// none.
    bool antialiased = false;
    std::uint8_t sample = 0; ///< number of the sample that is drawn
    bool moved = false;      ///< for recorded primitives: each sample is drawn at its own place
};

} // namespace spangle::raster
