// Rows of textured fragments whose planes are affine: those of many rows side by side, so that few lanes are
// idle, and the texels of many are fetched at a time.
#pragma once

#include "raster/span/fused_groups.hpp"
#include "raster/span/stage_fog.hpp"
#include "raster/span/stage_lanes.hpp"
#include "raster/span/stage_store.hpp"

namespace spangle::raster {

/// Fragments that passed the depth test, on their way to the surface. Case has: Test, Color, Texture, Coords,
/// Fog, FogColor (or None), fogged, gray, key.
template <class Case> class GatheredPacket {
  public:
    using N = typename Case::N;
    using L = typename N::L;
    static constexpr std::int32_t most = 120, size = most + 16; ///< what is held between two groups
    using Values = std::uint16_t[size];

    SPANGLE_INLINE explicit GatheredPacket(const PlaneRow& at) : texture_(at, 0), fog_(at, 0) {}

    SPANGLE_INLINE static void store(Values& to, std::int32_t i, const typename L::U16& v) {
        __builtin_memcpy(to + i, &v, 16);
    }
    /// A group whose first fragment is the i-th.
    SPANGLE_INLINE void place(typename L::Mask live, std::uint8_t* color, std::int32_t i) {
        groups_[group_count_++] = {live, color, i};
    }
    /// All `count` fragments to the surface.
    [[gnu::noinline]] void flush(std::int32_t count) {
        pad(count);
        for (std::int32_t i = 0; i < count; i += 8)
            finish(i);
        for (const Group* group = groups_; group != groups_ + group_count_; ++group)
            Words565<L, Case::key.format>::store_where(group->live, group->color, load(words_, group->first));
        group_count_ = 0;
    }

    alignas(16) Values index, colors[3], fogs;

  private:
    struct Group {
        typename L::Mask live;
        std::uint8_t* color;
        std::int32_t first; ///< of its fragments in the packet
    };

    SPANGLE_INLINE static typename L::U16 load(const Values& from, std::int32_t i) {
        typename L::U16 v;
        __builtin_memcpy(&v, from + i, 16);
        return v;
    }
    /// Fragments behind the last one look at the first texel.
    SPANGLE_INLINE void pad(std::int32_t count) {
        const typename L::U16 none = L::splat(0);
        store(index, count, none);
        for (Values& values : colors)
            store(values, count, none);
        store(fogs, count, none);
    }
    SPANGLE_INLINE void finish(std::int32_t i) {
        Px<N> p;
        p.color.r = load(colors[0], i);
        p.color.g = Case::gray ? p.color.r : load(colors[1], i);
        p.color.b = Case::gray ? p.color.r : load(colors[2], i);
        p.color.a = N::from_units(color_one);
        const typename L::U16 f = load(fogs, i);
        if constexpr (Case::fogged)
            FogLight<N>::dim(p, f);
        texture_.combine_words(p, texture_.words_of(index + i));
        if constexpr (Case::fogged)
            fog_.add(p, f);
        store(words_, i, truncated565<N>(p.color));
    }

    typename Case::Texture texture_;
    typename Case::FogColor fog_;
    alignas(16) Values words_;
    Group groups_[size];
    int group_count_ = 0;
};

/// What is interpolated: apart from the packet, which has an address, this is in registers.
template <class Case> class GatheredPlanes {
  public:
    using N = typename Case::N;
    using Packet = GatheredPacket<Case>;

    SPANGLE_INLINE explicit GatheredPlanes(const PlaneRow& at)
        : test_(at, 0), color_(at, 0), coords_(at, 0), fog_(at, 0) {}
    SPANGLE_INLINE bool takes() const { return coords_.is_small(); }
    SPANGLE_INLINE void start(const PlaneRow& at, std::int32_t x) {
        test_.start(at, x);
        color_.start(at, x);
        coords_.start(at, x);
        fog_.start(at, x);
    }
    SPANGLE_INLINE void step() {
        test_.step();
        color_.step();
        coords_.step();
        fog_.step();
    }
    /// To the i-th place of the packet; false where no fragment passed.
    SPANGLE_INLINE bool put(Packet& to, Px<N>& p, std::int32_t i) {
        if (!test_(p))
            return false;
        color_(p);
        Packet::store(to.index, i, coords_.index());
        Packet::store(to.colors[0], i, p.color.r);
        if constexpr (!Case::gray) {
            Packet::store(to.colors[1], i, p.color.g);
            Packet::store(to.colors[2], i, p.color.b);
        }
        if constexpr (Case::fogged)
            Packet::store(to.fogs, i, fog_.factor());
        to.place(p.live, p.color_plane + 2 * p.i, i);
        return true;
    }

  private:
    typename Case::Test test_;
    typename Case::Color color_;
    typename Case::Coords coords_;
    typename Case::Fog fog_;
};

/// False: nothing is drawn, there is too large an image for it.
template <class Case>
SPANGLE_INLINE bool fused_gathered_rows(Span<Fixed>& span, const Row* row, const Row* end) {
    const Rect& clip = span.state->fragment.scissor;
    const std::int32_t room = clip.x + clip.w - 8;
    PlaneRow at{span, nullptr, nullptr, row->first, row->y, row->first};
    GatheredPlanes<Case> planes(at);
    if (!planes.takes()) [[unlikely]]
        return false;
    GatheredPacket<Case> packet(at);
    std::int32_t count = 0;
    do {
        Px<typename Case::N> p(at);
        each_group<Case::key.format>(
            planes, p, at, *span.target, *row, room, [&](std::int32_t n) __attribute__((always_inline)) {
                count += planes.put(packet, p, count) ? n : 0;
                if (count > packet.most) [[unlikely]] {
                    packet.flush(count);
                    count = 0;
                }
            });
    } while (++row != end);
    packet.flush(count);
    return true;
}

} // namespace spangle::raster
