// COMBINE: a texture unit makes its result from up to three arguments (GL 1.3, 3.8.13, tables 3.24 to 3.26).
// Sources from other units come from GL 1.4.
#pragma once

#include "raster/ops/component.hpp"
#include "raster/ops/texture_env.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Constants and functions of COMBINE whose intermediate results leave [0, 1]: the constant 1/2, the scales,
/// and the scalar product.
template <class N> struct CombineMath {
    using T = typename N::T;
    using L = typename N::L;
    SPANGLE_INLINE static T half() { return component::constant<N>(N::one / 2); }

    SPANGLE_INLINE static T scaled(const T& v, unsigned log2) {
        if constexpr (N::lanes == 1)
            return v > N::one >> log2 ? N::one : v << log2;
        T doubled = component::smaller<N>(v, component::constant<N>(N::one >> log2));
        for (; log2 != 0; --log2)
            doubled = doubled + doubled;
        return doubled;
    }
    /// The scalar product 4 (a - 1/2) . (b - 1/2), clamped to [0, 1].
    SPANGLE_INLINE static T dot3(const typename N::Color& a, const typename N::Color& b) {
        if constexpr (N::lanes == 1) {
            const std::int64_t sum = product(a.r, b.r) + product(a.g, b.g) + product(a.b, b.b);
            return static_cast<T>(numeric::clamp<std::int64_t>(4 * sum, 0, N::one));
        } else {
            // Words of 32 bits hold the sum with its sign. A quarter of 1 is a whole number of units.
            const auto positive =
                L::positive(lanes_product(a.r, b.r) + lanes_product(a.g, b.g) + lanes_product(a.b, b.b));
            const auto sum = L::minimum(positive, L::splat32(N::one / 4)) << 2;
            if constexpr (is_exact<N>)
                return sum;
            else
                return L::low_half(sum);
        }
    }

  private:
    SPANGLE_INLINE static T distance(const T& a) {
        return component::larger<N>(a, half()) - component::smaller<N>(a, half());
    }
    static std::int64_t product(T a, T b) {
        const auto magnitude = static_cast<std::int64_t>(N::mul(distance(a), distance(b)));
        return (a > half()) == (b > half()) ? magnitude : -magnitude;
    }
    SPANGLE_INLINE static typename L::U32 lanes_product(const T& a, const T& b) {
        const auto sign = L::less(half(), a) ^ L::less(half(), b); // all ones where the product is negative
        typename L::U32 magnitude;
        if constexpr (is_exact<N>)
            magnitude = N::mul(distance(a), distance(b));
        else
            magnitude = L::widened(N::mul(distance(a), distance(b)));
        return L::select(sign, 0u - magnitude, magnitude);
    }
};

template <class N> class TextureCombine {
    using T = typename N::T;
    using Color = typename N::Color;
    using Math = CombineMath<N>;

  public:
    /// Applies all units. `texel[n]` is the texture colour of unit n where that unit is on. `color` is the
    /// primary colour and becomes the result.
    static void units(const FragmentState& state, const Color* texel, Color& color) {
        const Color primary = color;
        for (int u = 0; u < max_texture_units; ++u) {
            const TextureUnit& unit = state.unit[u];
            if (unit.texture == nullptr)
                continue;
            const Color constant = env_color<N>(unit);
            if (unit.env != TexEnv::combine)
                apply_env<N>(unit.env, unit.texture->base, color, texel[u], constant);
            else
                color = combine(unit, {state, texel, u, constant, primary, color});
        }
    }

    /// a + b - 1/2, clamped to [0, 1].
    SPANGLE_INLINE static T sum_less_half(const T& a, const T& b) {
        if constexpr (N::lanes == 1)
            return b < Math::half() ? N::subtract(a, Math::half() - b) : N::add(a, b - Math::half());
        else
            return component::where_less<N>(b, Math::half(), N::subtract(a, Math::half() - b),
                                            N::add(a, b - Math::half()));
    }

  private:
    struct Sources {
        const FragmentState& state;
        const Color* texel;
        int unit;
        Color constant, primary, previous;

        Color of(CombineSource source) const {
            switch (source) {
            case CombineSource::texture:
                return texture(unit);
            case CombineSource::constant:
                return constant;
            case CombineSource::primary_color:
                return primary;
            case CombineSource::previous:
                return previous;
            case CombineSource::texture0:
                break;
            }
            return texture(static_cast<int>(source) - static_cast<int>(CombineSource::texture0));
        }
        /// A texture colour. Components that its base format lacks are filled in (GL 1.3, table 3.21).
        Color texture(int from) const {
            Color c = texel[from];
            const Texture* const image = state.unit[from].texture;
            if (image == nullptr) {
                const T none{};
                return {none, none, none, none};
            }
            if (image->base == BaseFormat::alpha)
                c.r = c.g = c.b = T{};
            else if (image->base == BaseFormat::luminance || image->base == BaseFormat::rgb)
                c.a = component::one<N>();
            return c;
        }
    };

    static Color argument(const Sources& sources, const Combiner::Argument& argument) {
        const Color c = sources.of(argument.source);
        switch (argument.operand) {
        case CombineOperand::color:
            return c;
        case CombineOperand::one_minus_color:
            return {N::one - c.r, N::one - c.g, N::one - c.b, N::one - c.a};
        case CombineOperand::alpha:
            return {c.a, c.a, c.a, c.a};
        case CombineOperand::one_minus_alpha:
            break;
        }
        const T rest = N::one - c.a;
        return {rest, rest, rest, rest};
    }

    /// Makes a result that is clamped to [0, 1] before it is scaled, and again afterwards. The first clamp
    /// changes nothing, because scales are at least 1.
    static T result(CombineFunc func, T a, T b, T c) {
        switch (func) {
        case CombineFunc::replace:
            return a;
        case CombineFunc::modulate:
            return N::mul(a, b);
        case CombineFunc::add:
            return N::add(a, b);
        case CombineFunc::add_signed:
            return sum_less_half(a, b);
        case CombineFunc::interpolate:
            return N::lerp(b, a, c);
        case CombineFunc::subtract:
            return N::subtract(a, b);
        case CombineFunc::dot3_rgb:
        case CombineFunc::dot3_rgba:
            break; // combine() computes all components of DOT3 functions at once
        }
        return a;
    }

    static Color combine(const TextureUnit& unit, const Sources& sources) {
        const auto argument_of = [&](const Combiner& combiner, int i) {
            return argument(sources, combiner.argument[i]);
        };
        const CombineFunc func = unit.rgb.func;
        const Color a = argument_of(unit.rgb, 0), b = argument_of(unit.rgb, 1);
        Color out{};
        if (func >= CombineFunc::dot3_rgb) {
            out.r = out.g = out.b = out.a = Math::dot3(a, b);
        } else {
            const Color c = argument_of(unit.rgb, 2);
            out = {result(func, a.r, b.r, c.r), result(func, a.g, b.g, c.g), result(func, a.b, b.b, c.b),
                   T{}};
        }
        if (func != CombineFunc::dot3_rgba)
            out.a = result(unit.alpha.func, argument_of(unit.alpha, 0).a, argument_of(unit.alpha, 1).a,
                           argument_of(unit.alpha, 2).a);
        const unsigned rgb = unit.rgb.log2_scale;
        return {Math::scaled(out.r, rgb), Math::scaled(out.g, rgb), Math::scaled(out.b, rgb),
                Math::scaled(out.a, unit.alpha.log2_scale)};
    }
};

/// Whether some unit combines (GL_COMBINE). All units are then sampled before the first one combines, because
/// it may read the texel of any unit.
inline bool uses_combiners(const FragmentState& state) {
    bool any = false;
    for (const TextureUnit& unit : state.unit)
        any = any || (unit.texture != nullptr && unit.env == TexEnv::combine);
    return any;
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
