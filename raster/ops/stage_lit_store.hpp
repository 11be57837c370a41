// Lit textures of the exact tier on processors without long products. Divided attributes are exact. MODULATE
// and fog are guessed by products of half-words. The guess counts where it decides the stored bits. All other
// fragments, about one in eighty, are done again. Only fused spans of one lane use this file.
#pragma once

#include "raster/ops/stage_fogged.hpp"
#include "raster/ops/stage_lit.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Number system whose components and fog are those of Exact. MODULATE is left to the store, so a colour
/// carries its texel.
struct ExactLit {
    using Policy = Fixed;
    static constexpr int lanes = 1;
    using L = Lanes<1>;
    using T = std::uint32_t;
    struct Color {
        T r, g, b, a;
        std::uint32_t texel = 0;
    };
    using Coord = TexCoords<std::uint32_t, 1>;
    using Fog = std::uint32_t;
    SPANGLE_INLINE static T from_units(std::uint32_t c) { return c; }
    SPANGLE_INLINE static T from_affine(std::uint32_t v) { return Exact::from_affine(v); }
};

namespace inner {

/// Tables of F, where F / 2^16 stands for k / Most and F is at most 1 too small (LitGuess).
template <std::uint32_t Most> struct LitFactors {
    std::uint16_t of[Most + 1];
    constexpr LitFactors() : of{} {
        for (std::uint32_t k = 1; k <= Most; ++k)
            // The component 1 (k = Most) has the factor 65535.
            of[k] = static_cast<std::uint16_t>((k * 65536 - 1) / Most);
    }
};
template <std::uint32_t Most> inline constexpr LitFactors<Most> lit_factors;

} // namespace inner

/// Factors of 16 bits for texels, for products of half-words.
struct HalfFactors {
    SPANGLE_INLINE static std::uint32_t factor5(std::uint32_t k) { return inner::lit_factors<31>.of[k]; }
    SPANGLE_INLINE static std::uint32_t factor6(std::uint32_t k) { return inner::lit_factors<63>.of[k]; }
    SPANGLE_INLINE static std::uint32_t factor8(std::uint32_t k) { return inner::lit_factors<255>.of[k]; }
};

/// Makes the stored word of a lit fragment and its texel. The texel is a word R5 G6 B5, or bytes.
template <PixelFormat Format, bool Is565, bool HasFog, bool Dither> class LitStore : public StageBase {
  public:
    using N = ExactLit;
    static constexpr unsigned in = field_color | (HasFog ? field_fog : 0u);
    static constexpr bool effect = true;

    SPANGLE_INLINE LitStore(const Span<Fixed>& s, std::int32_t x)
        : fog_color_(s.state->fragment.fog_color), thresholds_(s.x + x, s.y) {
        for (int i = 0; i < 3; ++i)
            fog_[i] = HasFog ? rounded(fog_color_[i]) : 0;
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        Words565<N::L, Format>::store(p.color_plane + p.bytes(), word(p.color, p.fog));
        return true;
    }
    SPANGLE_INLINE void step() { thresholds_.step(); }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        thresholds_ = Thresholds(s.x + x, s.y);
    }
    /// The stored word of a fragment. `fog` is the fog coordinate as FogLinear takes it.
    SPANGLE_INLINE std::uint32_t word(const N::Color& c, std::uint32_t fog) const {
        const std::uint32_t f = HasFog ? N::L::clamped_24_to_16(fog) : 0, t = c.texel;
        const std::uint32_t r = least<5>(lit(c.r, Scales::red(t), f, 0)),
                            g = least<6>(lit(c.g, Scales::green(t), f, 1)),
                            b = least<5>(lit(c.b, Scales::blue(t), f, 2));
        constexpr std::uint32_t five = 0xF8u << (top - 8), six = 0xFCu << (top - 8);
        if (((((r + range) ^ r) | ((b + range) ^ b)) & five) != 0 || (((g + range) ^ g) & six) != 0)
            [[unlikely]] // a copy is passed: the address of p.color would force p into memory
            return done_again(N::Color(c), fog, fog_color_, thresholds_.threshold());
        return (r >> (top - 16) & 0xF800) | (g >> (top - 11) & 0x07E0) | b >> (top - 5);
    }
    /// The stored word, made by the arithmetic of the chain.
    [[gnu::noinline]] static std::uint32_t done_again(const N::Color& lit, std::uint32_t fog,
                                                      const std::uint32_t* fog_color,
                                                      std::uint32_t threshold) {
        Exact::Color c = {lit.r, lit.g, lit.b, color_one};
        apply_env<Exact>(TexEnv::modulate, BaseFormat::rgb, c,
                         TexelColors<Exact, Is565, false>::unpack(lit.texel), Exact::Color{});
        if constexpr (HasFog) {
            const Exact::T f = Exact::clamped_fraction(fog);
            c = {Exact::mix(fog_color[0], c.r, f), Exact::mix(fog_color[1], c.g, f),
                 Exact::mix(fog_color[2], c.b, f), c.a};
        }
        return Dither ? dithered565<Exact>(c, threshold) : truncated565<Exact>(c);
    }

  private:
    using Scales = TexelScales<HalfFactors, Is565>;
    using Thresholds = std::conditional_t<Dither, inner::DitherRow<N::L>, inner::NoThreshold>;
    static constexpr int top = Dither ? 32 : 16; ///< components end below this bit
    /// With dithering the range is one more, because steps keep the bits below a 256th of a 255th.
    static constexpr std::uint32_t under = LitGuess<HasFog>::under << (top - 16),
                                   range = under + ((LitGuess<HasFog>::over + Dither) << (top - 16));

    SPANGLE_INLINE static std::uint32_t rounded(std::uint32_t c) { return (c + (1u << 11)) >> 12; }
    SPANGLE_INLINE std::uint32_t lit(std::uint32_t c, std::uint32_t factor, std::uint32_t f, int i) const {
        const std::uint32_t v = rounded(c) * factor >> 16;
        return HasFog ? (fog_[i] * (65535 - f) >> 16) + (v * f >> 16) : v;
    }
    /// The least that a component may be. It is in 255ths with half of one added, or in steps with the
    /// threshold added.
    template <unsigned Bits> SPANGLE_INLINE std::uint32_t least(std::uint32_t v) const {
        if constexpr (Dither)
            return v * Balanced<1>::step_scale(Bits) + (thresholds_.threshold() << (27 - Bits)) - under;
        else
            return v + 128 - under;
    }

    const std::uint32_t* fog_color_;
    std::uint32_t fog_[3];
    [[no_unique_address]] Thresholds thresholds_;
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
