// The gathered polygon alone, with an arena of its own: which corners it keeps, and what a full arena costs.
#include <memory>

#include <gtest/gtest.h>

#include "gl/vertex/gathered_polygon.hpp"

namespace spangle::test {
namespace {

struct Corner {
    int number = -1;
    int more[9] = {};
};
/// Corners of one byte reach the greatest number of corners in little memory.
struct Mark {
    unsigned char value = 7;
};

class GatheredPolygonAlone : public testing::Test {
  protected:
    static constexpr int first_room = 8; ///< number of corners that the first block holds

    const std::unique_ptr<gl::Context> context_ = std::make_unique<gl::Context>();
    gl::Arena arena_;

    void give(std::size_t bytes) {
        memory_ = std::make_unique<std::uint64_t[]>(bytes / sizeof(std::uint64_t));
        arena_.give(memory_.get(), bytes);
        context_->arena = &arena_;
    }
    /// Adds corners with the numbers from `first` on. Returns how many the polygon took.
    int add(gl::GatheredPolygon<Corner>& polygon, int first, int n) {
        for (int i = 0; i < n; ++i) {
            Corner* const corner = polygon.add(*context_);
            if (corner == nullptr)
                return i;
            EXPECT_EQ(corner->number, -1) << "a new corner has its initial values";
            corner->number = first + i;
        }
        return n;
    }
    static void expect_numbers(const gl::GatheredPolygon<Corner>& polygon, int n) {
        ASSERT_EQ(polygon.count(), n);
        for (int i = 0; i < n; ++i)
            EXPECT_EQ(polygon[i].number, i);
    }

  private:
    std::unique_ptr<std::uint64_t[]> memory_;
};

TEST_F(GatheredPolygonAlone, TakesNoMemoryBeforeTheFirstCorner) {
    give(4096);
    gl::GatheredPolygon<Corner> polygon;
    EXPECT_EQ(polygon.count(), 0);
    EXPECT_EQ(arena_.used(), 0u);
    polygon.free(*context_);
    EXPECT_FALSE(polygon.has_failed());
    EXPECT_EQ(arena_.used(), 0u);
}

TEST_F(GatheredPolygonAlone, KeepsAllCornersInOrderWhileItGrows) {
    give(1 << 18);
    gl::GatheredPolygon<Corner> polygon;
    for (int n = 0; n < 1000; ++n) {
        ASSERT_EQ(add(polygon, n, 1), 1);
        if (n % 97 == 0 || (n & (n - 1)) == 0)
            expect_numbers(polygon, n + 1);
    }
    expect_numbers(polygon, 1000);
    EXPECT_FALSE(polygon.has_failed());
}

/// A context that is destroyed frees the corners of a polygon that has not ended.
TEST_F(GatheredPolygonAlone, TellsTheContextWhereItsMemoryIs) {
    give(1 << 16);
    gl::GatheredPolygon<Corner> polygon;
    for (int n = 0; n < 100; ++n) {
        add(polygon, n, 1);
        ASSERT_EQ(context_->render.gathered, &polygon[0]);
    }
    polygon.free(*context_);
    EXPECT_EQ(context_->render.gathered, nullptr);
}

TEST_F(GatheredPolygonAlone, GivesAllMemoryBack) {
    give(1 << 16);
    gl::GatheredPolygon<Corner> polygon;
    for (const int n : {1, first_room, first_room + 1, 200}) {
        ASSERT_EQ(add(polygon, 0, n), n);
        EXPECT_GT(arena_.used(), 0u);
        polygon.free(*context_);
        EXPECT_EQ(polygon.count(), 0);
        EXPECT_EQ(arena_.used(), 0u) << n << " corners";
    }
}

/// A block is freed when a larger one replaces it, so that the polygon holds one block.
TEST_F(GatheredPolygonAlone, HoldsOneBlock) {
    give(1 << 16);
    gl::GatheredPolygon<Corner> polygon;
    add(polygon, 0, 2 * first_room);
    const std::size_t grown = arena_.used();
    EXPECT_LT(grown, sizeof(Corner) * 2 * first_room + 64);
    add(polygon, 2 * first_room, 1);
    EXPECT_LT(arena_.used(), sizeof(Corner) * 4 * first_room + 64);
}

TEST_F(GatheredPolygonAlone, FailsIfTheArenaHasNoRoomForTheFirstCorner) {
    give(128);
    gl::GatheredPolygon<Corner> polygon;
    EXPECT_EQ(add(polygon, 0, 1), 0);
    EXPECT_TRUE(polygon.has_failed());
    EXPECT_EQ(polygon.count(), 0);
    EXPECT_EQ(arena_.used(), 0u);
    EXPECT_EQ(context_->render.gathered, nullptr);
    polygon.free(*context_);
    EXPECT_FALSE(polygon.has_failed());
}

/// The arena has room for the first block, but not for a second one beside it.
TEST_F(GatheredPolygonAlone, KeepsItsCornersIfItCannotGrow) {
    give(sizeof(Corner) * 2 * first_room);
    gl::GatheredPolygon<Corner> polygon;
    EXPECT_EQ(add(polygon, 0, 20), first_room);
    EXPECT_TRUE(polygon.has_failed());
    expect_numbers(polygon, first_room);
    EXPECT_EQ(context_->render.gathered, &polygon[0]);
    polygon.free(*context_);
    EXPECT_EQ(arena_.used(), 0u);
    EXPECT_FALSE(polygon.has_failed());
    EXPECT_EQ(add(polygon, 0, first_room), first_room);
    expect_numbers(polygon, first_room);
}

/// A polygon that has lost a corner stays incomplete, even if the arena has room for later corners.
TEST_F(GatheredPolygonAlone, RemembersACornerThatItLost) {
    give(sizeof(Corner) * 4 * first_room);
    void* const other = arena_.allocate(sizeof(Corner) * 2 * first_room);
    ASSERT_NE(other, nullptr);
    gl::GatheredPolygon<Corner> polygon;
    EXPECT_EQ(add(polygon, 0, first_room + 1), first_room);
    arena_.free(other);
    EXPECT_EQ(add(polygon, first_room, 1), 1);
    EXPECT_TRUE(polygon.has_failed());
}

TEST_F(GatheredPolygonAlone, FailsBeforeItsSizeOverflows) {
    give(4 << 20);
    constexpr int most = 1 << 19;
    gl::GatheredPolygon<Mark> polygon;
    for (int i = 0; i < most; ++i) {
        Mark* const mark = polygon.add(*context_);
        ASSERT_NE(mark, nullptr) << i;
        mark->value = static_cast<unsigned char>(i);
    }
    EXPECT_FALSE(polygon.has_failed());
    EXPECT_EQ(polygon.add(*context_), nullptr);
    EXPECT_TRUE(polygon.has_failed());
    ASSERT_EQ(polygon.count(), most);
    for (int i = 0; i < most; ++i)
        ASSERT_EQ(polygon[i].value, static_cast<unsigned char>(i));
    polygon.free(*context_);
    EXPECT_EQ(arena_.used(), 0u);
}

} // namespace
} // namespace spangle::test
