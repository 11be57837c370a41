// Eight dithered colours of the exact tier at a time: the steps that one alone has.
#include <gtest/gtest.h>

#include <random>

#include "raster/span/stage_dithered.hpp"

namespace spangle::raster::test {
namespace {

constexpr std::uint32_t bias = 1u << 15, most = (255u << 24) + bias; ///< as set-up adds it

template <unsigned Bits> void expect_same(std::uint32_t at, std::uint32_t t) {
    using Words = detail::DitheredLanes::Words;
    const Words step = detail::DitheredLanes(Words{t, t, t, t}).step<Bits>(Words{at, at, at, at});
    ASSERT_EQ(step[0], Exact::dithered<Bits>(Exact::from_affine(at), t)) << Bits << ' ' << at << ' ' << t;
}

/// On both sides of each place where a step begins, where rounding tells.
template <unsigned Bits> void steps_begin_alike() {
    constexpr std::uint32_t levels = (1u << Bits) - 1;
    for (std::uint32_t t = 1; t < 32; t += 2)
        for (std::uint64_t k = 1; k <= levels; ++k) {
            const auto begin = static_cast<std::uint32_t>((255 * (32 * k - t) << 24) / (32 * levels)); // 8.24
            for (std::uint32_t at = begin + bias - 64; at <= begin + bias + 64; ++at)
                expect_same<Bits>(at, t);
        }
}

TEST(Dithered, StepsBeginAlike) {
    steps_begin_alike<5>();
    steps_begin_alike<6>();
}

TEST(Dithered, AnyColor) {
    std::mt19937 random(4);
    for (int i = 0; i < 1000000; ++i) {
        const auto at = static_cast<std::uint32_t>(bias + random() % (most - bias));
        const std::uint32_t t = 1 + 2 * (random() & 15);
        expect_same<5>(at, t);
        expect_same<6>(at, t);
    }
}

/// What set-up may be off by at both ends.
TEST(Dithered, EndsHold) {
    for (std::uint32_t t = 1; t < 32; t += 2)
        for (std::uint32_t off = 0; off <= 1u << 14; ++off)
            for (const std::uint32_t at : {bias - off, bias + off, most - off, most + off}) {
                expect_same<5>(at, t);
                expect_same<6>(at, t);
            }
}

} // namespace
} // namespace spangle::raster::test
