// GL tokens and the rasterizer's enumerators for them. Each kind of token has one table, or one pair of
// functions, which defines both the legal tokens and their meaning. A command refuses all other tokens, so
// that no state holds a token without a meaning. tokens.cpp checks the functions token by token.
#pragma once

#include <array>
#include <cstddef>

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"

namespace spangle::gl {

/// A token and its meaning.
template <class Enum> struct Token {
    std::uint16_t token;
    Enum meaning;
};

/// No file defines it, so that a table that calls it does not compile.
void an_enumerator_has_no_token_or_two();

/// Returns the tokens at the indices of their enumerators, from the first one to `last`. The list may have
/// any order.
template <auto last, std::size_t count>
consteval auto by_enumerator(const Token<decltype(last)> (&list)[count]) {
    constexpr std::size_t all = static_cast<std::size_t>(last) + 1;
    std::array<std::uint16_t, all> table{};
    bool given[all] = {};
    for (const auto& [token, meaning] : list) {
        const auto place = static_cast<std::size_t>(meaning);
        if (count != all || place >= all || given[place])
            an_enumerator_has_no_token_or_two();
        given[place] = true;
        table[place] = token;
    }
    return table;
}

inline constexpr auto stencil_ops = by_enumerator<raster::StencilOp::decr_wrap>({
    {GL_KEEP, raster::StencilOp::keep},
    {GL_ZERO, raster::StencilOp::zero},
    {GL_REPLACE, raster::StencilOp::replace},
    {GL_INCR, raster::StencilOp::incr},
    {GL_DECR, raster::StencilOp::decr},
    {GL_INVERT, raster::StencilOp::invert},
    {GL_INCR_WRAP, raster::StencilOp::incr_wrap},
    {GL_DECR_WRAP, raster::StencilOp::decr_wrap},
});
inline constexpr auto blend_equations = by_enumerator<raster::BlendEquation::max>({
    {GL_FUNC_ADD, raster::BlendEquation::add},
    {GL_FUNC_SUBTRACT, raster::BlendEquation::subtract},
    {GL_FUNC_REVERSE_SUBTRACT, raster::BlendEquation::reverse_subtract},
    {GL_MIN, raster::BlendEquation::min},
    {GL_MAX, raster::BlendEquation::max},
});
inline constexpr auto fog_modes = by_enumerator<raster::FogMode::linear>({
    {GL_EXP, raster::FogMode::exp},
    {GL_EXP2, raster::FogMode::exp2},
    {GL_LINEAR, raster::FogMode::linear},
});
inline constexpr auto wraps = by_enumerator<raster::Wrap::mirrored_repeat>({
    {GL_REPEAT, raster::Wrap::repeat},
    {GL_CLAMP, raster::Wrap::clamp},
    {GL_CLAMP_TO_EDGE, raster::Wrap::clamp_to_edge},
    {GL_CLAMP_TO_BORDER, raster::Wrap::clamp_to_border},
    {GL_MIRRORED_REPEAT, raster::Wrap::mirrored_repeat},
});
#if SPANGLE_FEATURE_TEXTURE_COMBINE
inline constexpr auto last_env_mode = raster::TexEnv::combine;
#else
inline constexpr auto last_env_mode = raster::TexEnv::add;
#endif
inline constexpr auto env_modes = by_enumerator<last_env_mode>({
    {GL_REPLACE, raster::TexEnv::replace}, {GL_MODULATE, raster::TexEnv::modulate},
        {GL_DECAL, raster::TexEnv::decal}, {GL_BLEND, raster::TexEnv::blend}, {GL_ADD, raster::TexEnv::add},
#if SPANGLE_FEATURE_TEXTURE_COMBINE
        {GL_COMBINE, raster::TexEnv::combine},
#endif
});
inline constexpr auto combine_functions = by_enumerator<raster::CombineFunc::dot3_rgba>({
    {GL_REPLACE, raster::CombineFunc::replace},
    {GL_MODULATE, raster::CombineFunc::modulate},
    {GL_ADD, raster::CombineFunc::add},
    {GL_ADD_SIGNED, raster::CombineFunc::add_signed},
    {GL_INTERPOLATE, raster::CombineFunc::interpolate},
    {GL_SUBTRACT, raster::CombineFunc::subtract},
    {GL_DOT3_RGB, raster::CombineFunc::dot3_rgb},
    {GL_DOT3_RGBA, raster::CombineFunc::dot3_rgba},
});
/// Combiner sources except GL_TEXTUREn, whose enumerators follow.
inline constexpr auto combine_sources = by_enumerator<raster::CombineSource::previous>({
    {GL_TEXTURE, raster::CombineSource::texture},
    {GL_CONSTANT, raster::CombineSource::constant},
    {GL_PRIMARY_COLOR, raster::CombineSource::primary_color},
    {GL_PREVIOUS, raster::CombineSource::previous},
});
static_assert(combine_sources.size() == static_cast<std::size_t>(raster::CombineSource::texture0));

/// Returns the index of a token in a table, or `count` if the table does not have it.
unsigned place_in(const std::uint16_t* table, unsigned count, GLenum token);
template <std::size_t count> unsigned place_in(const std::array<std::uint16_t, count>& table, GLenum token) {
    return place_in(table.data(), count, token);
}
template <std::size_t count> bool is_in(const std::array<std::uint16_t, count>& table, GLenum token) {
    return place_in(table, token) < count;
}

/// True for comparisons of the alpha, stencil and depth tests, and of depth textures (GL 1.3, 4.1.4 to
/// 4.1.6).
constexpr bool is_compare(GLenum func) {
    return func >= GL_NEVER && func <= GL_ALWAYS;
}
constexpr raster::Compare compare_of(GLenum func) {
    return static_cast<raster::Compare>(func - GL_NEVER);
}

/// True for factors of both colours. SRC_ALPHA_SATURATE is a factor of the source only (GL 1.4, tables 4.1
/// and 4.2).
constexpr bool is_blend_factor(GLenum factor) {
    return factor == GL_ZERO || factor == GL_ONE ||
           (factor >= GL_SRC_COLOR && factor <= GL_ONE_MINUS_DST_COLOR) ||
           (factor >= GL_CONSTANT_COLOR && factor <= GL_ONE_MINUS_CONSTANT_ALPHA);
}
constexpr bool is_source_factor(GLenum factor) {
    return is_blend_factor(factor) || factor == GL_SRC_ALPHA_SATURATE;
}
constexpr raster::BlendFactor blend_factor_of(GLenum factor) {
    if (factor <= GL_ONE)
        return static_cast<raster::BlendFactor>(factor);
    if (factor >= GL_CONSTANT_COLOR)
        return static_cast<raster::BlendFactor>(factor - GL_CONSTANT_COLOR +
                                                static_cast<GLenum>(raster::BlendFactor::constant_color));
    return static_cast<raster::BlendFactor>(factor - GL_SRC_COLOR +
                                            static_cast<GLenum>(raster::BlendFactor::src_color));
}

constexpr bool is_logic_op(GLenum op) {
    return op >= GL_CLEAR && op <= GL_SET;
}
constexpr raster::LogicOp logic_op_of(GLenum op) {
    return static_cast<raster::LogicOp>(op - GL_CLEAR);
}

/// True for operands of an RGB combiner. A combiner of alpha has no operands of colours.
constexpr bool is_combine_operand(GLenum operand) {
    return operand >= GL_SRC_COLOR && operand <= GL_ONE_MINUS_SRC_ALPHA;
}
constexpr raster::CombineOperand combine_operand_of(GLenum operand) {
    return static_cast<raster::CombineOperand>(operand - GL_SRC_COLOR);
}

constexpr bool has_mipmaps(GLenum min_filter) {
    return min_filter >= GL_NEAREST_MIPMAP_NEAREST;
}
constexpr bool is_mag_filter(GLenum filter) {
    return filter == GL_NEAREST || filter == GL_LINEAR;
}
constexpr bool is_min_filter(GLenum filter) {
    return is_mag_filter(filter) || (has_mipmaps(filter) && filter <= GL_LINEAR_MIPMAP_LINEAR);
}
/// Returns the filter within a level. Bit 0 of a filter's token means linear within a level, and bit 1 linear
/// between levels.
constexpr raster::Filter filter_of(GLenum filter) {
    return (filter & 1) != 0 ? raster::Filter::linear : raster::Filter::nearest;
}
constexpr raster::MipFilter mip_filter_of(GLenum min_filter) {
    return !has_mipmaps(min_filter) ? raster::MipFilter::none
           : (min_filter & 2) != 0  ? raster::MipFilter::linear
                                    : raster::MipFilter::nearest;
}

} // namespace spangle::gl
