// The exact tier guesses colours. The divided colour must lie in the range that set-up gives for the guess.
#include <gtest/gtest.h>

#include "raster/ops/stage_guess.hpp"
#include "raster/primitive/setup.hpp"
#include "tests/unit/span/state_of_key.hpp"

namespace spangle::raster::test {
namespace {

constexpr int width = 64, height = 48;

/// Returns a triangle of any shape, slivers among them; 1/w and colours vary by any power of two.
Triangle any_triangle(RandomVertices& source) {
    Triangle t = random_triangle(source, width, height, Kind::full);
    if (source.below(3) == 0) // makes a sliver
        for (int i = 1; i < 3; ++i) {
            t.v[i].x = t.v[0].x + i * static_cast<std::int32_t>(source.below(3000)) - 2000;
            t.v[i].y = t.v[0].y + static_cast<std::int32_t>(source.below(40));
        }
    const std::uint32_t w = 0x80000000u + (source.word() >> 2), w_range = 1u << (10 + source.below(20)),
                        c_range = 1u << (8 + source.below(20));
    for (FixedVertex& v : t.v) {
        v.w_mantissa = w + source.below(w_range);
        v.w_exponent = -32;
        for (std::uint32_t& c : v.color) {
            c = t.v[0].color[0] / 2 + source.below(c_range);
            c = c < color_one ? c : color_one;
        }
    }
    return t;
}

bool covers(const FixedVertex (&v)[3], std::int32_t x, std::int32_t y) {
    const std::int32_t cx = x * subpixel_one + subpixel_one / 2, cy = y * subpixel_one + subpixel_one / 2;
    int sides = 0;
    for (int i = 0; i < 3; ++i) {
        const std::int64_t side = signed_area(v[i].x, v[i].y, v[(i + 1) % 3].x, v[(i + 1) % 3].y, cx, cy);
        sides |= side > 0 ? 1 : side < 0 ? 2 : 0;
    }
    return sides != 3;
}

/// Compares guessed with divided colours of random triangles. With `dither` the colours are in steps of the
/// format.
void hold_the_divided_colour(bool dither) {
    const Key key = [&] {
        Key k;
        k.dither = dither;
        k.number = Number::exact;
        k.kind = Kind::full;
        k.depth = Compare::less;
        k.depth_write = true;
        k.depth_format = DepthFormat::z16;
        return k;
    }();
    const StateOfKey of(key, width, height);
    Canvas canvas(width, height, key.format, key.depth_format);
    const DrawState state = compile<FixedVertex>(of.state, canvas.surface);
    ASSERT_TRUE(state.guesses);
    RandomVertices source(77);
    int guessed = 0, fragments = 0;
    double most = 0;
    for (int round = 0; round < 30000; ++round) {
        const Triangle t = any_triangle(source);
        const FixedVertex* v[3] = {&t.v[0], &t.v[1], &t.v[2]};
        std::sort(v, v + 3, [](auto* a, auto* b) { return a->y < b->y || (a->y == b->y && a->x < b->x); });
        const std::int64_t area = signed_area(v[0]->x, v[0]->y, v[1]->x, v[1]->y, v[2]->x, v[2]->y);
        if (area == 0)
            continue;
        Span<Fixed> span;
        span.state = &state;
        span.target = &canvas.surface;
        raster::Setup<Fixed>(span, *v[0], *v[1], *v[2], *v[2], area);
        if (span.kind != Kind::full || span.guess.project == nullptr)
            continue;
        ++guessed;
        // If set-up leaves no step open, the doubt may still be at most one step.
        const std::uint32_t doubt = span.guess.doubt5 == 0 ? 1u << 27 : (0 - span.guess.doubt5) >> 5;
        span.guess.project(span);
        for (std::int32_t y = 0; y < height; ++y)
            for (std::int32_t x = 0; x < width; ++x) {
                if (!covers(t.v, x, y))
                    continue;
                ++fragments;
                const auto at = [&](const auto& plane) {
                    return plane.at(x - span.anchor_x, y - span.anchor_y);
                };
                const Inverse inverse(unguarded(at(span.q)));
                for (int c = 0; c < 3; ++c) {
                    const std::uint32_t divided =
                        inner::projective_color(unguarded(at(span.color_q[c])), inverse);
                    const std::uint32_t steps = c == 1 ? 252 : 248, // the largest step in 255ths
                        wanted = dither
                                     ? static_cast<std::uint32_t>(std::uint64_t{divided} * 16 * steps / 255)
                                     : divided * 16 + (1u << 23),
                                        above = wanted - at(span.color_value[c]); // never below 0
                    ASSERT_LE(above, doubt) << "round " << round << " component " << c;
                    most = std::max(most, std::abs(2.0 * above / doubt - 1));
                }
            }
    }
    EXPECT_GT(guessed, 10000);
    EXPECT_GT(fragments, 500000);
    EXPECT_GT(most, 0.75); // the bound is nearly reached
}

TEST(Guesses, HoldTheDividedColour) {
    hold_the_divided_colour(false);
    hold_the_divided_colour(true);
}

/// A fragment is open if the doubt may reach the next step, and only then. A doubt of a whole step opens all
/// fragments.
TEST(Guesses, DoubtsOpenWhatTheyReach) {
    RandomVertices source(80);
    for (int i = 0; i < 100000; ++i) {
        const std::uint32_t most = 1 + (source.word() >> (1 + source.below(31))), v = source.word();
        Span<Fixed>::ColorGuess guess{};
        guess.doubt(most);
        const auto reaches = [&](int bits) {
            const std::uint64_t step = std::uint64_t{1} << (32 - bits);
            return v % step + most >= step;
        };
        ASSERT_EQ(v << 5 >= guess.doubt5, reaches(5)) << v << ' ' << most;
        ASSERT_EQ(v << 6 >= guess.doubt6, reaches(6)) << v << ' ' << most;
    }
}

TEST(Guesses, PicturesAreThoseOfDivisions) {
    for (std::size_t i = 0; i < fused_span_count; ++i) {
        const FusedSpan& fused = fused_span(i);
        if (!fused.guesses)
            continue;
        const StateOfKey of(fused.key, width, height);
        Canvas divided(width, height, fused.key.format, fused.key.depth_format),
            guessed(width, height, fused.key.format, fused.key.depth_format);
        DrawState state = compile<FixedVertex>(of.state, guessed.surface);
        const DrawState chained = in_chain(state, fused.key);
        RandomVertices source(78);
        for (int round = 0; round < 4000; ++round) {
            if (round % 50 == 0)
                divided.noise(static_cast<std::uint32_t>(round)),
                    guessed.noise(static_cast<std::uint32_t>(round));
            state.variant[static_cast<unsigned>(Kind::full)].run =
                reinterpret_cast<AnyFunction>(round % 2 == 0 ? fused.run : fused.narrow);
            const Triangle t = any_triangle(source);
            draw(chained, divided.surface, t);
            draw(state, guessed.surface, t);
            ASSERT_EQ(divided.color, guessed.color) << "entry " << i << " round " << round;
        }
    }
}

/// The colour of a line must not leave the range of its ends, so lines divide everywhere.
TEST(Guesses, LinesAreDivided) {
    const FusedSpan* guessing = nullptr;
    for (std::size_t i = 0; i < fused_span_count; ++i)
        guessing = fused_span(i).guesses ? &fused_span(i) : guessing;
    ASSERT_NE(guessing, nullptr);
    const StateOfKey of(guessing->key, width, height);
    Canvas divided(width, height, guessing->key.format, guessing->key.depth_format),
        guessed(width, height, guessing->key.format, guessing->key.depth_format);
    const DrawState state = compile<FixedVertex>(of.state, guessed.surface),
                    chained = in_chain(state, guessing->key);
    RandomVertices source(79);
    for (int round = 0; round < 4000; ++round) {
        const FixedVertex a = source.vertex(width, height), b = source.vertex(width, height);
        const auto wide = static_cast<std::int32_t>(1 + source.below(3));
        draw_line(chained, divided.surface, a, b, b, wide);
        draw_line(state, guessed.surface, a, b, b, wide);
        ASSERT_EQ(divided.color, guessed.color) << round;
    }
}

} // namespace
} // namespace spangle::raster::test
