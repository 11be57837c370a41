// Finds where fragments sample volumes, cube maps and depths that are compared, a packet at a time, in lanes.
// The integers are those of VolumeCoords. Only instruction sets that divide in lanes use it
// (lane_division.hpp).
#pragma once

#include "raster/ops/lane_log2.hpp"
#include "raster/ops/lane_words.hpp"
#include "raster/ops/stage_divided_packet.hpp"
#include "raster/ops/stage_texture_volume.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// The places of the fragments of a packet; VolumePlace is the place of one fragment. Lanes beyond the last
/// fragment have places, too.
struct VolumePlaces {
    alignas(32) std::uint32_t s[packet_length], t[packet_length], r[packet_length];
    alignas(32) std::uint32_t face[packet_length];
};

namespace inner {

/// A projective coordinate in lanes: its value, and its differences from column to column and from row to
/// row.
struct CoordLanes {
    LaneWords v, dx, dy;

    /// Selects this coordinate in lanes of the mask, and `other` in the other lanes.
    SPANGLE_INLINE CoordLanes where(const LaneWords& mask, const CoordLanes& other) const {
        const auto pick = [&](const LaneWords& a, const LaneWords& b) __attribute__((always_inline)) {
            return (a & mask) | (b & ~mask);
        };
        return {pick(v, other.v), pick(dx, other.dx), pick(dy, other.dy)};
    }
    /// Negates the coordinate in lanes of the mask.
    SPANGLE_INLINE CoordLanes turned(const LaneWords& mask) const {
        const auto turn = [&](const LaneWords& a) __attribute__((always_inline)) {
            return (a ^ mask) - mask;
        };
        return {turn(v), turn(dx), turn(dy)};
    }
    /// log2 of the step of this coordinate / q times q^2, of the larger step of both directions, in 256ths.
    SPANGLE_INLINE LaneWords steps(const CoordLanes& q) const {
        return LaneWords::mapped(
            [](const auto& v_s, const auto& dx_s, const auto& dy_s, const auto& v_q, const auto& dx_q,
               const auto& dy_q) __attribute__((always_inline)) {
                return lane_log2(larger(derivative(dx_s, v_s, dx_q, v_q), derivative(dy_s, v_s, dy_q, v_q)));
            },
            v, dx, dy, q.v, q.dx, q.dy);
    }
};

/// All ones in lanes where v is negative.
SPANGLE_INLINE LaneWords lanes_below_zero(const LaneWords& v) {
    return lane_shifted_signed(v, 31);
}
/// All ones in lanes where |a| < |b|.
SPANGLE_INLINE LaneWords lanes_nearer(const LaneWords& a, const LaneWords& b) {
    return LaneWords::mapped(
        [](const auto& v, const auto& w) __attribute__((always_inline)) {
            using Vector = std::remove_cvref_t<decltype(v)>;
            const auto size = [](const Vector& of) __attribute__((always_inline)) {
                const auto sign = std::bit_cast<Vector>(lane_words::as_signed(of) >> 31);
                return (of ^ sign) - sign; // the size of -2^31 is 2^31 as an unsigned word
            };
            return std::bit_cast<Vector>(size(v) < size(w));
        },
        a, b);
}

} // namespace inner

/// Does what VolumeCoords::at() does, for eight fragments at a time.
template <class Places> class VolumeLanes {
    using Coord = inner::CoordLanes;

  public:
    VolumeLanes(const Places& k, const Span<Fixed>& span, int which)
        : at_(span.unit[which]), texture_(*span.state->fragment.unit[which].texture),
          cube_(has_cube_maps && texture_.shape == TextureShape::cube),
          volume_(has_volumes && texture_.shape == TextureShape::volume),
          line_(texture_.shape == TextureShape::line), exponent_(cube_ ? 0 : at_.exponent),
          s_(k, span, at_.s, at_.s_dy), t_(k, span, at_.t, at_.t_dy), r_(k, span, at_.r, at_.r_dy),
          q_(k, span, at_.q, at_.q_dy) {
        const TextureLevel& base = texture_.level[0];
        width_ = static_cast<std::uint32_t>(log2_fraction8(base.width));
        height_ = static_cast<std::uint32_t>(log2_fraction8(base.height));
        depth_ = volume_ ? static_cast<std::uint32_t>(log2_fraction8(texture_.depth)) : 0;
    }
    /// Finds the places of fragments [0, n), and their levels of detail where the texture has any.
    void find(std::int32_t n, VolumePlaces& to, std::int32_t* lod) {
        const bool wants_level = raster::wants_lod(texture_);
        const auto put = [](auto* at, const LaneWords& v) __attribute__((always_inline)) {
            v.store(reinterpret_cast<std::uint8_t*>(at));
        };
        for (std::int32_t i = 0; i < n; i += 8) {
            Coord s = s_.next(), t = t_.next(), r = r_.next();
            put(to.face + i, cube_ ? face(s, t, r) : LaneWords::splat(0));
            const Coord q = cube_ ? r : q_.next();
            const InverseLanes inverse(q.v);
            put(to.s + i, coord(s.v, inverse, texture_.wrap_s));
            put(to.t + i, coord(t.v, inverse, texture_.wrap_t));
            // A cube map is sampled in the plane of a face, so its r is not read.
            put(to.r + i, cube_     ? LaneWords::splat(0)
                          : volume_ ? coord(r.v, inverse, texture_.wrap_r)
                                    : compared(r.v, inverse));
            put(lod + i, wants_level ? level(s, t, r, q) : LaneWords::splat(0));
        }
    }

  private:
    /// A plane of the span at the fragments of the packet.
    class Plane {
      public:
        Plane(const Places& k, const Span<Fixed>& span, const Span<Fixed>::Projective& plane,
              std::uint64_t dy)
            : value_(k, span, plane), dx_(word(plane.dx)), dy_(word(dy)) {}
        SPANGLE_INLINE Coord next() { return {value_.next(), LaneWords::splat(dx_), LaneWords::splat(dy_)}; }

      private:
        PlaneLanesOf<Places> value_;
        std::uint32_t dx_, dy_;
        static std::uint32_t word(std::uint64_t guarded) {
            return static_cast<std::uint32_t>(unguarded(guarded));
        }
    };
    const Span<Fixed>::Unit& at_;
    const Texture& texture_;
    const bool cube_, volume_, line_;
    const int exponent_;
    std::uint32_t width_, height_, depth_; ///< log2 of the sizes, with 8 fraction bits
    Plane s_, t_, r_, q_;

    /// Finds the faces of directions, by the rules of CubeFace.
    SPANGLE_INLINE static LaneWords face(Coord& s, Coord& t, Coord& r) {
        const Coord x = s, y = t, z = r;
        const LaneWords along_z = ~(inner::lanes_nearer(z.v, x.v) | inner::lanes_nearer(z.v, y.v)),
                        along_y = ~along_z & ~inner::lanes_nearer(y.v, x.v), along_x = ~(along_z | along_y);
        const Coord major = z.where(along_z, y.where(along_y, x));
        const LaneWords back = inner::lanes_below_zero(major.v);
        s = z.where(along_x, x).turned((along_z & back) | (along_x & ~back));
        t = z.where(along_y, y).turned(~along_y | back);
        r = major.turned(back);
        return (along_z & 4) | (along_y & 2) | (back & 1);
    }
    /// A coordinate over q in repeats, with 32 fraction bits (inner::to_repeats()). In cube maps -1 .. 1
    /// becomes 0 .. 1.
    template <class Vector>
    SPANGLE_INLINE inner::LongPair<Vector> repeats(const Vector& v, const Vector& mantissa,
                                                   const Vector& zeros) const {
        const auto of = inner::LongPair<Vector>::products(v, mantissa)
                            .after(static_cast<std::uint32_t>(30 - exponent_) - zeros);
        return cube_ ? (of + (std::int64_t{1} << 32)).after(1) : of;
    }
    SPANGLE_INLINE LaneWords coord(const LaneWords& v, const InverseLanes& inverse, Wrap wrap) const {
        const bool mirrored = wrap == Wrap::mirrored_repeat, wraps = mirrored || wrap == Wrap::repeat;
        return LaneWords::mapped(
            [&](const auto& of, const auto& m, const auto& n) __attribute__((always_inline)) {
                const auto once = repeats(of, m, n);
                if (!wraps)
                    return once.after(32 - clamped_coord_bits).saturated().low_words();
                // The unit of mirrored coordinates is two repeats, after which mirroring begins again.
                return (mirrored ? once.after(1) : once).low_words();
            },
            v, inverse.mantissa, inverse.zeros);
    }
    /// r as a depth for comparisons, limited to 0 .. 1, with 30 fraction bits.
    SPANGLE_INLINE LaneWords compared(const LaneWords& v, const InverseLanes& inverse) const {
        return LaneWords::mapped(
            [&](const auto& of, const auto& m, const auto& n) __attribute__((always_inline)) {
                using Vector = std::remove_cvref_t<decltype(of)>;
                const Vector depth = repeats(of, m, n).after(2).saturated().low_words();
                return lane_words::smaller(lane_words::positive(depth), Vector{} + (1u << 30));
            },
            v, inverse.mantissa, inverse.zeros);
    }
    SPANGLE_INLINE LaneWords level(const Coord& s, const Coord& t, const Coord& r, const Coord& q) const {
        const auto larger = [](const LaneWords& a, const LaneWords& b) __attribute__((always_inline)) {
            return LaneWords::mapped(
                [](const auto& v, const auto& w)
                    __attribute__((always_inline)) { return lane_words::larger(v, w); },
                a, b);
        };
        LaneWords most = s.steps(q) + LaneWords::splat(width_);
        if (!line_)
            most = larger(most, t.steps(q) + LaneWords::splat(height_));
        if (volume_)
            most = larger(most, r.steps(q) + LaneWords::splat(depth_));
        const auto more = static_cast<std::uint32_t>(cube_ ? -256 : at_.exponent * 256);
        return LaneWords::mapped(
            [more](const auto& steps, const auto& over_w) __attribute__((always_inline)) {
                const auto of_q = inner::lane_log2(inner::at_least_one(over_w)) << 1;
                return inner::lane_level_of_detail(steps - of_q + more);
            },
            most, q.v);
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
