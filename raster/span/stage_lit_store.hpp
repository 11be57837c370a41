// Lit textures of the exact tier where there are no long products: what is divided is exact, and what
// MODULATE and fog make of it is guessed by products of halves, as far as these decide the bits that are
// stored. The others, one in eighty, are done again. Fused spans of one lane only.
#pragma once

#include "raster/span/stage_fogged.hpp"
#include "raster/span/stage_lit.hpp"

namespace spangle::raster {

/// Components and fog are Exact's; MODULATE waits for the store, with its texel.
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

namespace detail {

/// k / Most as F / 2^16, at most 1 too small (LitGuess).
template <std::uint32_t Most> struct LitFactors {
    std::uint16_t of[Most + 1];
    constexpr LitFactors() : of{} {
        for (std::uint32_t k = 1; k <= Most; ++k)
            of[k] = static_cast<std::uint16_t>((k * 65536 - 1) / Most); // 65535 for 1
    }
};
template <std::uint32_t Most> inline constexpr LitFactors<Most> lit_factors;

} // namespace detail

/// Factors of 16 bits, for products of halves.
struct HalfFactors {
    SPANGLE_INLINE static std::uint32_t factor5(std::uint32_t k) { return detail::lit_factors<31>.of[k]; }
    SPANGLE_INLINE static std::uint32_t factor6(std::uint32_t k) { return detail::lit_factors<63>.of[k]; }
    SPANGLE_INLINE static std::uint32_t factor8(std::uint32_t k) { return detail::lit_factors<255>.of[k]; }
};

/// What LitFragments makes of a fragment and its texel, a word 565 or bytes.
template <PixelFormat Format, bool Is565, bool HasFog> class LitStore : public StageBase {
  public:
    using N = ExactLit;
    static constexpr unsigned in = field_color | (HasFog ? field_fog : 0u);
    static constexpr bool effect = true;

    SPANGLE_INLINE LitStore(const Span<Fixed>& s, std::int32_t) : fog_color_(s.state->fragment.fog_color) {
        for (int i = 0; i < 3; ++i)
            fog_[i] = HasFog ? rounded(fog_color_[i]) : 0;
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        Words565<N::L, Format>::store(p.color_plane + p.bytes(), word(p.color, p.fog));
        return true;
    }
    /// fog: as FogLinear has it.
    SPANGLE_INLINE std::uint32_t word(const N::Color& c, std::uint32_t fog) const {
        const std::uint32_t f = HasFog ? N::L::clamped_24_to_16(fog) : 0, t = c.texel;
        const std::uint32_t r = lit(c.r, Scales::red(t), f, 0), g = lit(c.g, Scales::green(t), f, 1),
                            b = lit(c.b, Scales::blue(t), f, 2);
        if (((((r + range) ^ r) | ((b + range) ^ b)) & 0xF800) != 0 || (((g + range) ^ g) & 0xFC00) != 0)
            [[unlikely]]
            return done_again(N::Color(c), fog, fog_color_); // a copy, or p would have an address
        return (r & 0xF800) | (g >> 5 & 0x07E0) | b >> 11;
    }
    /// What the chain does.
    [[gnu::noinline]] static std::uint32_t done_again(const N::Color& lit, std::uint32_t fog,
                                                      const std::uint32_t* fog_color) {
        Exact::Color c = {lit.r, lit.g, lit.b, color_one};
        apply_env<Exact>(TexEnv::modulate, BaseFormat::rgb, c,
                         TexelColors<Exact, Is565, false>::unpack(lit.texel), Exact::Color{});
        if constexpr (HasFog) {
            const Exact::T f = Exact::clamped_fraction(fog);
            c = {Exact::mix(fog_color[0], c.r, f), Exact::mix(fog_color[1], c.g, f),
                 Exact::mix(fog_color[2], c.b, f), c.a};
        }
        return truncated565<Exact>(c);
    }

  private:
    using Scales = TexelScales<HalfFactors, Is565>;
    static constexpr std::uint32_t under = LitGuess<HasFog>::under, range = under + LitGuess<HasFog>::over;

    SPANGLE_INLINE static std::uint32_t rounded(std::uint32_t c) { return (c + (1u << 11)) >> 12; }
    /// The least that the component, rounded to 255ths, may be.
    SPANGLE_INLINE std::uint32_t lit(std::uint32_t c, std::uint32_t factor, std::uint32_t f, int i) const {
        const std::uint32_t v = rounded(c) * factor >> 16;
        return (HasFog ? (fog_[i] * (65535 - f) >> 16) + (v * f >> 16) : v) + 128 - under;
    }

    const std::uint32_t* fog_color_;
    std::uint32_t fog_[3];
};

} // namespace spangle::raster
