// Stages of index surfaces (GL 1.3, 3.10, 3.11, 4.1.8, 4.1.9). The index takes the place of the red
// component. One step of the index is counted as one 255th. So interpolation, packets and read-back of
// colours serve indices, too.
#pragma once

#include "raster/ops/stage_fog.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The index nearest to v, limited to the largest index.
template <class N> SPANGLE_INLINE std::uint32_t nearest_index(typename N::T v) {
    return N::to8(v < N::one ? v : N::one);
}

/// Fog of an index: I = i_r + (1 - f) i_f, of which the bits above the largest index are masked off (GL 1.3,
/// 3.10).
template <class N> struct FogIndex : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned in = field_color | field_fog, out = field_color;
    FogMode mode;
    std::uint32_t index;
    FogIndex(const Span<typename N::Policy>& s, std::int32_t)
        : mode(s.state->fragment.fog_mode), index(s.state->fragment.fog_color[0]) {}
    bool operator()(Px<N>& p) const {
        constexpr std::uint32_t range = 256u << color_fraction_bits;
        const typename N::T part = N::mix(index, 0, N::clamped_fraction(fog_factor(mode, p.fog)));
        p.color.r = (p.color.r + part) & (range - 1);
        return true;
    }
};

/// Antialiasing of an index: its low four bits become the coverage, from 0 for none to 15 for all (GL 1.3,
/// 3.2). The index is rounded first, because a fraction would carry into these bits.
template <class N> struct IndexCoverage : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned in = field_color, out = field_color;
    static constexpr std::uint32_t bits = 15;
    bool antialiased;
    const std::uint32_t* at; ///< coverage of this pixel; null where every pixel is covered fully
    IndexCoverage(const Span<typename N::Policy>& s, std::int32_t x)
        : antialiased(s.state->primitive->antialiased), at(s.state->primitive->coverage) {
        if (at != nullptr)
            at += x - s.begin;
    }
    bool operator()(Px<N>& p) const {
        if (!antialiased)
            return true;
        const std::uint32_t covered =
            at == nullptr ? bits
                          : static_cast<std::uint32_t>((numeric::mul_u32(*at, bits) + full_coverage / 2) >>
                                                       coverage_bits);
        p.color.r = N::from8((nearest_index<N>(p.color.r) & ~bits) | covered);
        return true;
    }
    void step() {
        if (at != nullptr)
            ++at;
    }
};

/// Stores an index, dithered, combined and masked as the state says.
template <class N> struct StoreIndex : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned in = field_color;
    static constexpr bool effect = true;
    inner::DitherRow<typename N::L> dither;
    bool dithers;
    std::uint32_t mask;
    LogicTable logic;
    StoreIndex(const Span<typename N::Policy>& s, std::int32_t x)
        : dither(s.x + x, s.y), dithers(s.state->fragment.dither), mask(s.state->fragment.color_mask),
          logic(s.state->fragment) {}
    bool operator()(Px<N>& p) const {
        std::uint8_t& at = p.color_plane[p.i];
        const typename N::T v = p.color.r < N::one ? p.color.r : N::one;
        const std::uint32_t index =
            dithers ? N::template dithered<8>(v, dither.threshold()) : nearest_index<N>(v);
        at = static_cast<std::uint8_t>(logic.merged(index, at, mask));
        return true;
    }
    void step() { dither.step(); }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
