// Factors that convert a colour to steps of the stored component.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"

namespace spangle::raster {

/// Factors, in units of 2^-32, that convert a component in 255ths to steps of 5, 6 or 5 bits. In the result 8
/// units are a step of 5 bits, and 4 units are a step of 6 bits.
struct StepFactors {
    std::uint32_t five, six;
    SPANGLE_INLINE constexpr std::uint32_t of(int component) const { return component == 1 ? six : five; }
};
/// The factors five / parts and six / parts, to the nearest.
constexpr StepFactors step_factors(std::uint64_t five, std::uint64_t six, std::uint64_t parts) {
    const auto of = [=](std::uint64_t n) {
        return static_cast<std::uint32_t>(((n << 32) + parts / 2) / parts);
    };
    return {of(five), of(six)};
}
/// The exact factors are 31 * 8 / 255 and 63 * 4 / 255. Where colours may be less accurate, the factors are
/// 249/256 and 253/256, which make steps at most a 290th of a step too large. Thresholds are 1/32 to 31/32 of
/// a step, so with both pairs a colour of k whole steps stays at k.
inline constexpr StepFactors exact_steps = step_factors(31 * 8, 63 * 4, 255),
                             near_steps = step_factors(249, 253, 256);

} // namespace spangle::raster
