// Smooth colours of which nothing but five and six dithered bits is stored.
#pragma once

#include "raster/span/stage_color.hpp"
#include "raster/span/stage_thresholds.hpp"

namespace spangle::raster {

/// Colours that set-up has counted in steps (Variant::steps): floor(step + t) is one sum.
template <int Count> struct GouraudDithered : Gouraud<Raw565<Count>, false> {
    using N = Raw565<Count>;
    using Base = Gouraud<N, false>;
    detail::DitherPlace<typename N::L> dither;

    template <class S>
    SPANGLE_INLINE GouraudDithered(const S& s, std::int32_t x) : Base(s, x), dither(s.x + x, s.y) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color = N::word(N::dithered(N::tops(this->r.at, this->g.at, this->b.at), dither.threshold()));
        return true;
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
        dither = detail::DitherPlace<typename N::L>(s.x + x, s.y);
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
