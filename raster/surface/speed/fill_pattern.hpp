// Fills bytes with a pattern, by vectors or words.
#pragma once

#include "raster/surface/pattern.hpp"

namespace spangle::raster {

namespace clearing {

/// Whether rows that touch are filled as one piece.
inline constexpr bool joins_rows = true;

#if defined(__SSE2__) || defined(__aarch64__)

// Vectors of sixteen bytes may be stored at any address.
using Vector [[gnu::vector_size(16), gnu::aligned(1), gnu::may_alias]] = std::uint64_t;

/// Begins fill_masked() with blocks of 48 bytes, which hold whole periods. Returns the number of bytes in
/// these blocks.
inline std::int32_t fill_masked_blocks(std::uint8_t* to, const Pattern& pattern, const Pattern& mask,
                                       std::int32_t bytes) {
    Vector fresh[3], kept[3];
    const std::int32_t step = pattern.period() == 16 ? 0 : 16;
    for (int i = 0; i < 3; ++i) {
        const Vector open = *reinterpret_cast<const Vector*>(mask.byte + i * step);
        fresh[i] = *reinterpret_cast<const Vector*>(pattern.byte + i * step) & open;
        kept[i] = ~open;
    }
    std::int32_t done = 0;
    for (; bytes - done >= 48; done += 48) {
        Vector* const at = reinterpret_cast<Vector*>(to + done); // `auto` would drop the type's alignment
        at[0] = (at[0] & kept[0]) | fresh[0];
        at[1] = (at[1] & kept[1]) | fresh[1];
        at[2] = (at[2] & kept[2]) | fresh[2];
    }
    return done;
}

/// Fills `bytes` bytes with the pattern from its start. No byte beyond them is touched.
inline void fill(std::uint8_t* to, const Pattern& pattern, std::int32_t bytes) {
    Vector v[3];
    const std::int32_t step = pattern.period() == 16 ? 0 : 16;
    for (int i = 0; i < 3; ++i)
        v[i] = *reinterpret_cast<const Vector*>(pattern.byte + i * step);
    std::int32_t left = bytes;
    for (; left >= 96; left -= 96, to += 96) {
        Vector* const at = reinterpret_cast<Vector*>(to); // `auto` would drop the type's alignment
        at[0] = v[0];
        at[1] = v[1];
        at[2] = v[2];
        at[3] = v[0];
        at[4] = v[1];
        at[5] = v[2];
    }
    for (; left >= pattern.period(); left -= pattern.period(), to += pattern.period())
        for (std::int32_t i = 0; i < pattern.period(); i += 16)
            *reinterpret_cast<Vector*>(to + i) = v[i / 16];
    copy_bytes(to, pattern.byte, left);
}

#else

using Word [[gnu::may_alias]] = std::uint32_t;

/// Stores w[0..3] again and again, 64 bytes each time; `to` is 4-aligned, blocks > 0.
inline Word* store_blocks(Word* to, const Word* w, std::int32_t blocks) {
    Word* const end = to + 16 * blocks;
#if defined(__arm__)
    // Compilers do not make one STM instruction of four stores; one STM takes a third of the instructions.
    register std::uint32_t a asm("r2") = w[0];
    register std::uint32_t b asm("r3") = w[1];
    register std::uint32_t c asm("r4") = w[2];
    register std::uint32_t d asm("r5") = w[3];
    do {
        asm volatile("stmia %0!, {%1, %2, %3, %4}\n\tstmia %0!, {%1, %2, %3, %4}\n\t"
                     "stmia %0!, {%1, %2, %3, %4}\n\tstmia %0!, {%1, %2, %3, %4}"
                     : "+l"(to)
                     : "l"(a), "l"(b), "l"(c), "l"(d)
                     : "memory");
    } while (to != end);
#else
    do {
        for (int i = 0; i < 16; ++i)
            to[i] = w[i & 3];
        to += 16;
    } while (to != end);
#endif
    return to;
}

/// Fills `bytes` bytes with the pattern from its start. No byte beyond them is touched.
inline void fill(std::uint8_t* to, const Pattern& pattern, std::int32_t bytes) {
    std::int32_t head = static_cast<std::int32_t>(-reinterpret_cast<std::uintptr_t>(to) & 3);
    head = head < bytes ? head : bytes;
    copy_bytes(to, pattern.byte, head);
    bytes -= head;
    Word moved[12];
    const Word* w = reinterpret_cast<const Word*>(pattern.byte);
    if (head != 0)
        w = static_cast<const Word*>(__builtin_memcpy(moved, pattern.byte + head, sizeof moved));
    Word* at = reinterpret_cast<Word*>(to + head);
    if (pattern.period() == 16 && bytes >= 64) {
        at = store_blocks(at, w, bytes / 64);
        bytes &= 63;
    }
    const std::int32_t period = pattern.period() / 4;
    std::int32_t i = 0;
    for (; bytes >= 4; bytes -= 4) {
        *at++ = w[i];
        i = i + 1 == period ? 0 : i + 1;
    }
    copy_bytes(reinterpret_cast<std::uint8_t*>(at), pattern.byte + head + 4 * i, bytes);
}

/// Begins nothing, because fill_masked() itself fills all bytes by words of 32 bits.
constexpr std::int32_t fill_masked_blocks(const std::uint8_t*, const Pattern&, const Pattern&, std::int32_t) {
    return 0;
}

#endif

/// Like fill(), but writes only the bits of the mask, which has the period of the pattern.
inline void fill_masked(std::uint8_t* to, const Pattern& pattern, const Pattern& mask, std::int32_t bytes) {
    const std::int32_t done = fill_masked_blocks(to, pattern, mask, bytes);
    to += done;
    bytes -= done;
    std::int32_t from = 0;
    const auto next = [&](std::int32_t step) {
        to += step, bytes -= step, from += step;
        if (from == pattern.period())
            from = 0;
    };
    while (bytes >= 4) {
        std::uint32_t old, fresh, open;
        __builtin_memcpy(&old, to, 4);
        __builtin_memcpy(&fresh, pattern.byte + from, 4);
        __builtin_memcpy(&open, mask.byte + from, 4);
        fresh = (old & ~open) | (fresh & open);
        __builtin_memcpy(to, &fresh, 4);
        next(4);
    }
    while (bytes > 0) {
        const unsigned open = mask.byte[from];
        *to = static_cast<std::uint8_t>((*to & ~open) | (pattern.byte[from] & open));
        next(1);
    }
}

} // namespace clearing

} // namespace spangle::raster
