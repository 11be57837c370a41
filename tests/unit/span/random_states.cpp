// Draws every primitive in random states: what compile() chose must store the same bytes as the state's
// stages one after the other. Two of five states are those of fused spans, or a few steps beside them.
#include <gtest/gtest.h>

#include "raster/primitive/line_stipple.hpp"
#include "tests/unit/span/single_fragments.hpp"
#include "tests/unit/span/state_of_key.hpp"

namespace spangle::raster::test {
namespace {

constexpr int width = 56, height = 14;

/// Returns the state with the chain in all variants: no fused spans, tiles, paths or guesses.
DrawState chained(const DrawState& compiled, const Surface& target) {
    DrawState out = compiled;
    for (int i = 0; i < kind_count; ++i) {
        Variant& variant = out.variant[i];
        if (variant.run == nullptr)
            continue;
        const Key key = make_key(compiled.fragment, target, static_cast<Kind>(i));
        if (key.number == Number::raw565)
            variant.run = chain_runner(key.number);
        else
            single_fragments(variant, key, compiled.fragment);
        if (is_narrow(target.format)) // narrow surfaces store no plain rows of colours
            variant.run = reinterpret_cast<AnyFunction>(&by_narrow_row<Fixed, &chain_span<Exact>>);
        variant.gray = false;
        variant.walk = nullptr;
        variant.shapes = nullptr;
        // Set-up makes colours like this where none is guessed.
        const bool raw = key.number == Number::raw565;
        variant.steps = raw && key.dither;
        if (compiled.guesses)
            variant.color_bias = !raw ? 1u << 15 : variant.steps ? 0 : 1u << 23;
    }
    out.shapes = out.tiles = out.guesses = false;
    out.paths = {};
    return out;
}

/// Rows of an image or a bitmap, in which some pixels repeat.
struct Image : PixelSource {
    std::vector<std::uint32_t> words;
    std::uint32_t seed;
    bool colored;

    Image(RandomVertices& random, bool colors)
        : words(4 * width + pixel_room), seed(random.word()), colored(colors) {
        for (auto& word : words)
            word = random.below(color_one + 1);
        emit = [](PixelSource& source, PixelSink& sink) {
            auto& self = static_cast<Image&>(source);
            RandomVertices runs(self.seed);
            for (int y = 0; y < height; ++y) {
                const auto begin = static_cast<std::int32_t>(runs.below(width / 2)),
                           end = begin + 1 + static_cast<std::int32_t>(runs.below(width / 2));
                if (runs.below(4) == 0)
                    sink.depth(sink, runs.below(depth_one + 1));
                sink.run(sink, y, begin, end, self.colored ? self.words.data() : nullptr);
            }
        };
    }
};

enum class Draw {
    triangle,
    line,
    wide_line,
    stippled,
    point,
    rectangle,
    disc,
    smooth_line,
    smooth_point,
    polygon
};
constexpr std::uint32_t draws = 10;

/// Draws a primitive. If the state has coverage, it may be antialiased.
void draw_any(Draw what, RandomVertices random, const DrawState& state, const Surface& target,
              PrimitiveState& own, Kind kind) {
    Triangle t = random_triangle(random, width, height, kind);
    if (random.below(4) == 0) // one colour, whatever else varies
        for (FixedVertex& v : t.v)
            std::copy_n(t.v[0].color, 4, v.color);
    const FixedVertex &a = t.v[0], &b = t.v[1];
    const auto eighths = static_cast<std::int32_t>(8 + random.below(60));
    LineStipple stipple;
    stipple.pattern = static_cast<std::uint16_t>(random.word());
    stipple.factor = 1 + random.below(3);
    LineStipple* const maybe = random.below(2) == 0 ? &stipple : nullptr;
    switch (what) {
    case Draw::triangle:
        return draw(state, target, t);
    case Draw::line:
        return draw_line(state, target, a, b, b, 1);
    case Draw::wide_line:
        return draw_line(state, target, a, b, b, 3);
    case Draw::stippled:
        return draw_stippled_line(state, target, a, b, b, 2, stipple);
    case Draw::point:
        return draw_point(state, target, a, eighths / 8);
    case Draw::rectangle:
        return draw_line_rectangle(state, target, a, b, b, eighths, maybe);
    case Draw::disc:
        return draw_disc(state, target, a, eighths);
    case Draw::smooth_line:
        return draw_smooth_line(state, target, own, a, b, b, eighths, maybe);
    case Draw::smooth_point:
        return draw_smooth_point(state, target, own, a, eighths);
    case Draw::polygon: {
        const FixedVertex* const corner[3] = {&t.v[0], &t.v[1], &t.v[2]};
        return draw_smooth_polygon(state, target, own, corner, 3, t.v[2]);
    }
    }
}

struct Sweep {
    RandomVertices random{4242};
    Random texels{4242};
    int drawn = 0, fused = 0, kinds_of_draw[draws + 1] = {}, formats[10] = {};

    void round(int n) {
        const AnyTexture a(texels), b(texels);
        Extras extras(random, width);
        const FusedSpan& near = fused_span(random.below(static_cast<std::uint32_t>(fused_span_count)));
        StateOfKey of(near.key, width, height);
        FragmentState state = of.state;
        PixelFormat format = near.key.format;
        const std::uint32_t choice = random.below(5); // 0, 1: any state; 2: hardly any; 3, 4: a fused span's
        if (choice < 2)
            state = any_fragments(random, {&a.texture, &b.texture}, width, height);
        if (choice == 2)
            state = {};
        if (choice == 2)
            state.scissor = {3, 0, width - 7, height};
        if (choice <= 2)
            format = all_formats[random.below(10)];
        if (choice < 2 || random.below(3) == 0)
            extras.add_to(random, state);
        if (random.below(8) == 0)
            Extras::add_samples(random, state);
        state.flat = random.below(5) == 0;
        const bool image = random.below(8) == 0;
        const bool colored = image && random.below(4) != 0;
        if (colored)
            state.colors = Colors::of_pixels;
        const DepthFormat depth = random.below(3) == 0 ? DepthFormat::z24s8 : DepthFormat::z16;
        Canvas canvas[2] = {{width, height, format, depth}, {width, height, format, depth}};
        DrawState states[2] = {compile<FixedVertex>(state, canvas[0].surface), {}};
        if (states[0].nothing)
            return;
        states[1] = chained(states[0], canvas[1].surface);
        fused += find_fused(make_key(state, canvas[0].surface, Kind::affine)) != nullptr ? 1 : 0;
        ++formats[static_cast<int>(format)];
        for (int k = 0; k < kind_count; ++k) { // raw words have no alpha, and no stage that drops samples
            const Key key = make_key(state, canvas[0].surface, static_cast<Kind>(k));
            ASSERT_FALSE(key.samples && key.number == Number::raw565) << n;
        }
        Counters counters[2];
        const auto kind = static_cast<Kind>(random.below(4));
        auto what = static_cast<Draw>(random.below(state.coverage ? draws : draws - 3));
        const std::uint32_t seed = random.word();
        Image pixels(random, states[0].pixels);
        if (states[0].words) // raw words of 16 bits
            for (auto& word : pixels.words)
                word = seed * word;
        for (int i = 0; i < 2; ++i) {
            // The primitive itself finds the coverages.
            PrimitiveState own = extras.primitive;
            own.coverage = nullptr;
            own.antialiased = false;
            states[i].primitive = &own;
            states[i].counters = &counters[i];
            canvas[i].noise(static_cast<std::uint32_t>(n));
            for (std::uint32_t k = 0; k < 3; ++k)
                if (image)
                    draw_pixels(states[i], canvas[i].surface, RandomVertices(seed).vertex(width, height),
                                pixels);
                else
                    draw_any(what, RandomVertices(seed + k), states[i], canvas[i].surface, own, kind);
        }
        ++kinds_of_draw[image ? draws : static_cast<unsigned>(what)];
        ++drawn;
        ASSERT_EQ(canvas[0].color, canvas[1].color) << n;
        ASSERT_EQ(canvas[0].depth, canvas[1].depth) << n;
        ASSERT_EQ(counters[0].passed, counters[1].passed) << n;
    }
};

TEST(RandomStates, IsDrawnAsItsStagesOneAfterTheOther) {
    Sweep sweep;
    for (int n = 0; n < 8000 && !HasFatalFailure(); ++n)
        sweep.round(n);
    EXPECT_GT(sweep.drawn, 6000);
    EXPECT_GT(sweep.fused, 1200);
    for (const int count : sweep.kinds_of_draw)
        EXPECT_GT(count, 100);
    for (const int count : sweep.formats)
        EXPECT_GT(count, 100);
}

} // namespace
} // namespace spangle::raster::test
