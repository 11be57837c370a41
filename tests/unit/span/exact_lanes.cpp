// The exact tier in eight lanes has the bits of the exact tier in one lane, for all operands.
#include <gtest/gtest.h>

#include <functional>

#include "raster/ops/number_wide.hpp"
#include "raster/ops/texel.hpp"
#include "tests/support/random.hpp"

namespace spangle::raster::test {
namespace {

using L = ExactLanes::L;
using spangle::test::Random;

/// Eight random numbers from 0 to `most`; sometimes they are 0 or `most`.
struct Eight {
    std::uint32_t v[8];
    Eight(Random& random, std::uint32_t most) {
        for (std::uint32_t& one : v) {
            const std::uint32_t which = random.below(8), high = random.below(0x10000);
            one = which == 0   ? 0
                  : which == 1 ? most
                               : (high << 16 | random.below(0x10000)) % (most + std::uint64_t{1});
        }
    }
    L::U32 words() const { return L::gather(v); }
    L::U16 halves() const { return L::low_half(L::gather(v)); }
};

void expect_lanes(const L::U32& found, const std::function<std::uint32_t(int)>& expected, const char* what) {
    for (int i = 0; i < 8; ++i)
        ASSERT_EQ(found.lane(i), expected(i)) << what << ", lane " << i;
}
void expect_halves(const L::U16& found, const std::function<std::uint32_t(int)>& expected, const char* what) {
    for (int i = 0; i < 8; ++i)
        ASSERT_EQ(std::uint32_t{found[i]}, expected(i)) << what << ", lane " << i;
}

class ExactLanes : public ::testing::Test {
  protected:
    using Wide = raster::ExactLanes;
    Random random_{97};
    Eight component() { return {random_, Exact::one}; }
};

TEST_F(ExactLanes, CombineAsOneLaneDoes) {
    for (int n = 0; n < 20'000; ++n) {
        const Eight a = component(), b = component(), k = component(), f{random_, 1u << 30};
        const auto at = [&](auto function) {
            return [&, function](int i) { return function(a.v[i], b.v[i], k.v[i]); };
        };
        expect_lanes(Wide::mul(a.words(), b.words()),
                     at([](auto x, auto y, auto) { return Exact::mul(x, y); }), "mul");
        expect_lanes(Wide::add(a.words(), b.words()),
                     at([](auto x, auto y, auto) { return Exact::add(x, y); }), "add");
        expect_lanes(Wide::subtract(a.words(), b.words()),
                     at([](auto x, auto y, auto) { return Exact::subtract(x, y); }), "subtract");
        expect_lanes(Wide::lerp(a.words(), b.words(), k.words()),
                     at([](auto x, auto y, auto z) { return Exact::lerp(x, y, z); }), "lerp");
        expect_lanes(
            Wide::mix(a.words(), b.words(), f.words()),
            [&](int i) { return Exact::mix(a.v[i], b.v[i], f.v[i]); }, "mix");
        expect_halves(
            Wide::to8(a.words()), [&](int i) { return Exact::to8(a.v[i]); }, "to8");
    }
}

TEST_F(ExactLanes, ComponentsOfEveryCode) {
    for (std::uint32_t k = 0; k < 256; ++k) {
        const L::U16 code = L::splat(k);
        expect_lanes(
            Wide::from8(code), [&](int) { return Exact::from8(k); }, "from8");
        if (k >= 64)
            continue;
        expect_lanes(
            Wide::from6(code), [&](int) { return Exact::from6(k); }, "from6");
        expect_lanes(
            Wide::texel6(code), [&](int) { return Exact::texel6(k); }, "texel6");
        if (k >= 32)
            continue;
        expect_lanes(
            Wide::from5(code), [&](int) { return Exact::from5(k); }, "from5");
        expect_lanes(
            Wide::texel5(code), [&](int) { return Exact::texel5(k); }, "texel5");
    }
}

TEST_F(ExactLanes, PlanesAndFactorsAreClamped) {
    for (int n = 0; n < 20'000; ++n) {
        const Eight v{random_, 0xFFFFFFFF}, low{random_, 0x1FFFF};
        expect_lanes(
            Wide::from_affine(v.words()), [&](int i) { return Exact::from_affine(v.v[i]); }, "from_affine");
        expect_lanes(
            Wide::from_affine(low.words()), [&](int i) { return Exact::from_affine(low.v[i]); },
            "from_affine");
        expect_lanes(
            Wide::clamped_fraction(v.words()), [&](int i) { return Exact::clamped_fraction(v.v[i]); },
            "clamped_fraction");
    }
}

TEST_F(ExactLanes, FilterAsOneLaneDoes) {
    for (int n = 0; n < 20'000; ++n) {
        const Eight a = component(), b = component(), c = component(), d = component(), u{random_, 255},
                    v{random_, 255}, next{random_, 65535};
        const auto bilinear_of = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t s,
                                     int i) {
            const auto grey = [](std::uint32_t x) { return Exact::Color{x, x, x, x}; };
            return bilinear<Exact>(grey(p), grey(q), grey(r), grey(s), u.v[i], v.v[i]).g;
        };
        const Wide::Weights weights(v.halves());
        expect_lanes(
            weights.components(a.words(), b.words(), c.words(), d.words(), u.words()),
            [&](int i) { return bilinear_of(a.v[i], b.v[i], c.v[i], d.v[i], i); }, "components");
        const Eight k0{random_, 255}, k1{random_, 255}, k2{random_, 255}, k3{random_, 255};
        expect_lanes(
            weights.bytes(k0.halves(), k1.halves(), k2.halves(), k3.halves(), u.words()),
            [&](int i) {
                return bilinear_of(Exact::from8(k0.v[i]), Exact::from8(k1.v[i]), Exact::from8(k2.v[i]),
                                   Exact::from8(k3.v[i]), i);
            },
            "bytes");
        const L::U16 w = next.halves() | L::splat(1), rest = L::splat(65535) - w + L::splat(1);
        expect_lanes(
            Wide::weighted(a.words(), rest, b.words(), w),
            [&](int i) {
                const std::uint32_t weight = next.v[i] | 1;
                return Exact::weighted(a.v[i], 65536 - weight, b.v[i], weight, 0, 0, 0, 0);
            },
            "weighted");
    }
}

template <unsigned Bits> void expect_stored(Random& random, const Eight& c) {
    using Wide = raster::ExactLanes;
    const std::uint32_t threshold32 = 2 * random.below(16) + 1;
    const L::U16 threshold = L::splat(Wide::Threshold::word(0, threshold32));
    expect_halves(
        Wide::tops<Bits>(c.words(), threshold) >> (16 - Bits),
        [&](int i) { return Exact::dithered<Bits>(c.v[i], threshold32); }, "tops");
    expect_halves(
        Wide::dithered<Bits>(c.words(), L::splat(threshold32)),
        [&](int i) { return Exact::dithered<Bits>(c.v[i], threshold32); }, "dithered");
    const Eight s{random, Exact::one}, a{random, Exact::one}, k{random, (1u << Bits) - 1};
    expect_lanes(
        Wide::over<Bits>(s.words(), a.words(), k.halves()),
        [&](int i) { return Exact::over<Bits>(s.v[i], a.v[i], k.v[i]); }, "over");
}

TEST_F(ExactLanes, StoreAndBlendAsOneLaneDoes) {
    for (int n = 0; n < 20'000; ++n) {
        const Eight c = component();
        expect_stored<5>(random_, c);
        expect_stored<6>(random_, c);
    }
}

} // namespace
} // namespace spangle::raster::test
