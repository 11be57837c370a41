// Smooth colours that are dithered and stored as five and six bits.
#pragma once

#include "raster/ops/stage_color.hpp"
#include "raster/ops/stage_thresholds.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/rows.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The thresholds of fragments in the form of Raw565::fraction5(), stepped along the row.
template <class N> struct WalkedFractions : inner::DitherPlace<typename N::L> {
    template <class S>
    SPANGLE_INLINE WalkedFractions(const S& s, std::int32_t x)
        : inner::DitherPlace<typename N::L>(s.x + x, s.y) {}
    SPANGLE_INLINE typename N::T of(const Px<N>&) const { return N::fraction5(this->threshold()); }
};
/// The thresholds of WalkedFractions, looked up by the number of the fragment. Processors that cannot use
/// masks as operands, and need a register to rotate by, are faster with it.
template <class N> class NumberedFractions {
  public:
    SPANGLE_INLINE NumberedFractions(const PlaneRow& row, std::int32_t)
        : from_(numeric::factor32(inner::dither_numbered<27>.from(row.dither_column, row.y))) {}
    SPANGLE_INLINE std::uint32_t of(const Px<N>& p) const {
        std::uint32_t t;
        const std::uint32_t bytes = numeric::factor32(static_cast<std::uint32_t>(p.twice) << 29) >> 28;
        __builtin_memcpy(
            &t, __builtin_assume_aligned(reinterpret_cast<const unsigned char*>(from_) + bytes, sizeof t),
            sizeof t);
        return t;
    }
    SPANGLE_INLINE void step() {}

  private:
    const std::uint32_t* from_;
};
/// Takes the place of thresholds where nothing is dithered.
template <class N> struct NoFractions {
    template <class S> SPANGLE_INLINE NoFractions(const S&, std::int32_t) {}
    SPANGLE_INLINE void step() {}
    SPANGLE_INLINE void next_row() {}
};

/// The thresholds of a list over rows. Each row of the window has its own thresholds.
template <int Count>
using RowFractions = std::conditional_t<Count == 1 && !numeric::three_operands,
                                        NumberedFractions<Raw565<Count>>, WalkedFractions<Raw565<Count>>>;

/// Smooth colours as the bits that are stored. Set-up counts dithered colours in steps (Variant::steps), so
/// floor(step + threshold) takes one addition.
template <int Count, class Fractions> struct GouraudTops : Gouraud<Raw565<Count>, false> {
    using N = Raw565<Count>;
    using Base = Gouraud<N, false>;
    static constexpr bool dithers = !std::is_same_v<Fractions, NoFractions<N>>;
    [[no_unique_address]] Fractions fractions;

    template <class S> SPANGLE_INLINE GouraudTops(const S& s, std::int32_t x) : Base(s, x), fractions(s, x) {}
    SPANGLE_INLINE typename N::Tops tops(const Px<N>& p) const {
        // The sums are made after the depth test, because they would take the registers that the test needs.
        if constexpr (dithers && Count == 1)
            numeric::begin_here();
        const typename N::Tops v = N::tops(this->r.at, this->g.at, this->b.at);
        if constexpr (dithers)
            return N::dithered(v, fractions.of(p));
        else
            return v;
    }
    SPANGLE_INLINE void step() {
        Base::step();
        fractions.step();
    }
    SPANGLE_INLINE void next_row() {
        Base::next_row();
        fractions.next_row();
    }
    template <class S> SPANGLE_INLINE void start(const S& s, std::int32_t x) {
        Base::start(s, x);
        fractions = Fractions(s, x);
    }
};

template <int Count, class Fractions = WalkedFractions<Raw565<Count>>>
struct GouraudDithered : GouraudTops<Count, Fractions> {
    using N = Raw565<Count>;
    template <class S>
    SPANGLE_INLINE GouraudDithered(const S& s, std::int32_t x) : GouraudTops<Count, Fractions>(s, x) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color = N::joined(this->tops(p));
        return true;
    }
};

/// Dithered colours in rows of eight lanes. Eight columns are two periods of the dither pattern. So the
/// thresholds are added only once, where the ramps start.
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
        const N::L::U32 t = N::L::widened(inner::DitherRow<N::L>(s.x + x, s.y).threshold());
        r.at += t << 22;
        g.at += t << 21;
        b.at += t << 22;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
