// Logarithms that are accurate to 1/256, for levels of detail and lengths of runs.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// log2(mantissa) - 31 with 8 fraction bits, within 1/256; the mantissa is in [2^31, 2^32).
SPANGLE_INLINE std::int32_t log2_of_mantissa8(std::uint32_t mantissa) {
    // log2(1 + x) = x + x (1 - x) (0.4227 - 0.1587 x), within 0.0009.
    const std::uint32_t x = (mantissa << 1) >> 16; // the fraction of the mantissa, with 16 bits
    const std::uint32_t bulge = (x * (65536 - x)) >> 16;
    const std::int32_t slope = 27700 - ((static_cast<std::int32_t>(x) * 10400) >> 16);
    const std::int32_t fraction =
        static_cast<std::int32_t>(x) + ((static_cast<std::int32_t>(bulge) * slope) >> 16);
    return (fraction + 128) >> 8;
}

/// log2(v) with 8 fraction bits, within 1/256; v = 0 counts as 1.
SPANGLE_RUN_CALL inline std::int32_t log2_fraction8(std::uint64_t v) {
    v = v == 0 ? 1 : v;
    const int zeros = numeric::clz64(v);
    return ((63 - zeros) << 8) + log2_of_mantissa8(numeric::high_word_before(v, zeros));
}
/// log2(v) of a word that is not 0, with 8 fraction bits.
SPANGLE_RUN_CALL inline std::int32_t log2_of_word8(std::uint32_t v) {
    if constexpr (numeric::wide_words)
        return log2_fraction8(v);
    const int zeros = numeric::clz32(v);
    return ((31 - zeros) << 8) + log2_of_mantissa8(v << zeros);
}

/// Lambda with 8 fraction bits, from the sum of up to four logarithms, which together are off by less than
/// 3/256. In every policy a lambda within 3/256 of 0 is 0 by definition. So an image that is drawn one texel
/// to a pixel never mixes in its next level.
SPANGLE_INLINE constexpr std::int32_t level_of_detail(std::int32_t sum) {
    constexpr std::int32_t lost = 3;
    return sum < -lost || sum > lost ? sum : 0;
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
