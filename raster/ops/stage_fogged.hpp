// Fog and the store after it, as one stage of the exact tier. It makes the bytes of FogLinear followed by
// Store, which round once each. Only fused spans of one lane use it.
#pragma once

#include "raster/ops/stage_fog.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Blends with the fog's colour and stores. The kept fog colour includes half a 255th for rounding, unless
/// colours are dithered. The difference of the colours is multiplied by 4, because the fog factor has 30
/// fraction bits and the product keeps its high 32 bits.
template <PixelFormat Format, bool Dither> struct FoggedStore : StageBase {
    using N = Exact;
    static constexpr unsigned in = field_color | field_fog;
    static constexpr bool effect = true;
    struct Fog {
        std::uint32_t half_more, four;
        SPANGLE_INLINE explicit Fog(std::uint32_t units)
            : half_more(numeric::factor32(units + (Dither ? 0 : 1u << (color_fraction_bits - 1)))),
              four(numeric::factor32(units << 2)) {}
    };
    Fog r, g, b;
    using Thresholds = std::conditional_t<Dither, inner::DitherRow<Lanes<1>>, inner::NoThreshold>;
    [[no_unique_address]] Thresholds dither;

    SPANGLE_INLINE FoggedStore(const Span<Fixed>& s, std::int32_t x)
        : r(s.state->fragment.fog_color[0]), g(s.state->fragment.fog_color[1]),
          b(s.state->fragment.fog_color[2]), dither(s.x + x, s.y) {}
    SPANGLE_INLINE void start(const Span<Fixed>& s, std::int32_t x) { dither = Thresholds(s.x + x, s.y); }
    SPANGLE_INLINE void step() { dither.step(); }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const auto f = static_cast<std::int32_t>(N::clamped_fraction(p.fog));
        const auto rounded = [&](const Fog& fog, std::uint32_t color) {
            const auto difference = static_cast<std::int32_t>((color << 2) - fog.four);
            return fog.half_more + static_cast<std::uint32_t>(numeric::mul_high_s32(difference, f));
        };
        const N::Color c = {rounded(r, p.color.r), rounded(g, p.color.g), rounded(b, p.color.b), color_one};
        std::uint8_t* const at = p.color_plane + p.bytes();
        if constexpr (Dither)
            Words565<N::L, Format>::store(at, dithered565<N>(c, dither.threshold()));
        else
            Words565<N::L, Format>::store(at, (c.r >> (color_fraction_bits - 8) & 0xF800) |
                                                  (c.g >> (color_fraction_bits - 3) & 0x07E0) |
                                                  c.b >> (color_fraction_bits + 3));
        return true;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
