// Tests how the rasterizer's state is derived from GL's fragment state: every token, every clamp, and when it
// is derived again (GL 1.3, 3.10, 4.1, 4.2, 5.6; docs/features.md G02 to G20, H08).
#include <gtest/gtest.h>

#include <bit>
#include <climits>
#include <functional>

#include "gl/api/generated/commands.hpp"
#include "gl/context/features.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/vertex/engine.hpp"
#include "tests/gl/pixel/bare_context.hpp"
#include "tests/gl/texture/client_image.hpp"

namespace spangle::gl {
namespace {

using test::BareContext;
using test::SharedMemory;

int compiles = 0;
void count_compile(const raster::FragmentState& fragment, const raster::Surface&, raster::DrawState& out) {
    ++compiles;
    out.fragment = fragment;
}
const Engine counting_engine = [] {
    Engine engine{};
    engine.compile = count_compile;
    return engine;
}();

Real real(float v) {
    return numeric::from_float(v);
}
Params integer(std::int64_t value) {
    Params params;
    params.v[0] = Param::from_integer(static_cast<std::uint32_t>(value));
    params.count = 1;
    return params;
}
Params reals(std::initializer_list<float> values) {
    Params params;
    for (float value : values)
        params.v[params.count++] = Param::from(real(value));
    return params;
}

struct FragmentSetup : testing::Test {
    SharedMemory memory{1 << 18};
    BareContext b{memory};
    Context& c = b.context;

    FragmentSetup() { c.engine = &counting_engine; }
    const raster::FragmentState& state() { return draw_state(c).fragment; }
};

TEST_F(FragmentSetup, InitialState) {
    const raster::FragmentState& f = state();
    EXPECT_FALSE(f.alpha_test || f.stencil_test || f.depth_test || f.blend || f.fog || f.flat || f.color_sum);
    EXPECT_TRUE(f.dither);
    EXPECT_TRUE(f.depth_write);
    EXPECT_EQ(f.depth_func, raster::Compare::less);
    EXPECT_EQ(f.alpha_func, raster::Compare::always);
    EXPECT_EQ(f.stencil.func, raster::Compare::always);
    EXPECT_EQ(f.stencil.compare_mask, 0xFF);
    EXPECT_EQ(f.stencil.write_mask, 0xFF);
    EXPECT_EQ(f.color_mask, 0xF);
    EXPECT_EQ(f.scissor, (Rect{0, 0, 8, 6}));
    EXPECT_EQ(f.blend_rgb, raster::Blending{});
    EXPECT_EQ(f.blend_alpha, raster::Blending{});
    EXPECT_FALSE(f.logic);
    EXPECT_EQ(f.unit[0].texture, nullptr);
}

TEST_F(FragmentSetup, ComparisonsOfAllThreeTests) {
    const struct {
        GLenum token;
        raster::Compare compare;
    } all[] = {{GL_NEVER, raster::Compare::never},     {GL_LESS, raster::Compare::less},
               {GL_EQUAL, raster::Compare::equal},     {GL_LEQUAL, raster::Compare::lequal},
               {GL_GREATER, raster::Compare::greater}, {GL_NOTEQUAL, raster::Compare::notequal},
               {GL_GEQUAL, raster::Compare::gequal},   {GL_ALWAYS, raster::Compare::always}};
    for (const auto& v : all) {
        cmd::AlphaFunc(c, v.token, real(0.5f));
        cmd::StencilFunc(c, v.token, 3, 0x1F0);
        cmd::DepthFunc(c, v.token);
        EXPECT_EQ(state().alpha_func, v.compare);
        EXPECT_EQ(state().stencil.func, v.compare);
        EXPECT_EQ(state().depth_func, v.compare);
    }
    EXPECT_EQ(state().alpha_ref, 128);
    EXPECT_EQ(state().stencil.ref, 3);
    EXPECT_EQ(state().stencil.compare_mask, 0xF0);
    for (GLenum bad : {GLenum{GL_NEVER - 1}, GLenum{GL_ALWAYS + 1}, GLenum{0}, GLenum{GL_NONE}}) {
        cmd::AlphaFunc(c, bad, real(1));
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
        cmd::StencilFunc(c, bad, 9, 9);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
        cmd::DepthFunc(c, bad);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    }
    EXPECT_EQ(state().alpha_ref, 128); // a refused command changes nothing
    EXPECT_EQ(state().stencil.ref, 3);
    EXPECT_EQ(state().depth_func, raster::Compare::always);
    for (const auto& clamp :
         {std::pair{-5, 0}, std::pair{300, 255}, std::pair{INT_MIN, 0}, std::pair{INT_MAX, 255}}) {
        cmd::StencilFunc(c, GL_EQUAL, clamp.first, ~0u);
        EXPECT_EQ(state().stencil.ref, clamp.second);
    }
    for (const auto& clamp : {std::pair{-1.0f, 0}, std::pair{2.0f, 255}}) {
        cmd::AlphaFunc(c, GL_LESS, real(clamp.first));
        EXPECT_EQ(state().alpha_ref, clamp.second);
    }
}

TEST_F(FragmentSetup, StencilOperations) {
    const struct {
        GLenum token;
        raster::StencilOp op;
    } all[] = {{GL_KEEP, raster::StencilOp::keep},           {GL_ZERO, raster::StencilOp::zero},
               {GL_REPLACE, raster::StencilOp::replace},     {GL_INCR, raster::StencilOp::incr},
               {GL_DECR, raster::StencilOp::decr},           {GL_INVERT, raster::StencilOp::invert},
               {GL_INCR_WRAP, raster::StencilOp::incr_wrap}, {GL_DECR_WRAP, raster::StencilOp::decr_wrap}};
    for (std::size_t i = 0; i < 8; ++i) {
        cmd::StencilOp(c, all[i].token, all[(i + 1) % 8].token, all[(i + 2) % 8].token);
        EXPECT_EQ(state().stencil.fail, all[i].op);
        EXPECT_EQ(state().stencil.depth_fail, all[(i + 1) % 8].op);
        EXPECT_EQ(state().stencil.pass, all[(i + 2) % 8].op);
    }
    const GLenum wrong = GL_DECR_WRAP + 1;
    cmd::StencilOp(c, wrong, GL_KEEP, GL_KEEP);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    cmd::StencilOp(c, GL_KEEP, wrong, GL_KEEP);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    cmd::StencilOp(c, GL_KEEP, GL_KEEP, wrong);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(state().stencil.fail, raster::StencilOp::decr_wrap);
    cmd::StencilMask(c, 0x1A5);
    EXPECT_EQ(state().stencil.write_mask, 0xA5);
}

TEST_F(FragmentSetup, BlendFactorsOfEachSide) {
    using F = raster::BlendFactor;
    const struct {
        GLenum token;
        F factor;
        bool source, destination; // allowed as source and as destination (GL 1.4, tables 4.1 and 4.2)
    } all[] = {{GL_ZERO, F::zero, true, true},
               {GL_ONE, F::one, true, true},
               {GL_SRC_COLOR, F::src_color, true, true},
               {GL_ONE_MINUS_SRC_COLOR, F::one_minus_src_color, true, true},
               {GL_SRC_ALPHA, F::src_alpha, true, true},
               {GL_ONE_MINUS_SRC_ALPHA, F::one_minus_src_alpha, true, true},
               {GL_DST_ALPHA, F::dst_alpha, true, true},
               {GL_ONE_MINUS_DST_ALPHA, F::one_minus_dst_alpha, true, true},
               {GL_DST_COLOR, F::dst_color, true, true},
               {GL_ONE_MINUS_DST_COLOR, F::one_minus_dst_color, true, true},
               {GL_SRC_ALPHA_SATURATE, F::src_alpha_saturate, true, false},
               {GL_CONSTANT_COLOR, F::constant_color, true, true},
               {GL_ONE_MINUS_CONSTANT_COLOR, F::one_minus_constant_color, true, true},
               {GL_CONSTANT_ALPHA, F::constant_alpha, true, true},
               {GL_ONE_MINUS_CONSTANT_ALPHA, F::one_minus_constant_alpha, true, true},
               {GLenum{GL_CONSTANT_COLOR} - 1, F::zero, false, false},
               {GLenum{GL_ONE_MINUS_CONSTANT_ALPHA} + 1, F::zero, false, false},
               {GLenum{GL_SRC_ALPHA_SATURATE} + 1, F::zero, false, false},
               {2, F::zero, false, false}};
    for (const auto& s : all)
        for (const auto& d : all) {
            cmd::BlendFunc(c, GL_ONE, GL_ONE);
            cmd::BlendFunc(c, s.token, d.token);
            const bool legal = s.source && d.destination;
            EXPECT_EQ(b.take_error(), legal ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_ENUM})
                << s.token << d.token;
            const raster::Blending both = {legal ? s.factor : F::one, legal ? d.factor : F::one};
            EXPECT_EQ(state().blend_rgb, both);
            EXPECT_EQ(state().blend_alpha, both);
            cmd::BlendFunc(c, GL_ONE, GL_ONE);
            cmd::BlendFuncSeparate(c, GL_ZERO, GL_SRC_COLOR, s.token, d.token);
            EXPECT_EQ(b.take_error(), legal ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_ENUM});
            const raster::Blending one = {F::one, F::one}, rgb = {F::zero, F::src_color};
            EXPECT_EQ(state().blend_rgb, legal ? rgb : one);
            EXPECT_EQ(state().blend_alpha, legal ? both : one);
            cmd::BlendFunc(c, GL_ONE, GL_ONE);
            cmd::BlendFuncSeparate(c, s.token, d.token, GL_ZERO, GL_SRC_COLOR);
            EXPECT_EQ(b.take_error(), legal ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_ENUM});
            EXPECT_EQ(state().blend_rgb, legal ? both : one);
            EXPECT_EQ(state().blend_alpha, legal ? rgb : one);
        }
}

TEST_F(FragmentSetup, BlendEquationsOfBothParts) {
    using E = raster::BlendEquation;
    const struct {
        GLenum token;
        E equation;
        bool legal = true;
    } all[] = {{GL_FUNC_ADD, E::add},
               {GL_FUNC_SUBTRACT, E::subtract},
               {GL_FUNC_REVERSE_SUBTRACT, E::reverse_subtract},
               {GL_MIN, E::min},
               {GL_MAX, E::max},
               {GLenum{GL_MAX} + 1, E::add, false},
               {GLenum{GL_FUNC_REVERSE_SUBTRACT} + 1, E::add, false},
               {GLenum{GL_FUNC_ADD} - 1, E::add, false}};
    for (const auto& rgb : all)
        for (const auto& alpha : all) {
            cmd::BlendEquation(c, GL_MAX);
            cmd::BlendEquationSeparate(c, rgb.token, alpha.token);
            const bool legal = rgb.legal && alpha.legal;
            EXPECT_EQ(b.take_error(), legal ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_ENUM});
            EXPECT_EQ(state().blend_rgb.equation, legal ? rgb.equation : E::max);
            EXPECT_EQ(state().blend_alpha.equation, legal ? alpha.equation : E::max);
        }
    cmd::BlendEquation(c, GL_FUNC_SUBTRACT);
    EXPECT_EQ(state().blend_rgb.equation, E::subtract);
    EXPECT_EQ(state().blend_alpha.equation, E::subtract);
    cmd::BlendColor(c, real(0.5f), real(-1), real(2), real(0.25f));
    const std::uint32_t units[4] = {raster::color_one / 2, 0, raster::color_one, raster::color_one / 4};
    const Real kept[4] = {real(0.5f), real(0), real(1), real(0.25f)};
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(state().blend_color[i], units[i]);
        EXPECT_EQ(c.fragment_ops.blend_color[i], kept[i]) << "clamped when it is given";
    }
}

TEST_F(FragmentSetup, LogicalOperations) {
    for (GLenum op = GL_CLEAR; op <= GL_SET; ++op) {
        cmd::LogicOp(c, op);
        EXPECT_EQ(static_cast<GLenum>(state().logic_op), op - GL_CLEAR);
    }
    for (const GLenum wrong : {GLenum{GL_CLEAR} - 1, GLenum{GL_SET} + 1, GLenum{GL_ZERO}}) {
        cmd::LogicOp(c, wrong);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
        EXPECT_EQ(state().logic_op, raster::LogicOp::set);
    }
    EXPECT_FALSE(state().logic);
    cmd::Enable(c, GL_INDEX_LOGIC_OP);
    EXPECT_FALSE(state().logic) << "of colours, not of indices";
    cmd::Enable(c, GL_COLOR_LOGIC_OP);
    EXPECT_TRUE(state().logic);
}

TEST_F(FragmentSetup, StencilOfEachSide) {
    using O = raster::StencilOp;
    cmd::Enable(c, GL_STENCIL_TEST);
    cmd::StencilFunc(c, GL_EQUAL, 3, 0xF);
    cmd::StencilOp(c, GL_INCR_WRAP, GL_DECR_WRAP, GL_INVERT);
    EXPECT_FALSE(stencil_sides(c));
    EXPECT_EQ(state().stencil.fail, O::incr_wrap);
    EXPECT_EQ(state().stencil.depth_fail, O::decr_wrap);
    cmd::StencilFuncSeparate(c, GL_BACK, GL_LESS, 300, 0x1F0);
    cmd::StencilOpSeparate(c, GL_BACK, GL_REPLACE, GL_KEEP, GL_ZERO);
    cmd::StencilMaskSeparate(c, GL_FRONT, 0x107);
    EXPECT_TRUE(stencil_sides(c));
    state();
    const raster::StencilState front = draw_state_of(c, 0).fragment.stencil,
                               back = draw_state_of(c, 1).fragment.stencil;
    EXPECT_EQ(front.func, raster::Compare::equal);
    EXPECT_EQ(front.ref, 3);
    EXPECT_EQ(front.compare_mask, 0xF);
    EXPECT_EQ(front.write_mask, 7);
    EXPECT_EQ(front.pass, O::invert);
    EXPECT_EQ(back.func, raster::Compare::less);
    EXPECT_EQ(back.ref, 255);
    EXPECT_EQ(back.compare_mask, 0xF0);
    EXPECT_EQ(back.write_mask, 0xFF);
    EXPECT_EQ(back.fail, O::replace);
    EXPECT_EQ(back.depth_fail, O::keep);
    EXPECT_EQ(back.pass, O::zero);
    for (const GLenum face : {GLenum{GL_LEFT}, GLenum{GL_NONE}}) {
        cmd::StencilFuncSeparate(c, face, GL_LESS, 1, 1);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
        cmd::StencilOpSeparate(c, face, GL_KEEP, GL_KEEP, GL_KEEP);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
        cmd::StencilMaskSeparate(c, face, 1);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    }
    state();
    EXPECT_EQ(draw_state_of(c, 0).fragment.stencil.ref, 3);
    EXPECT_EQ(draw_state_of(c, 1).fragment.stencil.write_mask, 0xFF);
    cmd::Disable(c, GL_STENCIL_TEST);
    EXPECT_FALSE(stencil_sides(c));
}

TEST_F(FragmentSetup, ScissorIsCutToTheSurface) {
    const struct {
        GLint x, y;
        GLsizei w, h;
        Rect wanted; // on a surface of 8 x 6; if w or h is 0, any empty rectangle
    } cases[] = {
        {1, 2, 3, 4, {1, 2, 3, 4}},
        {-2, -3, 5, 5, {0, 0, 3, 2}},
        {6, 4, 100, 100, {6, 4, 2, 2}},
        {0, 0, 0, 6, {0, 0, 0, 6}},
        {8, 0, 1, 1, {8, 0, 0, 1}},
        {-5, 0, 5, 1, {0, 0, 0, 1}},
        {INT_MIN, INT_MIN, INT_MAX, INT_MAX, {0, 0, 0, 0}},
        {INT_MAX, INT_MAX, INT_MAX, INT_MAX, {8, 6, 0, 0}},
        {-1, -1, INT_MAX, INT_MAX, {0, 0, 8, 6}},
    };
    c.fragment_ops.scissor_test = true;
    for (const auto& s : cases) {
        cmd::Scissor(c, s.x, s.y, s.w, s.h);
        EXPECT_EQ(state().scissor, s.wanted) << s.x << " " << s.y;
    }
    for (const auto& bad : {std::pair{-1, 1}, std::pair{1, -1}}) {
        cmd::Scissor(c, 0, 0, bad.first, bad.second);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_VALUE});
    }
    EXPECT_EQ(state().scissor, (Rect{0, 0, 8, 6}));
    c.fragment_ops.scissor_test = false;
    cmd::Scissor(c, 1, 1, 1, 1);
    EXPECT_EQ(state().scissor, (Rect{0, 0, 8, 6}));
}

TEST_F(FragmentSetup, MasksAndBuffers) {
    for (unsigned bits = 0; bits < 16; ++bits) {
        cmd::ColorMask(c, (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0);
        EXPECT_EQ(state().color_mask, bits);
    }
    cmd::DepthMask(c, false);
    EXPECT_FALSE(state().depth_write);
    cmd::DrawBuffer(c, GL_NONE);
    EXPECT_EQ(state().color_mask, 0);
    const struct {
        GLenum mode;
        GLenum single_draw, single_read, double_draw, double_read; // the errors of DrawBuffer and ReadBuffer
    } cases[] = {
        {GL_FRONT, 0, 0, GL_INVALID_OPERATION, GL_INVALID_OPERATION},
        {GL_FRONT_LEFT, 0, 0, GL_INVALID_OPERATION, GL_INVALID_OPERATION},
        {GL_BACK, GL_INVALID_OPERATION, GL_INVALID_OPERATION, 0, 0},
        {GL_BACK_LEFT, GL_INVALID_OPERATION, GL_INVALID_OPERATION, 0, 0},
        {GL_FRONT_AND_BACK, 0, GL_INVALID_ENUM, 0, GL_INVALID_ENUM},
        {GL_FRONT_RIGHT, GL_INVALID_OPERATION, GL_INVALID_OPERATION, GL_INVALID_OPERATION,
         GL_INVALID_OPERATION},
        {GL_AUX0, GL_INVALID_OPERATION, GL_INVALID_OPERATION, GL_INVALID_OPERATION, GL_INVALID_OPERATION},
        {GL_NONE, 0, GL_INVALID_ENUM, 0, GL_INVALID_ENUM},
        {GL_COLOR, GL_INVALID_ENUM, GL_INVALID_ENUM, GL_INVALID_ENUM, GL_INVALID_ENUM},
    };
    for (const auto& v : cases)
        for (bool twice : {false, true}) {
            c.drawable.double_buffered = c.drawable.read_double_buffered = twice;
            c.drawable.front_buffered = c.drawable.read_front_buffered = !twice;
            cmd::DrawBuffer(c, v.mode);
            EXPECT_EQ(b.take_error(), twice ? v.double_draw : v.single_draw) << std::hex << v.mode << twice;
            cmd::ReadBuffer(c, v.mode);
            EXPECT_EQ(b.take_error(), twice ? v.double_read : v.single_read) << std::hex << v.mode << twice;
        }
}

TEST_F(FragmentSetup, TestsWithoutTheirBufferAlwaysPass) {
    for (DepthFormat depth : {DepthFormat::none, DepthFormat::z16, DepthFormat::z24s8}) {
        BareContext bare(memory, PixelFormat::rgb565_be, depth);
        bare.context.engine = &counting_engine;
        bare.context.fragment_ops.depth_test = bare.context.fragment_ops.stencil_test = true;
        EXPECT_EQ(draw_state(bare.context).fragment.depth_test, depth != DepthFormat::none);
        EXPECT_EQ(draw_state(bare.context).fragment.stencil_test, depth == DepthFormat::z24s8);
    }
}

TEST_F(FragmentSetup, HintsChooseTiers) {
    using raster::Tier;
    for (Tier of_config : {Tier::exact, Tier::balanced, Tier::fast}) {
        c.tier = of_config;
        cmd::Hint(c, GL_PERSPECTIVE_CORRECTION_HINT, GL_DONT_CARE);
        cmd::Hint(c, GL_FOG_HINT, GL_FASTEST);
        EXPECT_EQ(state().tier, of_config);
        cmd::Hint(c, GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
        EXPECT_EQ(state().tier, Tier::exact);
        cmd::Hint(c, GL_PERSPECTIVE_CORRECTION_HINT, GL_FASTEST);
        EXPECT_EQ(state().tier, Tier::fast);
    }
    // All other hints are kept, and nothing else: fog and smooth primitives follow the tier (docs/trade.md).
    cmd::Hint(c, GL_PERSPECTIVE_CORRECTION_HINT, GL_DONT_CARE);
    const raster::FragmentState before = state();
    for (GLenum target : {GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT})
        for (GLenum mode : {GL_FASTEST, GL_NICEST, GL_DONT_CARE}) {
            cmd::Hint(c, target, mode);
            EXPECT_EQ(c.hint.mode[target - GL_PERSPECTIVE_CORRECTION_HINT], mode);
            EXPECT_EQ(state(), before);
        }
    for (GLenum target : {GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT}) {
        cmd::Hint(c, target, GL_NICEST);
        EXPECT_EQ(b.take_error(), GLenum{GL_NO_ERROR});
    }
    cmd::Hint(c, GL_FOG, GL_NICEST);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    cmd::Hint(c, GL_FOG_HINT, GL_LINEAR);
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
}

#if SPANGLE_FEATURE_FOG
TEST_F(FragmentSetup, Fog) {
    const struct {
        GLenum token;
        raster::FogMode mode;
    } modes[] = {{GL_LINEAR, raster::FogMode::linear},
                 {GL_EXP2, raster::FogMode::exp2},
                 {GL_EXP, raster::FogMode::exp}};
    for (const auto& m : modes) {
        cmd::Fog(c, GL_FOG_MODE, integer(m.token));
        EXPECT_EQ(state().fog_mode, m.mode);
    }
    cmd::Fog(c, GL_FOG_DENSITY, reals({0.25f}));
    cmd::Fog(c, GL_FOG_START, reals({-3}));
    cmd::Fog(c, GL_FOG_END, reals({100}));
    cmd::Fog(c, GL_FOG_COLOR, reals({0.5f, 2, -1, 1}));
    EXPECT_EQ(state().fog_density, std::bit_cast<std::uint32_t>(0.25f));
    EXPECT_EQ(state().fog_start, std::bit_cast<std::uint32_t>(-3.0f));
    EXPECT_EQ(state().fog_end, std::bit_cast<std::uint32_t>(100.0f));
    EXPECT_EQ(state().fog_color[0], raster::color_one / 2);
    EXPECT_EQ(state().fog_color[1], raster::color_one);
    EXPECT_EQ(state().fog_color[2], 0u);
    cmd::Fog(c, GL_FOG_DENSITY, reals({-0.25f}));
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_VALUE});
    for (const auto& bad : {std::pair{GLenum{GL_FOG_MODE}, integer(GL_NEAREST)},
                            {GLenum{GL_FOG}, integer(1)},
                            {GLenum{GL_FOG_COLOR}, Params{}}}) {
        cmd::Fog(c, bad.first, bad.second);
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    }
    EXPECT_EQ(state().fog_density, std::bit_cast<std::uint32_t>(0.25f));
}
#endif

TEST_F(FragmentSetup, TextureUnitsAndEnvironments) {
    const std::uint8_t texel[4] = {1, 2, 3, 4};
    tex_image_2d(c, GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    EXPECT_EQ(state().unit[0].texture, nullptr); // null, because texturing is not enabled
    c.texture.unit[0].enabled[index_of(TextureKind::two)] = true;
    c.changed(dirty_fragment);
    ASSERT_NE(state().unit[0].texture, nullptr);
    EXPECT_EQ(state().unit[0].texture->level[0].texels[2], 3);
    const struct {
        GLenum token;
        raster::TexEnv env;
    } modes[] = {{GL_REPLACE, raster::TexEnv::replace},
                 {GL_MODULATE, raster::TexEnv::modulate},
                 {GL_DECAL, raster::TexEnv::decal},
                 {GL_BLEND, raster::TexEnv::blend},
                 {GL_ADD, raster::TexEnv::add}};
    for (const auto& m : modes) {
        cmd::TexEnv(c, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, integer(m.token));
        EXPECT_EQ(state().unit[0].env, m.env);
    }
    cmd::TexEnv(c, GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, reals({0, 1, 0.5f, 0.25f}));
    EXPECT_EQ(state().unit[0].env_color[0], 0u);
    EXPECT_EQ(state().unit[0].env_color[1], raster::color_one);
    EXPECT_EQ(state().unit[0].env_color[2], raster::color_one / 2);
    EXPECT_EQ(state().unit[0].env_color[3], raster::color_one / 4);
    cmd::BindTexture(c, GL_TEXTURE_2D, 8); // an incomplete texture, which counts as disabled (GL 1.3, 3.8.9)
    EXPECT_EQ(state().unit[0].texture, nullptr);
    EXPECT_EQ(b.take_error(), GLenum{GL_NO_ERROR});
    const GLuint name = 8;
    cmd::DeleteTextures(c, 1, &name);
    EXPECT_NE(state().unit[0].texture, nullptr);
}

TEST_F(FragmentSetup, Switches) {
    const std::pair<GLenum, bool raster::FragmentState::*> switches[] = {
        {GL_ALPHA_TEST, &raster::FragmentState::alpha_test},
        {GL_STENCIL_TEST, &raster::FragmentState::stencil_test},
        {GL_DEPTH_TEST, &raster::FragmentState::depth_test},
        {GL_BLEND, &raster::FragmentState::blend},
        {GL_DITHER, &raster::FragmentState::dither},
        {GL_FOG, &raster::FragmentState::fog},
    };
    for (const auto& [name, member] : switches)
        for (const bool on : {true, false, true}) {
            (on ? cmd::Enable : cmd::Disable)(c, name);
            EXPECT_EQ(state().*member, on) << std::hex << name;
        }
}

/// State is derived once after each change, and at no other time.
TEST_F(FragmentSetup, DerivedOncePerChange) {
    const GLuint name = 8;
    const std::function<void()> changes[] = {
        [&] { cmd::Scissor(c, 0, 0, 1, 1); },
        [&] { cmd::AlphaFunc(c, GL_LESS, real(0)); },
        [&] { cmd::StencilFunc(c, GL_LESS, 0, 0); },
        [&] { cmd::StencilOp(c, GL_KEEP, GL_KEEP, GL_INCR); },
        [&] { cmd::StencilMask(c, 1); },
        [&] { cmd::DepthFunc(c, GL_LESS); },
        [&] { cmd::DepthMask(c, false); },
        [&] { cmd::BlendFunc(c, GL_ZERO, GL_ONE); },
        [&] { cmd::ColorMask(c, true, false, true, false); },
        [&] { cmd::DrawBuffer(c, GL_NONE); },
        [&] { cmd::Hint(c, GL_FOG_HINT, GL_FASTEST); },
        [&] { cmd::BindTexture(c, GL_TEXTURE_2D, name); },
        [&] { cmd::TexParameter(c, GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, integer(GL_CLAMP)); },
        [&] { tex_image_2d(c, GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); },
        [&] { cmd::TexEnv(c, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, integer(GL_ADD)); },
        [&] { cmd::DeleteTextures(c, 1, &name); },
    };
    draw_state(c);
    for (const auto& change : changes) {
        change();
        c.fragments.kept = decltype(c.fragments.kept)(); // otherwise an earlier compilation would be copied
        const int before = compiles;
        draw_state(c);
        draw_state(c);
        EXPECT_EQ(compiles, before + 1) << &change - changes;
    }
    const int before = compiles; // changes of state that no fragment depends on
    cmd::ClearColor(c, real(1), real(1), real(1), real(1));
    cmd::PixelStore(c, GL_UNPACK_ALIGNMENT, integer(1));
    draw_state(c);
    EXPECT_EQ(compiles, before);
}

TEST_F(FragmentSetup, PixelStoreParameters) {
    const struct {
        GLenum pack, unpack;
        GLint PixelStore::*member;
    } numbers[] = {{GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH, &PixelStore::row_length},
                   {GL_PACK_SKIP_ROWS, GL_UNPACK_SKIP_ROWS, &PixelStore::skip_rows},
                   {GL_PACK_SKIP_PIXELS, GL_UNPACK_SKIP_PIXELS, &PixelStore::skip_pixels},
                   {GL_PACK_IMAGE_HEIGHT, GL_UNPACK_IMAGE_HEIGHT, &PixelStore::image_height},
                   {GL_PACK_SKIP_IMAGES, GL_UNPACK_SKIP_IMAGES, &PixelStore::skip_images},
                   {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT, &PixelStore::alignment}};
    for (const auto& n : numbers) {
        cmd::PixelStore(c, n.pack, integer(8));
        cmd::PixelStore(c, n.unpack, integer(2));
        EXPECT_EQ(c.pixel_store.pack.*n.member, 8);
        EXPECT_EQ(c.pixel_store.unpack.*n.member, 2);
        for (GLenum pname : {n.pack, n.unpack}) {
            cmd::PixelStore(c, pname, integer(-1));
            EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_VALUE});
        }
        EXPECT_EQ(c.pixel_store.pack.*n.member, 8);
    }
    for (GLint alignment : {0, 3, 5, 16, INT_MAX}) {
        cmd::PixelStore(c, GL_PACK_ALIGNMENT, integer(alignment));
        EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_VALUE}) << alignment;
    }
    cmd::PixelStore(c, GL_PACK_SWAP_BYTES, integer(1));
    cmd::PixelStore(c, GL_UNPACK_LSB_FIRST, integer(7));
    EXPECT_TRUE(c.pixel_store.pack.swap_bytes);
    EXPECT_FALSE(c.pixel_store.unpack.swap_bytes);
    EXPECT_TRUE(c.pixel_store.unpack.lsb_first);
    EXPECT_FALSE(c.pixel_store.pack.lsb_first);
    cmd::PixelStore(c, GL_TEXTURE_2D, integer(1));
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
    cmd::PixelStore(c, GL_PACK_ALIGNMENT, Params{});
    EXPECT_EQ(b.take_error(), GLenum{GL_INVALID_ENUM});
}

} // namespace
} // namespace spangle::gl
