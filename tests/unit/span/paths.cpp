// Compares lines drawn as paths with the same lines drawn as rows: colour, depth, touched columns, counters.
#include <gtest/gtest.h>

#include "raster/ops/dither_pattern.hpp"
#include "raster/ops/stage_raw.hpp"
#include "raster/primitive/draw.hpp"
#include "raster/primitive/line_batch.hpp"
#include "raster/primitive/line_end.hpp"
#include "raster/primitive/setup_math.hpp"
#include "tests/unit/span/sweep.hpp"

namespace spangle::raster::test {
namespace {

constexpr int width = 48, height = 40;

struct Drawn {
    Canvas canvas;
    std::vector<RowSpan> touched = std::vector<RowSpan>(height);
    Counters counters;
    DrawState state;

    Drawn(const FragmentState& fragment, DepthFormat depth, bool walks)
        : canvas(width, height, PixelFormat::rgb565_be, depth) {
        canvas.noise(9);
        canvas.surface.touched = touched.data();
        canvas.surface.touched_step = 1;
        state = compile<FixedVertex>(fragment, canvas.surface);
        state.counters = &counters;
        if (!walks)
            state.paths = {};
    }
    void line(const FixedVertex& a, const FixedVertex& b) {
        draw_line<FixedVertex>(state, canvas.surface, a, b, b, 1);
    }
    /// Draws a line in one lane, as processors without vectors do.
    void line_in_turn(const FixedVertex& a, const FixedVertex& b) {
        draw_line_by<LineLanes<1>>(state, canvas.surface, a, b, b, 1);
    }
    void expect(const Drawn& other, int i) const {
        EXPECT_EQ(canvas.color, other.canvas.color) << "line " << i;
        EXPECT_EQ(canvas.depth, other.canvas.depth) << "line " << i;
        EXPECT_EQ(touched, other.touched) << "line " << i;
        EXPECT_EQ(counters.fragments, other.counters.fragments) << "line " << i;
        EXPECT_EQ(counters.triangles, other.counters.triangles) << "line " << i;
    }
    void forget() { touched.assign(touched.size(), RowSpan{}); }
};

FixedVertex random_end(std::mt19937& random, bool same_w, int beyond) {
    const auto within = [&](int size) {
        return static_cast<std::int32_t>(random() % static_cast<unsigned>((size + 2 * beyond) * 256)) -
               beyond * 256;
    };
    FixedVertex v{};
    v.x = within(width);
    v.y = within(height);
    v.z = random() >> 1;
    v.w_mantissa = same_w ? 0x80000000u : 0x80000000u | random();
    v.w_exponent = same_w ? -31 : -31 - static_cast<int>(random() % 3);
    for (auto& c : v.color)
        c = random() % (255u << color_fraction_bits);
    return v;
}

struct Case {
    bool flat, same_w, depth, dither;
    Rect scissor;
};

long compare(const Case& c, bool& walks) {
    FragmentState fragment;
    fragment.scissor = c.scissor;
    fragment.tier = Tier::balanced;
    fragment.dither = c.dither;
    fragment.flat = c.flat;
    fragment.depth_test = c.depth;
    fragment.depth_func = Compare::less;
    const DepthFormat format = c.depth ? DepthFormat::z16 : DepthFormat::none;
    Drawn path(fragment, format, true), in_turn(fragment, format, true), rows(fragment, format, false);
    walks = path.state.paths.w != 0;
    std::mt19937 random(21);
    for (int i = 0; i < 2000; ++i) {
        const FixedVertex a = random_end(random, c.same_w, 4);
        FixedVertex b = random_end(random, c.same_w, 4);
        if (i % 5 == 0)
            b.x = a.x + (i % 2 == 0 ? b.y - a.y : a.y - b.y); // a line of 45 degrees
        if (i % 7 == 0)
            b.y = a.y;
        if (i % 16 == 0) // some lines find all or some of their columns touched already
            path.forget(), in_turn.forget(), rows.forget();
        path.line(a, b);
        in_turn.line_in_turn(a, b);
        rows.line(a, b);
        path.expect(rows, i);
        in_turn.expect(rows, i);
        if (testing::Test::HasFailure())
            break;
    }
    return path.counters.fragments;
}

TEST(Paths, AreTheirRows) {
    for (const bool flat : {false, true})
        for (const bool same_w : {false, true})
            for (const bool depth : {false, true})
                for (const bool dither : {false, true})
                    for (const Rect scissor : {Rect{0, 0, width, height}, Rect{5, 7, 30, 21}}) {
                        bool walks = false;
                        EXPECT_GT(compare({flat, same_w, depth, dither, scissor}, walks), 10000);
                        EXPECT_TRUE(walks) << "a state with a loop over paths";
                    }
}

/// Many lines of all kinds and places are drawn at once. Each must be drawn as if it were alone, in the order
/// of the lines.
TEST(Paths, ManyAreOneAfterTheOther) {
    std::mt19937 random(22);
    FragmentState fragment;
    fragment.scissor = {5, 7, 36, 27};
    fragment.tier = Tier::balanced;
    fragment.depth_test = true;
    fragment.depth_func = Compare::lequal;
    for (const bool dither : {false, true}) {
        fragment.dither = dither;
        Drawn many(fragment, DepthFormat::z16, true), single(fragment, DepthFormat::z16, true);
        for (int round = 0; round < 400; ++round) {
            std::vector<FixedVertex> v;
            std::vector<const FixedVertex*> at;
            at.reserve(41);
            // Lines may reach beyond the picture, or all lie inside.
            const int step = 1 + round % 2, beyond = round % 3 == 0 ? 1 : -8;
            for (int i = 0; i < 41; ++i) {
                v.push_back(random_end(random, true, beyond));
                v.back().z = v[0].z; // the last line stays visible
                if (i > 0 && (round % 5 != 0 || random() % 2 != 0))
                    std::copy_n(v[v.size() - 2].color, 4, v.back().color);
            }
            for (const FixedVertex& vertex : v)
                at.push_back(&vertex);
            many.state.fragment.flat = single.state.fragment.flat = round % 7 == 0;
            const bool painted = round % 11 == 0;
            for (FixedVertex& vertex : v)
                if (painted)
                    std::copy_n(v[0].color, 4, vertex.color);
            draw_lines<FixedVertex>(many.state, many.canvas.surface, at.data(), 41, step,
                                    painted ? at[0] : nullptr, 1);
            for (int i = 0; i + 1 < 41; i += step)
                draw_line<FixedVertex>(single.state, single.canvas.surface, *at[i], *at[i + 1], *at[i + 1],
                                       1);
            ASSERT_EQ(many.canvas.color, single.canvas.color) << "round " << round;
            ASSERT_EQ(many.canvas.depth, single.canvas.depth) << "round " << round;
        }
        EXPECT_EQ(many.touched, single.touched);
        EXPECT_EQ(many.counters.fragments, single.counters.fragments);
        EXPECT_EQ(many.counters.triangles, single.counters.triangles);
    }
}

/// Strips go on in one direction and turn, as curves do, with lines from a subpixel to half the picture.
TEST(Paths, StripsAreTheirRows) {
    std::mt19937 random(23);
    FragmentState fragment;
    fragment.scissor = {0, 0, width, height};
    fragment.tier = Tier::balanced;
    fragment.depth_test = true;
    fragment.depth_func = Compare::less;
    const auto noise = [&](int most) {
        return static_cast<std::int32_t>(random() % static_cast<unsigned>(2 * most + 1)) - most;
    };
    for (const bool dither : {false, true})
        for (const int step : {1, 2}) {
            fragment.dither = dither;
            Drawn in_turn(fragment, DepthFormat::z16, true), together(fragment, DepthFormat::z16, true),
                strip(fragment, DepthFormat::z16, true), rows(fragment, DepthFormat::z16, false);
            const DrawState::Area area = strip_area(strip.state, 1);
            EXPECT_TRUE(area.holds(2 * 256, 2 * 256) && area.holds((width - 2) * 256, (height - 2) * 256));
            EXPECT_EQ(strip_area(strip.state, 2).w, 0u);
            EXPECT_EQ(strip_area(rows.state, 1).w, 0u);
            long fragments = 0;
            for (int round = 0; round < 1600; ++round) {
                std::vector<FixedVertex> v(20);
                std::vector<const FixedVertex*> at;
                const int longest = 1 << (round % 13), turn = 1 + longest / (1 + round % 5);
                std::int32_t dx = noise(longest), dy = noise(longest);
                for (std::size_t i = 0; i < v.size(); ++i) {
                    const FixedVertex& last = i == 0 ? random_end(random, true, -8) : v[i - 1];
                    v[i] = last;
                    v[i].x = std::clamp(last.x + dx, 2 * 256, (width - 2) * 256);
                    v[i].y = std::clamp(last.y + dy, 2 * 256, (height - 2) * 256);
                    v[i].z = i % 4 == 0 ? random() >> 1 : last.z + static_cast<std::uint32_t>(noise(1 << 12));
                    v[i].z = std::min(v[i].z, depth_one);
                    if (round % 4 != 3) // in other rounds each line has a colour of its own
                        std::copy_n(v[0].color, 4, v[i].color);
                    else
                        std::copy_n(random_end(random, true, -8).color, 4, v[i].color);
                    dx += noise(turn), dy += noise(turn);
                    at.push_back(&v[i]);
                }
                const FixedVertex* const painted = round % 2 == 0 ? at[0] : nullptr;
                for (Drawn* const drawn : {&in_turn, &together, &strip, &rows})
                    drawn->state.fragment.flat = round % 4 == 3;
                draw_lines_by<LineLanes<1>>(in_turn.state, in_turn.canvas.surface, at.data(), 20, step,
                                            painted, 1);
                draw_lines<FixedVertex>(together.state, together.canvas.surface, at.data(), 20, step, painted,
                                        1);
                for (std::size_t i = 0; i + 1 < v.size(); i += static_cast<std::size_t>(step))
                    rows.line(v[i], v[i + 1]);
                in_turn.expect(rows, round);
                together.expect(rows, round);
                if (step == 1 && round % 4 != 3) {
                    std::vector<LineEnd> ends;
                    for (const FixedVertex& end : v)
                        ends.push_back(line_end(end));
                    draw_strip(strip.state, strip.canvas.surface, ends.data(), 10, v[0]);
                    draw_strip(strip.state, strip.canvas.surface, ends.data() + 9, 11, v[0]);
                    strip.expect(rows, round);
                } else {
                    for (std::size_t i = 0; i + 1 < v.size(); i += static_cast<std::size_t>(step))
                        strip.line(v[i], v[i + 1]);
                }
                ASSERT_FALSE(HasFailure());
                fragments = in_turn.counters.fragments;
                if (round % 16 == 0) // stored depths that lines can be nearer than
                    for (Drawn* const drawn : {&in_turn, &together, &strip, &rows})
                        drawn->canvas.noise(9);
            }
            EXPECT_GT(fragments, 10000);
        }
}

TEST(Paths, OneColorIsDitheredAsItsTierDithersColors) {
    std::mt19937 random(5);
    for (int i = 0; i < 20000; ++i) {
        std::uint32_t color[4];
        for (auto& c : color)
            c = i % 3 == 0 ? random() % 256 << color_fraction_bits : random() % (color_one + 1);
        const auto same = [&]<class N>(N) {
            const auto x = static_cast<std::int32_t>(random() % 64),
                       y = static_cast<std::int32_t>(random() % 64);
            const std::uint32_t t = dither_threshold(dither_row(y), x);
            const auto c = [&](int k) { return N::from_units(color[k]); };
            const std::uint32_t want = N::template dithered<5>(c(0), t) << 11 |
                                       N::template dithered<6>(c(1), t) << 5 |
                                       N::template dithered<5>(c(2), t);
            const std::uint32_t components = dithered_word<N>(color);
            ASSERT_EQ(DitheredWord{components}.at(DitheredWord::place(x, y)), want);
            const std::uint32_t swapped = __builtin_bswap16(static_cast<std::uint16_t>(want));
            ASSERT_EQ(std::uint32_t{DitherRows<false>(components).row(y)[x & 3]}, want);
            ASSERT_EQ(std::uint32_t{DitherRows<true>(components).row(y)[(x & 3) + 4]}, swapped);
            const auto row = static_cast<std::int32_t>(random() % 64) - 32;
            const std::uint32_t at = PathPixels::row * static_cast<std::uint32_t>(y) +
                                     PathPixels::pixel(static_cast<std::uint32_t>(y * row + x));
            DitherCells<true> cells;
            cells.make(components, row);
            ASSERT_EQ(std::uint32_t{cells.words()[PathPixels::cell(at)]}, swapped);
        };
        same(Exact{});
        same(Balanced<1>{});
    }
}

} // namespace
} // namespace spangle::raster::test
