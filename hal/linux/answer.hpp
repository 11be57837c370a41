// A serial answer that was clocked in as whole bytes: the dummy bits come first, and shift the rest.
#pragma once

#include <span>

#include <spangle/hal/bus.hpp>

namespace spangle::hal {

/// Bytes that hold the whole answer.
inline std::size_t answer_bytes(const Op& op) {
    return (op.dummy_bits + std::size_t{op.length} * 8 + 7) / 8;
}

inline void take_answer(const Op& op, std::span<const std::uint8_t> clocked) {
    for (std::uint32_t i = 0; i < op.length; ++i) {
        const std::size_t bit = op.dummy_bits + std::size_t{i} * 8, at = bit / 8;
        const unsigned high = clocked[at], low = at + 1 < clocked.size() ? clocked[at + 1] : 0u;
        op.into[i] = static_cast<std::uint8_t>((high << 8 | low) >> (8 - bit % 8));
    }
}

} // namespace spangle::hal
