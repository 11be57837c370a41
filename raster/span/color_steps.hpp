// Factors that count a colour in steps of the component that is stored.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"

namespace spangle::raster {

/// Parts of 2^32 that make a colour one in steps of its component of 5, 6 or 5 bits, 8 or 4 of its 255ths
/// each.
struct StepFactors {
    std::uint32_t five, six;
    SPANGLE_INLINE constexpr std::uint32_t of(int component) const { return component == 1 ? six : five; }
};
/// 31 8 / 255 and 63 4 / 255, and where colours may be off by more: 249 and 253 / 256, a 290th of a step too
/// large at most. Thresholds are 1/32 to 31/32 of a step, so that with either k steps stay k.
inline constexpr StepFactors exact_steps{0xF8F8F8F9, 0xFCFCFCFD}, near_steps{0xF9000000, 0xFD000000};

} // namespace spangle::raster
