// Names of the ranges that profiles record.
#pragma once

#include <cstdint>

/// 1 in builds that check the ranges of a profile; see cmake/Profile.cmake.
#ifndef SPANGLE_CHECK_RANGES
#define SPANGLE_CHECK_RANGES 0
#endif

namespace spangle::gl {

enum class Range : std::uint8_t {
#define RANGE(name, counted) name,
#include "gl/context/ranges.inc"
#undef RANGE
};

inline constexpr unsigned range_count = 0
#define RANGE(name, counted) +1
#include "gl/context/ranges.inc"
#undef RANGE
    ;

} // namespace spangle::gl
