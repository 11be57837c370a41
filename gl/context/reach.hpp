// Reports the value that a program reaches in each range (ranges.inc). `spangle profile` watches a context
// and is told each new number. A build that checks ranges stops a program that exceeds its profile. All other
// builds, release firmware included, have no such code, because tells_reach is false.
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

inline constexpr bool tells_reach = SPANGLE_TELLS_REACH;

/// True if the ranges of this context are reported, to a watcher or to the checks of this build.
inline bool is_told([[maybe_unused]] const Context& context) {
    return SPANGLE_CHECK_RANGES || (SPANGLE_WATCHED && (context.gate & gate_watched) != 0);
}

#if SPANGLE_CHECK_RANGES

/// Stops the program, after a message that names the range, if `value` exceeds the recorded number.
void check_range(Range range, std::uint32_t value);

#endif

/// Reports that the program reached `value` in this range.
inline void reach([[maybe_unused]] Context& context, [[maybe_unused]] Range range,
                  [[maybe_unused]] std::uint32_t value) {
#if SPANGLE_CHECK_RANGES
    check_range(range, value);
#endif
#if SPANGLE_WATCHED
    if ((context.gate & gate_watched) != 0) [[unlikely]]
        context.watcher->reached(range, value);
#endif
}

/// Returns the least n >= 0 such that |v| < 2^n, or 128 for an infinity.
constexpr std::uint32_t bits_before_point(Real v) {
    constexpr std::uint32_t one_half = 126;
    const std::uint32_t exponent = v.bits >> 23 & 0xFF;
    return exponent > one_half ? exponent - one_half : 0;
}

} // namespace spangle::gl
