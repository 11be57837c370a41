// Lit textures are guessed by products: stored words are those of the chain's arithmetic, and components lie
// within their doubt.
#include <gtest/gtest.h>

#include <random>

#include "raster/ops/stage_lit_one.hpp"

namespace spangle::raster::test {
namespace {

template <bool Is565, bool HasFog, bool Dither> void check_words(std::uint32_t seed) {
    using Store = LitStore<PixelFormat::rgb565_be, Is565, HasFog, Dither>;
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random()) % n; };
    DrawState state{};
    Span<Fixed> span{};
    span.state = &state;
    for (int round = 0; round < 400; ++round) {
        for (int i = 0; i < 3; ++i)
            state.fragment.fog_color[i] = round % 3 == 0   ? color_one
                                          : round % 3 == 1 ? 0
                                                           : below(color_one + 1);
        span.x = round & 3;
        span.y = round >> 2;
        const Store store(span, 0);
        const std::uint32_t threshold = dither_threshold(dither_row(span.y), span.x);
        for (int i = 0; i < 1000; ++i) {
            const auto component = [&] {
                const std::uint32_t ends[] = {0, color_one, color_one - below(3),
                                              below(256) << color_fraction_bits};
                return i % 8 < 4 ? ends[i & 3] : below(color_one + 1);
            };
            const std::uint32_t r = component(), g = component(), b = component();
            const std::uint32_t texel = i % 16 == 0 ? ~0u : static_cast<std::uint32_t>(random());
            const ExactLit::Color c = {r, g, b, color_one, texel & (Is565 ? 0xFFFF : 0xFFFFFF)};
            const std::uint32_t fogs[] = {0, 1 << 24, (1 << 24) - 1, ~0u, below(1 << 24)};
            const std::uint32_t fog = fogs[i % 5];
            ASSERT_EQ(store.word(c, fog), Store::done_again(c, fog, state.fragment.fog_color, threshold))
                << r << ' ' << g << ' ' << b << ' ' << c.texel << ' ' << fog;
        }
    }
}

TEST(LitStore, WordsAreThoseOfTheChain) {
    check_words<true, true, false>(1);
    check_words<true, false, false>(2);
    check_words<false, true, false>(3);
    check_words<false, false, false>(4);
}
TEST(LitStore, DitheredWordsAreThoseOfTheChain) {
    check_words<true, true, true>(5);
    check_words<true, false, true>(6);
    check_words<false, true, true>(7);
    check_words<false, false, true>(8);
}

template <std::uint32_t Most> void check_factors() {
    for (std::uint32_t k = 0; k <= Most; ++k) {
        const double short_by = k * 65536. / Most - inner::lit_factors<Most>.of[k];
        EXPECT_GE(short_by, 0) << k;
        EXPECT_LE(short_by, 1) << k;
    }
}
TEST(LitStore, FactorsAreAtMostOneTooSmall) {
    check_factors<31>();
    check_factors<63>();
    check_factors<255>();
}

template <class Products, std::uint32_t Whole, std::uint32_t Most, bool HasFog> void check_component() {
    using Numbers = LitNumbers<Products>;
    constexpr std::uint32_t one = 255 << 8 << Products::fraction_bits;
    constexpr double unit = Whole / 255.;
    const std::uint32_t whole_fog = Numbers::rest(0);
    std::mt19937 random(1);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random()) % n; };
    for (int i = 0; i < 200000; ++i) {
        const std::uint32_t c = i % 4 == 0 ? one - below(2) : below(one + 1),
                            k = i % 3 == 0 ? Most : below(Most + 1), // a factor that is often 1
            f = i % 5 == 0 ? whole_fog - below(2) : below(whole_fog + 1), color = below(color_one + 1);
        const double share = !HasFog || f == whole_fog ? 1 : f / (65536. * (1 << Products::fraction_bits)),
                     light = c * 255. / one * k / Most,
                     exact = unit * (light * share + color * (1 - share) / (1 << color_fraction_bits));
        std::uint32_t guess =
            Numbers::template light<Whole, Most>(HasFog ? Numbers::share(c, f) : Numbers::whole(c)) * k;
        if (HasFog)
            guess = Numbers::fogged(guess, Numbers::template fog_color<Whole>(color), Numbers::rest(f));
        ASSERT_LE(guess, exact + (Numbers::template under<true>))
            << c << ' ' << k << ' ' << f << ' ' << color;
        ASSERT_GE(guess + (Numbers::template over<Whole, Most, HasFog>), exact)
            << c << ' ' << k << ' ' << f << ' ' << color;
    }
}
template <class Products, bool HasFog> void check_components() {
    constexpr int top = LitNumbers<Products>::top;
    constexpr std::uint32_t bytes = 255u << (top - 8), five = 31u << (top - 6), six = 63u << (top - 6);
    check_component<Products, bytes, 31, HasFog>();
    check_component<Products, bytes, 63, HasFog>();
    check_component<Products, bytes, 255, HasFog>();
    check_component<Products, five, 31, HasFog>();
    check_component<Products, six, 63, HasFog>();
    check_component<Products, five, 255, HasFog>();
    check_component<Products, six, 255, HasFog>();
}
TEST(LitNumbers, ComponentsAreWithinTheirDoubt) {
    check_components<NearWords, true>();
    check_components<NearWords, false>();
    check_components<NearHalves, true>();
    check_components<NearHalves, false>();
}

} // namespace
} // namespace spangle::raster::test
