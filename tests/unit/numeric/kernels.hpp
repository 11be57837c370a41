// Sweeps of the reciprocal and the root: with a stride every day, exhaustive in the slow tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <gtest/gtest.h>

#include "raster/numeric/reciprocal.hpp"
#include "raster/numeric/rsqrt.hpp"

struct KernelError {
    double low_1 = 0, high_1 = 0;  ///< relative errors after one Newton step
    double relative = 0, ulps = 0; ///< errors after two steps
    std::uint64_t rises = 0;       ///< places where the result grows with the argument
};

template <class One, class Two, class Exact>
KernelError sweep(std::uint64_t begin, std::uint64_t stride, One one_step, Two two_steps, Exact exact) {
    KernelError e;
    std::uint32_t before = 0xFFFFFFFF;
    for (std::uint64_t a = begin; a < std::uint64_t{1} << 32; a += stride) {
        const auto word = static_cast<std::uint32_t>(a);
        const double t = exact(static_cast<double>(word));
        const double one = one_step(word) / t - 1;
        const std::uint32_t two = two_steps(word);
        const double difference = std::fabs(two - t);
        e.low_1 = std::min(e.low_1, one);
        e.high_1 = std::max(e.high_1, one);
        e.ulps = std::max(e.ulps, difference);
        e.relative = std::max(e.relative, difference / t);
        e.rises += two > before ? 1 : 0;
        before = two;
    }
    return e;
}

inline double bound(int tenths) {
    return std::exp2(-tenths / 10.0);
}

/// Checks the bounds that reciprocal.hpp states.
inline void check_reciprocal(std::uint64_t stride) {
    using namespace spangle::numeric;
    const KernelError e = sweep(
        std::uint64_t{1} << 31, stride, [](std::uint32_t a) { return reciprocal_1(a); },
        [](std::uint32_t a) { return reciprocal(a); }, [](double a) { return 0x1p62 / a; });
    std::printf("reciprocal: one step [-2^%.3f, 2^%.3f], two steps 2^%.3f = %.4f ulp\n", std::log2(-e.low_1),
                std::log2(e.high_1), std::log2(e.relative), e.ulps);
    EXPECT_GE(e.low_1, -bound(reciprocal_1_accuracy));
    EXPECT_LE(e.high_1, std::exp2(-30.0));
    EXPECT_LE(e.ulps, reciprocal_ulp_percent / 100.0);
    EXPECT_LE(e.relative, bound(reciprocal_accuracy));
    EXPECT_EQ(e.rises, 0u);
    EXPECT_EQ(reciprocal(0x80000000u), 0x80000000u);
}

/// Checks the bounds that rsqrt.hpp states.
inline void check_rsqrt(std::uint64_t stride) {
    using namespace spangle::numeric;
    const KernelError e = sweep(
        std::uint64_t{1} << 30, stride, [](std::uint32_t a) { return rsqrt_1(a); },
        [](std::uint32_t a) { return rsqrt(a); }, [](double a) { return 0x1p46 / std::sqrt(a); });
    std::printf("rsqrt: one step [-2^%.3f, 2^%.3f], two steps 2^%.3f = %.4f ulp\n", std::log2(-e.low_1),
                std::log2(e.high_1), std::log2(e.relative), e.ulps);
    EXPECT_GE(e.low_1, -bound(rsqrt_1_accuracy));
    EXPECT_LE(e.high_1, std::exp2(-29.0));
    EXPECT_LE(e.relative, bound(rsqrt_accuracy));
    EXPECT_EQ(rsqrt(1u << 30), 0x80000000u);
}
