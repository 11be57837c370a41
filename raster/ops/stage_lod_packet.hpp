// Finds levels of detail of a unit for a packet at a time, in lanes. The integers are those of LevelOfDetail.
#pragma once

#include "raster/ops/lane_log2.hpp"
#include "raster/ops/packet.hpp"
#include "raster/ops/stage_divided_packet.hpp"
#include "raster/ops/stage_texture_lod.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// LevelOfDetail::projective() of one unit for eight fragments.
class LevelLanes {
  public:
    LevelLanes(const Span<Fixed>& span, int which) {
        const auto& unit = span.unit[which];
        s_ = {unguarded(unit.s.dx), unguarded(unit.s_dy)};
        t_ = {unguarded(unit.t.dx), unguarded(unit.t_dy)};
        q_ = {unguarded(unit.shares_q ? span.q.dx : unit.q.dx),
              unguarded(unit.shares_q ? span.q_dy : unit.q_dy)};
        const Texture& texture = *span.state->fragment.unit[which].texture;
        const TextureLevel& base = texture.level[0];
        const int width = span.state->log2_width[which];
        is_1d_ = texture.shape == TextureShape::line;
        shares_logarithm_ = !is_1d_ && is_power_of_two(base.width) && is_power_of_two(base.height);
        log2_aspect_ = span.state->log2_height[which] - width;
        const auto& halves = span.state->halves[which];
        const std::int32_t exponent = unit.exponent << 8;
        bias_u_ = (shares_logarithm_ ? width << 8 : log2_fraction8(base.width) + (halves.s << 8)) + exponent;
        bias_v_ = shares_logarithm_ ? 0 : log2_fraction8(base.height) + (halves.t << 8) + exponent;
    }
    /// The levels of detail (s23.8) at fragments with these s, t and q, from which the guard bits are
    /// removed.
    SPANGLE_INLINE LaneWords at(const LaneWords& s, const LaneWords& t, const LaneWords& q) const {
        return LaneWords::mapped(
            [this](const auto& at_s, const auto& at_t, const auto& over_w) __attribute__((always_inline)) {
                const auto at_q = inner::at_least_one(over_w);
                const auto ds = along(s_, at_s, at_q), dt = along(t_, at_t, at_q);
                return inner::lane_level_of_detail(texels(ds, dt) - (inner::lane_log2(at_q) << 1));
            },
            s, t, q);
    }

  private:
    struct Slopes {
        std::int32_t dx, dy; ///< differences from pixel to pixel and from row to row
    };
    Slopes s_, t_, q_;
    bool is_1d_;                   ///< true for 1D textures, of which only s counts
    bool shares_logarithm_;        ///< both sizes are powers of two, so one logarithm serves both axes
    int log2_aspect_;              ///< log2 of height / width
    std::int32_t bias_u_, bias_v_; ///< constants in 256ths that are added to the logarithms

    template <class Vector>
    SPANGLE_INLINE inner::LongPair<Vector> along(const Slopes& of, const Vector& v, const Vector& q) const {
        return inner::larger(inner::derivative(of.dx, v, q_.dx, q), inner::derivative(of.dy, v, q_.dy, q));
    }
    template <class Vector>
    SPANGLE_INLINE Vector texels(const inner::LongPair<Vector>& ds, const inner::LongPair<Vector>& dt) const {
        const auto u = static_cast<std::uint32_t>(bias_u_);
        if (shares_logarithm_) {
            const inner::LongPair<Vector> of_t =
                log2_aspect_ >= 0
                    ? inner::LongPair<Vector>{dt.even << log2_aspect_, dt.odd << log2_aspect_}
                    : inner::LongPair<Vector>{dt.even >> -log2_aspect_, dt.odd >> -log2_aspect_};
            return inner::lane_log2(inner::larger(ds, of_t)) + u;
        }
        const Vector of_s = inner::lane_log2(ds) + u;
        if (is_1d_)
            return of_s;
        const Vector of_t = inner::lane_log2(dt) + static_cast<std::uint32_t>(bias_v_);
        return lane_words::larger(of_s, of_t);
    }
};

template <class Places> class PacketLevels {
  public:
    template <int Unit> static void run(Places& k, const Span<Fixed>& span) { levels(k, span, Unit); }

  private:
    [[gnu::noinline]] static void levels(Places& k, const Span<Fixed>& span, int which) {
        const auto put = [to = k.lod[which]](std::int32_t i, const LaneWords& levels)
            __attribute__((always_inline)) {
            levels.store(reinterpret_cast<std::uint8_t*>(to + i));
        };
        if (span.kind < Kind::textured) {
            const auto all = static_cast<std::uint32_t>(LevelOfDetail(span, which, false).affine());
            for (std::int32_t i = 0; i < k.n; i += Places::lanes)
                put(i, LaneWords::splat(all));
            return;
        }
        const auto& unit = span.unit[which];
        PlaneLanesOf<Places> s(k, span, unit.s), t(k, span, unit.t),
            q(k, span, unit.shares_q ? span.q : unit.q);
        const LevelLanes lanes(span, which);
        for (std::int32_t i = 0; i < k.n; i += Places::lanes)
            put(i, lanes.at(s.next(), t.next(), q.next()));
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
