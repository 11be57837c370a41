// Gathers the fragments of many rows side by side, where all planes are affine and there is a texture. So few
// lanes are idle, and the texels of many fragments are fetched together.
#pragma once

#include "raster/fused/groups.hpp"
#include "raster/ops/row_planes.hpp"
#include "raster/ops/stage_fog.hpp"
#include "raster/ops/stage_lanes.hpp"
#include "raster/ops/stage_store.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

/// Fragments that have passed the depth test and wait to be stored. Case has Test, Texture, Fog, FogColor,
/// fogged, gray, tested and key.
template <class Case> class GatheredPacket {
  public:
    using N = typename Case::N;
    using L = typename N::L;
    /// At most `most` fragments are in the packet when a group is added. `size` is the room for fragments.
    static constexpr std::int32_t most = 120, size = most + 16;
    using Values = std::uint16_t[size];

    SPANGLE_INLINE explicit GatheredPacket(const PlaneRow& at) : texture_(at, 0), fog_(at, 0) {}

    SPANGLE_INLINE static void store(Values& to, std::ptrdiff_t i, const typename L::U16& v) {
        __builtin_memcpy(to + i, &v, 16);
    }
    /// A group of eight lanes in the packet: its live lanes, the address of its pixels, and the number of its
    /// first fragment.
    struct Group {
        typename L::Mask live;
        std::uint8_t* color;
        std::ptrdiff_t first;
    };
    Group groups[size];

    /// Stores all `count` fragments, whose groups end at `end`.
    [[gnu::noinline]] void flush(std::ptrdiff_t count, const Group* end) {
        pad_group(count);
        for (std::ptrdiff_t i = 0; i < count; i += 8)
            finish(i);
        for (const Group* group = groups; group != end; ++group)
            L::store(group->color, L::select(group->live, load(words_, group->first), L::load(group->color)));
    }

    alignas(16) Values index, colors[3], fogs, thresholds;

  private:
    SPANGLE_INLINE static typename L::U16 load(const Values& from, std::ptrdiff_t i) {
        typename L::U16 v;
        __builtin_memcpy(&v, from + i, 16);
        return v;
    }
    /// Fragments behind the last one get the first texel of the image.
    SPANGLE_INLINE void pad_group(std::ptrdiff_t count) {
        const typename L::U16 none = L::splat(0);
        store(index, count, none);
        for (Values& values : colors)
            store(values, count, none);
        store(fogs, count, none);
    }
    SPANGLE_INLINE void finish(std::ptrdiff_t i) {
        Px<N> p;
        p.color.r = load(colors[0], i);
        p.color.g = Case::gray ? p.color.r : load(colors[1], i);
        p.color.b = Case::gray ? p.color.r : load(colors[2], i);
        p.color.a = N::from_units(color_one);
        const typename L::U16 f = load(fogs, i);
        if constexpr (Case::fogged)
            FogLight<N>::apply_fog(p, f);
        texture_.combine_words(p, texture_.words_of(index + i));
        if constexpr (Case::fogged)
            fog_.add(p, f);
        typename L::U16 word;
        if constexpr (counts_steps(Case::key))
            word = steps565<N>(p.color, load(thresholds, i) >> 1);
        else if constexpr (Case::key.dither)
            word = dithered565_lanes<N>(p.color, load(thresholds, i));
        else
            word = truncated565<N>(p.color);
        store(words_, i, Words565<L, Case::key.format>::to_wire_order(word));
    }

    typename Case::Texture texture_;
    typename Case::FogColor fog_;
    alignas(16) Values words_; ///< words of pixels, in the byte order of the surface
};

/// The planes of gathered fragments, walked from group to group.
template <class Case> class GatheredPlanes {
  public:
    using N = typename Case::N;
    using L = typename N::L;
    using Packet = GatheredPacket<Case>;

    /// Starts at the row and the column of `at`. The planes are valid from this row up, and from this column
    /// to the right.
    SPANGLE_INLINE explicit GatheredPlanes(const PlaneRow& at)
        : texture_(at, 0), fog_is_inside_(Case::fogged && at.fog_inside), planes_(planes(at)),
          thresholds_(at.x, at.y) {}
    SPANGLE_INLINE bool takes() const { return texture_.is_small(); }
    SPANGLE_INLINE void next_row() { planes_.next_row(); }
    SPANGLE_INLINE void to_row(std::int32_t y) { planes_.to_row(y); }
    /// Starts at column x of the row in which the planes are.
    SPANGLE_INLINE void start(const PlaneRow& at, std::int32_t x) { start(at.x + x, at.y); }
    SPANGLE_INLINE void start(std::int32_t x, std::int32_t y) {
        planes_.start(x);
        thresholds_ = Thresholds(x, y);
    }
    SPANGLE_INLINE void step() { planes_.step(); }
    /// Tests eight fragments and puts them at place i of the packet. Returns false where no fragment has
    /// passed.
    SPANGLE_INLINE bool put(Packet& to, Px<N>& p, std::ptrdiff_t i, typename Packet::Group& group) {
        if (!Case::Test::test(p.live, p.depth_plane + p.bytes(), planes_.template high<0>()))
            return false;
        Packet::store(to.index, i, texture_.index_at(planes_.template high<1>(), planes_.template high<2>()));
        Packet::store(to.colors[0], i, planes_.template high<3>());
        if constexpr (!Case::gray) {
            Packet::store(to.colors[1], i, planes_.template high<4>());
            Packet::store(to.colors[2], i, planes_.template high<5>());
        }
        if constexpr (Case::fogged)
            Packet::store(to.fogs, i, fog_factor());
        if constexpr (Case::key.dither)
            Packet::store(to.thresholds, i, thresholds_.word(0));
        group = {p.live, p.color_plane + p.bytes(), i};
        return true;
    }

  private:
    static constexpr int fog = Case::gray ? 4 : 6;
    using Thresholds = std::conditional_t<Case::key.dither, inner::KeptThresholds<N>, inner::NoThreshold>;
    using Planes = LanePlanes<fog + (Case::fogged ? 1 : 0)>;

    /// The fog factor, as FogFactorLanes::factor() makes it.
    SPANGLE_INLINE typename L::U16 fog_factor() const {
        return fog_is_inside_ ? planes_.template high<fog>()
                              : N::clamped_fraction(planes_.template words<fog>());
    }
    SPANGLE_INLINE Planes planes(const PlaneRow& at) const {
        const auto s = texture_.s_plane(at, 0), t = texture_.t_plane(at, 0);
        const auto& c = at.color_value;
        if constexpr (Case::gray && Case::fogged)
            return Planes(at, 0, at.z, s, t, c[0], Case::Fog::plane_of(at));
        else if constexpr (Case::gray)
            return Planes(at, 0, at.z, s, t, c[0]);
        else if constexpr (Case::fogged)
            return Planes(at, 0, at.z, s, t, c[0], c[1], c[2], Case::Fog::plane_of(at));
        else
            return Planes(at, 0, at.z, s, t, c[0], c[1], c[2]);
    }

    typename Case::Texture texture_;
    const bool fog_is_inside_;
    Planes planes_;
    [[no_unique_address]] Thresholds thresholds_; ///< thresholds stay: eight columns are two periods
};

/// Draws rows of a primitive through a packet. All other data is kept in registers; the packet has an
/// address.
template <class Case> class GatheredRows {
  public:
    using Packet = GatheredPacket<Case>;
    SPANGLE_INLINE GatheredRows(const PlaneRow& at, Packet& packet)
        : planes_(at), fragment_(at), packet_(packet), group_end_(packet.groups) {}
    SPANGLE_INLINE bool takes() const { return planes_.takes(); }

    /// Draws columns [first, last) of row y, whose address is `row`. The row must come after the row that was
    /// drawn last. The scissor rectangle must hold seven more columns.
    SPANGLE_INLINE void draw(const RowPlace& row, std::int32_t y, std::int32_t first, std::int32_t last) {
        planes_.start(first, y);
        each_whole_group<true>(
            planes_, fragment_, row, first,
            last, [&](std::int32_t n) __attribute__((always_inline)) { group(n < 8 ? n : 8); });
    }
    SPANGLE_INLINE void next_row() { planes_.next_row(); }
    /// Draws a row of a primitive. The last group in the scissor rectangle starts at column `room`.
    SPANGLE_INLINE void draw(PlaneRow& at, const Surface& target, const Row& row, std::int32_t room) {
        planes_.to_row(row.y);
        if (row.last <= room) [[likely]]
            return draw(row_of<Case>(target, row.y), row.y, row.first, row.last);
        each_group<Case::key.format>(
            planes_, fragment_, at, target, row,
            room, [&](std::int32_t n) __attribute__((always_inline)) { group(n); });
    }
    SPANGLE_INLINE void flush() {
        packet_.flush(fragment_count_, group_end_);
        group_end_ = packet_.groups;
        fragment_count_ = 0;
    }

  private:
    /// Puts a group into the packet. All its live lanes are among the first n.
    SPANGLE_INLINE void group(std::int32_t n) {
        if (!planes_.put(packet_, fragment_, fragment_count_, *group_end_))
            return;
        ++group_end_;
        fragment_count_ += n;
        if (fragment_count_ > Packet::most) [[unlikely]]
            flush();
    }

    GatheredPlanes<Case> planes_;
    Px<typename Case::N> fragment_;
    Packet& packet_;
    typename Packet::Group* group_end_;
    std::ptrdiff_t fragment_count_ = 0; ///< fragments in the packet
};

/// Draws rows in any order. Returns false, and draws nothing, where the image is too large for the packet.
template <class Case>
SPANGLE_INLINE bool fused_gathered_rows(Span<Fixed>& span, const Row* row, const Row* end) {
    const Rect& clip = span.state->fragment.scissor;
    const std::int32_t room = clip.x + clip.w - 8;
    PlaneRow at{span, nullptr, nullptr, clip.x, clip.y, clip.x};
    GatheredPacket<Case> packet(at);
    GatheredRows<Case> rows(at, packet);
    if (!rows.takes()) [[unlikely]]
        return false;
    const Surface target = *span.target; // a copy, which stays in registers
    do
        rows.draw(at, target, *row, room);
    while (++row != end);
    rows.flush();
    return true;
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
