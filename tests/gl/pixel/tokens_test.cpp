// Gives every token of 16 bits, and some wider ones, to each command that keeps a token for the rasterizer. A
// command must take the tokens of its list only, and the rasterizer must get the enumerators of the list. An
// unknown token must never stand for anything.
#include <gtest/gtest.h>

#include <functional>
#include <map>

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

const Engine describing_engine = [] {
    Engine engine{};
    engine.compile = [](const raster::FragmentState& fragment, const raster::Surface&,
                        raster::DrawState& out) { out.fragment = fragment; };
    return engine;
}();

Params token(GLenum value) {
    Params params;
    params.v[0] = Param::from_integer(value);
    params.count = 1;
    return params;
}

struct Tokens : testing::Test {
    SharedMemory memory{1 << 18};
    BareContext b{memory};
    Context& c = b.context;

    Tokens() {
        c.engine = &describing_engine;
        const std::uint8_t texel[4] = {};
        tex_image_2d(c, GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
        c.texture.unit[0].enabled[index_of(TextureKind::two)] = true;
    }
    const raster::FragmentState& state() { return draw_state(c).fragment; }

    /// Tries all tokens. `of` reads what the rasterizer got.
    template <class Enum>
    void sweep(const std::map<GLenum, Enum>& meanings, const std::function<void(GLenum)>& set,
               const std::function<Enum()>& of) {
        set(meanings.begin()->first);
        ASSERT_EQ(b.take_error(), GLenum{GL_NO_ERROR});
        Enum expected = meanings.begin()->second;
        const auto attempt = [&](GLenum value) {
            const auto found = meanings.find(value);
            set(value);
            ASSERT_EQ(b.take_error(), found != meanings.end() ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_ENUM})
                << std::hex << value;
            if (found != meanings.end()) {
                expected = found->second;
                ASSERT_EQ(of(), expected) << std::hex << value;
            }
        };
        for (GLenum value = 0; value < 0x10000; ++value)
            attempt(value);
        for (const auto& [value, meaning] : meanings)
            attempt(value | 0x10000);
        ASSERT_EQ(of(), expected) << "refused tokens change nothing";
    }
};

TEST_F(Tokens, Comparisons) {
    using raster::Compare;
    const std::map<GLenum, Compare> all = {
        {GL_NEVER, Compare::never},   {GL_LESS, Compare::less},       {GL_EQUAL, Compare::equal},
        {GL_LEQUAL, Compare::lequal}, {GL_GREATER, Compare::greater}, {GL_NOTEQUAL, Compare::notequal},
        {GL_GEQUAL, Compare::gequal}, {GL_ALWAYS, Compare::always},
    };
    sweep<Compare>(
        all, [&](GLenum f) { cmd::DepthFunc(c, f); }, [&] { return state().depth_func; });
    sweep<Compare>(
        all, [&](GLenum f) { cmd::AlphaFunc(c, f, numeric::zero); }, [&] { return state().alpha_func; });
    sweep<Compare>(
        all, [&](GLenum f) { cmd::StencilFunc(c, f, 0, 1); }, [&] { return state().stencil.func; });
#if SPANGLE_FEATURE_DEPTH_TEXTURES
    sweep<Compare>(
        all, [&](GLenum f) { cmd::TexParameter(c, GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, token(f)); },
        [&] { // only a view of a depth texture holds the comparison
            const GLenum kept = c.texture.bound(0).parameters.compare_func;
            return all.at(kept);
        });
#endif
}

TEST_F(Tokens, StencilOperations) {
    using raster::StencilOp;
    const std::map<GLenum, StencilOp> all = {
        {GL_KEEP, StencilOp::keep},           {GL_ZERO, StencilOp::zero},
        {GL_REPLACE, StencilOp::replace},     {GL_INCR, StencilOp::incr},
        {GL_DECR, StencilOp::decr},           {GL_INVERT, StencilOp::invert},
        {GL_INCR_WRAP, StencilOp::incr_wrap}, {GL_DECR_WRAP, StencilOp::decr_wrap},
    };
    sweep<StencilOp>(
        all, [&](GLenum op) { cmd::StencilOp(c, op, GL_KEEP, GL_KEEP); },
        [&] { return state().stencil.fail; });
    sweep<StencilOp>(
        all, [&](GLenum op) { cmd::StencilOp(c, GL_KEEP, op, GL_KEEP); },
        [&] { return state().stencil.depth_fail; });
    sweep<StencilOp>(
        all, [&](GLenum op) { cmd::StencilOp(c, GL_KEEP, GL_KEEP, op); },
        [&] { return state().stencil.pass; });
}

TEST_F(Tokens, Blending) {
    using F = raster::BlendFactor;
    std::map<GLenum, F> factors = {
        {GL_ZERO, F::zero},
        {GL_ONE, F::one},
        {GL_SRC_COLOR, F::src_color},
        {GL_ONE_MINUS_SRC_COLOR, F::one_minus_src_color},
        {GL_SRC_ALPHA, F::src_alpha},
        {GL_ONE_MINUS_SRC_ALPHA, F::one_minus_src_alpha},
        {GL_DST_ALPHA, F::dst_alpha},
        {GL_ONE_MINUS_DST_ALPHA, F::one_minus_dst_alpha},
        {GL_DST_COLOR, F::dst_color},
        {GL_ONE_MINUS_DST_COLOR, F::one_minus_dst_color},
        {GL_CONSTANT_COLOR, F::constant_color},
        {GL_ONE_MINUS_CONSTANT_COLOR, F::one_minus_constant_color},
        {GL_CONSTANT_ALPHA, F::constant_alpha},
        {GL_ONE_MINUS_CONSTANT_ALPHA, F::one_minus_constant_alpha},
    };
    sweep<F>(
        factors, [&](GLenum f) { cmd::BlendFunc(c, GL_ONE, f); }, [&] { return state().blend_rgb.dst; });
    factors[GL_SRC_ALPHA_SATURATE] =
        F::src_alpha_saturate; // no factor of the destination (GL 1.4, table 4.2)
    sweep<F>(
        factors, [&](GLenum f) { cmd::BlendFunc(c, f, GL_ONE); }, [&] { return state().blend_rgb.src; });
    using E = raster::BlendEquation;
    const std::map<GLenum, E> equations = {
        {GL_FUNC_ADD, E::add},
        {GL_FUNC_SUBTRACT, E::subtract},
        {GL_FUNC_REVERSE_SUBTRACT, E::reverse_subtract},
        {GL_MIN, E::min},
        {GL_MAX, E::max},
    };
    sweep<E>(
        equations, [&](GLenum e) { cmd::BlendEquationSeparate(c, e, GL_MAX); },
        [&] { return state().blend_rgb.equation; });
    sweep<E>(
        equations, [&](GLenum e) { cmd::BlendEquationSeparate(c, GL_MAX, e); },
        [&] { return state().blend_alpha.equation; });
}

TEST_F(Tokens, LogicalOperations) {
    using L = raster::LogicOp;
    sweep<L>(
        {{GL_CLEAR, L::clear},
         {GL_AND, L::logical_and},
         {GL_AND_REVERSE, L::and_reverse},
         {GL_COPY, L::copy},
         {GL_AND_INVERTED, L::and_inverted},
         {GL_NOOP, L::noop},
         {GL_XOR, L::logical_xor},
         {GL_OR, L::logical_or},
         {GL_NOR, L::nor},
         {GL_EQUIV, L::equiv},
         {GL_INVERT, L::invert},
         {GL_OR_REVERSE, L::or_reverse},
         {GL_COPY_INVERTED, L::copy_inverted},
         {GL_OR_INVERTED, L::or_inverted},
         {GL_NAND, L::nand},
         {GL_SET, L::set}},
        [&](GLenum op) { cmd::LogicOp(c, op); }, [&] { return state().logic_op; });
}

#if SPANGLE_FEATURE_FOG
TEST_F(Tokens, FogModes) {
    using raster::FogMode;
    sweep<FogMode>(
        {{GL_EXP, FogMode::exp}, {GL_EXP2, FogMode::exp2}, {GL_LINEAR, FogMode::linear}},
        [&](GLenum mode) { cmd::Fog(c, GL_FOG_MODE, token(mode)); }, [&] { return state().fog_mode; });
}
#endif

TEST_F(Tokens, TextureParameters) {
    const auto set = [&](GLenum pname) {
        return [this, pname](GLenum value) { cmd::TexParameter(c, GL_TEXTURE_2D, pname, token(value)); };
    };
    using raster::Filter;
    sweep<Filter>({{GL_NEAREST, Filter::nearest}, {GL_LINEAR, Filter::linear}}, set(GL_TEXTURE_MAG_FILTER),
                  [&] { return state().unit[0].texture->mag; });
    using Min = std::pair<Filter, raster::MipFilter>;
    sweep<Min>({{GL_NEAREST, {Filter::nearest, raster::MipFilter::none}},
                {GL_LINEAR, {Filter::linear, raster::MipFilter::none}},
                {GL_NEAREST_MIPMAP_NEAREST, {Filter::nearest, raster::MipFilter::nearest}},
                {GL_LINEAR_MIPMAP_NEAREST, {Filter::linear, raster::MipFilter::nearest}},
                {GL_NEAREST_MIPMAP_LINEAR, {Filter::nearest, raster::MipFilter::linear}},
                {GL_LINEAR_MIPMAP_LINEAR, {Filter::linear, raster::MipFilter::linear}}},
               set(GL_TEXTURE_MIN_FILTER), [&] {
                   const raster::Texture& view = *state().unit[0].texture;
                   return Min{view.min, view.mip};
               });
    using raster::Wrap;
    const std::map<GLenum, Wrap> wraps = {
        {GL_REPEAT, Wrap::repeat},
        {GL_CLAMP, Wrap::clamp},
        {GL_CLAMP_TO_EDGE, Wrap::clamp_to_edge},
        {GL_CLAMP_TO_BORDER, Wrap::clamp_to_border},
        {GL_MIRRORED_REPEAT, Wrap::mirrored_repeat},
    };
    sweep<Wrap>(wraps, set(GL_TEXTURE_WRAP_S), [&] { return state().unit[0].texture->wrap_s; });
    sweep<Wrap>(wraps, set(GL_TEXTURE_WRAP_T), [&] { return state().unit[0].texture->wrap_t; });
}

TEST_F(Tokens, TextureEnvironments) {
    const auto set = [&](GLenum pname) {
        return [this, pname](GLenum value) { cmd::TexEnv(c, GL_TEXTURE_ENV, pname, token(value)); };
    };
    using raster::TexEnv;
    std::map<GLenum, TexEnv> modes = {{GL_REPLACE, TexEnv::replace},
                                      {GL_MODULATE, TexEnv::modulate},
                                      {GL_DECAL, TexEnv::decal},
                                      {GL_BLEND, TexEnv::blend},
                                      {GL_ADD, TexEnv::add}};
#if SPANGLE_FEATURE_TEXTURE_COMBINE
    modes[GL_COMBINE] = TexEnv::combine;
#endif
    sweep<TexEnv>(modes, set(GL_TEXTURE_ENV_MODE), [&] { return state().unit[0].env; });
#if SPANGLE_FEATURE_TEXTURE_COMBINE
    cmd::TexEnv(c, GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, token(GL_COMBINE));
    using F = raster::CombineFunc;
    std::map<GLenum, F> functions = {
        {GL_REPLACE, F::replace},       {GL_MODULATE, F::modulate},       {GL_ADD, F::add},
        {GL_ADD_SIGNED, F::add_signed}, {GL_INTERPOLATE, F::interpolate}, {GL_SUBTRACT, F::subtract}};
    sweep<F>(functions, set(GL_COMBINE_ALPHA), [&] { return state().unit[0].alpha.func; });
    functions[GL_DOT3_RGB] = F::dot3_rgb;
    functions[GL_DOT3_RGBA] = F::dot3_rgba;
    sweep<F>(functions, set(GL_COMBINE_RGB), [&] { return state().unit[0].rgb.func; });
    cmd::TexEnv(c, GL_TEXTURE_ENV, GL_COMBINE_RGB, token(GL_MODULATE));
    using O = raster::CombineOperand;
    std::map<GLenum, O> operands = {{GL_SRC_ALPHA, O::alpha}, {GL_ONE_MINUS_SRC_ALPHA, O::one_minus_alpha}};
    sweep<O>(operands, set(GL_OPERAND0_ALPHA), [&] { return state().unit[0].alpha.argument[0].operand; });
    operands[GL_SRC_COLOR] = O::color;
    operands[GL_ONE_MINUS_SRC_COLOR] = O::one_minus_color;
    sweep<O>(operands, set(GL_OPERAND0_RGB), [&] { return state().unit[0].rgb.argument[0].operand; });
    using S = raster::CombineSource;
    std::map<GLenum, S> sources = {{GL_TEXTURE, S::texture},
                                   {GL_CONSTANT, S::constant},
                                   {GL_PRIMARY_COLOR, S::primary_color},
                                   {GL_PREVIOUS, S::previous},
                                   {GL_TEXTURE0, S::texture0}};
    for (int unit = 1; unit < texture_units; ++unit) {
        const auto u = static_cast<unsigned>(unit);
        sources[GL_TEXTURE0 + u] = static_cast<S>(static_cast<unsigned>(S::texture0) + u);
        cmd::ActiveTexture(c, GL_TEXTURE0 + u);
        const std::uint8_t texel[4] = {};
        tex_image_2d(c, GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
        c.texture.unit[u].enabled[index_of(TextureKind::two)] = true;
    }
    cmd::ActiveTexture(c, GL_TEXTURE0);
    sweep<S>(sources, set(GL_SOURCE0_RGB), [&] { return state().unit[0].rgb.argument[0].source; });
#endif
}

} // namespace
} // namespace spangle::gl
