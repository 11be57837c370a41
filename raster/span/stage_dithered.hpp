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
        p.color = N::dithered(this->r.at, this->g.at, this->b.at, dither.threshold());
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

} // namespace spangle::raster
