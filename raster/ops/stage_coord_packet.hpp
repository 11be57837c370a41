// Finds coordinates and levels of detail of units in the balanced and fast tiers, a packet at a time. Small
// builds have this one piece of code in place of Coord and Lod for each unit and kind.
#pragma once

#include "raster/ops/stage_texture.hpp"
#include "raster/ops/stage_texture_lod.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Finds levels of detail of packets that have one lane and lie in one row. Most packets are sampled alike
/// from their first fragment to their last, and no levels are mixed. All fragments of such a packet get the
/// lambda of the first, so that only the ends are computed.
template <class Places> class RowLevels {
    static_assert(Places::lanes == 1);

  public:
    template <int Unit> static void run(Places& k, const Span<Fixed>& span) { find(k, span, Unit); }

  private:
    [[gnu::noinline]] static void find(Places& k, const Span<Fixed>& span, int unit) {
        const bool varies = span.kind >= Kind::textured;
        const LevelOfDetail lod(span, unit, varies);
        std::int32_t* const to = k.lod[unit];
        to[0] = varies ? lod.projective(k.x) : lod.affine();
        const bool alike = !varies || (k.n > 2 && are_alike(span.state->fragment.unit[unit], lod, k, to[0]));
        for (std::int32_t i = 1; i < k.n; ++i)
            to[i] = alike ? to[0] : lod.projective(k.x + i);
    }
    /// How a texture is sampled changes only one way while lambda grows, so the bounds of lambda decide.
    static bool are_alike(const TextureUnit& unit, const LevelOfDetail& lod, const Places& k,
                          std::int32_t first) {
        const LevelChoice choice(unit);
        const Sampling how = choice.choose_sampling(first);
        LevelOfDetail::Bounds bounds;
        if (how.next != 0 || !lod.bounds(k.x, k.x + k.n - 1, bounds))
            return false;
        return how.alike(choice.choose_sampling(bounds.least)) &&
               how.alike(choice.choose_sampling(bounds.most));
    }
};

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
