// Texture coordinates and levels of detail of packets must be the integers that single fragments get,
// whatever the planes and rows are.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "raster/chain/shared_rows.hpp"
#include "raster/ops/stage_lod_packet.hpp"
#include "raster/ops/stage_raw.hpp"
#include "raster/ops/stage_runs_packet.hpp"
#include "tests/support/random.hpp"

namespace spangle::raster::test {
namespace {

using spangle::test::Random;
using N = Raw565<8>;

struct Seen {
    std::int32_t x, y; ///< window position in pixels
    std::uint32_t s, t;
    std::int32_t lod;
};
std::vector<Seen> seen;

/// A chain stage that records the coordinates and level of each fragment, as the stages before left them.
void look(PlacesOf<N>& k, const Span<Fixed>& span) {
    for (std::int32_t i = 0; i < k.n; ++i) {
        const std::int32_t x = k.rows != nullptr ? static_cast<std::int32_t>(k.rows->x[i]) + span.anchor_x
                                                 : span.x + k.x + i,
                           y = k.rows != nullptr ? static_cast<std::int32_t>(k.rows->y[i]) + span.anchor_y
                                                 : span.y;
        seen.push_back({x, y, k.coord[0][i / 8].s[i % 8], k.coord[0][i / 8].t[i % 8], k.lod[0][i]});
    }
}

/// A primitive of random planes, whose rows lie one above the other.
class AnyPrimitive {
  public:
    explicit AnyPrimitive(std::uint32_t seed) : random_{seed} {
        surface_.color = surface_.depth = pixels_;
        span_.state = &state_;
        span_.target = &surface_;
        span_.kind = Kind::textured;
        choose_state();
        choose_rows();
        choose_planes();
        Variant& variant = state_.variant[static_cast<int>(Kind::textured)];
        variant.shares = random_.below(4) != 0;
        const ChainStage<N> stages[] = {&PacketRuns<PlacesOf<N>>::run<0>, &PacketLevels<PlacesOf<N>>::run<0>,
                                        &look};
        for (int i = 0; i < 3; ++i)
            variant.chain[i] = reinterpret_cast<AnyFunction>(stages[i]);
    }
    void expect_single_fragments() {
        seen.clear();
        chain_rows<N>(span_, rows_.data(), rows_.data() + rows_.size());
        std::sort(seen.begin(), seen.end(),
                  [](const Seen& a, const Seen& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
        auto next = seen.cbegin();
        for (const Row& row : rows_) {
            enter(span_, row);
            const LevelOfDetail lod(span_, 0);
            LevelOfDetail::Bounds bounds;
            const bool bounded = fit_words() && lod.bounds(span_.begin, span_.end - 1, bounds);
            CoordRuns run(span_, span_.begin, 0);
            std::int32_t end = span_.begin;
            for (std::int32_t x = span_.begin; x < span_.end; ++x, run.step(), ++next) {
                if (x == end)
                    end = run.begin(end);
                ASSERT_NE(next, seen.cend());
                ASSERT_EQ(next->x, span_.x + x);
                ASSERT_EQ(next->y, row.y);
                ASSERT_EQ(next->s, run.s) << x << " of " << span_.length << ", row " << row.y;
                ASSERT_EQ(next->t, run.t) << x << " of " << span_.length << ", row " << row.y;
                ASSERT_EQ(next->lod, lod.projective(x)) << x << " of " << span_.length << ", row " << row.y;
                if (!bounded)
                    continue;
                ASSERT_LE(bounds.least, next->lod) << x << " of " << span_.length << ", row " << row.y;
                ASSERT_GE(bounds.most, next->lod) << x << " of " << span_.length << ", row " << row.y;
            }
        }
        ASSERT_EQ(next, seen.cend());
    }
    /// Rows longer than the shortest runs must have runs as long as if each row were drawn alone.
    void expect_lengths() {
        const RowRuns runs(rows_.data(), static_cast<std::int32_t>(rows_.size()));
        RowRuns::Group group;
        for (std::size_t n = 0; n < rows_.size(); ++n) {
            if (n % 8 == 0) {
                group.number = static_cast<std::int32_t>(n / 8);
                find_runs(span_, 0, runs, group);
            }
            enter(span_, rows_[n]);
            if (span_.length > 1 << RunLimits(state_, 0).shortest) {
                ASSERT_EQ(static_cast<int>(group.log2[n % 8]), CoordRuns(span_, 0, 0).choose_log2()) << n;
            }
        }
    }
    std::size_t fragments() const { return seen.size(); }

  private:
    Random random_;
    DrawState state_;
    Texture texture_;
    Surface surface_{};
    std::uint8_t pixels_[8] = {};
    Span<Fixed> span_{};
    std::vector<Row> rows_;
    std::int32_t widest_ = 1;

    /// Whether 32 bits hold the values of all planes along the row, as they do inside of primitives.
    bool fit_words() const {
        const auto fits = [&](const Interpolant<std::uint64_t>& plane) {
            for (const std::int32_t x : {span_.begin, span_.end - 1}) {
                const std::int64_t v = static_cast<std::int64_t>(span_.at(x, plane)) >> guard_bits;
                if (v != static_cast<std::int32_t>(v))
                    return false;
            }
            return true;
        };
        const auto& unit = span_.unit[0];
        return fits(unit.s) && fits(unit.t) && fits(unit.shares_q ? span_.q : unit.q);
    }
    bool chance(std::uint32_t of) { return random_.below(of) == 0; }
    std::int32_t between(std::int32_t least, std::int32_t most) {
        return least + static_cast<std::int32_t>(random_.below(static_cast<std::uint32_t>(most - least + 1)));
    }
    /// Returns a random number of any size below 2^bits.
    std::int64_t number(int bits) {
        const std::int64_t all = std::int64_t{between(0, (1 << 24) - 1)} << 8 | between(0, 255);
        return (all >> (32 - bits)) >> random_.below(static_cast<std::uint32_t>(chance(2) ? bits : 1));
    }
    std::int64_t any_sign(int bits) { return chance(2) ? number(bits) : -number(bits); }

    void choose_state() {
        state_.tier = chance(2) ? Tier::balanced : Tier::fast;
#if SPANGLE_OWN_TIERS
        state_.knobs = knobs_of(state_.tier);
        if (chance(4)) {
            state_.knobs.texel_bits = static_cast<std::uint8_t>(between(0, 13));
            state_.knobs.shortest_run = static_cast<std::uint8_t>(between(0, 6));
            state_.knobs.longest_run = static_cast<std::uint8_t>(between(state_.knobs.shortest_run, 16));
        }
#endif
        const bool both = chance(2);
        state_.wraps[0].s = both || chance(2);
        state_.wraps[0].t = both || chance(2);
        state_.halves[0].s = chance(4);
        state_.halves[0].t = chance(4);
        state_.log2_width[0] = static_cast<std::uint8_t>(between(0, 11));
        state_.log2_height[0] = chance(2) ? state_.log2_width[0] : static_cast<std::uint8_t>(between(0, 11));
        const auto size = [&](int log2) {
            return static_cast<std::uint16_t>(chance(3) ? (1 << log2) - (1 << log2) / 3 : 1 << log2);
        };
        texture_.level[0].width = size(state_.log2_width[0]);
        texture_.level[0].height = size(state_.log2_height[0]);
        texture_.shape = chance(5) ? TextureShape::line : TextureShape::plane;
        state_.fragment.unit[0].texture = &texture_;
    }
    void choose_rows() {
        const std::int32_t lengths[] = {4, 16, 20, 70, 700};
        const std::int32_t longest = lengths[random_.below(5)], count = between(1, chance(2) ? 64 : 6);
        span_.anchor_x = between(-40, 200);
        span_.anchor_y = between(-40, 200);
        std::int32_t y = between(-100, 100);
        for (std::int32_t n = 0; n < count; ++n, y += between(1, 2)) {
            const std::int32_t left = between(-100, 100), length = between(1, longest);
            const std::int32_t first = chance(3) ? between(0, length - 1) : 0,
                               last = chance(3) ? between(first + 1, length) : length;
            rows_.push_back({y, left, left + length, left + first, left + last});
            widest_ = length > widest_ ? length : widest_;
        }
    }
    /// Returns a plane with the value `at`, and the values `right` and `up` at the edges.
    Interpolant<std::uint64_t> plane(std::int64_t at, std::int64_t right, std::int64_t up) {
        const auto per = [&](std::int64_t v, std::int64_t n) {
            return static_cast<std::uint64_t>(((v - at) << guard_bits) / n);
        };
        return {static_cast<std::uint64_t>(at << guard_bits) + random_.below(1 << 16),
                per(right, widest_ + 200), per(up, 400)};
    }
    void choose_planes() {
        auto& unit = span_.unit[0];
        unit.exponent = chance(4) ? between(-40, 40) : between(-3, 6);
        unit.s_base = between(-16, 16);
        unit.t_base = between(-16, 16);
        unit.shares_q = chance(2);
        unit.s = plane(any_sign(30), any_sign(30), any_sign(30));
        unit.t = plane(any_sign(30), any_sign(30), any_sign(30));
        auto& q = unit.shares_q ? span_.q : unit.q;
        if (chance(3)) {
            const std::int64_t near = number(29) + (1 << 20);
            q = plane(near, near + any_sign(20), near + any_sign(20));
        } else {
            const int bits = between(8, 30);
            const auto w = [&] { return chance(8) ? any_sign(bits) : number(bits); };
            q = plane(w(), w(), w());
        }
        if (chance(6))
            q.dx = 0;
        unit.s_dy = unit.s.dy;
        unit.t_dy = unit.t.dy;
        (unit.shares_q ? span_.q_dy : unit.q_dy) = q.dy;
    }
};

TEST(PacketRuns, AreThoseOfSingleFragments) {
    std::size_t fragments = 0;
    for (std::uint32_t seed = 0; seed < 8000 && !testing::Test::HasFatalFailure(); ++seed) {
        SCOPED_TRACE(seed);
        AnyPrimitive primitive(seed * 7919 + 1);
        primitive.expect_single_fragments();
        fragments += primitive.fragments();
    }
    EXPECT_GT(fragments, 1000000u);
}

TEST(PacketRuns, AreAsLongAsThoseOfSingleRows) {
    for (std::uint32_t seed = 0; seed < 20000 && !testing::Test::HasFatalFailure(); ++seed) {
        SCOPED_TRACE(seed);
        AnyPrimitive(seed * 7919 + 2).expect_lengths();
    }
}

/// Takes eight logarithms at once, also of numbers that a double or a float would round.
TEST(PacketRuns, LogarithmsAreThoseOfSingleNumbers) {
    using Vector = lane_words::Half;
    using Pair = inner::LongPair<Vector>;
    Random random{5};
    const auto word = [&] { return random.below(1 << 16) << 16 | random.below(1 << 16); };
    const auto number = [&] {
        const std::uint64_t v = std::uint64_t{word()} << 32 | word(), ones = ~std::uint64_t{0};
        const std::uint32_t down = random.below(64);
        return random.below(4) == 0   ? (ones >> down) - random.below(2)
               : random.below(2) == 0 ? v >> down
                                      : v & 1;
    };
    for (int round = 0; round < 100000; ++round) {
        const std::uint64_t v[4] = {number(), number(), number(), number()};
        const Vector found = inner::lane_log2(Pair{{v[0], v[2]}, {v[1], v[3]}});
        Vector words;
        for (int i = 0; i < 4; ++i) {
            ASSERT_EQ(static_cast<std::int32_t>(found[i]), log2_fraction8(v[i])) << v[i];
            words[i] = static_cast<std::uint32_t>(v[i] >> 33);
            words[i] = words[i] == 0 ? 1 : words[i];
        }
        const Vector of_words = inner::lane_log2(words);
        for (int i = 0; i < 4; ++i)
            ASSERT_EQ(static_cast<std::int32_t>(of_words[i]), log2_fraction8(words[i])) << words[i];
    }
}

} // namespace
} // namespace spangle::raster::test
