// The level of detail (GL 1.3, 3.8.8). Lambda is log2 of the largest derivative of u and v along x and y,
// which is an approximation that the specification allows.
#pragma once

#include "raster/ops/guarded_row.hpp"
#include "raster/ops/stage_coord.hpp"
#include "raster/ops/texel.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Levels of detail of one unit.
class LevelOfDetail {
  public:
    /// `varies`: projective() or bounds() is to be called.
    LevelOfDetail(const Span<Fixed>& span, int unit, bool varies = true) : span_(span), unit_(unit) {
        const Texture& texture = *span.state->fragment.unit[unit].texture;
        const TextureLevel& base = texture.level[0];
        const int width = span.state->log2_width[unit];
        is_1d_ = texture.shape == TextureShape::line;
        shares_logarithm_ = !is_1d_ && is_power_of_two(base.width) && is_power_of_two(base.height);
        log2_aspect_ = span.state->log2_height[unit] - width;
        if (shares_logarithm_) {
            bias_u_ = width << 8;
        } else {
            const auto& halves = span.state->halves[unit];
            bias_u_ = log2_of_word8(base.width) + (halves.s << 8);
            bias_v_ = log2_of_word8(base.height) + (halves.t << 8);
        }
        if (varies)
            read_planes();
    }

    [[gnu::noinline]] std::int32_t affine() const {
        const auto steps = [](std::uint64_t dx, std::uint64_t dy, bool wraps) SPANGLE_RUN_LAMBDA {
            const std::uint64_t m = largest(numeric::abs_u64(static_cast<std::int64_t>(dx)),
                                            numeric::abs_u64(static_cast<std::int64_t>(dy)));
            return m << (wraps ? 0 : 32 - clamped_coord_bits);
        };
        const auto& unit = span_.unit[unit_];
        const std::uint64_t ds = steps(unit.s.dx, unit.s_dy, span_.state->wraps[unit_].s);
        const std::uint64_t dt = steps(unit.t.dx, unit.t_dy, span_.state->wraps[unit_].t);
        return level_of_detail(in_texels(ds, dt) - (32 << 8));
    }

    /// Lambda at pixel x, s23.8. The derivative d(S/Q) is (dS Q - S dQ) / Q^2, of which only the logarithm is
    /// needed.
    [[gnu::noinline]] std::int32_t projective(std::int32_t x) const {
        const std::int32_t q = q_.at.value(x), at_q = q > 0 ? q : 1;
        const auto along = [&](const Plane& of) SPANGLE_RUN_LAMBDA {
            const std::int32_t v = of.at.value(x);
            return largest(numeric::abs_u64(numerator(of.dx, v, q_.dx, at_q)),
                           numeric::abs_u64(numerator(of.dy, v, q_.dy, at_q)));
        };
        const std::uint64_t ds = along(s_), dt = along(t_);
        return lambda(ds, dt, at_q);
    }

    /// Bounds of projective() over a part of the row.
    struct Bounds {
        std::int32_t least, most;
    };
    /// Finds bounds over pixels [first, last]. Returns false where that cannot be done.
    ///
    /// Along a row dS Q - S dQ is affine, except that S and Q have lost their guard bits, less than 1 each.
    /// So a numerator is off by less than |dS| + |dQ|, and lies between those of both ends, or beyond them by
    /// less than twice as much. No logarithm becomes smaller as its number grows.
    [[gnu::noinline]] bool bounds(std::int32_t first, std::int32_t last, Bounds& to) const {
        const std::int32_t q0 = q_.at.value(first), q1 = q_.at.value(last);
        if (q0 <= 0 || q1 <= 0)
            return false;
        const auto along = [&](const Plane& of) {
            const std::int32_t v0 = of.at.value(first), v1 = of.at.value(last);
            Range range{0, 0};
            range.add(of.dx, q_.dx, v0, v1, q0, q1);
            range.add(of.dy, q_.dy, v0, v1, q0, q1);
            return range;
        };
        const Range s = along(s_), t = along(t_);
        if (log2_aspect_ > 0 && t.most >> (63 - log2_aspect_) != 0) // in_texels() would lose its top bits
            return false;
        to = {lambda(s.least, t.least, q0 > q1 ? q0 : q1), lambda(s.most, t.most, q0 < q1 ? q0 : q1)};
        return true;
    }

  private:
    /// A plane along the row, and its differences from pixel to pixel and from row to row.
    struct Plane {
        GuardedRow at;
        std::int32_t dx, dy;
    };
    /// Bounds of the larger of some numerators, whose signs are dropped.
    struct Range {
        std::uint64_t least, most;
        /// Adds a numerator that has these values of a plane and of q at the ends.
        [[gnu::noinline]] void add(std::int32_t dv, std::int32_t dq, std::int32_t v0, std::int32_t v1,
                                   std::int32_t q0, std::int32_t q1) {
            const std::int64_t n0 = numerator(dv, v0, dq, q0), n1 = numerator(dv, v1, dq, q1);
            const std::uint64_t a = numeric::abs_u64(n0), b = numeric::abs_u64(n1), large = largest(a, b),
                                off = (std::uint64_t{numeric::abs_u32(dv)} + numeric::abs_u32(dq)) * 2,
                                small = (n0 < 0) == (n1 < 0) ? a + b - large : 0;
            least = largest(least, small > off ? small - off : 0);
            most = largest(most, large + off);
        }
    };
    const Span<Fixed>& span_;
    int unit_;
    bool is_1d_;                       ///< true for 1D textures, of which only s counts
    bool shares_logarithm_;            ///< both sizes are powers of two, so one logarithm serves both axes
    int log2_aspect_;                  ///< log2 of height / width
    std::int32_t bias_u_, bias_v_ = 0; ///< logarithms of the sizes, with 8 fraction bits
    // The next members are set only where levels vary.
    Plane q_, s_, t_;
    std::int32_t exponent_; ///< exponent of the coordinates, in 256ths

    void read_planes() {
        const auto& unit = span_.unit[unit_];
        const auto plane = [&](const Span<Fixed>::Projective& of, std::uint64_t dy) {
            return Plane{{span_, of}, unguarded(of.dx), unguarded(dy)};
        };
        q_ = unit.shares_q ? plane(span_.q, span_.q_dy) : plane(unit.q, unit.q_dy);
        s_ = plane(unit.s, unit.s_dy);
        t_ = plane(unit.t, unit.t_dy);
        exponent_ = unit.exponent << 8;
    }

    SPANGLE_INLINE static std::int64_t numerator(std::int32_t dv, std::int32_t v, std::int32_t dq,
                                                 std::int32_t q) {
        return numeric::mul_s32(dv, q) - numeric::mul_s32(v, dq);
    }
    static std::uint64_t largest(std::uint64_t a, std::uint64_t b) { return a > b ? a : b; }

    [[gnu::noinline]] std::int32_t lambda(std::uint64_t ds, std::uint64_t dt, std::int32_t q) const {
        return level_of_detail(in_texels(ds, dt) - 2 * log2_of_word8(static_cast<std::uint32_t>(q)) +
                               exponent_);
    }
    /// log2 of the largest of the four derivatives, in texels, with 8 fraction bits.
    std::int32_t in_texels(std::uint64_t ds, std::uint64_t dt) const {
        if (shares_logarithm_) {
            const int up = log2_aspect_;
            return log2_fraction8(largest(ds, up >= 0 ? dt << up : dt >> -up)) + bias_u_;
        }
        const std::int32_t u = log2_fraction8(ds) + bias_u_;
        if (is_1d_)
            return u;
        const std::int32_t v = log2_fraction8(dt) + bias_v_;
        return u > v ? u : v;
    }
};

template <class N, int Unit> struct Lod : StageBase {
    static_assert(N::lanes == 1);
    static constexpr unsigned out = field_lod << Unit;
    LevelOfDetail lod;
    bool varies;
    std::int32_t x, constant;
    SPANGLE_INLINE Lod(const Span<Fixed>& s, std::int32_t first)
        : lod(s, Unit, s.kind >= Kind::textured), varies(s.kind >= Kind::textured), x(first),
          constant(varies ? 0 : lod.affine()) {}
    SPANGLE_INLINE bool operator()(Px<N>& p) {
        p.lod[Unit][0] = varies ? lod.projective(x) : constant;
        return true;
    }
    SPANGLE_INLINE void step() { ++x; }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
