// Tests the order of baked triangles: they are the same triangles with the same winding, and fewer vertices
// are processed.
#include <algorithm>
#include <array>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "host_sim/bake/vertex_cache.hpp"

namespace spangle::bake {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Returns a triangle from its least vertex on, so that equal triangles of equal winding are the same.
Triangle canonical(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    Triangle t{a, b, c};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

std::map<Triangle, int> triangles_of(const IndexList& list) {
    std::map<Triangle, int> out;
    for (std::size_t i = 0; i + 2 < list.size(); i += 3)
        ++out[canonical(list[i], list[i + 1], list[i + 2])];
    return out;
}

/// Returns the triangles of a strip as GL cuts it (GL 1.3, 2.6.1), without those that have no area.
std::map<Triangle, int> triangles_of_strip(const IndexList& strip) {
    std::map<Triangle, int> out;
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
        const std::uint32_t a = strip[i], b = strip[i + 1], c = strip[i + 2];
        if (a != b && b != c && c != a)
            ++out[i % 2 == 0 ? canonical(a, b, c) : canonical(b, a, c)];
    }
    return out;
}

/// Returns a grid of side x side squares, with its triangles in random order.
IndexList shuffled_grid(std::uint32_t side, unsigned seed) {
    std::vector<Triangle> list;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t a = y * (side + 1) + x, b = a + 1, c = a + side + 2, d = a + side + 1;
            list.push_back({a, b, c});
            list.push_back({c, d, a});
        }
    std::shuffle(list.begin(), list.end(), std::mt19937(seed));
    IndexList out;
    for (const Triangle& t : list)
        out.insert(out.end(), t.begin(), t.end());
    return out;
}

IndexList renumbered(IndexList list, std::size_t vertices) {
    const std::vector<std::uint32_t> place = first_use_order(list, vertices);
    for (std::uint32_t& index : list)
        index = place[index];
    return list;
}

TEST(VertexCache, CountsAsTheLibraryKeepsVertices) {
    EXPECT_EQ(cache_misses({0, 1, 2, 0, 1, 2}, 3), 3u);
    EXPECT_EQ(cache_misses({0, 3, 0, 3}, 3), 4u) << "both live in entry 0";
    EXPECT_EQ(cache_misses({0, 1, 2, 3, 0}, 4), 4u);
    EXPECT_EQ(cache_misses({}, 4), 0u);
}

TEST(VertexCache, OrderKeepsTrianglesAndSavesVertices) {
    for (const unsigned entries : {1u, 8u, 16u, 32u, 80u})
        for (const unsigned seed : {1u, 2u, 3u}) {
            const IndexList given = shuffled_grid(24, seed);
            const IndexList ordered = order_triangles(given, 625, entries);
            ASSERT_EQ(triangles_of(ordered), triangles_of(given));
            const double each = static_cast<double>(cache_misses(renumbered(ordered, 625), entries)) / 1152;
            if (entries >= 16) {
                EXPECT_LT(each, entries >= 32 ? 0.72 : 0.85) << entries << " entries";
            }
        }
    EXPECT_TRUE(order_triangles({}, 0, 8).empty());
}

TEST(VertexCache, StripsAreTheSameTrianglesWithTheirWinding) {
    for (const unsigned seed : {4u, 5u, 6u})
        for (const std::size_t reach : {std::size_t{0}, std::size_t{7}, std::size_t{10000}}) {
            const IndexList given = order_triangles(shuffled_grid(12, seed), 169, 32);
            const IndexList strip = make_strip(given, reach);
            ASSERT_EQ(triangles_of_strip(strip), triangles_of(given)) << "reach " << reach;
            if (reach == 10000) {
                EXPECT_LT(strip.size(), given.size());
            }
        }
    // Vertices are random, so edges belong to many triangles, in both directions.
    std::mt19937 random(9);
    IndexList soup;
    while (soup.size() < 600) {
        const std::uint32_t a = random() % 20, b = random() % 20, c = random() % 20;
        if (a != b && b != c && c != a)
            soup.insert(soup.end(), {a, b, c});
    }
    EXPECT_EQ(triangles_of_strip(make_strip(soup, 600)), triangles_of(soup));
}

TEST(VertexCache, NumbersComeInTheOrderOfUse) {
    const IndexList list{5, 3, 5, 0, 3, 1};
    EXPECT_EQ(renumbered(list, 7), (IndexList{0, 1, 0, 2, 1, 3}));
    EXPECT_EQ(first_use_order(list, 7)[6], unused);
}

} // namespace
} // namespace spangle::bake
