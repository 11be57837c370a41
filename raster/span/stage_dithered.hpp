// Smooth colours of which nothing but five and six dithered bits is stored.
#pragma once

#include "raster/span/stage_color.hpp"
#include "raster/span/stage_thresholds.hpp"

namespace spangle::raster {

/// Smooth colours as the bits that are stored of them. Dither: counted in steps by set-up (Variant::steps),
/// so that floor(step + t) is one sum.
template <int Count, bool Dither> struct GouraudTops : Gouraud<Raw565<Count>, false> {
    using N = Raw565<Count>;
    using Base = Gouraud<N, false>;
    using Place = std::conditional_t<Dither, detail::DitherPlace<typename N::L>, detail::NoThreshold>;
    [[no_unique_address]] Place dither;

    template <class S>
    SPANGLE_INLINE GouraudTops(const S& s, std::int32_t x) : Base(s, x), dither(s.x + x, s.y) {}
    SPANGLE_INLINE typename N::Tops tops() const {
        if constexpr (Dither && Count == 1) // sums before a test of depth, and its code, take registers
            numeric::begin_here();
        const typename N::Tops v = N::tops(this->r.at, this->g.at, this->b.at);
        if constexpr (Dither)
            return N::dithered(v, dither.threshold());
        else
            return v;
    }
    SPANGLE_INLINE void step() {
        Base::step();
        dither.step();
    }
    SPANGLE_INLINE void next_row() {
        Base::next_row();
        dither.next_row();
    }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        Base::start(s, x);
        dither = Place(s.x + x, s.y);
    }
};

template <int Count> struct GouraudDithered : GouraudTops<Count, true> {
    using N = Raw565<Count>;
    template <class S>
    SPANGLE_INLINE GouraudDithered(const S& s, std::int32_t x) : GouraudTops<Count, true>(s, x) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color = N::joined(this->tops());
        return true;
    }
};

/// Rows of eight lanes at a time: two periods of the pattern, so that the thresholds are part of the ramps
/// from where these start.
struct GouraudDitheredRow : Gouraud<Raw565<8>, false> {
    using N = Raw565<8>;
    using Base = Gouraud<N, false>;

    template <class S> SPANGLE_INLINE GouraudDitheredRow(const S& s, std::int32_t x) : Base(s, x) {
        add(s, x);
    }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        Base::start(s, x);
        add(s, x);
    }

  private:
    template <class S> SPANGLE_INLINE void add(const S& s, std::int32_t x) {
        const N::L::U32 t = N::L::widened(detail::DitherRow<N::L>(s.x + x, s.y).threshold());
        r.at += t << 22;
        g.at += t << 21;
        b.at += t << 22;
    }
};

} // namespace spangle::raster
