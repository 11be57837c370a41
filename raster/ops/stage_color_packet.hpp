// The colours of a packet. Small builds have this one piece of code in place of Gouraud, GouraudQ and
// ColorSum.
#pragma once

#include "raster/ops/packet.hpp"
#include "raster/ops/stage_color.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Colours of packets of number system N.
template <class N> class PacketColors {
    using SingleLane = OneLane<N>;
    using Affine = Span<Fixed>::Affine;
    using Projective = Span<Fixed>::Projective;

  public:
    static void primary(PlacesOf<N>& k, const Span<Fixed>& span) {
        fill(k, span, span.color_value, span.color_q, span.state->needs.alpha ? 4 : 3);
    }
    static void sum(PlacesOf<N>& k, const Span<Fixed>& span) {
        fill(k, span, span.secondary, span.secondary_q, 0);
    }

  private:
    /// `channels` is 3 or 4 where a new colour is written. 0 means that three channels are added to the
    /// colour that the packet has.
    [[gnu::noinline]] static void fill(PlacesOf<N>& places, const Span<Fixed>& span, const Affine* affine,
                                       const Projective* over_w, int channels) {
        auto& k = static_cast<Packet<N>&>(places);
        const bool adds = channels == 0, divides = span.kind == Kind::full;
        channels = adds ? 3 : channels;
        std::uint64_t at[4], by[4], q = 0; // an affine colour uses the low word
        for (int c = 0; c < channels; ++c) {
            at[c] = divides ? span.at(k.x, over_w[c]) : span.at(k.x, affine[c]);
            by[c] = divides ? over_w[c].dx : affine[c].dx;
        }
        if (divides)
            q = span.at(k.x, span.q);
        for (std::int32_t i = 0; i < k.n; ++i) {
            Inverse inverse{};
            if (divides)
                inverse = Inverse(unguarded(q));
            q += span.q.dx;
            typename SingleLane::T v[4];
            v[3] = SingleLane::from_units(color_one);
            for (int c = 0; c < channels; ++c) {
                v[c] = divides ? SingleLane::from_units(inner::projective_color(unguarded(at[c]), inverse))
                               : SingleLane::from_affine(static_cast<std::uint32_t>(at[c]));
                at[c] += by[c];
            }
            auto& stored = k.color[i / N::lanes];
            typename SingleLane::Color color{v[0], v[1], v[2], v[3]};
            if (adds) {
                lane_of(stored, i % N::lanes, color);
                color = {SingleLane::add(color.r, v[0]), SingleLane::add(color.g, v[1]),
                         SingleLane::add(color.b, v[2]), color.a};
            }
            set_lane(stored, i % N::lanes, color);
        }
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
