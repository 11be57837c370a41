// Antialiasing (GL 1.3, 3.11) multiplies alpha by coverage. This file holds the stage of polygon stippling
// (3.5.2), too.
#pragma once

#include <bit>
#include <type_traits>

#include "raster/ops/stage.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

template <class N> struct Coverage : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned in = field_color, out = field_color;
    const std::uint32_t* at; ///< coverage of this pixel; null where every pixel is covered fully
    SPANGLE_INLINE Coverage(const Span<typename N::Policy>& s, std::int32_t x)
        : at(s.state->primitive->coverage) {
        if (at != nullptr)
            at += x - s.begin;
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        if (at != nullptr)
            p.color.a = scaled(p.color.a, *at);
        return true;
    }
    SPANGLE_INLINE void step() {
        if (at != nullptr)
            ++at;
    }

  private:
    SPANGLE_INLINE static typename N::T scaled(typename N::T alpha, std::uint32_t coverage) {
        if constexpr (std::is_floating_point_v<typename N::T>)
            return alpha * coverage / full_coverage;
        else
            return static_cast<typename N::T>((numeric::mul_u32(alpha, coverage) + full_coverage / 2) >>
                                              coverage_bits);
    }
};

/// Keeps a fragment at window position (x, y) where bit x mod 32 of row y mod 32 of the stipple is set.
template <class N> struct PolygonStipple : StageBase {
    static_assert(N::lanes == 1);
    static constexpr bool kill = true;
    std::uint32_t pattern; ///< the bits of this row, rotated so that bit 0 decides this column
    SPANGLE_INLINE PolygonStipple(const Span<typename N::Policy>& s, std::int32_t x)
        : pattern(s.state->primitive->stippled
                      ? std::rotr(s.state->fragment.polygon_stipple[s.y & 31], (s.x + x) & 31)
                      : ~0u) {}
    SPANGLE_INLINE bool operator()(Px<N>&) const { return (pattern & 1) != 0; }
    SPANGLE_INLINE void step() { pattern = std::rotr(pattern, 1); }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
