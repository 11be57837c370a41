// Finds coordinates and levels of detail of units in the balanced and fast tiers, a packet at a time. Small
// builds have this one piece of code in place of Coord and Lod for each unit and kind.
#pragma once

#include "raster/ops/stage_texture.hpp"
#include "raster/ops/stage_texture_lod.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Finds texture coordinates of packets. One body of code serves all number systems that share this type of
/// places.
template <class Places> class PacketCoordinates {
  public:
    template <int Unit> static void run(Places& k, const Span<Fixed>& span) {
        span.kind >= Kind::textured ? along_runs(k, span, Unit) : affine(k, span, Unit);
    }

  private:
    SPANGLE_INLINE static void put(Places& k, int unit, std::int32_t i, std::uint32_t s, std::uint32_t t) {
        auto& at = k.coord[unit][i / Places::lanes];
        at.s[i % Places::lanes] = s;
        at.t[i % Places::lanes] = t;
    }
    static bool has_levels(const Span<Fixed>& span, int unit) {
        return wants_lod(*span.state->fragment.unit[unit].texture);
    }
    [[gnu::noinline]] static void affine(Places& k, const Span<Fixed>& span, int unit) {
        std::uint32_t s = span.at(k.x, span.s[unit]), t = span.at(k.x, span.t[unit]);
        const std::int32_t lod = has_levels(span, unit) ? LevelOfDetail(span, unit, false).affine() : 0;
        for (std::int32_t i = 0; i < k.n; ++i) {
            put(k, unit, i, s, t);
            k.lod[unit][i] = lod;
            s += span.s[unit].dx;
            t += span.t[unit].dx;
        }
    }
    [[gnu::noinline]] static void along_runs(Places& k, const Span<Fixed>& span, int unit) {
        const LevelOfDetail lod(span, unit);
        const bool levels = has_levels(span, unit);
        CoordRuns run(span, k.x, unit);
        std::int32_t next = k.x;
        for (std::int32_t i = 0; i < k.n; ++i) {
            if (k.x + i == next)
                next = run.begin(next);
            put(k, unit, i, run.s, run.t);
            if (levels)
                k.lod[unit][i] = lod.projective(k.x + i);
            run.step();
        }
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
