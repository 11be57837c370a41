// Fills parts of rows with 16-bit words, 32 bits at a time.
#pragma once

#include <bit>
#include <cstdint>

#include "raster/numeric/bits.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

using Half [[gnu::may_alias]] = std::uint16_t;
using Pair [[gnu::may_alias]] = std::uint32_t;

SPANGLE_INLINE bool between_pairs(const std::uint8_t* at) {
    return (reinterpret_cast<std::uintptr_t>(at) & 2) != 0;
}

/// Two 16-bit words as one 32-bit word, so that `first` comes first in memory.
SPANGLE_INLINE constexpr std::uint32_t in_turn(std::uint32_t first, std::uint32_t second) {
    return std::endian::native == std::endian::little ? first | second << 16 : second | first << 16;
}

/// Fills `count` >= 0 words from `at`, which is 4-aligned, with two pairs by turns. Returns the address of
/// the last word where `count` is odd.
SPANGLE_INLINE Half* fill_pairs(std::uint8_t* at, std::uint32_t first, std::uint32_t second,
                                std::int32_t count) {
    Pair* to = reinterpret_cast<Pair*>(at);
    for (Pair* const end = to + (count >> 3) * 4; to != end; to += 4)
        to[0] = first, to[1] = second, to[2] = first, to[3] = second;
    const std::int32_t rest = (count & 7) >> 1;
    for (std::int32_t i = 0; i < rest; ++i)
        *to++ = (i & 1) != 0 ? second : first;
    return reinterpret_cast<Half*>(to);
}

} // namespace inner

/// Fills `count` > 0 words of 16 bits from `at`, which is 2-aligned.
SPANGLE_INLINE void fill16(std::uint8_t* at, std::uint32_t word, std::int32_t count) {
    const auto half = static_cast<std::uint16_t>(word);
    if (inner::between_pairs(at)) {
        *reinterpret_cast<inner::Half*>(at) = half;
        at += 2;
        --count;
    }
    const std::uint32_t pair = word | word << 16;
    inner::Half* const last = inner::fill_pairs(at, pair, pair, count);
    if ((count & 1) != 0)
        *last = half;
}

/// Fills `count` > 0 words of 16 bits from `at`, which is 2-aligned, with four words by turns. `words` holds
/// these four words twice.
SPANGLE_INLINE void fill_columns(std::uint8_t* at, const inner::Half* words, std::int32_t count) {
    if (inner::between_pairs(at)) {
        *reinterpret_cast<inner::Half*>(at) = *words++;
        at += 2;
        --count;
    }
    inner::Half* const last =
        inner::fill_pairs(at, inner::in_turn(words[0], words[1]), inner::in_turn(words[2], words[3]), count);
    if ((count & 1) != 0)
        *last = words[(count - 1) & 3];
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
