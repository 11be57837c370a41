// Tests blending with SRC_ALPHA, ONE_MINUS_SRC_ALPHA in the balanced tier: its bound, its identities, and the
// bits of its packed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "raster/ops/number_packed.hpp"

namespace spangle::raster::test {
namespace {

using N = Balanced<1>;

template <unsigned Bits> double worst_error() {
    constexpr std::uint32_t most = (1u << Bits) - 1;
    double worst = 0;
    for (std::uint32_t s = 0; s < 256; ++s)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t k = 0; k <= most; ++k) {
                const double want = (s * a + (255. - a) * k * 255 / most) / 255;
                const double got = N::over<Bits>(N::from8(s), N::from8(a), k) / 256.;
                worst = std::fmax(worst, std::fabs(got - want));
            }
    return worst;
}

TEST(Over, ErrorOfStoredBits) {
    EXPECT_LE(worst_error<5>(), 1. / 5);
    EXPECT_LE(worst_error<6>(), 1. / 5);
}

TEST(Over, EightBitsAreRoundedExactly) {
    for (std::uint32_t s = 0; s < 256; ++s)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t k = 0; k < 256; ++k)
                ASSERT_EQ(N::to8(N::over<8>(N::from8(s), N::from8(a), k)),
                          (2 * (s * a + k * (255 - a)) + 255) / 510)
                    << s << " " << a << " " << k;
}

/// With alpha 0 the stored colour stays, dithered or not, so such fragments need not be drawn. With alpha 1
/// the fragment's colour is stored. With every alpha in 8.8, white over white stays white, so nothing leaves
/// 16 bits.
template <unsigned Bits> void identities() {
    constexpr std::uint32_t most = (1u << Bits) - 1;
    for (std::uint32_t k = 0; k <= most; ++k) {
        const std::uint32_t kept = N::over<Bits>(0, 0, k);
        EXPECT_EQ(N::to8(kept) >> (8 - Bits), k);
        for (std::uint32_t t = 1; t < 32; t += 2)
            EXPECT_EQ(N::dithered<Bits>(kept, t), k) << t;
        for (std::uint32_t s = 0; s < 256; ++s)
            EXPECT_EQ(N::to8(N::over<Bits>(N::from8(s), N::one, k)), s);
    }
    for (std::uint32_t a = 0; a <= N::one; ++a) {
        const std::uint32_t white = N::over<Bits>(N::one, a, most);
        ASSERT_EQ(N::to8(white), 255u) << a;
        ASSERT_EQ(N::dithered<Bits>(white, 31), most) << a;
    }
}

TEST(Over, Identities) {
    identities<5>();
    identities<6>();
}

TEST(Over, PackedHasTheSameBits) {
    for (std::uint32_t s = 0; s < 256; ++s)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t k = 0; k < 64; ++k) {
                const std::uint32_t g = s ^ 0x5A, b = 255 - s, r5 = k & 31, b5 = (k * 7) & 31;
                const auto top = [&]<unsigned Bits>(std::uint32_t c, std::uint32_t under) {
                    return N::to8(N::over<Bits>(N::from8(c), N::from8(a), under)) >> (8 - Bits);
                };
                const std::uint32_t want =
                    top.operator()<5>(s, r5) << 11 | top.operator()<6>(g, k) << 5 | top.operator()<5>(b, b5);
                const Packed::Color c = Packed::from_word(s | g << 8 | b << 16 | a << 24);
                ASSERT_EQ(Packed::over(c, r5 << 11 | k << 5 | b5), want) << s << " " << a << " " << k;
                if (a == 255) {
                    ASSERT_EQ(Packed::opaque(c), want);
                }
            }
}

template <unsigned Bits> void packed_exact() {
    for (std::uint32_t s = 0; s < 256; ++s)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t k = 0; k < 1u << Bits; ++k) {
                const std::uint32_t want =
                    Exact::to8(Exact::over<Bits>(Exact::from8(s), Exact::from8(a), k)) >> (8 - Bits);
                const Packed::Color c = Packed::from_word(s | s << 8 | s << 16 | a << 24);
                const std::uint32_t got = PackedExact::over(c, Bits == 5 ? k << 11 | (31 - k) : k << 5);
                ASSERT_EQ(Bits == 5 ? got >> 11 : (got >> 5) & 63, want) << s << " " << a << " " << k;
                ASSERT_EQ(ExactBytes<1>::over<Bits>(s, a, k) >> (8 - Bits), want)
                    << s << " " << a << " " << k;
            }
}

TEST(Over, PackedAndBytesHaveTheBitsOfExact) {
    packed_exact<5>();
    packed_exact<6>();
}

/// The packed form has the bits of the balanced tier when it dithers.
TEST(Over, DitheredPackedHasTheSameBits) {
    for (std::uint32_t s = 0; s < 256; ++s)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t k = 0; k < 64; ++k) {
                const std::uint32_t g = s ^ 0x5A, b = 255 - s, r5 = k & 31, b5 = (k * 7) & 31;
                const std::uint32_t r_over = N::over<5>(N::from8(s), N::from8(a), r5),
                                    g_over = N::over<6>(N::from8(g), N::from8(a), k),
                                    b_over = N::over<5>(N::from8(b), N::from8(a), b5);
                const Packed::Color c = Packed::from_word(s | g << 8 | b << 16 | a << 24);
                for (std::uint32_t t = 1; t < 32; t += 2) {
                    const std::uint32_t want = N::dithered<5>(r_over, t) << 11 |
                                               N::dithered<6>(g_over, t) << 5 | N::dithered<5>(b_over, t);
                    ASSERT_EQ(Packed::over(c, r5 << 11 | k << 5 | b5, t), want) << s << " " << a << " " << k;
                }
            }
}

/// A dither threshold (in 32nds) as lanes keep it.
template <class Numbers> struct Kept {
    std::uint32_t threshold32;
    std::uint32_t word(int i) const { return Numbers::Threshold::word(i, threshold32); }
};
using ExactKept = Kept<ExactBytes<1>>;
using CoarseKept = Kept<CoarseBytes<1>>;

/// The dithered form stores floor(v + t) of the exact quotient v; the packed form and lanes store the same.
template <unsigned Bits> void dithered_exact() {
    for (std::uint32_t s = 0; s < 256; ++s)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t k = 0; k < 1u << Bits; ++k) {
                const std::uint32_t v = Exact::over<Bits>(Exact::from8(s), Exact::from8(a), k);
                const Packed::Color c = Packed::from_word(s | s << 8 | s << 16 | a << 24);
                const std::uint32_t under = Bits == 5 ? k << 11 | (31 - k) : k << 5;
                for (std::uint32_t t = 1; t < 32; t += 2) {
                    const std::uint32_t want = Exact::dithered<Bits>(v, t),
                                        got = PackedExact::over(c, under, t);
                    ASSERT_EQ(Bits == 5 ? got >> 11 : (got >> 5) & 63, want) << s << " " << a << " " << k;
                    ASSERT_EQ(ExactBytes<1>::dithered<Bits>(s, a, k, ExactKept{t}), want)
                        << s << " " << a << " " << k;
                }
            }
}

TEST(Over, DitheredPackedAndBytesHaveTheBitsOfExact) {
    dithered_exact<5>();
    dithered_exact<6>();
}

/// Returns by how many steps of the target the fast tier differs from blending in real numbers, rounded down:
/// at most one step of five bits, two of six. A fully transparent colour stores the old bits, and an opaque
/// colour its own.
template <unsigned Bits> int coarse() {
    constexpr std::uint32_t most = (1u << Bits) - 1;
    int worst = 0;
    for (std::uint32_t s = 0; s < 256; ++s)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t k = 0; k <= most; ++k) {
                const double exact = (s * a + (255. - a) * k * 255 / most) / 255;
                const int want = static_cast<int>(exact + 0.5) >> (8 - Bits);
                const auto got = static_cast<int>(CoarseBytes<1>::over<Bits>(s, a, k) >> (8 - Bits));
                worst = std::max(worst, std::abs(got - want));
                if (a == 0) {
                    EXPECT_EQ(got, static_cast<int>(k));
                }
                if (a == 255) {
                    EXPECT_EQ(got, static_cast<int>(s >> (8 - Bits)));
                }
            }
    return worst;
}

TEST(Coarse, ErrorOfStoredBits) {
    EXPECT_EQ(coarse<5>(), 1);
    EXPECT_EQ(coarse<6>(), 2);
}

/// Returns by how many steps the dithered fast tier differs from floor(steps + t) of real numbers.
template <unsigned Bits> int coarse_dithered() {
    constexpr std::uint32_t most = (1u << Bits) - 1;
    int worst = 0;
    for (std::uint32_t s = 0; s < 256; ++s)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t k = 0; k <= most; ++k) {
                const double steps = (s * a * most / 255. + (255. - a) * k) / 255;
                for (std::uint32_t t = 1; t < 32; t += 2) {
                    const auto got = static_cast<int>(CoarseBytes<1>::dithered<Bits>(s, a, k, CoarseKept{t}));
                    worst = std::max(worst, std::abs(got - static_cast<int>(steps + t / 32.)));
                    if (a == 0) {
                        EXPECT_EQ(got, static_cast<int>(k));
                    }
                }
            }
    return worst;
}

TEST(Coarse, ErrorOfDitheredBits) {
    EXPECT_EQ(coarse_dithered<5>(), 1);
    EXPECT_EQ(coarse_dithered<6>(), 2);
}

/// Over a whole dither pattern, the mean of a solid colour is within 3/16 of a step, and both ends are exact.
template <unsigned Bits> void solid_dithered() {
    constexpr std::uint32_t most = (1u << Bits) - 1;
    for (std::uint32_t s = 0; s < 256; ++s) {
        int sum = 0;
        for (std::uint32_t t = 1; t < 32; t += 2)
            sum += static_cast<int>(CoarseBytes<1>::dithered<Bits>(s, 255, most - s / 8, CoarseKept{t}));
        EXPECT_NEAR(sum / 16., s * most / 255., 3 / 16.) << s;
        if (s == 0 || s == 255) {
            EXPECT_EQ(sum, static_cast<int>(s / 255 * most * 16));
        }
    }
}

TEST(Coarse, PatternsOfSolidColors) {
    solid_dithered<5>();
    solid_dithered<6>();
}

TEST(Coarse, DitheredPackedHasTheSameBits) {
    for (std::uint32_t s = 0; s < 256; ++s)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t k = 0; k < 64; ++k)
                for (std::uint32_t t = 1; t < 32; t += 2) {
                    const std::uint32_t g = (s * 5 + a + t) & 255, b = 255 - s, r5 = k & 31, b5 = 31 - r5;
                    const auto over = [&]<unsigned Bits>(std::uint32_t c, std::uint32_t under) {
                        return CoarseBytes<1>::dithered<Bits>(c, a, under, CoarseKept{t});
                    };
                    const std::uint32_t want = over.operator()<5>(s, r5) << 11 |
                                               over.operator()<6>(g, k) << 5 | over.operator()<5>(b, b5);
                    const std::uint32_t under = r5 << 11 | k << 5 | b5;
                    const auto c = PackedCoarse::from_word(s | g << 8 | b << 16 | a << 24),
                               d = PackedCoarse::dithered(c, t);
                    ASSERT_EQ(PackedCoarse::clear(c)       ? under
                              : PackedCoarse::is_opaque(c) ? PackedCoarse::opaque(d)
                                                           : PackedCoarse::over(d, under),
                              want)
                        << s << " " << a << " " << k << " " << t;
                }
}

/// The neighbouring components of a word have extreme values, so that a carry from one component into the
/// next would show.
TEST(Coarse, PackedHasTheSameBits) {
    for (std::uint32_t s = 0; s < 256; ++s)
        for (std::uint32_t a = 0; a < 256; ++a)
            for (std::uint32_t k = 0; k < 64; ++k)
                for (std::uint32_t other : {s, 255 - s, 0u, 255u}) {
                    const std::uint32_t r5 = k & 31, b5 = other != 0 ? 31 : 31 - r5;
                    const auto over = [&]<unsigned Bits>(std::uint32_t c, std::uint32_t under) {
                        return CoarseBytes<1>::over<Bits>(c, a, under) >> (8 - Bits);
                    };
                    const std::uint32_t want = over.operator()<5>(s, r5) << 11 |
                                               over.operator()<6>(other, k) << 5 |
                                               over.operator()<5>(255 - other, b5);
                    const std::uint32_t under = r5 << 11 | k << 5 | b5;
                    const auto c = PackedCoarse::from_word(s | other << 8 | (255 - other) << 16 | a << 24);
                    ASSERT_EQ(PackedCoarse::whole(c), PackedCoarse::clear(c) || PackedCoarse::is_opaque(c));
                    ASSERT_EQ(PackedCoarse::clear(c)       ? under
                              : PackedCoarse::is_opaque(c) ? PackedCoarse::opaque(c)
                                                           : PackedCoarse::over(c, under),
                              want)
                        << s << " " << a << " " << k << " " << other;
                }
}

/// Components that were read from steps of the format are stored as the same steps.
TEST(Coarse, StepsAreStoredAsTheyAre) {
    for (std::uint32_t k = 0; k < 64; ++k) {
        EXPECT_EQ(N::to8(N::from6(k)) >> 2, k);
        EXPECT_EQ(N::to8(N::from5(k & 31)) >> 3, k & 31);
    }
}

} // namespace
} // namespace spangle::raster::test
