// Measures products, mixtures, filters and blending of colours.
#include "raster/ops/number.hpp"
#include "tests/oracle/bounds/bounds.hpp"

namespace spangle::test {
namespace {

using raster::Balanced;
using raster::Exact;

constexpr double real(std::uint32_t v) {
    return v;
}

/// Returns a number from 0 to `one`; sometimes it is an end.
std::uint32_t colour(Random& random, std::uint32_t one) {
    const std::uint32_t which = random.below(16);
    return which == 0 ? 0 : which == 1 ? one : word(random) % (one + 1);
}

TEST(Bounds, ExactColours) {
    Random random{21};
    constexpr double one = Exact::one;
    double product = 0, mixture = 0, filtered = 0;
    for (int n = 0; n < 300'000; ++n) {
        const std::uint32_t a = colour(random, Exact::one), b = colour(random, Exact::one),
                            c = colour(random, Exact::one), d = colour(random, Exact::one),
                            f = colour(random, 1u << 30);
        product = std::fmax(product, std::fabs(Exact::mul(a, b) - real(a) * b / one));
        mixture = std::fmax(mixture, std::fabs(Exact::mix(a, b, f) - (a + (real(b) - a) * f * 0x1p-30)));
        const std::uint32_t u = random.below(257), v = random.below(257),
                            w[] = {(256 - u) * (256 - v), u * (256 - v), (256 - u) * v, u * v};
        const double sum = (real(a) * w[0] + real(b) * w[1] + real(c) * w[2] + real(d) * w[3]) / 65536;
        filtered = std::fmax(filtered, std::fabs(Exact::weighted(a, w[0], b, w[1], c, w[2], d, w[3]) - sum));
    }
    EXPECT_LE(product, 0.75);
    EXPECT_LE(mixture, 1);
    EXPECT_LE(filtered, 1);
    row({"product of colours, exact tier", "255ths with 20 bits, factors of 32", "[0, 1]",
         "0.75 2^-20 of a 255th", "blend_exact"},
        "%.3f 2^-20", product);
    row({"mixture (fog, lerp), exact tier", "255ths with 20 bits", "[0, 1]", "2^-20 of a 255th below",
         "mix_exact"},
        "%.3f 2^-20", mixture);
    row({"four filtered texels, exact tier", "weights of 16 bits, sums in uint64", "[0, 1]",
         "2^-20 of a 255th above", "filter_exact"},
        "%.3f 2^-20", filtered);
}

/// Returns the error of s a + (1 - a) k / most, in 255ths.
template <unsigned Bits> double over(Random& random) {
    constexpr std::uint32_t one = Balanced<1>::one, most = (1u << Bits) - 1;
    double worst = 0;
    for (int n = 0; n < 300'000; ++n) {
        const std::uint32_t s = colour(random, one), a = colour(random, one), k = random.below(most + 1);
        const double exact = (real(s) * a / one + real(k) / most * (one - a)) / 256;
        worst = std::fmax(worst, std::fabs(Balanced<1>::over<Bits>(s, a, k) / 256.0 - exact));
    }
    return worst;
}

TEST(Bounds, BalancedColours) {
    Random random{22};
    constexpr std::uint32_t one = Balanced<1>::one;
    double product = 0;
    for (int n = 0; n < 300'000; ++n) {
        const std::uint32_t a = colour(random, one), b = colour(random, one);
        product = std::fmax(product, std::fabs(Balanced<1>::mul(a, b) - real(a) * b / one));
    }
    EXPECT_LE(product, 3);
    row({"product of colours, balanced and fast", "255ths with 8 bits, in 16", "[0, 1]",
         "3/256 of a 255th below", "blend_balanced"},
        "%.3f/256", product);
    const double five = over<5>(random), six = over<6>(random);
    EXPECT_LE(std::fmax(five, six), 0.22);
    row({"alpha blending over 5 bits, balanced and fast", "65025ths, in 16 bits", "[0, 1]",
         "0.22 of a 255th, of which k (1 - a) is 0.2", "over_5"},
        "%.3f", five);
    row({"alpha blending over 6 bits, balanced and fast", "65025ths, in 16 bits", "[0, 1]",
         "0.22 of a 255th, of which k (1 - a) is 0.2", "over_6"},
        "%.3f", six);
}

} // namespace
} // namespace spangle::test
