// Words of scaled(), with a short form for shifts by 1 to 31 bits.
#pragma once

#include "raster/primitive/scaled.hpp"

namespace spangle::raster {

/// Both words of scaled(v, n). With words of 32 bits, 0 < n < 32 takes four instructions.
SPANGLE_INLINE std::uint64_t scaled_words(std::int64_t v, int n) {
    if (numeric::wide_words || n <= 0 || n >= 32) [[unlikely]]
        return static_cast<std::uint64_t>(scaled(v, n));
    return static_cast<std::uint64_t>(numeric::words_after(v, n));
}

/// The low word of scaled(v, n). With words of 32 bits, 0 < n < 32 takes three instructions.
SPANGLE_INLINE std::uint32_t scaled_word(std::int64_t v, int n) {
    if (numeric::wide_words || n <= 0 || n >= 32) [[unlikely]]
        return static_cast<std::uint32_t>(scaled(v, n));
    return numeric::low_word_after(v, n);
}

/// Whether words hold differences with these difference_bits() 2^lift times as large. Products of such words
/// with coefficients below 2^30 need no shift by n = 32 - lift, because their high words are the result.
SPANGLE_INLINE bool fits_lifted(std::uint32_t bits, std::uint32_t lift) {
    return lift <= static_cast<std::uint32_t>(numeric::clz32(bits | 1));
}

} // namespace spangle::raster
