// Compares texturing, fog, stencil and blending with values that are computed here from the formulas of GL
// 1.3.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "tests/unit/stages/canvas.hpp"

namespace spangle::raster::test {
namespace {

using Rgba4 = std::array<double, 4>;

/// Returns the colour of one fragment on an RGBA8888 surface, in 255ths.
template <class V> std::array<int, 4> fragment(const FragmentState& f, Canvas& c, const Point& p) {
    cover<V>(f, c, p);
    const StoredColor got = c.at(1, 1);
    return {got.c[0].k, got.c[1].k, got.c[2].k, got.c[3].k};
}

void expect_color(const FragmentState& f, const Point& p, const Rgba4& want, double tolerance,
                  const std::string& what, std::uint32_t under = 0) {
    for (const Tier tier : {Tier::exact, Tier::balanced}) {
        Canvas c(PixelFormat::rgba8888, 4, 4);
        for (std::size_t i = 0; i < c.color.size(); ++i)
            c.color[i] = static_cast<std::uint8_t>(under >> (8 * (i & 3)));
        FragmentState state = f;
        state.tier = tier;
        const auto got = fragment<FixedVertex>(state, c, p);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(got[i], 255 * want[i], tolerance + (tier == Tier::balanced ? 0.05 : 0))
                << what << " component " << i << " tier " << int(tier);
    }
}

/// Tests gl-commands 17.11 with N = 4 texels along s, a border colour, and no texture border.
TEST(Specification, WrapAndFilterVectors) {
    const std::uint8_t texel[4] = {10, 60, 130, 240};
    constexpr double b = 200; // the border's colour
    struct Row {
        double s;
        Wrap wrap;
        int nearest; // texel index; 4: border
        int i0, i1;  // texels of the linear sum
        double weight0;
    };
    constexpr Wrap R = Wrap::repeat, C = Wrap::clamp, E = Wrap::clamp_to_edge, B = Wrap::clamp_to_border;
    const Row rows[] = {{-0.25, R, 3, 2, 3, .5}, {-0.25, C, 0, 4, 0, .5},   {-0.25, E, 0, 0, 0, 1},
                        {-0.25, B, 4, 4, 4, 1},  {0.0, R, 0, 3, 0, .5},     {0.0, C, 0, 4, 0, .5},
                        {0.0, E, 0, 0, 0, 1},    {0.0, B, 0, 4, 0, .5},     {0.125, R, 0, 0, 0, 1},
                        {0.125, C, 0, 0, 0, 1},  {0.125, E, 0, 0, 0, 1},    {0.125, B, 0, 0, 0, 1},
                        {0.25, R, 1, 0, 1, .5},  {0.25, C, 1, 0, 1, .5},    {0.25, E, 1, 0, 1, .5},
                        {0.25, B, 1, 0, 1, .5},  {0.9375, R, 3, 3, 0, .75}, {0.9375, C, 3, 3, 4, .75},
                        {0.9375, E, 3, 3, 3, 1}, {0.9375, B, 3, 3, 4, .75}, {1.0, R, 0, 3, 0, .5},
                        {1.0, C, 3, 3, 4, .5},   {1.0, E, 3, 3, 3, 1},      {1.0, B, 3, 3, 4, .5},
                        {1.25, R, 1, 0, 1, .5},  {1.25, C, 3, 3, 4, .5},    {1.25, E, 3, 3, 3, 1},
                        {1.25, B, 4, 4, 4, 1}};
    const auto value = [&](int i) { return i == 4 ? b : texel[i]; };
    for (const Row& row : rows)
        for (const bool along_t : {false, true})
            for (const Filter filter : {Filter::nearest, Filter::linear}) {
                Texture t;
                t.level[0] = {texel, static_cast<std::uint16_t>(along_t ? 1 : 4),
                              static_cast<std::uint16_t>(along_t ? 4 : 1), along_t ? 1u : 4u};
                t.level_count = 1;
                t.format = TexelFormat::i8;
                t.base = BaseFormat::intensity;
                t.wrap_s = along_t ? R : row.wrap;
                t.wrap_t = along_t ? row.wrap : R;
                t.mag = t.min = filter;
                std::memset(t.border_color, 200, 4);
                Canvas c;
                FragmentState f = plain_state(c);
                f.scissor = {0, 0, 4, 4};
                f.unit[0].texture = &t;
                f.unit[0].env = TexEnv::replace;
                Point p;
                (along_t ? p.t : p.s) = row.s;
                const double want = filter == Filter::nearest
                                        ? value(row.nearest)
                                        : value(row.i0) * row.weight0 + value(row.i1) * (1 - row.weight0);
                for (const int w : {1, 3}) {
                    p.w = w;
                    expect_color(f, p, {want / 255, want / 255, want / 255, want / 255}, 0.51,
                                 "s " + std::to_string(row.s) + " wrap " + std::to_string(int(row.wrap)) +
                                     " filter " + std::to_string(int(filter)));
                }
            }
}

/// Border texels of the image are sampled if a wrap mode reaches them.
TEST(Specification, BorderTexels) {
    const std::uint8_t image[3 * 3] = {1, 2, 3, 4, 50, 6, 7, 8, 9};
    Texture t;
    t.level[0] = {image + 4, 1, 1, 3};
    t.level_count = 1;
    t.format = TexelFormat::i8;
    t.base = BaseFormat::intensity;
    t.border_texels = 1;
    t.wrap_s = t.wrap_t = Wrap::clamp_to_border;
    t.mag = t.min = Filter::nearest;
    Canvas c;
    FragmentState f = plain_state(c);
    f.scissor = {0, 0, 4, 4};
    f.unit[0].texture = &t;
    f.unit[0].env = TexEnv::replace;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            Point p;
            p.s = i + 0.5;
            p.t = j + 0.5;
            const double want = image[4 + 3 * j + i] / 255.0;
            expect_color(f, p, {want, want, want, want}, 0.51, std::to_string(i) + "," + std::to_string(j));
        }
}

/// Tests tables 3.21 and 3.22 of GL 1.3: base format, source colour, function.
TEST(Specification, EnvironmentTable) {
    const std::uint8_t bytes[4] = {90, 170, 30, 110};
    const Rgba4 cf = {0.8, 0.3, 0.55, 0.7}, cc = {0.2, 0.9, 0.4, 0.6};
    struct Base {
        TexelFormat format;
        BaseFormat base;
        Rgba4 source; // (Cs, As)
        bool color, alpha;
    };
    const double k[4] = {90 / 255., 170 / 255., 30 / 255., 110 / 255.};
    const Base bases[] = {
        {TexelFormat::a8, BaseFormat::alpha, {0, 0, 0, k[0]}, false, true},
        {TexelFormat::l8, BaseFormat::luminance, {k[0], k[0], k[0], 1}, true, false},
        {TexelFormat::la88, BaseFormat::luminance_alpha, {k[0], k[0], k[0], k[1]}, true, true},
        {TexelFormat::i8, BaseFormat::intensity, {k[0], k[0], k[0], k[0]}, true, true},
        {TexelFormat::rgb888, BaseFormat::rgb, {k[0], k[1], k[2], 1}, true, false},
        {TexelFormat::rgba8888, BaseFormat::rgba, {k[0], k[1], k[2], k[3]}, true, true}};
    for (const Base& base : bases)
        for (int env = 0; env < 5; ++env) {
            const auto mode = static_cast<TexEnv>(env);
            if (mode == TexEnv::decal && base.base != BaseFormat::rgb && base.base != BaseFormat::rgba)
                continue; // GL does not define this combination
            Rgba4 want = cf;
            const double as = base.source[3];
            for (std::size_t i = 0; i < 3 && base.color; ++i) {
                const double s = base.source[i];
                want[i] = mode == TexEnv::replace    ? s
                          : mode == TexEnv::modulate ? cf[i] * s
                          : mode == TexEnv::decal
                              ? (base.base == BaseFormat::rgba ? cf[i] * (1 - as) + s * as : s)
                          : mode == TexEnv::blend ? cf[i] * (1 - s) + cc[i] * s
                                                  : std::fmin(cf[i] + s, 1);
            }
            if (base.alpha && mode != TexEnv::decal) {
                const bool intensity = base.base == BaseFormat::intensity;
                want[3] = mode == TexEnv::replace              ? as
                          : mode == TexEnv::blend && intensity ? cf[3] * (1 - as) + cc[3] * as
                          : mode == TexEnv::add && intensity   ? std::fmin(cf[3] + as, 1)
                                                               : cf[3] * as;
            }
            for (const Filter filter : {Filter::nearest, Filter::linear})
                for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge}) {
                    Texture t;
                    t.level[0] = {bytes, 1, 1, 4};
                    t.level_count = 1;
                    t.format = base.format;
                    t.base = base.base;
                    t.mag = t.min = filter;
                    t.wrap_s = t.wrap_t = wrap;
                    Canvas c;
                    FragmentState f = plain_state(c);
                    f.scissor = {0, 0, 4, 4};
                    f.unit[0].texture = &t;
                    f.unit[0].env = mode;
                    for (std::size_t i = 0; i < 4; ++i)
                        f.unit[0].env_color[i] = static_cast<std::uint32_t>(std::lround(cc[i] * color_one));
                    Point p;
                    std::copy(cf.begin(), cf.end(), p.color);
                    p.s = p.t = 0.5;
                    expect_color(f, p, want, 0.52,
                                 "base " + std::to_string(int(base.base)) + " env " + std::to_string(env));
                }
        }
}

/// lambda <= c magnifies. c is 1/2 if LINEAR magnifies and NEAREST_MIPMAP_* minifies, else 0 (GL 1.3, 3.8.9).
TEST(Specification, SwitchOver) {
    std::uint8_t texels[16 * 16 + 8 * 8];
    for (std::size_t i = 0; i < sizeof texels; ++i)
        texels[i] = static_cast<std::uint8_t>(i * 71 + i / 16 * 13);
    for (const double lambda : {-0.2, 0.2, 0.45, 0.55, 0.9})
        for (const Filter min : {Filter::nearest, Filter::linear})
            for (const Filter mag : {Filter::nearest, Filter::linear})
                for (const MipFilter mip : {MipFilter::none, MipFilter::nearest}) {
                    Texture t;
                    t.level[0] = {texels, 16, 16, 16};
                    t.level[1] = {texels + 256, 8, 8, 8};
                    t.level_count = 2;
                    t.format = TexelFormat::l8;
                    t.base = BaseFormat::luminance;
                    t.mag = mag;
                    t.min = min;
                    t.mip = mip;
                    const auto picture = [&](const Texture& texture) {
                        Canvas c(PixelFormat::rgba8888, 32, 32);
                        FragmentState f = plain_state(c);
                        f.unit[0].texture = &texture;
                        Point p[4];
                        const double end = 32 * std::exp2(lambda) / 16;
                        p[1].x = p[2].x = p[2].y = p[3].y = 32;
                        p[1].s = p[2].s = p[2].t = p[3].t = end;
                        quad<FixedVertex>(f, c, p);
                        return c.color;
                    };
                    const bool late =
                        mag == Filter::linear && min == Filter::nearest && mip != MipFilter::none;
                    const bool magnified = lambda <= (late ? 0.5 : 0.0);
                    Texture plain = t;
                    plain.mip = MipFilter::none;
                    plain.mag = plain.min = magnified ? mag : min;
                    if (!magnified && mip == MipFilter::nearest && lambda > 0.5)
                        plain.level[0] = t.level[1];
                    EXPECT_EQ(picture(t), picture(plain))
                        << lambda << " min " << int(min) << " mag " << int(mag) << " mip " << int(mip);
                }
}

/// A component k of a 565 texel means k/31 or k/63.
TEST(Specification, Texels565) {
    for (std::uint32_t k = 0; k < 64; ++k) {
        const std::uint16_t word = static_cast<std::uint16_t>((k / 2) << 11 | k << 5 | (31 - k / 2));
        Texture t;
        t.level[0] = {reinterpret_cast<const std::uint8_t*>(&word), 1, 1, 2};
        t.level_count = 1;
        t.format = TexelFormat::rgb565;
        t.mag = t.min = Filter::nearest;
        Canvas c;
        FragmentState f = plain_state(c);
        f.scissor = {0, 0, 4, 4};
        f.unit[0].texture = &t;
        expect_color(f, Point{}, {(k / 2) / 31.0, k / 63.0, (31 - k / 2) / 31.0, 1}, 0.51, std::to_string(k));
    }
}

/// Tests gl-commands 17.8 and the formulas of GL 1.3, 3.10.
TEST(Specification, FogFactors) {
    for (int mode = 0; mode < 3; ++mode)
        for (const double density : {0.25, 1.0, 1.7})
            for (const double z : {0.0, 0.25, 0.5, 1.0, 2.0, 7.0}) {
                const double start = 0.125, end = 2 * density;
                const double f = mode == 0   ? std::exp(-density * z)
                                 : mode == 1 ? std::exp(-density * z * density * z)
                                             : std::fmin(std::fmax((end - z) / (end - start), 0), 1);
                Canvas c;
                FragmentState state = plain_state(c);
                state.scissor = {0, 0, 4, 4};
                state.fog = true;
                state.fog_mode = static_cast<FogMode>(mode);
                state.fog_density = std::bit_cast<std::uint32_t>(static_cast<float>(density));
                state.fog_start = std::bit_cast<std::uint32_t>(static_cast<float>(start));
                state.fog_end = std::bit_cast<std::uint32_t>(static_cast<float>(end));
                state.fog_color[0] = color_one;
                state.fog_color[1] = color_one / 4;
                Point p;
                p.color[0] = 0, p.color[1] = 0.75, p.color[2] = 1, p.color[3] = 0.4;
                p.fog = z;
                expect_color(state, p, {1 - f, f * 0.75 + (1 - f) * 0.25, f, 0.4}, 0.52,
                             "mode " + std::to_string(mode) + " d " + std::to_string(density) + " z " +
                                 std::to_string(z));
            }
}

constexpr Rgba4 blend_constant = {0.25, 0.8, 0.1, 0.6};

double blend_factor(BlendFactor f, const Rgba4& s, const Rgba4& d, std::size_t i) {
    switch (f) {
    case BlendFactor::zero:
        return 0;
    case BlendFactor::one:
        return 1;
    case BlendFactor::src_color:
        return s[i];
    case BlendFactor::one_minus_src_color:
        return 1 - s[i];
    case BlendFactor::src_alpha:
        return s[3];
    case BlendFactor::one_minus_src_alpha:
        return 1 - s[3];
    case BlendFactor::dst_alpha:
        return d[3];
    case BlendFactor::one_minus_dst_alpha:
        return 1 - d[3];
    case BlendFactor::dst_color:
        return d[i];
    case BlendFactor::one_minus_dst_color:
        return 1 - d[i];
    case BlendFactor::src_alpha_saturate:
        return i == 3 ? 1 : std::fmin(s[3], 1 - d[3]);
    case BlendFactor::constant_color:
        return blend_constant[i];
    case BlendFactor::one_minus_constant_color:
        return 1 - blend_constant[i];
    case BlendFactor::constant_alpha:
        return blend_constant[3];
    case BlendFactor::one_minus_constant_alpha:
        return 1 - blend_constant[3];
    }
    return 0;
}

double blended(const Blending& by, const Rgba4& s, const Rgba4& d, std::size_t i) {
    const double source = s[i] * blend_factor(by.src, s, d, i), stored = d[i] * blend_factor(by.dst, s, d, i);
    switch (by.equation) {
    case BlendEquation::add:
        return std::fmin(1, source + stored);
    case BlendEquation::subtract:
        return std::fmax(0, source - stored);
    case BlendEquation::reverse_subtract:
        return std::fmax(0, stored - source);
    case BlendEquation::min:
        return std::fmin(s[i], d[i]);
    case BlendEquation::max:
        return std::fmax(s[i], d[i]);
    }
    return 0;
}

/// A pair of colours on a lattice: the fragment's and the stored one.
struct BlendSample {
    Rgba4 s, d;
    Point p;
    std::uint32_t under = 0;
    explicit BlendSample(int n) {
        constexpr int level[] = {0, 1, 77, 128, 254, 255};
        const int s8[4] = {level[n % 6], level[(n * 5 + 2) % 6], level[(n + 3) % 6], level[(n / 4) % 6]};
        const int d8[4] = {level[(n * 7 + 1) % 6], level[n % 5], level[(n + 4) % 6], level[(n * 5 / 3) % 6]};
        for (std::size_t i = 0; i < 4; ++i) {
            s[i] = p.color[i] = s8[i] / 255.0;
            d[i] = d8[i] / 255.0;
            under |= static_cast<std::uint32_t>(d8[i]) << (8 * i);
        }
    }
    void expect(const Blending& rgb, const Blending& alpha) const {
        Rgba4 want;
        for (std::size_t i = 0; i < 4; ++i)
            want[i] = blended(i == 3 ? alpha : rgb, s, d, i);
        Canvas c;
        FragmentState f = plain_state(c);
        f.scissor = {0, 0, 4, 4};
        f.blend = true;
        f.blend_rgb = rgb;
        f.blend_alpha = alpha;
        for (std::size_t i = 0; i < 4; ++i)
            f.blend_color[i] = static_cast<std::uint32_t>(std::lround(blend_constant[i] * color_one));
        expect_color(f, p, want, 0.51,
                     "src " + std::to_string(int(rgb.src)) + " dst " + std::to_string(int(rgb.dst)) +
                         " equation " + std::to_string(int(rgb.equation)),
                     under);
    }
};

/// Tests every pair of factors on a lattice of colours (GL 1.4, tables 4.1 and 4.2).
TEST(Specification, BlendFactors) {
    for (int src = 0; src < 15; ++src)
        for (int dst = 0; dst < 15; ++dst)
            for (int n = 0; n < 24; ++n) {
                const Blending both = {static_cast<BlendFactor>(src), static_cast<BlendFactor>(dst)};
                if (both.dst == BlendFactor::src_alpha_saturate)
                    continue; // this factor is for the source only
                BlendSample(n).expect(both, both);
            }
}

/// Tests every equation, the same for both parts, and with every other one for alpha (GL 1.4, 4.1.7).
TEST(Specification, BlendEquations) {
    constexpr BlendFactor factors[] = {BlendFactor::one, BlendFactor::src_alpha,
                                       BlendFactor::one_minus_constant_color, BlendFactor::dst_color};
    for (int rgb = 0; rgb < 5; ++rgb)
        for (int alpha = 0; alpha < 5; ++alpha)
            for (int n = 0; n < 24; ++n)
                for (const BlendFactor f : factors)
                    BlendSample(n).expect({f, BlendFactor::one, static_cast<BlendEquation>(rgb)},
                                          {BlendFactor::one, f, static_cast<BlendEquation>(alpha)});
}

/// Some equations have a form for colour and alpha together. The form must not be used if only one of them
/// has the equation.
TEST(Specification, BlendPartsApart) {
    for (const Blending& common : {blend_over, Blending{}})
        for (const Blending& other : {Blending{BlendFactor::one, BlendFactor::one},
                                      Blending{BlendFactor::zero, BlendFactor::dst_alpha}})
            for (int n = 0; n < 24; ++n) {
                BlendSample(n).expect(common, other);
                BlendSample(n).expect(other, common);
            }
}

/// Tests every logical operation on every format's bits under every mask; blending and its factors do not
/// matter (GL 1.3, table 4.3).
TEST(Specification, LogicalOperations) {
    const auto result = [](LogicOp op, unsigned s, unsigned d) -> unsigned {
        switch (op) {
        case LogicOp::clear:
            return 0;
        case LogicOp::logical_and:
            return s & d;
        case LogicOp::and_reverse:
            return s & ~d;
        case LogicOp::copy:
            return s;
        case LogicOp::and_inverted:
            return ~s & d;
        case LogicOp::noop:
            return d;
        case LogicOp::logical_xor:
            return s ^ d;
        case LogicOp::logical_or:
            return s | d;
        case LogicOp::nor:
            return ~(s | d);
        case LogicOp::equiv:
            return ~(s ^ d);
        case LogicOp::invert:
            return ~d;
        case LogicOp::or_reverse:
            return s | ~d;
        case LogicOp::copy_inverted:
            return ~s;
        case LogicOp::or_inverted:
            return ~s | d;
        case LogicOp::nand:
            return ~(s & d);
        case LogicOp::set:
            return ~0u;
        }
        return 0;
    };
    constexpr unsigned source[4] = {0xA6, 0x5C, 0x93, 0x3A}, under[4] = {0x3C, 0xF1, 0x0F, 0xC5};
    for (const PixelFormat format :
         {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888, PixelFormat::rgba8888}) {
        const FormatInfo info = format_info(format);
        const unsigned bits[4] = {info.red_bits, info.green_bits, info.blue_bits, info.alpha_bits};
        for (unsigned op = 0; op < 16; ++op)
            for (const unsigned mask : {15u, 5u, 10u})
                for (const Tier tier : {Tier::exact, Tier::balanced}) {
                    Canvas c(format, 4, 4);
                    std::uint32_t stored[4];
                    Point p;
                    for (std::size_t i = 0; i < 4; ++i) {
                        stored[i] = under[i] >> (8 - bits[i]);
                        p.color[i] = source[i] / 255.0;
                    }
                    write_color(c.surface(), 1, 1, stored);
                    FragmentState f = plain_state(c);
                    f.scissor = {0, 0, 4, 4};
                    f.tier = tier;
                    f.logic = true;
                    f.logic_op = static_cast<LogicOp>(op);
                    f.color_mask = static_cast<std::uint8_t>(mask);
                    f.blend = true;
                    f.blend_rgb = f.blend_alpha = {BlendFactor::zero, BlendFactor::one};
                    cover<FixedVertex>(f, c, p);
                    const StoredColor got = c.at(1, 1);
                    for (unsigned i = 0; i < 4; ++i) {
                        if (bits[i] == 0)
                            continue;
                        const unsigned want =
                            (mask >> i & 1u) == 0
                                ? stored[i]
                                : result(f.logic_op, source[i] >> (8 - bits[i]), stored[i]) &
                                      ((1u << bits[i]) - 1);
                        EXPECT_EQ(got.c[i].k, want)
                            << int(format) << " op " << op << " mask " << mask << " component " << i;
                    }
                }
    }
}

/// Tests all stencil functions, all operations and all three outcomes (gl-commands 17.9; GL 1.3, 4.1.5).
TEST(Specification, StencilOutcomes) {
    const auto passes = [](Compare f, int a, int b) {
        switch (f) {
        case Compare::never:
            return false;
        case Compare::less:
            return a < b;
        case Compare::equal:
            return a == b;
        case Compare::lequal:
            return a <= b;
        case Compare::greater:
            return a > b;
        case Compare::notequal:
            return a != b;
        case Compare::gequal:
            return a >= b;
        case Compare::always:
            return true;
        }
        return false;
    };
    const auto operate = [](StencilOp op, int v, int ref) {
        switch (op) {
        case StencilOp::keep:
            return v;
        case StencilOp::zero:
            return 0;
        case StencilOp::replace:
            return ref;
        case StencilOp::incr:
            return v < 255 ? v + 1 : 255;
        case StencilOp::decr:
            return v > 0 ? v - 1 : 0;
        case StencilOp::invert:
            return v ^ 255;
        case StencilOp::incr_wrap:
            return (v + 1) & 255;
        case StencilOp::decr_wrap:
            return (v - 1) & 255;
        }
        return v;
    };
    for (int func = 0; func < 8; ++func)
        for (int op = 0; op < 8; ++op)
            for (const int stored : {0, 1, 0x12, 0x0F, 254, 255})
                for (const int ref : {0, 1, 0x12, 255})
                    for (const int mask : {0xFF, 0x0F})
                        for (const bool depth_passes : {false, true}) {
                            Canvas c(PixelFormat::rgb565_be, 4, 4);
                            for (std::size_t i = 0; i < c.depth.size(); i += 4) {
                                const std::uint32_t word = 0x80000000u | static_cast<std::uint32_t>(stored);
                                std::memcpy(&c.depth[i], &word, 4);
                            }
                            FragmentState f = plain_state(c);
                            f.depth_test = true;
                            f.stencil_test = true;
                            const int write = op & 1 ? 0xF0 : 0xFF;
                            const auto at = [&](int n) { return static_cast<StencilOp>((op + n) & 7); };
                            f.stencil = {static_cast<Compare>(func),
                                         static_cast<std::uint8_t>(ref),
                                         static_cast<std::uint8_t>(mask),
                                         static_cast<std::uint8_t>(write),
                                         at(0),
                                         at(1),
                                         at(2)};
                            Point p;
                            p.z = depth_passes ? 0.25 : 0.75;
                            cover<FixedVertex>(f, c, p);
                            const bool stencil_passes =
                                passes(static_cast<Compare>(func), ref & mask, stored & mask);
                            const int made = operate(!stencil_passes ? at(0)
                                                     : depth_passes  ? at(2)
                                                                     : at(1),
                                                     stored, ref);
                            ASSERT_EQ(read_stencil(c.surface(), 2, 1), (made & write) | (stored & ~write));
                            const bool drawn = stencil_passes && depth_passes;
                            ASSERT_EQ(c.at(2, 1).c[0].k, drawn ? 31 : 0);
                            ASSERT_EQ(read_depth(c.surface(), 2, 1).k, drawn ? 0x400000u : 0x800000u);
                        }
}

/// Alpha is rounded to 8 bits before the comparison (GL 1.3, 4.1.4).
TEST(Specification, AlphaTest) {
    for (int func = 0; func < 8; ++func)
        for (int alpha = 118; alpha < 123; ++alpha)
            for (const double fraction : {-0.49, 0.0, 0.49}) {
                Canvas c(PixelFormat::rgb565_be, 4, 4);
                FragmentState f = plain_state(c);
                f.alpha_test = true;
                f.alpha_func = static_cast<Compare>(func);
                f.alpha_ref = 120;
                Point p;
                p.color[3] = (alpha + fraction) / 255;
                cover<FixedVertex>(f, c, p);
                const int outcome = alpha < 120 ? 1 : alpha == 120 ? 2 : 4; // bits of LESS, EQUAL, GREATER
                EXPECT_EQ(c.at(1, 1).c[0].k != 0, (func & outcome) != 0) << func << ' ' << alpha;
            }
}

/// Only flat shading takes the provoking vertex's colour (GL 1.3, 2.13.7). That vertex need not be a corner:
/// parts of quads and of clipped polygons keep the colour that their corners share.
template <class V> void expect_provoking_color(PixelFormat format, bool fog, bool flat) {
    Canvas c(format, 8, 8);
    FragmentState f = plain_state(c);
    f.flat = flat;
    f.fog = fog;
    f.fog_mode = FogMode::exp; // density 0 gives no fog, by the longer way
    f.color_sum = fog;
    Point corner[4];
    for (int i = 0; i < 4; ++i) {
        Point& p = corner[i];
        p.x = 16 * (i == 1), p.y = 16 * (i == 2);
        p.w = 1 + 0.5 * i;
        p.color[0] = i == 3 ? 1 : 0;
        p.color[1] = p.color[2] = 0;
        p.secondary[2] = i == 3 && fog ? 1 : 0;
    }
    const Surface surface = c.surface();
    const DrawState state = compile<V>(f, surface);
    draw_triangle<V>(state, surface, make<V>(corner[0]), make<V>(corner[1]), make<V>(corner[2]),
                     make<V>(corner[3]), signed_area(0, 0, 16 * 256, 0, 0, 16 * 256));
    EXPECT_EQ(c.at(1, 1).c[0].k != 0, flat) << "fog " << fog;
    EXPECT_EQ(c.at(1, 1).c[2].k != 0, flat && fog) << "fog " << fog;
}
TEST(Specification, TheProvokingVertexColorsOnlyFlatShading) {
    for (const PixelFormat format : {PixelFormat::rgb565_be, PixelFormat::rgba8888})
        for (const bool fog : {false, true})
            for (const bool flat : {false, true}) {
                expect_provoking_color<FixedVertex>(format, fog, flat);
                expect_provoking_color<DoubleVertex>(format, fog, flat);
            }
}

} // namespace
} // namespace spangle::raster::test
