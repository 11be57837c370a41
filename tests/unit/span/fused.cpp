// Every fused span stores the same bytes as its chain, with one lane and with eight, over all alignments and
// lengths.
#include <gtest/gtest.h>

#include <algorithm>

#include "raster/fused/cases.hpp"
#include "tests/unit/span/state_of_key.hpp"

namespace spangle::raster::test {
namespace {

constexpr int width = 56, height = 12;

struct Hits {
    int draws = 0;
    bool length[41] = {}, alignment[8] = {};
};
Hits hits;
RowsFunction<Fixed> under_test;

/// Replaces the span function: records the length and alignment of each row, then draws the row.
void note_and_draw(Span<Fixed>& span, const Row* row, const Row* end) {
    for (const Row* r = row; r != end; ++r) {
        const std::int32_t n = r->last - r->first;
        ++hits.draws;
        if (n <= 40)
            hits.length[n] = true;
        hits.alignment[reinterpret_cast<std::uintptr_t>(span.target->color_row(r->y) + 2 * r->first) / 2 %
                       8] = true;
    }
    under_test(span, row, end);
}

/// Gives each vertex a texture coordinate q of its own.
void project_texture(RandomVertices& source, Triangle& t) {
    for (FixedVertex& v : t.v) {
        v.tex[0].q = static_cast<std::int32_t>((1u << 28) + source.below(1u << 29));
        v.tex[0].q_is_one = 0;
    }
}

void expect_equal(const FusedSpan& fused, RowsFunction<Fixed> run, const char* name, int log2_texels = 6,
                  int log2_rows = 5) {
    const StateOfKey of(fused.key, width, height, log2_texels, log2_rows);
    const DepthFormat depth =
        fused.key.depth_format == DepthFormat::none ? DepthFormat::z16 : fused.key.depth_format;
    Canvas chain_canvas(width, height, fused.key.format, depth),
        fused_canvas(width, height, fused.key.format, depth);
    DrawState state = compile<FixedVertex>(of.state, chain_canvas.surface);
    const auto kind = static_cast<unsigned>(fused.key.kind);
    ASSERT_EQ(reinterpret_cast<RowsFunction<Fixed>>(state.variant[kind].run), fused.run)
        << "the key is not the state's: " << name;
    DrawState chained = in_chain(state, fused.key);
    state.shapes = state.tiles = false; // without these forms, small triangles are drawn as rows, too
    under_test = run;
    state.variant[kind].run = reinterpret_cast<AnyFunction>(&note_and_draw);
    hits = {};
    RandomVertices source(17 + kind);
    const int rounds = fused.key.unit[0].on ? 1400 : 700; // the second half of the rounds draws sprites
    for (int round = 0; round < rounds; ++round) {
        chain_canvas.noise(static_cast<std::uint32_t>(round));
        fused_canvas.noise(static_cast<std::uint32_t>(round));
        Triangle t = round < 700 ? random_triangle(source, width, height, fused.key.kind)
                                 : random_sprite(source, width, height, fused.key.kind);
        if (round % 3 == 0 && fused.key.kind != Kind::flat)
            for (int i = 0; i < (round % 2 == 0 ? 3 : 2); ++i) // makes the colours gray, or nearly gray
                t.v[i].color[0] = t.v[i].color[1] = t.v[i].color[2];
        if (round % 5 == 0 && fused.key.kind >= Kind::textured)
            project_texture(source, t);
        if (round % 7 == 3) // makes the texture repeat many times
            for (FixedVertex& v : t.v)
                v.tex[0].exponent = -20;
        const Rect cut = {static_cast<int>(source.below(8)), 0,
                          width - static_cast<int>(source.below(30)) - 8, height};
        state.fragment.scissor = chained.fragment.scissor = round % 2 == 0 ? of.state.scissor : cut;
        // The fused span draws first, because the chain would leave its planes on the stack.
        draw(state, fused_canvas.surface, t);
        draw(chained, chain_canvas.surface, t);
        ASSERT_EQ(chain_canvas.color, fused_canvas.color) << name << " round " << round;
        ASSERT_EQ(chain_canvas.depth, fused_canvas.depth) << name << " round " << round;
    }
    EXPECT_GE(hits.draws, 500) << name;
    EXPECT_EQ(std::count(hits.length + 1, hits.length + 41, true), 40) << name;
    EXPECT_EQ(std::count(hits.alignment, hits.alignment + 8, true), 8) << name;
}

TEST(Fused, EverySpanIsItsChain) {
    ASSERT_GT(fused_span_count, 10u);
    for (std::size_t i = 0; i < fused_span_count; ++i) {
        const FusedSpan& fused = fused_span(i);
        const std::string name = "entry " + std::to_string(i);
        expect_equal(fused, fused.run, (name + ", lanes of this build").c_str());
        expect_equal(fused, fused.narrow, (name + ", one lane").c_str());
    }
}

/// The key of a lit texture that is drawn with products of halves, as on boards without long products.
template <Kind K, TexelFormat Texels, bool Fog> constexpr Key lit_key() {
    Key key;
    key.number = Number::exact;
    key.kind = K;
    key.depth = Compare::less;
    key.depth_write = true;
    key.depth_format = DepthFormat::z16;
    key.unit[0] = {true, false, Texels, BaseFormat::rgb, Filter::nearest, TexEnv::modulate};
    key.color = true;
    key.fog = Fog;
    if (Fog)
        key.fog_mode = FogMode::linear;
    return key;
}
template <Key K> void draw_by_halves(Span<Fixed>& span, const Row* row, const Row* end) {
    using Case = FusedCase<K>;
    if (!Case::serves(span))
        Case::template run_lanes<1>(span, row, end);
    else if (Case::splits_gray && span.gray)
        fused_lit_rows<FusedCase<K, true>, NearHalves>(span, row, end);
    else
        fused_lit_rows<Case, NearHalves>(span, row, end);
}
template <Key K> void expect_halves_equal(const char* name) {
    const FusedSpan* const found = find_fused(K);
    ASSERT_NE(found, nullptr) << name;
    expect_equal(*found, &draw_by_halves<K>, name);
}

TEST(Fused, LitTexturesByHalves) {
    expect_halves_equal<lit_key<Kind::full, TexelFormat::rgb565, true>()>("full 565 fog");
    expect_halves_equal<lit_key<Kind::full, TexelFormat::rgb888, true>()>("full 888 fog");
    expect_halves_equal<lit_key<Kind::full, TexelFormat::rgb565, false>()>("full 565");
    expect_halves_equal<lit_key<Kind::textured, TexelFormat::rgb565, true>()>("textured 565 fog");
}

TEST(Fused, OneTexelAlongAnAxis) {
    constexpr int sizes[][2] = {{0, 4}, {7, 0}, {0, 0}};
    int textured = 0;
    for (std::size_t i = 0; i < fused_span_count; ++i) {
        const FusedSpan& fused = fused_span(i);
        if (!fused.key.unit[0].on)
            continue;
        const auto& [texels, rows] = sizes[textured++ % 3];
        const std::string name = "entry " + std::to_string(i);
        expect_equal(fused, fused.run, (name + ", lanes of this build").c_str(), texels, rows);
        expect_equal(fused, fused.narrow, (name + ", one lane").c_str(), texels, rows);
    }
    EXPECT_GT(textured, 30);
}

TEST(Fused, ImagesOfMoreTexelsThanAWordOf16BitsCounts) {
    int modulated = 0;
    for (std::size_t i = 0; i < fused_span_count; ++i) {
        const FusedSpan& fused = fused_span(i);
        if (fused.key.kind != Kind::affine || fused.key.unit[0].env != TexEnv::modulate || !fused.key.fog)
            continue;
        expect_equal(fused, fused.run, ("entry " + std::to_string(i)).c_str(), 9, 8);
        ++modulated;
    }
    EXPECT_GE(modulated, 4);
}

/// In wide triangles 1/w and the coordinates vary little, so the guesses leave many fragments of a patch
/// open.
TEST(Fused, WidePatchesAreTheirChain) {
    constexpr int wide = 264, high = 20;
    int lit = 0;
    for (std::size_t i = 0; i < fused_span_count; ++i) {
        const FusedSpan& fused = fused_span(i);
        const Key& key = fused.key;
        if (key.number != Number::exact || key.kind < Kind::textured || key.unit[0].env != TexEnv::modulate)
            continue;
        ++lit;
        const StateOfKey of(key, wide, high);
        Canvas chain_canvas(wide, high, key.format, key.depth_format),
            fused_canvas(wide, high, key.format, key.depth_format);
        const DrawState state = compile<FixedVertex>(of.state, chain_canvas.surface),
                        chained = in_chain(state, key);
        RandomVertices source(31);
        for (int round = 0; round < 60; ++round) {
            chain_canvas.noise(static_cast<std::uint32_t>(round));
            fused_canvas.noise(static_cast<std::uint32_t>(round));
            Triangle t = random_triangle(source, wide, high, key.kind);
            const auto far = static_cast<std::int32_t>(source.below(0x7FC00000));
            for (int k = 0; k < 3; ++k) {
                FixedVertex& v = t.v[k];
                v.x = (k == 1 ? wide - 1 : 0) * 256 + static_cast<std::int32_t>(source.below(256));
                v.y = (k == 2 ? high - 1 : 0) * 256 + static_cast<std::int32_t>(source.below(256));
                v.z = source.below(1 << 20);
                v.w_mantissa = 0xF0000000u + source.below(1u << 26);
                v.w_exponent = t.v[0].w_exponent;
                if (round % 3 == 0) // often far beyond the end of fog
                    v.fog_mantissa = far + static_cast<std::int32_t>(source.below(1u << 20)),
                    v.fog_exponent = -27;
                v.tex[0].s = static_cast<std::int32_t>(source.below(1u << 26));
                v.tex[0].t = static_cast<std::int32_t>(source.below(1u << 26));
            }
            draw(chained, chain_canvas.surface, t);
            draw(state, fused_canvas.surface, t);
            ASSERT_EQ(chain_canvas.color, fused_canvas.color) << i << " round " << round;
            ASSERT_EQ(chain_canvas.depth, fused_canvas.depth) << i << " round " << round;
        }
    }
    EXPECT_GE(lit, 6);
}

/// The texture repeats so often that the high word of a coordinate does not decide the texel alone. In one of
/// 4,000 fragments the low word decides, with what is added to it. All fragments are nearer than any fog.
TEST(Fused, TexelsManyRepeatsAwayAreTheirChain) {
    constexpr int wide = 128, high = 64;
    int divided = 0;
    for (std::size_t i = 0; i < fused_span_count; ++i) {
        const FusedSpan& fused = fused_span(i);
        const Key& key = fused.key;
        if (key.number != Number::exact || key.kind != Kind::full || key.unit[0].env != TexEnv::modulate)
            continue;
        ++divided;
        const StateOfKey of(key, wide, high);
        Canvas chain_canvas(wide, high, key.format, key.depth_format),
            fused_canvas(wide, high, key.format, key.depth_format);
        DrawState state = compile<FixedVertex>(of.state, chain_canvas.surface);
        const DrawState chained = in_chain(state, key);
        state.shapes = state.tiles = false;
        state.variant[static_cast<unsigned>(Kind::full)].run = reinterpret_cast<AnyFunction>(fused.narrow);
        RandomVertices source(37);
        for (int round = 0; round < 24; ++round) {
            chain_canvas.noise(static_cast<std::uint32_t>(round));
            fused_canvas.noise(static_cast<std::uint32_t>(round));
            Triangle t = random_triangle(source, wide, high, key.kind);
            for (int k = 0; k < 3; ++k) {
                FixedVertex& v = t.v[k];
                v.x = (k == 1 ? wide - 1 : 0) * 256 + static_cast<std::int32_t>(source.below(256));
                v.y = (k == 2 ? high - 1 : 0) * 256 + static_cast<std::int32_t>(source.below(256));
                v.z = source.below(1 << 20);
                v.w_exponent = -32;
                v.fog_mantissa = 0;
                v.tex[0].exponent = -18;
            }
            draw(chained, chain_canvas.surface, t);
            draw(state, fused_canvas.surface, t);
            ASSERT_EQ(chain_canvas.color, fused_canvas.color) << i << " round " << round;
        }
    }
    EXPECT_GE(divided, 4);
}

TEST(Fused, PaddedRowsOfTexelsAreReadAsTheyLie) {
    constexpr int row = 64 * 2;
    TestTexture packed(TexelFormat::rgb565, BaseFormat::rgb), padded = packed;
    padded.texels.clear();
    for (int y = 0; y < 64; ++y) {
        padded.texels.insert(padded.texels.end(), packed.texels.begin() + y * row,
                             packed.texels.begin() + (y + 1) * row);
        padded.texels.insert(padded.texels.end(), {1, 2, 3, 4});
    }
    padded.texture.level[0].texels = padded.texels.data();
    packed.texture.level[0].texels = packed.texels.data();
    padded.texture.level[0].stride = row + 4;
    Canvas canvas[2] = {{width, height, PixelFormat::rgb565_be, DepthFormat::none},
                        {width, height, PixelFormat::rgb565_be, DepthFormat::none}};
    for (int i = 0; i < 2; ++i) {
        FragmentState state;
        state.tier = Tier::balanced;
        state.scissor = {0, 0, width, height};
        state.unit[0].texture = i == 0 ? &packed.texture : &padded.texture;
        state.unit[0].env = TexEnv::replace;
        RandomVertices source(5);
        for (int n = 0; n < 20; ++n)
            draw(compile<FixedVertex>(state, canvas[i].surface), canvas[i].surface,
                 random_triangle(source, width, height, Kind::affine));
    }
    EXPECT_EQ(canvas[0].color, canvas[1].color);
}

TEST(Fused, KeysAreDistinct) {
    for (std::size_t i = 0; i < fused_span_count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(fused_span(i).key == fused_span(j).key) << i << " and " << j;
}

} // namespace
} // namespace spangle::raster::test
