// What the stages of some states are told about the current primitive beside its planes. The code that draws
// owns it and changes it from primitive to primitive. A state whose key asks for none of it never reads it.
#pragma once

#include <cstdint>

namespace spangle::raster {

/// Fraction bits of coverage, where 1 is a whole pixel: areas are products of n.16 and n.12 coordinates,
/// counted twice as fine (area.hpp).
inline constexpr int coverage_bits = 29;
inline constexpr std::uint32_t full_coverage = 1u << coverage_bits;

/// Stands for all samples in recorded primitives.
inline constexpr std::uint8_t every_sample = 0xFF;

struct PrimitiveState {
    /// Coverage of the pixels of the current row, from its first drawn pixel on. Null: all of them are
    /// covered.
    const std::uint32_t* coverage = nullptr;
    /// Added to the depth of each fragment, which is then clamped (GL 1.3, 3.5.5). 2^32 is the whole range of
    /// depths less one code.
    std::int64_t depth_offset = 0;
#ifndef SPANGLE_FIRMWARE
    double reference_depth_offset = 0; ///< the same offset in the double policy; 1 is the whole range
#endif
    bool stippled = false; ///< FragmentState::polygon_stipple applies
    bool antialiased =
        /// The primitive has a coverage, even if it is null; other primitives of the same state have none.
        false;
    std::uint8_t sample = 0; ///< number of the sample that is drawn
    bool moved = false;      ///< for recorded primitives: each sample gets what lies at its own place
};

} // namespace spangle::raster
