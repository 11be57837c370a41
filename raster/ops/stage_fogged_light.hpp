// MODULATE, the fog's share and the store of the balanced tier, as one stage. It makes the bytes of these
// three stages, whose products are each rounded down. Only fused spans of one lane use this file.
#pragma once

#include "raster/ops/stage_fog.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/ops/texel_color.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The balanced number system with colours that carry a texel along: MODULATE only puts it there, and the
/// store multiplies with it.
struct BalancedLit : Balanced<1> {
    struct Color {
        T r, g, b, a;
        std::uint32_t texel = 0;
    };
};

/// Makes the stored word of light that fog has dimmed, of a texel and of the fog factor. Dithered components
/// are counted in steps (counts_steps()). Low: sums are made in the low half of a word instead of the high
/// half, with the same stored bits.
template <PixelFormat Format, bool Is565, bool Dither,
          bool Low = Dither && (numeric::adds_products || !numeric::long_products)>
class FoggedTexel {
    /// What the factors of a texel count: 0 for 255ths, 1 for steps of 15 bits, 2 for such steps that end one
    /// bit higher, in a high half-word.
    static constexpr int steps = !Dither ? 0 : Low ? 1 : 2;

  public:
    using N = BalancedLit;
    template <class S>
    SPANGLE_INLINE explicit FoggedTexel(const S& s) : FoggedTexel(FogShare<Balanced<1>, Dither>(s, 0)) {}
    /// Tables of the factors by which a texel R5 G6 B5 multiplies green (`sixths`), and red and blue
    /// (`fifths`).
    using Factors = const std::uint16_t*;
    static constexpr Factors sixths = texel_factors<Balanced<1>, steps>.of6,
                             fifths = texel_factors<Balanced<1>, steps>.of5;
    static constexpr int threshold_bits = Low ? 10 : 27; ///< log2 of one step of a component of five bits
    /// The fog's shares of the components, with thresholds added.
    struct Shares {
        std::uint32_t g, r, b;
    };
    SPANGLE_INLINE Shares shares(std::uint32_t f, std::uint32_t threshold) const {
        const std::uint32_t factor = Share::of(f);
        return {g_.of_fog(factor, threshold >> 1), r_.of_fog(factor, threshold),
                b_.of_fog(factor, threshold)};
    }
    /// The stored word, made of light and the fog factor. Only its low 16 bits are to be stored.
    SPANGLE_INLINE std::uint32_t word(const N::Color& light, std::uint32_t f, Factors of6,
                                      Factors of5) const {
        std::uint32_t texel = light.texel;
        const std::uint32_t by = Is565 ? of6[texel >> 5 & 63] : Scales::green(texel);
        std::uint32_t g = Share::sum(g_.of_fog(f, 0), light.g, by);
        texel = numeric::evaluate_after(texel, g);
        f = numeric::evaluate_after(f, g);
        std::uint32_t r = Share::sum(r_.of_fog(f, 0), light.r, Is565 ? of5[texel >> 11] : Scales::red(texel));
        texel = numeric::evaluate_after(texel, r);
        f = numeric::evaluate_after(f, r);
        std::uint32_t b = Share::sum(b_.of_fog(f, 0), light.b, Is565 ? of5[texel & 31] : Scales::blue(texel));
        return joined_high(r, g, b);
    }
    /// The dithered word, made of light and of the fog's shares. Only its low 16 bits are to be stored.
    SPANGLE_INLINE static std::uint32_t word(const N::Color& light, const Shares& shares, Factors of6,
                                             Factors of5) {
        std::uint32_t texel = light.texel;
        std::uint32_t g = Share::sum(shares.g, light.g, Is565 ? of6[texel >> 5 & 63] : Scales::green(texel));
        texel = numeric::evaluate_after(texel, g);
        std::uint32_t r = Share::sum(shares.r, light.r, Is565 ? of5[texel >> 11] : Scales::red(texel));
        texel = numeric::evaluate_after(texel, r);
        std::uint32_t b = Share::sum(shares.b, light.b, Is565 ? of5[texel & 31] : Scales::blue(texel));
        return Low ? joined_low(r, g, b) : joined_high(r, g, b);
    }

  private:
    using Words = Words565<N::L, Format>;
    using Scales = ChainScales<Balanced<1>, Is565, steps>;
    SPANGLE_INLINE explicit FoggedTexel(const FogShare<Balanced<1>, Dither>& fog)
        : g_(fog.g), r_(fog.r), b_(fog.b) {}

    SPANGLE_INLINE static std::uint32_t joined_high(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
        // The word is made in the high half, which a swap of bytes moves to the low half.
        if constexpr (numeric::inserts_bits) {
            const std::uint32_t high = numeric::with_bits<16, 5>((r & 0xF8000000) | g >> 5, b >> 27);
            return Words::swaps ? __builtin_bswap32(high) : high >> 16;
        }
        const std::uint32_t word = ((r >> 27) << 6 | g >> 26) << 5 | b >> 27;
        return Words::swaps ? N::L::swap_bytes(word) : word;
    }
    SPANGLE_INLINE static std::uint32_t joined_low(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
        if constexpr (numeric::inserts_bits) { // joined_high() does the same with words in the upper half
            const std::uint32_t high = numeric::with_bits<16, 5>((r << 17 & 0xF8000000) | g << 12, b >> 10);
            return Words::swaps ? __builtin_bswap32(high) : high >> 16;
        }
        const std::uint32_t word = ((r >> 10) << 6 | g >> 9) << 5 | b >> 10;
        return Words::swaps ? N::L::swap_bytes(word) : word;
    }

    /// The fog's share in the high half-word: 65535 - f times the fog's colour. It includes the half that
    /// rounds the sum to 255ths.
    class HighShare {
      public:
        SPANGLE_INLINE explicit HighShare(std::uint32_t color) : HighShare(color << (lowest - 16), 0) {}
        SPANGLE_INLINE static std::uint32_t of(std::uint32_t f) { return f; }
        /// The share at fog factor f. Bits below those of the sum are cleared, so that both products are
        /// rounded down and none carries into the sum.
        SPANGLE_INLINE std::uint32_t of_fog(std::uint32_t f, [[maybe_unused]] std::uint32_t threshold) const {
            const auto [color, whole] = numeric::load_two(color_integer_);
            const std::uint32_t share = numeric::without_low<lowest>(whole - color * f);
            return Dither ? share + threshold : share;
        }
        SPANGLE_INLINE static std::uint32_t sum(std::uint32_t share, std::uint32_t light, std::uint32_t by) {
            return light * by + share;
        }

      private:
        static constexpr int lowest = Dither ? 17 : 16;
        SPANGLE_INLINE HighShare(std::uint32_t color, int)
            : color_integer_{color, numeric::factor32(color * 0xFFFF + (Dither ? 0 : 128u << 16))} {}
        /// The fog's colour, and its share where f is 0.
        numeric::WordPair<std::uint32_t, std::uint32_t> color_integer_;
    };
    /// The fog's share where products end in the low half-word.
    class LowShare {
      public:
        SPANGLE_INLINE explicit LowShare(std::uint32_t color) : color_(color) {}
        SPANGLE_INLINE static std::uint32_t of(std::uint32_t f) { return ~f & 0xFFFF; }
        SPANGLE_INLINE std::uint32_t of_fog(std::uint32_t rest, std::uint32_t threshold) const {
            return numeric::add_product(threshold, rest, color_);
        }
        SPANGLE_INLINE static std::uint32_t sum(std::uint32_t share, std::uint32_t light, std::uint32_t by) {
            return numeric::add_product(share, light, by);
        }

      private:
        std::uint32_t color_;
    };
    using Share = std::conditional_t<Low, LowShare, HighShare>;

    Share g_, r_, b_; ///< shares of the components, in the order in which word() reads them
};

/// Stores fragments whose light FogLight has dimmed.
template <PixelFormat Format, bool Is565, bool Dither> class FoggedLightStore : public StageBase {
  public:
    using N = BalancedLit;
    static constexpr unsigned in = field_color | field_fog;
    static constexpr bool effect = true;

    template <class S>
    SPANGLE_INLINE FoggedLightStore(const S& s, std::int32_t)
        : texel_(s), thresholds_(s.dither_column, s.y) {}
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t) {
        thresholds_ = Thresholds(s.dither_column, s.y);
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const std::uint32_t f = N::clamped_fraction(p.fog);
        std::uint32_t word;
        if constexpr (Dither)
            word = texel_.word(p.color, texel_.shares(f, thresholds_.threshold(p.bytes() >> 1)),
                               texel_.sixths, texel_.fifths);
        else
            word = texel_.word(p.color, f, texel_.sixths, texel_.fifths);
        N::L::store(p.color_plane + p.bytes(), word);
        return true;
    }

  private:
    using Texel = FoggedTexel<Format, Is565, Dither>;
    using Thresholds =
        std::conditional_t<Dither, inner::NumberedThresholds<Texel::threshold_bits>, inner::NoThreshold>;
    Texel texel_;
    /// The thresholds, from the fragment on from which the list counts.
    [[no_unique_address]] Thresholds thresholds_;
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
