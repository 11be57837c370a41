#include "gl/context/tokens.hpp"

namespace spangle::gl {

namespace {

/// True if the list has the enumerators in order from the first one on. Each token must be legal and stand
/// for its enumerator.
template <class Enum, std::size_t count>
consteval bool agree(bool (*legal)(GLenum), Enum (*meaning_of)(GLenum), const Token<Enum> (&list)[count]) {
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [token, meaning] = list[i];
        if (static_cast<std::size_t>(meaning) != i || !legal(token) || meaning_of(token) != meaning)
            return false;
    }
    return true;
}

static_assert(agree(is_compare, compare_of,
                    {{GL_NEVER, raster::Compare::never},
                     {GL_LESS, raster::Compare::less},
                     {GL_EQUAL, raster::Compare::equal},
                     {GL_LEQUAL, raster::Compare::lequal},
                     {GL_GREATER, raster::Compare::greater},
                     {GL_NOTEQUAL, raster::Compare::notequal},
                     {GL_GEQUAL, raster::Compare::gequal},
                     {GL_ALWAYS, raster::Compare::always}}));
static_assert(agree(is_source_factor, blend_factor_of,
                    {{GL_ZERO, raster::BlendFactor::zero},
                     {GL_ONE, raster::BlendFactor::one},
                     {GL_SRC_COLOR, raster::BlendFactor::src_color},
                     {GL_ONE_MINUS_SRC_COLOR, raster::BlendFactor::one_minus_src_color},
                     {GL_SRC_ALPHA, raster::BlendFactor::src_alpha},
                     {GL_ONE_MINUS_SRC_ALPHA, raster::BlendFactor::one_minus_src_alpha},
                     {GL_DST_ALPHA, raster::BlendFactor::dst_alpha},
                     {GL_ONE_MINUS_DST_ALPHA, raster::BlendFactor::one_minus_dst_alpha},
                     {GL_DST_COLOR, raster::BlendFactor::dst_color},
                     {GL_ONE_MINUS_DST_COLOR, raster::BlendFactor::one_minus_dst_color},
                     {GL_SRC_ALPHA_SATURATE, raster::BlendFactor::src_alpha_saturate},
                     {GL_CONSTANT_COLOR, raster::BlendFactor::constant_color},
                     {GL_ONE_MINUS_CONSTANT_COLOR, raster::BlendFactor::one_minus_constant_color},
                     {GL_CONSTANT_ALPHA, raster::BlendFactor::constant_alpha},
                     {GL_ONE_MINUS_CONSTANT_ALPHA, raster::BlendFactor::one_minus_constant_alpha}}));
static_assert(agree(is_logic_op, logic_op_of,
                    {{GL_CLEAR, raster::LogicOp::clear},
                     {GL_AND, raster::LogicOp::logical_and},
                     {GL_AND_REVERSE, raster::LogicOp::and_reverse},
                     {GL_COPY, raster::LogicOp::copy},
                     {GL_AND_INVERTED, raster::LogicOp::and_inverted},
                     {GL_NOOP, raster::LogicOp::noop},
                     {GL_XOR, raster::LogicOp::logical_xor},
                     {GL_OR, raster::LogicOp::logical_or},
                     {GL_NOR, raster::LogicOp::nor},
                     {GL_EQUIV, raster::LogicOp::equiv},
                     {GL_INVERT, raster::LogicOp::invert},
                     {GL_OR_REVERSE, raster::LogicOp::or_reverse},
                     {GL_COPY_INVERTED, raster::LogicOp::copy_inverted},
                     {GL_OR_INVERTED, raster::LogicOp::or_inverted},
                     {GL_NAND, raster::LogicOp::nand},
                     {GL_SET, raster::LogicOp::set}}));
static_assert(agree(is_combine_operand, combine_operand_of,
                    {{GL_SRC_COLOR, raster::CombineOperand::color},
                     {GL_ONE_MINUS_SRC_COLOR, raster::CombineOperand::one_minus_color},
                     {GL_SRC_ALPHA, raster::CombineOperand::alpha},
                     {GL_ONE_MINUS_SRC_ALPHA, raster::CombineOperand::one_minus_alpha}}));

constexpr bool filters_by(GLenum token, raster::Filter within, raster::MipFilter between) {
    return is_min_filter(token) && filter_of(token) == within && mip_filter_of(token) == between;
}
static_assert(filters_by(GL_NEAREST, raster::Filter::nearest, raster::MipFilter::none) &&
              filters_by(GL_LINEAR, raster::Filter::linear, raster::MipFilter::none) &&
              filters_by(GL_NEAREST_MIPMAP_NEAREST, raster::Filter::nearest, raster::MipFilter::nearest) &&
              filters_by(GL_LINEAR_MIPMAP_NEAREST, raster::Filter::linear, raster::MipFilter::nearest) &&
              filters_by(GL_NEAREST_MIPMAP_LINEAR, raster::Filter::nearest, raster::MipFilter::linear) &&
              filters_by(GL_LINEAR_MIPMAP_LINEAR, raster::Filter::linear, raster::MipFilter::linear));

} // namespace

unsigned place_in(const std::uint16_t* table, unsigned count, GLenum token) {
    unsigned place = 0;
    while (place < count && table[place] != token)
        ++place;
    return place;
}

} // namespace spangle::gl
