// Blends a packet at a time, by any equation and factors (GL 1.3, 4.1.7; GL 1.4, 4.1.7). The bytes are those
// of Blend.
#pragma once

#include "raster/ops/packet_operand.hpp"
#include "raster/ops/stage_blend.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Applies the equations of BlendEquations to all fragments of a packet.
template <class N> class PacketBlend {
    using Color = typename N::Color;
    using T = typename N::T;
    using Operand = PacketOperand<N>;
    using Result = PacketResult<N>;

  public:
    /// Blends colours, in place, with the colours that are stored under them. Alpha is blended only where it
    /// is stored.
    static void blend(const FragmentState& state, std::int32_t groups, const Color* stored, bool alpha,
                      Color* colors) {
        const PacketBlend by(state, groups, stored, colors);
        for (int c = 0; c < 3; ++c)
            by.component(state.blend_rgb, c);
        if (alpha)
            by.component(blending_of_alpha(state), 3);
    }

  private:
    const FragmentState& state_;
    const std::int32_t groups_;
    const Color* const stored_;
    Color* const colors_; ///< sources, replaced by results component after component
    const Color one_, constant_;

    PacketBlend(const FragmentState& state, std::int32_t groups, const Color* stored, Color* colors)
        : state_(state), groups_(groups), stored_(stored), colors_(colors),
          one_(all(color_one)), constant_{N::from_units(state.blend_color[0]),
                                          N::from_units(state.blend_color[1]),
                                          N::from_units(state.blend_color[2]),
                                          N::from_units(state.blend_color[3])} {}
    static Color all(std::uint32_t units) {
        const T v = N::from_units(units);
        return {v, v, v, v};
    }
    /// Blends component c. MIN and MAX use no factors.
    [[gnu::noinline]] void component(const Blending& by, int c) const {
        const Result to(colors_, c, groups_);
        const Operand cs = Operand::of(colors_, c), cd = Operand::of(stored_, c);
        const auto set = [&](auto f, const Operand& a, const Operand& b) __attribute__((always_inline)) {
            to.set(f, a, b);
        };
        const auto smaller = [](const T& a, const T& b) __attribute__((always_inline)) {
            return component::smaller<N>(a, b);
        };
        const auto larger = [](const T& a, const T& b) __attribute__((always_inline)) {
            return component::larger<N>(a, b);
        };
        if (by.equation == BlendEquation::min)
            return set(smaller, cs, cd);
        if (by.equation == BlendEquation::max)
            return set(larger, cs, cd);
        T products[2][PlacesOf<N>::groups];
        const Operand source = times(cs, by.src, c, products[0]), stored = times(cd, by.dst, c, products[1]);
        const auto sum = [](const T& a, const T& b) __attribute__((always_inline)) {
            return N::add(a, b);
        };
        const auto difference = [](const T& a, const T& b) __attribute__((always_inline)) {
            return N::subtract(a, b);
        };
        switch (by.equation) {
        case BlendEquation::add:
            return set(sum, source, stored);
        case BlendEquation::subtract:
            return set(difference, source, stored);
        case BlendEquation::reverse_subtract:
            return set(difference, stored, source);
        case BlendEquation::min:
        case BlendEquation::max:
            break; // the function has returned above
        }
    }

    /// The products value * factor in component c; the factors 0 and 1 are exact. `to` is room for the
    /// products.
    Operand times(const Operand& value, BlendFactor factor, int c, T* to) const {
        const Result result(to, groups_);
        const auto by = [&](const Operand& of) __attribute__((always_inline)) {
            return result.set(
                [](const T& v, const T& f) __attribute__((always_inline)) { return N::mul(v, f); }, value,
                of);
        };
        const auto by_rest = [&](const Operand& of) __attribute__((always_inline)) {
            const T one = one_.r;
            return result.set(
                [one](const T& v, const T& f) __attribute__((always_inline)) { return N::mul(v, one - f); },
                value, of);
        };
        const bool rest = is_rest(factor);
        switch (factor) {
        case BlendFactor::zero:
            return Operand::zero();
        case BlendFactor::one:
            return value;
        case BlendFactor::src_alpha_saturate:
            return by(saturating(result));
        default:
            break;
        }
        const Operand of = factor_of(factor, c);
        return rest ? by_rest(of) : by(of);
    }
    /// Whether a factor is 1 minus another factor.
    static bool is_rest(BlendFactor factor) {
        switch (factor) {
        case BlendFactor::one_minus_src_color:
        case BlendFactor::one_minus_src_alpha:
        case BlendFactor::one_minus_dst_alpha:
        case BlendFactor::one_minus_dst_color:
        case BlendFactor::one_minus_constant_color:
        case BlendFactor::one_minus_constant_alpha:
            return true;
        default:
            return false;
        }
    }
    /// The value of a factor. For a factor 1 - f (is_rest()) it is f.
    Operand factor_of(BlendFactor factor, int c) const {
        switch (factor) {
        case BlendFactor::src_color:
        case BlendFactor::one_minus_src_color:
            return Operand::of(colors_, c);
        case BlendFactor::src_alpha:
        case BlendFactor::one_minus_src_alpha:
            return Operand::of(colors_, 3);
        case BlendFactor::dst_color:
        case BlendFactor::one_minus_dst_color:
            return Operand::of(stored_, c);
        case BlendFactor::dst_alpha:
        case BlendFactor::one_minus_dst_alpha:
            return Operand::of(stored_, 3);
        case BlendFactor::constant_color:
        case BlendFactor::one_minus_constant_color:
            return Operand::constant(constant_, c);
        case BlendFactor::constant_alpha:
        case BlendFactor::one_minus_constant_alpha:
            return Operand::constant(constant_, 3);
        case BlendFactor::zero:
        case BlendFactor::one:
        case BlendFactor::src_alpha_saturate:
            break; // times() handles these factors
        }
        return Operand::zero();
    }
    /// min(As, 1 - Ad), written into the room of `to`.
    Operand saturating(const Result& to) const {
        const T one = one_.r;
        return to.set(
            [one](const T& s, const T& d)
                __attribute__((always_inline)) { return component::smaller<N>(s, one - d); },
            Operand::of(colors_, 3), Operand::of(stored_, 3));
    }
};

/// The stage of a chain that blends with the pixels of a format.
template <class N, PixelFormat Format>
void blend_packet(PlacesOf<N>& places, const Span<typename N::Policy>& span) {
    auto& k = static_cast<Packet<N>&>(places);
    typename N::Color stored[PlacesOf<N>::groups];
    const std::int32_t groups = (k.n + N::lanes - 1) / N::lanes;
    for (std::int32_t g = 0; g < groups; ++g)
        stored[g] = load_color<N, Format>(k.color_plane, g * N::lanes);
    PacketBlend<N>::blend(span.state->fragment, groups, stored, format_info(Format).alpha_bits != 0, k.color);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
