// Divides by w, a packet at a time. 1/w of each fragment is found once, for colours, fog and coordinates.
// Only number systems with several lanes use it. The bytes are those of GouraudQ, ColorSum, FogCoord and
// DividedCoords.
#pragma once

#include "raster/ops/cubic_runs.hpp"
#include "raster/ops/lane_division.hpp"
#include "raster/ops/packet.hpp"
#include "raster/ops/stage_color.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

namespace inner {

/// A plane at the fragments of a packet, one fragment at a time. The packet lies in one row or in several.
template <class Places> class PlaneOf {
  public:
    SPANGLE_INLINE PlaneOf(const Places& k, const Span<Fixed>& span, const Span<Fixed>::Projective& plane)
        : rows_(k.rows), plane_(plane), first_(span.at(k.x, plane)) {}
    SPANGLE_INLINE std::uint64_t at(std::int32_t i) const {
        return rows_ != nullptr
                   ? plane_.at(static_cast<std::int32_t>(rows_->x[i]), static_cast<std::int32_t>(rows_->y[i]))
                   : first_ + static_cast<std::uint64_t>(i) * plane_.dx;
    }

  private:
    const PacketRows* rows_;
    const Span<Fixed>::Projective& plane_;
    std::uint64_t first_;
};

} // namespace inner

/// A plane at the fragments of a packet, in lanes. The packet lies in one row or in several.
template <class Places> class PlaneLanesOf {
  public:
    SPANGLE_INLINE PlaneLanesOf(const Places& k, const Span<Fixed>& span,
                                const Span<Fixed>::Projective& plane)
        : rows_(k.rows), row_starts_(plane) {
        if (rows_ == nullptr)
            ramp_ = inner::GuardedLanes<>(span, k.x, plane);
    }
    /// The signed values at the next eight fragments, without guard bits.
    SPANGLE_INLINE LaneWords next() {
        const std::int32_t i = first_;
        first_ += 8;
        if (rows_ != nullptr)
            return row_starts_.at(Lanes<8>::gather(rows_->x + i), Lanes<8>::gather(rows_->y + i));
        const LaneWords value = ramp_.value();
        ramp_.step();
        return value;
    }

  private:
    const PacketRows* rows_;
    std::int32_t first_ = 0;
    PlaneInRows row_starts_;
    inner::GuardedLanes<> ramp_;
};

/// Finds divided attributes of packets of number system N.
template <class N> class PacketDivided {
    using L = typename N::L;
    using U32 = typename L::U32;
    using Places = PlacesOf<N>;
    using Plane = Span<Fixed>::Projective;
    using PlaneOf = inner::PlaneOf<Places>;
    static constexpr int lanes = N::lanes;

  public:
    /// Finds the primitive's 1/w at each fragment; the other functions of this class read it.
    static void inverses(Places& k, const Span<Fixed>& span) {
        if constexpr (divides_in_lanes)
            return inverses_in_lanes(k, span);
        const PlaneOf plane(k, span, span.q);
        for (std::int32_t first = 0; first < k.n; first += lanes) {
            numeric::Reciprocals<lanes> mantissa(numeric::each_is_set);
            for (std::int32_t i = first; i < first + lanes; ++i) {
                const std::int32_t value = unguarded(plane.at(i));
                // 1/w is found as in Inverse, but the reciprocals of all lanes together.
                const std::uint32_t q = value > 0 ? static_cast<std::uint32_t>(value) : 1u;
                const int zeros = numeric::clz32(q);
                mantissa.set(i - first, q << zeros);
                k.inverse.q[i] = q;
                k.inverse.power[i] = 1u << zeros;
            }
            mantissa.finish(lanes);
            for (std::int32_t i = 0; i < lanes; ++i)
                k.inverse.mantissa[first + i] = mantissa.at(i);
        }
    }
    template <bool Alpha> static void primary(Places& places, const Span<Fixed>& span) {
        auto& k = static_cast<Packet<N>&>(places);
        each(k, span, span.color_q[0], [&](std::int32_t g, const U32& c) { k.color[g].r = component(c); });
        each(k, span, span.color_q[1], [&](std::int32_t g, const U32& c) { k.color[g].g = component(c); });
        each(k, span, span.color_q[2], [&](std::int32_t g, const U32& c) { k.color[g].b = component(c); });
        if constexpr (Alpha)
            each(k, span, span.color_q[3],
                 [&](std::int32_t g, const U32& c) { k.color[g].a = component(c); });
        else
            for (auto& color : k.color)
                color.a = N::from_units(color_one);
    }
    static void sum(Places& places, const Span<Fixed>& span) {
        auto& k = static_cast<Packet<N>&>(places);
        const auto add = [](typename N::T& to, const U32& c) { to = N::add(to, component(c)); };
        each(k, span, span.secondary_q[0], [&](std::int32_t g, const U32& c) { add(k.color[g].r, c); });
        each(k, span, span.secondary_q[1], [&](std::int32_t g, const U32& c) { add(k.color[g].g, c); });
        each(k, span, span.secondary_q[2], [&](std::int32_t g, const U32& c) { add(k.color[g].b, c); });
    }
    static void fog(Places& k, const Span<Fixed>& span) {
        if constexpr (divides_in_lanes)
            if (fog_in_lanes(k, span))
                return;
        const PlaneOf f(k, span, span.fog_q);
        std::uint32_t fog[packet_length];
        for (std::int32_t i = 0; i < whole(k); ++i)
            fog[i] = inner::projective_fog(unguarded(f.at(i)), span.fog_exponent, inverse_of(k, i));
        for (std::int32_t i = 0; i < whole(k); i += lanes)
            k.fog[i / lanes] = L::gather(fog + i);
    }
    /// Finds texture coordinates of a unit, whether or not the unit shares the primitive's 1/w.
    template <int Unit> static void coordinates(Places& k, const Span<Fixed>& span) {
        if constexpr (divides_in_lanes)
            return coordinates_in_lanes(k, span, Unit, span.unit[Unit].shares_q, k.coord[Unit]);
        const auto& unit = span.unit[Unit];
        const auto& wraps = span.state->wraps[Unit];
        const PlaneOf s(k, span, unit.s), t(k, span, unit.t), q(k, span, unit.shares_q ? span.q : unit.q);
        for (std::int32_t i = 0; i < whole(k); ++i) {
            const Inverse inverse = unit.shares_q ? inverse_of(k, i) : Inverse(unguarded(q.at(i)));
            auto& to = k.coord[Unit][i / lanes];
            to.s[i % lanes] = inner::to_coord(inner::to_repeats(unguarded(s.at(i)), inverse, unit.exponent),
                                              wraps.s, unit.s_base);
            to.t[i % lanes] = inner::to_coord(inner::to_repeats(unguarded(t.at(i)), inverse, unit.exponent),
                                              wraps.t, unit.t_base);
        }
    }

    /// Finds texture coordinates of the exact tier. Rows that have cubic runs follow them. Coordinates that
    /// are divided at every fragment are divided in lanes.
    template <int Unit> static void along_cubics(Places& k, const Span<Fixed>& span) {
        along_cubics(k, span, Unit);
    }

  private:
    using Coord = typename N::Coord;

    static void inverses_in_lanes(Places& k, const Span<Fixed>& span) {
        PlaneLanesOf<Places> plane(k, span, span.q);
        for (std::int32_t i = 0; i < k.n; i += lanes) {
            const InverseLanes inverse(plane.next());
            store(k.inverse.q + i, inverse.q);
            store(k.inverse.mantissa + i, inverse.mantissa);
            store(k.inverse.power + i, inverse.power());
        }
    }
    /// Returns false where a product would have to be shifted to the left.
    static bool fog_in_lanes(Places& k, const Span<Fixed>& span) {
        if (span.fog_exponent > 38 - 31) // 1/w has at most 31 leading zeros
            return false;
        PlaneLanesOf<Places> f(k, span, span.fog_q);
        for (std::int32_t i = 0; i < k.n; i += lanes)
            k.fog[i / lanes] = inverse_lanes(k, i).fog(f.next(), span.fog_exponent);
        return true;
    }
    [[gnu::noinline]] static void coordinates_in_lanes(Places& k, const Span<Fixed>& span, int which,
                                                       bool has_inverse, Coord* to) {
        const auto& unit = span.unit[which];
        const auto& wraps = span.state->wraps[which];
        PlaneLanesOf<Places> s(k, span, unit.s), t(k, span, unit.t),
            q(k, span, unit.shares_q ? span.q : unit.q);
        for (std::int32_t i = 0; i < k.n; i += lanes, ++to) {
            const InverseLanes inverse = has_inverse ? inverse_lanes(k, i) : InverseLanes(q.next());
            store(to->s, inverse.coord(s.next(), unit.exponent, wraps.s, unit.s_base));
            store(to->t, inverse.coord(t.next(), unit.exponent, wraps.t, unit.t_base));
        }
    }
    [[gnu::noinline]] static void along_cubics(Places& k, const Span<Fixed>& span, int unit) {
        Coord* const to = k.coord[unit];
        if (k.rows == nullptr) {
            if (!along_cubic(span, unit, k.x, 0, k.n, to))
                coordinates_in_lanes(k, span, unit, false, to);
            return;
        }
        const PacketRows& rows = *k.rows;
        PacketBits divided = 0; // a bit says that the piece of its number is divided
        for (std::int32_t n = 0; n < rows.pieces; ++n) {
            const Piece& piece = rows.piece[n];
            enter(rows.span, piece.row);
            divided |= PacketBits{!along_cubic(span, unit, span.begin, piece.at, end_of(piece), to)} << n;
        }
        if (divided == 0)
            return;
        if (divided == first_bits(rows.pieces))
            return coordinates_in_lanes(k, span, unit, false, to);
        Coord each[Places::groups];
        coordinates_in_lanes(k, span, unit, false, each);
        for (PacketBits left = divided; left != 0; left &= left - 1) {
            const Piece& piece = rows.piece[std::countr_zero(left)];
            for (std::int32_t i = piece.at; i < end_of(piece); ++i)
                put(to, i, each[i / lanes].s[i % lanes], each[i / lanes].t[i % lanes]);
        }
    }
    SPANGLE_INLINE static std::int32_t end_of(const Piece& piece) {
        return piece.at + piece.row.last - piece.row.first;
    }
    /// Finds fragments [from, end) of the span's row along its cubic runs; the first one is in column x.
    /// Returns false where each fragment divides.
    [[gnu::noinline]] static bool along_cubic(const Span<Fixed>& span, int unit, std::int32_t x,
                                              std::int32_t from, std::int32_t end, Coord* to) {
        CubicRuns run(span, x, unit);
        if (run.divides_each_fragment())
            return false;
        for (std::int32_t i = from; i < end;) {
            const std::int32_t next = run.begin(x), room = end - i,
                               length = next - x < room ? next - x : room;
            x = next;
            for (const std::int32_t stop = i + length; i < stop; ++i) {
                put(to, i, run.s, run.t);
                run.step();
            }
        }
        return true;
    }
    SPANGLE_INLINE static void put(Coord* to, std::int32_t i, std::uint32_t s, std::uint32_t t) {
        to[i / lanes].s[i % lanes] = s;
        to[i / lanes].t[i % lanes] = t;
    }
    SPANGLE_INLINE static void store(std::uint32_t* to, const U32& v) {
        L::store32(reinterpret_cast<std::uint8_t*>(to), v);
    }
    SPANGLE_INLINE static InverseLanes inverse_lanes(const Places& k, std::int32_t i) {
        return {L::gather(k.inverse.q + i), L::gather(k.inverse.mantissa + i)};
    }
    /// The number of fragments, rounded up to whole groups. Lanes beyond the packet are never read.
    static std::int32_t whole(const Places& k) { return (k.n + lanes - 1) & -lanes; }
    SPANGLE_INLINE static Inverse inverse_of(const Places& k, std::int32_t i) {
        Inverse inverse;
        inverse.q = k.inverse.q[i];
        inverse.mantissa = k.inverse.mantissa[i];
        inverse.zeros = std::countr_zero(k.inverse.power[i]);
        return inverse;
    }
    /// A component of number system N from a component in colour units.
    SPANGLE_INLINE static typename N::T component(const U32& units) {
        if constexpr (is_exact<N>)
            return units;
        else
            return L::low_half((units + L::splat32(1u << 11)) >> 12);
    }
    /// Calls f(group, colour units) for a colour plane that is divided at each fragment, as
    /// inner::projective_color() does.
    template <class F>
    SPANGLE_INLINE static void each(const Places& k, const Span<Fixed>& span, const Plane& plane, F f) {
        PlaneLanesOf<Places> over_w(k, span, plane);
        const PlaneOf of_rows(k, span, plane);
        const auto value = [&](std::int32_t g) __attribute__((always_inline)) {
            if (divides_in_lanes || k.rows == nullptr)
                return over_w.next();
            return L::generate([&](std::uint32_t lane) __attribute__((always_inline)) {
                return static_cast<std::uint32_t>(
                    unguarded(of_rows.at(g * lanes + static_cast<std::int32_t>(lane))));
            });
        };
        for (std::int32_t g = 0; g * lanes < k.n; ++g) {
            const U32 q = L::gather(k.inverse.q + g * lanes),
                      mantissa = L::gather(k.inverse.mantissa + g * lanes),
                      power = L::gather(k.inverse.power + g * lanes);
            const U32 most = q - (q >> 8) - L::splat32(1);
            const U32 v = L::minimum(L::positive(value(g)), most) * power;
            f(g, lane_product_high(v, mantissa) >> 2);
        }
    }
};

/// Adds the affine secondary colour, in lanes.
template <class N> struct ColorSumLanes : StageBase {
    static constexpr unsigned in = field_color, out = field_color;
    Ramp<typename N::L> r, g, b;
    template <class S>
    SPANGLE_INLINE ColorSumLanes(const S& s, std::int32_t x)
        : r(s, x, s.secondary[0]), g(s, x, s.secondary[1]), b(s, x, s.secondary[2]) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) const {
        p.color.r = N::add(p.color.r, N::from_affine(r.at));
        p.color.g = N::add(p.color.g, N::from_affine(g.at));
        p.color.b = N::add(p.color.b, N::from_affine(b.at));
        return true;
    }
    SPANGLE_INLINE void step() {
        r.step();
        g.step();
        b.step();
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
