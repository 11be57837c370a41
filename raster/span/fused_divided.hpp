// Rows of which every fragment divides: the fragments of many rows side by side, so that no lane is idle.
#pragma once

#include "raster/span/fused_groups.hpp"
#include "raster/span/stage_lit.hpp"

namespace spangle::raster {

/// 1/w along a row of n fragments.
class InverseRow {
  public:
    SPANGLE_INLINE InverseRow(const PlaneRow& row, std::int32_t n)
        : at_(row.at(0, row.q)), by_(row.q.dx), last_(n - 1) {}
    SPANGLE_INLINE int zeros(std::int32_t i) const {
        return Inverse(unguarded(at_ + static_cast<std::uint64_t>(std::int64_t{i}) * by_)).zeros;
    }
    /// Where those end that have as many leading zeros as the i-th.
    SPANGLE_INLINE std::int32_t alike(std::int32_t i) const {
        const int of = zeros(i);
        if (zeros(last_) == of) [[likely]]
            return last_ + 1;
        while (zeros(++i) == of)
            ;
        return i;
    }

  private:
    std::uint64_t at_, by_;
    std::int32_t last_;
};

/// Fragments that passed the depth test, on their way to the surface. Case has: Test, LitPlanes,
/// LitFragments.
template <class Case> class LitPacket {
  public:
    using L = Lanes<8>;
    SPANGLE_INLINE explicit LitPacket(const PlaneRow& at) : test_(at, 0), planes_(at, 0), fragments_(at) {}

    /// A piece of a row whose 1/w begins with so many zeros.
    SPANGLE_INLINE void add(PlaneRow& at, const Row& piece, std::int32_t room, int zeros) {
        if (zeros != zeros_)
            flush();
        zeros_ = zeros;
        Px<ExactLanes> p(at);
        each_group<Case::key.format>(
            *this, p, at, *at.planes.target, piece, room, [&](std::int32_t n) __attribute__((always_inline)) {
                if (!test_(p))
                    return;
                planes_.store(values_, count_);
                groups_[group_count_++] = {p.live, p.color_plane + 2 * p.i, count_};
                count_ += n;
                if (count_ > LitValues::most)
                    flush();
            });
    }
    SPANGLE_INLINE void start(const PlaneRow& at, std::int32_t x) {
        test_.start(at, x);
        planes_.start(at, x);
    }
    SPANGLE_INLINE void step() {
        test_.step();
        planes_.step();
    }
    /// To the surface.
    void flush() {
        if (count_ == 0)
            return;
        planes_.pad(values_, count_);
        fragments_.finish(values_, count_, zeros_);
        for (int i = 0; i < group_count_; ++i) {
            using Target = Words565<L, Case::key.format>;
            const Group& group = groups_[i];
            const L::U16 word = fragments_.words(group.first);
            Target::store(group.color, L::select(group.live, word, Target::load(group.color)));
        }
        count_ = group_count_ = 0;
    }

  private:
    struct Group {
        L::Mask live;
        std::uint8_t* color;
        std::int32_t first; ///< of its fragments in the packet
    };
    typename Case::Test test_;
    typename Case::Planes planes_;
    typename Case::Fragments fragments_;
    LitValues values_;
    Group groups_[LitValues::size];
    std::int32_t count_ = 0;
    int group_count_ = 0, zeros_ = 0;
};

/// `narrow` draws what there are no lanes for.
template <class Case, class Narrow>
SPANGLE_INLINE void fused_divided_rows(Span<Fixed>& span, const Row* row, const Row* end, Narrow narrow) {
    const Rect& clip = span.state->fragment.scissor;
    const std::int32_t room = clip.x + clip.w - 8;
    PlaneRow at{span, nullptr, nullptr, row->first, row->y, row->first};
    LitPacket<typename Case::Lit> packet(at);
    do {
        at.x = row->first;
        at.y = row->y;
        const InverseRow inverse(at, row->last - row->first);
        Row piece = *row;
        do {
            const std::int32_t i = piece.first - row->first;
            piece.last = row->first + inverse.alike(i);
            const int zeros = inverse.zeros(i);
            if (Case::Lit::Fragments::takes(span, zeros)) [[likely]]
                packet.add(at, piece, room, zeros);
            else
                narrow(span, piece);
            piece.first = piece.last;
        } while (piece.first != row->last);
    } while (++row != end);
    packet.flush();
}

} // namespace spangle::raster
