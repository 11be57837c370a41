// The pool of clipped vertices alone, with vertices that are numbers: which of them take() may give.
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "gl/vertex/clipped_vertex_pool.hpp"

namespace spangle::test {
namespace {

struct Corner {
    int number = 0;
};
/// A vertex of the pool is larger than the corner that a polygon points to.
struct Clipped : Corner {
    int more[6] = {};
};

/// A pool between two vertices that are not its own.
template <int Count> struct Surrounded {
    Clipped before;
    gl::ClippedVertexPool<Clipped, Count> pool;
    Clipped after;

    /// The indices of all vertices that the pool still gives, up to the one that is null.
    std::set<int> taken() {
        std::set<int> indices;
        for (int most = 0; most <= Count; ++most) {
            const Clipped* const vertex = pool.take();
            if (vertex == nullptr)
                return indices;
            EXPECT_TRUE(indices.insert(static_cast<int>(vertex - &pool[0])).second) << "given twice";
        }
        ADD_FAILURE() << "the pool gives more vertices than it has";
        return indices;
    }
    /// taken() after only the vertices with the given indices are corners.
    std::set<int> taken_beside(const std::initializer_list<int>& corners) {
        Corner* corner[2 * Count + 2];
        int n = 0;
        for (const int i : corners)
            corner[n++] = &pool[i];
        pool.keep(corner, n);
        return taken();
    }
};

template <int Count> std::set<int> all_but(const std::set<int>& some) {
    std::set<int> rest;
    for (int i = 0; i < Count; ++i)
        if (!some.contains(i))
            rest.insert(i);
    return rest;
}

TEST(ClippedVertexPoolAlone, GivesNothingBeforeItKnowsTheCorners) {
    Surrounded<4> fresh;
    EXPECT_EQ(fresh.pool.take(), nullptr);
}

TEST(ClippedVertexPoolAlone, GivesEachVertexOnceIfNoneIsACorner) {
    Surrounded<1> one;
    EXPECT_EQ(one.taken_beside({}), all_but<1>({}));
    Surrounded<7> some;
    EXPECT_EQ(some.taken_beside({}), all_but<7>({}));
    Surrounded<32> most; // all bits of the word that tells which vertices are free
    EXPECT_EQ(most.taken_beside({}), all_but<32>({}));
}

TEST(ClippedVertexPoolAlone, GivesNoCorner) {
    Surrounded<32> most;
    EXPECT_EQ(most.taken_beside({0}), all_but<32>({0}));
    EXPECT_EQ(most.taken_beside({31}), all_but<32>({31}));
    EXPECT_EQ(most.taken_beside({31, 0, 15, 16}), all_but<32>({0, 15, 16, 31}));
    Surrounded<1> one;
    EXPECT_EQ(one.taken_beside({0}), all_but<1>({0}));
}

/// A polygon may have one corner twice, where a plane touches it.
TEST(ClippedVertexPoolAlone, KeepsACornerThatComesTwice) {
    Surrounded<4> pool;
    EXPECT_EQ(pool.taken_beside({2, 1, 2}), all_but<4>({1, 2}));
}

TEST(ClippedVertexPoolAlone, GivesNothingIfAllVerticesAreCorners) {
    Surrounded<4> pool;
    EXPECT_TRUE(pool.taken_beside({0, 1, 2, 3}).empty());
    EXPECT_EQ(pool.pool.take(), nullptr);
}

/// Corners of a gathered polygon lie in the arena, before or after the pool.
TEST(ClippedVertexPoolAlone, TakesNoCornerElsewhereForItsOwn) {
    const auto parts = std::make_unique<Surrounded<5>>();
    Corner* const corners[] = {&parts->before, &parts->after, &parts->pool[4]};
    ASSERT_LT(&parts->before, static_cast<Clipped*>(corners[2]));
    parts->pool.keep(corners, 3);
    EXPECT_EQ(parts->taken(), all_but<5>({4}));
}

/// Each plane cuts corners off, whose vertices are free for the next plane.
TEST(ClippedVertexPoolAlone, GivesAVertexAgainThatIsNoCornerAnyMore) {
    Surrounded<3> pool;
    pool.pool.keep(static_cast<Corner**>(nullptr), 0);
    Corner* const first = pool.pool.take();
    Corner* const second = pool.pool.take();
    ASSERT_NE(first, nullptr);
    ASSERT_NE(second, nullptr);
    Corner* const left[] = {second};
    for (int plane = 0; plane < 100; ++plane) {
        pool.pool.keep(left, 1);
        EXPECT_NE(pool.pool.take(), second);
        EXPECT_NE(pool.pool.take(), second);
        ASSERT_EQ(pool.pool.take(), nullptr) << plane;
    }
}

TEST(ClippedVertexPoolAlone, LeavesTheValuesOfItsVertices) {
    Surrounded<4> pool;
    for (int i = 0; i < 4; ++i)
        pool.pool[i].number = 10 + i;
    pool.taken_beside({1});
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(pool.pool[i].number, 10 + i);
}

} // namespace
} // namespace spangle::test
