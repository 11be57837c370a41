// Texels as they lie in memory, one word per lane, become colours: single texels, or four filtered ones.
#pragma once

#include "raster/ops/filter.hpp"
#include "raster/ops/filter_words.hpp"
#include "raster/ops/number_wide.hpp"
#include "raster/ops/texel.hpp"
#include "raster/ops/texel_factor.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The factors of MODULATE for a texel, which is a word R5 G6 B5 or has 8-bit components with R in the lowest
/// byte. Factors has factor5(), factor6() and factor8().
template <class Factors, bool Is565> struct TexelScales {
    SPANGLE_INLINE static std::uint32_t red(std::uint32_t t) {
        return Is565 ? Factors::factor5(t >> 11) : Factors::factor8(t & 255);
    }
    SPANGLE_INLINE static std::uint32_t green(std::uint32_t t) {
        return Is565 ? Factors::factor6(t >> 5 & 63) : Factors::factor8(t >> 8 & 255);
    }
    SPANGLE_INLINE static std::uint32_t blue(std::uint32_t t) {
        return Is565 ? Factors::factor5(t & 31) : Factors::factor8(t >> 16 & 255);
    }
};

/// The components themselves, as factors for TexelScales.
struct TexelComponents {
    SPANGLE_INLINE static std::uint32_t factor5(std::uint32_t k) { return k; }
    SPANGLE_INLINE static std::uint32_t factor6(std::uint32_t k) { return k; }
    SPANGLE_INLINE static std::uint32_t factor8(std::uint32_t k) { return k; }
};

/// The factors of TexelScales as the chain has them. Those of texels R5 G6 B5 come from tables.
template <class N, bool Is565, int Steps> struct ChainScales {
    SPANGLE_INLINE static std::uint32_t red(std::uint32_t t) {
        return Is565 ? texel_factor<5, N, Steps>(t >> 11) : of<5>(t & 255);
    }
    SPANGLE_INLINE static std::uint32_t green(std::uint32_t t) {
        return Is565 ? texel_factor<6, N, Steps>(t >> 5 & 63) : of<6>(t >> 8 & 255);
    }
    SPANGLE_INLINE static std::uint32_t blue(std::uint32_t t) {
        return Is565 ? texel_factor<5, N, Steps>(t & 31) : of<5>(t >> 16 & 255);
    }

  private:
    template <unsigned Bits> SPANGLE_INLINE static std::uint32_t of(std::uint32_t k) {
        if constexpr (Steps != 0)
            return Steps * N::fraction(N::template steps15<Bits>(N::from8(k)));
        else
            return N::fraction(N::from8(k));
    }
};

/// Colours of texels that are words R5 G6 B5, or have 8-bit components with R in the lowest byte. Alpha: the
/// texels have alpha.
template <class N, bool Is565, bool Alpha> struct TexelColors {
    using Color = typename N::Color;
    using L = typename N::L;

    template <class V> SPANGLE_INLINE static Color unpack(const V& v) {
        if constexpr (Is565)
            return {N::texel5(v >> 11), N::texel6((v >> 5) & 63), N::texel5(v & 31),
                    N::from_units(color_one)};
        else
            return {N::from8(L::byte(v, 0)), N::from8(L::byte(v, 1)), N::from8(L::byte(v, 2)),
                    Alpha ? N::from8(L::byte(v, 3)) : N::from_units(color_one)};
    }
    /// The LINEAR filter of the exact tier with one lane. b is the weight of row j + 1 in 256ths.
    struct ExactBilinear {
        std::uint32_t b;
        SPANGLE_INLINE explicit ExactBilinear(std::uint32_t weight) : b(weight) {}
        /// Filters texels of bytes; a is the weight of column i + 1. A component is k 2^20 and the weights
        /// add up to 2^16, so nothing is rounded (ExactFilter). Two components share a word along t.
        SPANGLE_INLINE Color bytes(std::uint32_t c00, std::uint32_t c10, std::uint32_t c01, std::uint32_t c11,
                                   std::uint32_t a) const {
            constexpr std::uint32_t pair = 0x00FF00FF;
            const auto column = [&](std::uint32_t near, std::uint32_t far) {
                return (near & pair) * (256 - b) + (far & pair) * b;
            };
            const auto across = [&](std::uint32_t v0, std::uint32_t v1) {
                return (v0 * (256 - a) + v1 * a) << (color_fraction_bits - 16);
            };
            const std::uint32_t rb0 = column(c00, c01), rb1 = column(c10, c11),
                                ga0 = column(c00 >> 8, c01 >> 8), ga1 = column(c10 >> 8, c11 >> 8);
            return {across(rb0 & 0xFFFF, rb1 & 0xFFFF), across(ga0 & 0xFFFF, ga1 & 0xFFFF),
                    across(rb0 >> 16, rb1 >> 16), across(ga0 >> 16, ga1 >> 16)};
        }
    };
    using Weights = std::conditional_t<
        is_raw<N>, FilterWords<N::lanes>,
        std::conditional_t<
            std::is_same_v<N, Exact>, ExactBilinear,
            std::conditional_t<is_exact<N>, ExactLanes::Weights,
                               std::conditional_t<Is565, Filter565<N::lanes>, Filter8<N::lanes>>>>>;
    template <class V, class W>
    SPANGLE_INLINE static Color mix(const Weights& weights, const V& c00, const V& c10, const V& c01,
                                    const V& c11, const W& a) {
        if constexpr (is_raw<N>)
            return {weights(c00, c10, c01, c11, a)};
        else if constexpr (std::is_same_v<N, Exact> && !Is565 && Alpha)
            return weights.bytes(c00, c10, c01, c11, a);
        else if constexpr (std::is_same_v<N, Exact>)
            return bilinear<N>(unpack(c00), unpack(c10), unpack(c01), unpack(c11), a, weights.b);
        else if constexpr (is_exact<N>)
            return mix_lanes(weights, c00, c10, c01, c11, L::widened(a));
        else if constexpr (Is565)
            return weights(c00, c10, c01, c11, a);
        else
            return weights.template texels<Alpha>(c00, c10, c01, c11, a);
    }

  private:
    /// Mixes four texels in the exact tier. Where texels have no alpha, the result's alpha is 1 for any
    /// weights.
    template <class V, class W>
    SPANGLE_INLINE static Color mix_lanes(const Weights& weights, const V& c00, const V& c10, const V& c01,
                                          const V& c11, const W& right) {
        const auto one = N::from_units(color_one);
        if constexpr (Is565) {
            const auto mix = [&](auto component) __attribute__((always_inline)) {
                return weights.components(component(c00), component(c10), component(c01), component(c11),
                                          right);
            };
            return {mix([](const V& v) __attribute__((always_inline)) { return N::texel5(v >> 11); }),
                    mix([](const V& v) __attribute__((always_inline)) { return N::texel6((v >> 5) & 63); }),
                    mix([](const V& v) __attribute__((always_inline)) { return N::texel5(v & 31); }), one};
        } else {
            const auto mix = [&](int n) __attribute__((always_inline)) {
                return weights.bytes(L::byte(c00, n), L::byte(c10, n), L::byte(c01, n), L::byte(c11, n),
                                     right);
            };
            return {mix(0), mix(1), mix(2), Alpha ? mix(3) : one};
        }
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
