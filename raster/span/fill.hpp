// Rows of one 16-bit word: 32 bits at a time.
#pragma once

#include <cstdint>

#include "raster/numeric/bits.hpp"

namespace spangle::raster {

/// `count` > 0 words from `at`, which is 2-aligned.
SPANGLE_INLINE void fill16(std::uint8_t* at, std::uint32_t word, std::int32_t count) {
    using Half [[gnu::may_alias]] = std::uint16_t;
    using Pair [[gnu::may_alias]] = std::uint32_t;
    const auto half = static_cast<std::uint16_t>(word);
    if ((reinterpret_cast<std::uintptr_t>(at) & 2) != 0) {
        *reinterpret_cast<Half*>(at) = half;
        at += 2;
        --count;
    }
    const std::uint32_t pair = word | word << 16;
    Pair* to = reinterpret_cast<Pair*>(at);
    for (Pair* const end = to + (count >> 3) * 4; to != end; to += 4)
        to[0] = pair, to[1] = pair, to[2] = pair, to[3] = pair;
    for (Pair* const end = to + ((count & 7) >> 1); to != end; ++to)
        *to = pair;
    if ((count & 1) != 0)
        *reinterpret_cast<Half*>(to) = half;
}

/// The same of four words in turn, from `column` on.
inline void fill_columns(std::uint8_t* at, const std::uint16_t (&words)[4], std::int32_t column,
                         std::int32_t count) {
    const auto word = [&](std::int32_t i) { return words[(column + i) & 3]; };
    const auto put = [&](std::int32_t i) {
        const std::uint16_t v = word(i);
        __builtin_memcpy(at + 2 * i, &v, 2);
    };
    const std::uint16_t four[4] = {word(0), word(1), word(2), word(3)};
    std::int32_t i = 0;
    for (; i + 4 <= count; i += 4)
        __builtin_memcpy(at + 2 * i, four, 8);
    for (; i < count; ++i)
        put(i);
}

} // namespace spangle::raster
