// The clipper alone: what it leaves of polygons and lines, and which vertices two primitives share.
#include <memory>
#include <vector>

#include "gl/vertex/clipper.hpp"
#include "tests/gl/vertex/vertex_parts.hpp"

namespace spangle::test {
namespace {

using Clipper = gl::Clipper<gl::FixedMath, gl::FixedLighting>;
using ClippedVertex = Clipper::ClippedVertex;

struct ClipperPart : Alone<Clipper> {
    using Clipper::clip_vertices;
    using Clipper::pool_;
};

struct Position {
    float v[3];
};

class ClipperAlone : public VertexParts {
  protected:
    using M = gl::FixedMath;

    const std::unique_ptr<ClipperPart> part_ = std::make_unique<ClipperPart>();

    /// Clips a polygon by all planes of the guard band that it crosses.
    std::vector<ClippedVertex> clipped(const std::vector<Position>& polygon) {
        part_->begin(GL_POLYGON);
        Vertex* corners[ClipperPart::clip_vertices];
        Vertex* work[ClipperPart::clip_vertices];
        unsigned any = 0;
        int n = 0;
        for (const Position& p : polygon) {
            Vertex& v = part_->vertex_slot_[n];
            part_->process(v, p.v[0], p.v[1], p.v[2]);
            any |= v.flags;
            corners[n] = &part_->to_clip_vertex(v, part_->pool_[n]);
            ++n;
        }
        EXPECT_TRUE(Clipper::needs_clipping(any));
        const int left =
            part_->clip_polygon(corners, work, ClipperPart::clip_vertices, n, part_->clip_planes(any));
        std::vector<ClippedVertex> out;
        for (int i = 0; i < left; ++i)
            out.push_back(static_cast<ClippedVertex&>(*corners[i]));
        return out;
    }
    /// The corner that clipping made on the edge between two others: neither of them kept its place.
    static bool same_place(const ClippedVertex& a, const ClippedVertex& b) {
        numeric::Real at_a[4], at_b[4];
        M::to_reals(M::narrow(a.clip), at_a);
        M::to_reals(M::narrow(b.clip), at_b);
        for (int c = 0; c < 4; ++c)
            if (at_a[c].bits != at_b[c].bits)
                return false;
        return true;
    }
};

TEST_F(ClipperAlone, LeavesCornersInsideOfTheGuardBand) {
    const std::vector<std::vector<Position>> polygons = {
        {{{0, 0, 0}}, {{9, 0, 0}}, {{0, 1, 0}}},
        {{{-7, 0, 0}}, {{8, 0, 0}}, {{0, 6, 0}}},
        {{{0, 0, -2}}, {{0, 0.5f, 2}}, {{0.5f, 0, 0}}},
        {{{-9, -9, -3}}, {{9, -9, 3}}, {{9, 9, 0}}, {{-9, 9, 0}}},
    };
    for (const auto& polygon : polygons) {
        const std::vector<ClippedVertex> left = clipped(polygon);
        EXPECT_GE(left.size(), 3u);
        for (const ClippedVertex& v : left)
            for (int plane = 0; plane < 6; ++plane)
                EXPECT_EQ(v.flags >> (gl::beyond_shift + static_cast<unsigned>(plane)) & 1, 0u)
                    << "plane " << plane;
    }
    EXPECT_EQ(clipped(polygons[0]).size(), 4u);
}

TEST_F(ClipperAlone, LeavesNothingOfAPolygonBeyondAPlane) {
    EXPECT_TRUE(clipped({{{5, 0, 0}}, {{9, 0, 0}}, {{6, 2, 0}}}).empty());
}

/// Two triangles share the edge from (0, 0.3, -0.2) to (9, -7, 3), which planes of both cut.
TEST_F(ClipperAlone, CutsASharedEdgeAtTheSamePlace) {
    const Position a{{0, 0.3f, -0.2f}}, b{{9, -0.7f, 0.3f}};
    const std::vector<ClippedVertex> first = clipped({a, b, {{0.1f, 1, 0}}}),
                                     second = clipped({b, a, {{0.2f, -1, 0}}});
    ASSERT_EQ(first.size(), 4u);
    ASSERT_EQ(second.size(), 4u);
    int shared = 0;
    for (const ClippedVertex& p : first)
        for (const ClippedVertex& q : second)
            shared += same_place(p, q) ? 1 : 0;
    EXPECT_EQ(shared, 2); // corner a, and the corner where the plane cuts the edge
}

/// The polygon's boundary goes on along the plane, and along what is left of a boundary edge.
TEST_F(ClipperAlone, MarksTheEdgesAlongAPlaneAsBoundary) {
    int boundaries = 0;
    for (const ClippedVertex& v : clipped({{{0, 0, 0}}, {{9, 0, 0}}, {{0, 1, 0}}}))
        boundaries += (v.flags & gl::boundary) != 0 ? 1 : 0;
    EXPECT_EQ(boundaries, 1);
}

TEST_F(ClipperAlone, ClipsALineAtBothEnds) {
    part_->begin(GL_LINES);
    Vertex a, b;
    part_->process(a, -9, 0.5f, 0);
    part_->process(b, 9, 0.5f, 0);
    Vertex* ends[2] = {&a, &b};
    ASSERT_TRUE(part_->clip_line(ends));
    for (Vertex* const end : ends) {
        EXPECT_EQ(end->flags & gl::beyond_mask, 0u);
        ASSERT_TRUE(part_->project(*end));
    }
    // The guard band is four times as wide as the viewport, which has 64 pixels.
    const std::int32_t left = raster::position(ends[0]->window).x,
                       right = raster::position(ends[1]->window).x;
    EXPECT_EQ(left, -96 * raster::subpixel_one);
    EXPECT_EQ(right, 160 * raster::subpixel_one);
    part_->process(a, 8, 0.5f, 0);
    Vertex* beyond[2] = {&a, &b};
    EXPECT_FALSE(part_->clip_line(beyond));
}

} // namespace
} // namespace spangle::test
