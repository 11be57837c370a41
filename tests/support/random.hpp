// Random numbers that are the same on every machine.
#pragma once

#include <cstdint>

namespace spangle::test {

struct Random {
    std::uint32_t state;

    explicit constexpr Random(std::uint32_t seed) : state(seed) {}
    /// A number from 0 to n - 1.
    std::uint32_t below(std::uint32_t n) {
        state = state * 1664525u + 1013904223u;
        return static_cast<std::uint32_t>((std::uint64_t{state >> 8} * n) >> 24);
    }
};

} // namespace spangle::test
