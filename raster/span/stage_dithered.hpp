// Smooth colours of the exact tier of which nothing but five and six dithered bits is stored.
#pragma once

#include "raster/span/stage_color.hpp"
#include "raster/span/stage_store.hpp"

namespace spangle::raster {

namespace detail {

/// Exact::dithered<Bits>(Exact::from_affine(at), t) of four fragments: floor(c M / 255 + t / 32), M = 2^Bits
/// - 1, of a component c with 20 fraction bits is floor(n / 255) with n = floor((c M + 255 t 2^15) / 2^20).
/// Set-up is off by less than 2^-18 of 255, 2^10 in c; t is 1 at least and 31 at most, so that 2^16 less than
/// 0 or more than 255 give the same step: nothing is clamped.
struct DitheredLanes {
    using Words = Lanes<8>::Words;

    Words threshold; ///< 255 t 2^13
    DitheredLanes() = default;
    /// t in the low halves.
    SPANGLE_INLINE explicit DitheredLanes(Words t) : threshold(((t << 8) - t) << 13) {}

    template <unsigned Bits> SPANGLE_INLINE Words step(Words at) const {
        // 32 bits hold c M without its last bit or two, which count 15 or 15.75 each.
        constexpr int less = Bits - 4;
        const Words whole = at >> (4 + less), rest = at & (Bits == 5 ? 0x10u : 0x30u);
        const Words of_rest = Bits == 5 ? rest - (rest >> 4) : rest - ((rest + 48) >> 6);
        // The bias of set-up, 2^11 in c, goes; with n + 1 in place of n the quotient is two shifts.
        constexpr std::uint32_t constant = (1u << (20 - less)) - (2048u >> less) * ((1u << Bits) - 1);
        const Words sum =
            (whole << Bits) - whole + of_rest + ((threshold << (2 - less)) + constant); // below 2^32
        return ((sum >> (20 - less)) + (sum >> (28 - less))) >> 8;
    }

    /// R5 G6 B5 in the low halves.
    SPANGLE_INLINE Words word(Words r, Words g, Words b) const {
        return (step<5>(r) << 11) | (step<6>(g) << 5) | step<5>(b);
    }
};

} // namespace detail

template <int Count> struct GouraudDithered;

template <> struct GouraudDithered<1> : Gouraud<Raw565<1>, false> {
    using N = Raw565<1>;
    detail::DitherRow<Lanes<1>> dither;

    template <class S>
    SPANGLE_INLINE GouraudDithered(const S& s, std::int32_t x)
        : Gouraud<N, false>(s, x), dither(s.x + x, s.y) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        const std::uint32_t t = dither.threshold();
        const auto step = [t]<unsigned Bits>(std::uint32_t at, std::integral_constant<unsigned, Bits>) {
            return Exact::dithered<Bits>(Exact::from_affine(at), t);
        };
        constexpr std::integral_constant<unsigned, 5> five;
        constexpr std::integral_constant<unsigned, 6> six;
        p.color.word = pack565<N>(step(r.at, five), step(g.at, six), step(b.at, five));
        return true;
    }
    SPANGLE_INLINE void step() {
        Gouraud<N, false>::step();
        dither.step();
    }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        Gouraud<N, false>::start(s, x);
        dither = detail::DitherRow<Lanes<1>>(s.x + x, s.y);
    }
};

/// Eight columns are two periods: thresholds stay along the row.
template <> struct GouraudDithered<8> : Gouraud<Raw565<8>, false> {
    using N = Raw565<8>;
    detail::DitheredLanes even, odd;

    template <class S> SPANGLE_INLINE GouraudDithered(const S& s, std::int32_t x) : Gouraud<N, false>(s, x) {
        thresholds(s, x);
    }
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.word = N::L::low_half(
            {even.word(r.at.even, g.at.even, b.at.even), odd.word(r.at.odd, g.at.odd, b.at.odd)});
        return true;
    }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        Gouraud<N, false>::start(s, x);
        thresholds(s, x);
    }

  private:
    template <class S> SPANGLE_INLINE void thresholds(const S& s, std::int32_t x) {
        using Words = detail::DitheredLanes::Words;
        const std::uint32_t row = std::rotr(dither_row(s.y), 8 * ((s.x + x) & 3));
        const auto of = [row](int column) { return (row >> (8 * column)) & 0xFF; };
        even = detail::DitheredLanes(Words{of(0), of(2), of(0), of(2)});
        odd = detail::DitheredLanes(Words{of(1), of(3), of(1), of(3)});
    }
};

} // namespace spangle::raster
