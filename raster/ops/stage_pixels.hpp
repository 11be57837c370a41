// Colours that come with the fragments, as the pixels of a pixel rectangle do (GL 1.3, 3.6.4).
#pragma once

#include "raster/ops/stage.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Reads four components in colour units for each pixel of the span.
template <class N> struct PixelColor : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned out = field_color;
    const std::uint32_t* at;
    SPANGLE_INLINE PixelColor(const Span<typename N::Policy>& s, std::int32_t x)
        : at(static_cast<const std::uint32_t*>(s.pixels) + 4 * std::ptrdiff_t{x}) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color = {N::from_units(at[0]), N::from_units(at[1]), N::from_units(at[2]), N::from_units(at[3])};
        return true;
    }
    SPANGLE_INLINE void step() { at += 4; }
};

/// Reads the R5 G6 B5 words that are to be stored. The caller's buffer has room for a whole group of lanes
/// behind the last word.
template <int Count> struct PixelWord : StageBase {
    static constexpr unsigned out = field_color;
    using N = Raw565<Count>;
    const std::uint8_t* at;
    SPANGLE_INLINE PixelWord(const Span<Fixed>& s, std::int32_t x)
        : at(static_cast<const std::uint8_t*>(s.pixels) + 2 * std::ptrdiff_t{x}) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = N::L::load(at);
        return true;
    }
    SPANGLE_INLINE void step() { at += 2 * Count; }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
