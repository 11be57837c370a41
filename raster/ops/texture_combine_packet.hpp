// COMBINE for all fragments of a packet (GL 1.3, 3.8.13). The bytes are those of TextureCombine.
#pragma once

#include "raster/ops/packet_operand.hpp"
#include "raster/ops/texture_combine.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <class N> class PacketCombine {
    using Color = typename N::Color;
    using T = typename N::T;
    using Math = CombineMath<N>;
    using Operand = PacketOperand<N>;
    using Result = PacketResult<N>;
    using Room = Color[PlacesOf<N>::groups];
    using Values = T[PlacesOf<N>::groups]; ///< values of one component, for all groups

  public:
    /// Applies all units. `texels[n]` are the texture colours of unit n where that unit is on. `colors` are
    /// the primary colours and become the results.
    static void units(const FragmentState& state, const Room* texels, std::int32_t groups, Color* colors) {
        Room primary;
        const Color* before = colors; // the primary colours: `colors` itself, until a unit has replaced them
        for (int u = 0; u < max_texture_units; ++u) {
            const TextureUnit& unit = state.unit[u];
            if (unit.texture == nullptr)
                continue;
            if (u == 0 && max_texture_units > 1) {
                for (std::int32_t g = 0; g < groups; ++g)
                    primary[g] = colors[g];
                before = primary;
            }
            const Color constant = env_color<N>(unit);
            if (unit.env == TexEnv::combine)
                PacketCombine(state, texels, u, before, colors, constant, groups).combine(unit);
            else
                for (std::int32_t g = 0; g < groups; ++g)
                    apply_env<N>(unit.env, unit.texture->base, colors[g], texels[u][g], constant);
        }
    }

  private:
    const FragmentState& state_;
    const Room* const texels_;
    const int unit_number_;
    const Color* const primary_;
    /// Results of the previous unit; component by component they become the results of this unit.
    Color* const colors_;
    const Color& constant_;
    const Color white_;
    const std::int32_t groups_;

    PacketCombine(const FragmentState& state, const Room* texels, int which, const Color* primary,
                  Color* colors, const Color& constant, std::int32_t groups)
        : state_(state), texels_(texels), unit_number_(which), primary_(primary), colors_(colors),
          constant_(constant), white_(white()), groups_(groups) {}
    static Color white() {
        const T one = component::one<N>();
        return {one, one, one, one};
    }

    /// Component c of a source.
    Operand source(CombineSource from, int c) const {
        switch (from) {
        case CombineSource::texture:
            return texture(unit_number_, c);
        case CombineSource::constant:
            return Operand::constant(constant_, c);
        case CombineSource::primary_color:
            return Operand::of(primary_, c);
        case CombineSource::previous:
            return Operand::of(colors_, c);
        case CombineSource::texture0:
            break;
        }
        return texture(static_cast<int>(from) - static_cast<int>(CombineSource::texture0), c);
    }
    /// Component c of a texture colour. Components that its base format lacks are filled in (GL 1.3, table
    /// 3.21).
    Operand texture(int from, int c) const {
        const Texture* const image = state_.unit[from].texture;
        if (image == nullptr || (image->base == BaseFormat::alpha && c < 3))
            return Operand::zero();
        if ((image->base == BaseFormat::luminance || image->base == BaseFormat::rgb) && c == 3)
            return Operand::constant(white_, c);
        return Operand::of(texels_[from], c);
    }
    /// Component c of an argument. `to` is room for the values.
    Operand argument(const Combiner::Argument& of, int c, T* to) const {
        const bool alpha =
            of.operand == CombineOperand::alpha || of.operand == CombineOperand::one_minus_alpha;
        const Operand found = source(of.source, alpha ? 3 : c);
        if (of.operand == CombineOperand::color || of.operand == CombineOperand::alpha)
            return found;
        return Result(to, groups_)
            .set(
                [](const T& v) __attribute__((always_inline)) { return N::one - v; }, found);
    }

    void combine(const TextureUnit& unit) const {
        const CombineFunc func = unit.rgb.func;
        if (func >= CombineFunc::dot3_rgb)
            dot3(unit.rgb, func == CombineFunc::dot3_rgba);
        else
            for (int c = 0; c < 3; ++c)
                component(unit.rgb, c);
        if (func != CombineFunc::dot3_rgba)
            component(unit.alpha, 3);
        const auto scale = [&](int c, unsigned log2) {
            if (log2 != 0)
                Result(colors_, c, groups_)
                    .set(
                        [log2](const T& v) __attribute__((always_inline)) { return Math::scaled(v, log2); },
                        Operand::of(colors_, c));
        };
        for (int c = 0; c < 3; ++c)
            scale(c, unit.rgb.log2_scale);
        scale(3, unit.alpha.log2_scale);
    }
    [[gnu::noinline]] void dot3(const Combiner& by, bool alpha) const {
        Values room[2][3];
        Operand a[3], b[3];
        for (int c = 0; c < 3; ++c) {
            a[c] = argument(by.argument[0], c, room[0][c]);
            b[c] = argument(by.argument[1], c, room[1][c]);
        }
        for (std::int32_t g = 0; g < groups_; ++g) {
            const T v = Math::dot3({a[0][g], a[1][g], a[2][g], T{}}, {b[0][g], b[1][g], b[2][g], T{}});
            colors_[g] = {v, v, v, alpha ? v : colors_[g].a};
        }
    }
    /// Makes component c of the result, clamped but not scaled.
    [[gnu::noinline]] void component(const Combiner& by, int c) const {
        Values room[3];
        const Result to(colors_, c, groups_);
        const auto argument_of = [&](int i) { return argument(by.argument[i], c, room[i]); };
        const Operand a = argument_of(0),
                      b = by.func == CombineFunc::replace ? Operand::zero() : argument_of(1);
        const auto two = [&](auto f) __attribute__((always_inline)) {
            to.set(f, a, b);
        };
        switch (by.func) {
        case CombineFunc::replace:
            to.set(
                [](const T& v) __attribute__((always_inline)) { return v; }, a);
            return;
        case CombineFunc::modulate:
            return two([](const T& v, const T& w) __attribute__((always_inline)) { return N::mul(v, w); });
        case CombineFunc::add:
            return two([](const T& v, const T& w) __attribute__((always_inline)) { return N::add(v, w); });
        case CombineFunc::add_signed:
            return two([](const T& v, const T& w)
                           __attribute__((always_inline)) { return TextureCombine<N>::sum_less_half(v, w); });
        case CombineFunc::interpolate:
            to.set(
                [](const T& v, const T& w, const T& by_c)
                    __attribute__((always_inline)) { return N::lerp(w, v, by_c); },
                a, b, argument_of(2));
            return;
        case CombineFunc::subtract:
            return two([](const T& v, const T& w)
                           __attribute__((always_inline)) { return N::subtract(v, w); });
        case CombineFunc::dot3_rgb:
        case CombineFunc::dot3_rgba:
            return; // dot3() has computed all components already
        }
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
