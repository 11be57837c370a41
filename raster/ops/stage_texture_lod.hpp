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
    /// `varies` says that projective() will be called, which needs the planes.
    SPANGLE_INLINE LevelOfDetail(const Span<Fixed>& span, int unit, bool varies = true)
        : span_(span), unit_(unit) {
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
        const auto numerator = [&](std::int32_t dv, std::int32_t v, std::int32_t dq) SPANGLE_RUN_LAMBDA {
            return numeric::abs_u64(numeric::mul_s32(dv, at_q) - numeric::mul_s32(v, dq));
        };
        const auto along = [&](const Plane& of) {
            const std::int32_t v = of.at.value(x);
            return largest(numerator(of.dx, v, q_.dx), numerator(of.dy, v, q_.dy));
        };
        const std::uint64_t ds = along(s_), dt = along(t_);
        return level_of_detail(in_texels(ds, dt) - 2 * log2_of_word8(static_cast<std::uint32_t>(at_q)) +
                               exponent_);
    }

  private:
    /// A plane along the row, and its differences from pixel to pixel and from row to row.
    struct Plane {
        GuardedRow at;
        std::int32_t dx, dy;
    };
    const Span<Fixed>& span_;
    int unit_;
    // The following members are set only where the level of detail varies along the row.
    Plane q_, s_, t_;
    std::int32_t exponent_; ///< of the coordinates, with 8 fraction bits

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

    static std::uint64_t largest(std::uint64_t a, std::uint64_t b) { return a > b ? a : b; }

    /// log2 of the largest of the four derivatives, in texels, with 8 fraction bits.
    std::int32_t in_texels(std::uint64_t ds, std::uint64_t dt) const {
        const Texture& texture = *span_.state->fragment.unit[unit_].texture;
        const TextureLevel& base = texture.level[0];
        const int width = span_.state->log2_width[unit_], height = span_.state->log2_height[unit_];
        if (texture.shape != TextureShape::line && is_power_of_two(base.width) &&
            is_power_of_two(base.height)) {
            const int up = height - width;
            return log2_fraction8(largest(ds, up >= 0 ? dt << up : dt >> -up)) + (width << 8);
        }
        const auto& halves = span_.state->halves[unit_];
        const auto along = [](std::uint64_t d, std::uint32_t size, int halved) SPANGLE_RUN_LAMBDA {
            return log2_fraction8(d) + log2_fraction8(size) + (halved << 8);
        };
        const std::int32_t u = along(ds, base.width, halves.s), v = along(dt, base.height, halves.t);
        return texture.shape == TextureShape::line || u > v ? u : v;
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
