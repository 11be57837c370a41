// The cache of vertices, with a policy whose window vertices are single numbers.
#include <memory>

#include <gtest/gtest.h>

#include "gl/vertex/vertex_cache.hpp"

namespace spangle::test {
namespace {

struct NumberMath {
    struct Window {
        int number;
    };
    using Place = int;
    static void keep_place(const Window& window, int& place) { place = window.number; }
    static void take_place(int place, Window& window) { window.number = place; }
};

class VertexCacheAlone : public testing::Test {
  protected:
    using Cache = gl::VertexCache<NumberMath>;
    using Vertex = gl::Vertex<NumberMath>;

    const std::unique_ptr<Cache> cache_ = std::make_unique<Cache>();
    int transforms_ = 0;
    unsigned flags_ = 0; ///< flags of all vertices that are transformed

    static Vertex vertex(int x, int w = 1) {
        Vertex v;
        v.position[0] = numeric::from_i32(x);
        v.position[3] = numeric::from_i32(w);
        return v;
    }
    /// Places a vertex. Its number counts how many vertices were transformed before.
    int place(Vertex v) {
        cache_->place(v, gl::uncolored, [this](Vertex& fresh) {
            fresh.window.number = transforms_++;
            fresh.flags = flags_;
        });
        return v.window.number;
    }
    /// Gives as many vertices as it takes until the cache keeps positions.
    void keep_positions() {
        for (std::size_t i = 0; i < Cache::position_count(); ++i)
            place(vertex(-1));
        transforms_ = 0;
    }
};

TEST_F(VertexCacheAlone, TransformsAPositionOnce) {
    keep_positions();
    EXPECT_EQ(place(vertex(1)), 0);
    EXPECT_EQ(place(vertex(2)), 1);
    EXPECT_EQ(place(vertex(1)), 0);
    EXPECT_EQ(place(vertex(2)), 1);
    cache_->invalidate();
    EXPECT_EQ(place(vertex(1)), 2);
}

TEST_F(VertexCacheAlone, GivesKnownFlagsToAKeptPosition) {
    keep_positions();
    place(vertex(1));
    Vertex v = vertex(1);
    v.flags = gl::edge_flag;
    cache_->place(v, gl::uncolored, [](Vertex&) { FAIL(); });
    EXPECT_EQ(v.flags, gl::uncolored);
}

TEST_F(VertexCacheAlone, KeepsNoPositionWithAnotherW) {
    keep_positions();
    EXPECT_EQ(place(vertex(1, 2)), 0);
    EXPECT_EQ(place(vertex(1, 2)), 1);
    EXPECT_EQ(place(vertex(1)), 2);
    EXPECT_EQ(place(vertex(1, 2)), 3);
}

/// A vertex that is outside of a plane, or that is not projected, is processed each time.
TEST_F(VertexCacheAlone, KeepsNoVertexWithFlags) {
    keep_positions();
    flags_ = gl::unprojected;
    EXPECT_EQ(place(vertex(1)), 0);
    EXPECT_EQ(place(vertex(1)), 1);
    flags_ = gl::uncolored;
    EXPECT_EQ(place(vertex(1)), 2);
    EXPECT_EQ(place(vertex(1)), 2);
}

TEST_F(VertexCacheAlone, KeepsElementsDuringAFewVertices) {
    const auto context = std::make_unique<gl::Context>();
    cache_->hold_elements(*context, 100);
    cache_->invalidate();
    Vertex& kept = cache_->element(5);
    cache_->stamp(kept);
    for (std::size_t i = 1; i < Cache::position_count(); ++i)
        place(vertex(1));
    EXPECT_EQ(transforms_, static_cast<int>(Cache::position_count()) - 1);
    EXPECT_TRUE(cache_->is_valid(cache_->element(5)));
}

TEST_F(VertexCacheAlone, ForgetsElementsWhereItKeptPositions) {
    const auto context = std::make_unique<gl::Context>();
    cache_->hold_elements(*context, 100);
    cache_->invalidate();
    for (std::uint32_t i = 0; i < 100; ++i)
        cache_->stamp(cache_->element(i));
    keep_positions();
    cache_->hold_elements(*context, 100);
    for (std::uint32_t i = 0; i < 100; ++i)
        EXPECT_FALSE(cache_->is_valid(cache_->element(i))) << i;
}

/// What of an element is valid: nothing, its position, or all.
enum class Known { nothing, position, all };

TEST_F(VertexCacheAlone, ForgetsElementsOfAnotherLayoutAndColorsOfAnotherColor) {
    const numeric::Real red[4] = {numeric::one, numeric::zero, numeric::zero, numeric::one},
                        white[4] = {numeric::one, numeric::one, numeric::one, numeric::one};
    const auto context = std::make_unique<gl::Context>();
    cache_->hold_elements(*context, 1);
    const auto known = [&](unsigned layout, const numeric::Real(&color)[4], bool lit, bool others) {
        cache_->begin_draw(layout, color, lit, others);
        Vertex& v = cache_->element(0);
        const Known before = cache_->is_valid(v)       ? Known::all
                             : cache_->has_position(v) ? Known::position
                                                       : Known::nothing;
        cache_->stamp(v);
        return before;
    };
    constexpr Known position = Cache::keeps_positions ? Known::position : Known::nothing;
    known(1, red, false, false);
    EXPECT_EQ(known(1, red, false, false), Known::all);
    EXPECT_EQ(known(2, red, false, false), Known::nothing);
    EXPECT_EQ(known(2, red, false, false), Known::all);
    EXPECT_EQ(known(2, white, false, false), position);
    EXPECT_EQ(known(2, white, false, true), Known::nothing);
    EXPECT_EQ(known(2, red, true, false), Known::all);
    EXPECT_EQ(known(2, red, false, false), Known::all);
}

/// A cache that has seen many colours does not take an old vertex for one of now.
TEST_F(VertexCacheAlone, ForgetsElementsAfterManyColors) {
    const auto context = std::make_unique<gl::Context>();
    cache_->hold_elements(*context, 1);
    cache_->invalidate();
    Vertex& v = cache_->element(0);
    cache_->stamp(v);
    for (int i = 0; i < 1 << 17; ++i) {
        cache_->invalidate_colors();
        ASSERT_FALSE(cache_->is_valid(v)) << i;
    }
    EXPECT_FALSE(cache_->has_position(v));
}

} // namespace
} // namespace spangle::test
