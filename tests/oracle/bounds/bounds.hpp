// A row of docs/bounds.md: what a stage computes in, what bounds its error or range, which obligation of
// tests/oracle/gappa proves it, and the worst error that the test met.
#pragma once

#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/support/random.hpp"

namespace spangle::test {

struct Stage {
    const char *name, *format, *range, *bound, *proof;
};

[[gnu::format(printf, 2, 3)]] inline void row(const Stage& stage, const char* observed, ...) {
    char text[200] = {};
    va_list arguments;
    va_start(arguments, observed);
    std::vsnprintf(text, sizeof text, observed, arguments);
    va_end(arguments);
    std::printf("| %s | %s | %s | %s | %s | %s |\n", stage.name, stage.format, stage.range, stage.bound,
                stage.proof, text);
}

inline std::uint32_t word(Random& random) {
    const std::uint32_t high = random.below(0x10000);
    return high << 16 | random.below(0x10000);
}
/// Returns a random number from -most to most.
inline std::int32_t lot(Random& random, std::int32_t most) {
    return static_cast<std::int32_t>(word(random) % (2 * static_cast<std::uint32_t>(most) + 1)) - most;
}

} // namespace spangle::test
