// 1/w of a fragment.
#pragma once

#include <cstdint>

#include "raster/numeric/reciprocal.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// 1 / q of a fragment, where q is the 30-bit value of a projective plane. Values q <= 0, which are outside
/// of GL's domain, count as 1.
struct Inverse {
    std::uint32_t q;
    std::uint32_t mantissa; ///< 1/q = mantissa * 2^(zeros - 62)
    int zeros;              ///< leading zero bits of q
    Inverse() = default;
    SPANGLE_INLINE Inverse(std::int32_t value, numeric::LeadingZeros<true>&) : Inverse(value) {}
    SPANGLE_INLINE Inverse(std::int32_t value, numeric::LeadingZeros<false>& count)
        : q(value > 0 ? static_cast<std::uint32_t>(value) : 1u) {
        zeros = count.of(q);
        mantissa = numeric::reciprocal(q << zeros);
    }
    SPANGLE_RUN_INLINE explicit Inverse(std::int32_t value)
        : q(value > 0 ? static_cast<std::uint32_t>(value) : 1u) {
        zeros = numeric::clz32(q);
        mantissa = numeric::reciprocal(q << zeros);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
