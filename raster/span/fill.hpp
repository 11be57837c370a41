// Rows of one 16-bit word: 32 bits at a time.
#pragma once

#include <cstdint>
#include <cstring>

#include "raster/numeric/bits.hpp"

namespace spangle::raster {

/// `count` > 0 words from `at`, which is 2-aligned.
SPANGLE_INLINE void fill16(std::uint8_t* at, std::uint32_t word, std::int32_t count) {
    const auto half = static_cast<std::uint16_t>(word);
    if ((reinterpret_cast<std::uintptr_t>(at) & 2) != 0) {
        std::memcpy(__builtin_assume_aligned(at, 2), &half, 2);
        at += 2;
        --count;
    }
    const std::uint32_t pair = word | word << 16;
    std::uint8_t* to = static_cast<std::uint8_t*>(__builtin_assume_aligned(at, 4));
    std::uint8_t* const end8 = to + 2 * (count & ~7);
    for (; to != end8; to += 16) {
        std::memcpy(to, &pair, 4);
        std::memcpy(to + 4, &pair, 4);
        std::memcpy(to + 8, &pair, 4);
        std::memcpy(to + 12, &pair, 4);
    }
    std::uint8_t* const end2 = to + 2 * (count & 6);
    for (; to != end2; to += 4)
        std::memcpy(to, &pair, 4);
    if ((count & 1) != 0)
        std::memcpy(to, &half, 2);
}

} // namespace spangle::raster
