// Trapezoids store the bytes of their chain, in the fragments that exact rows find.
#include <gtest/gtest.h>

#include "raster/ops/lanes.hpp"
#include "raster/span/trapezoids.hpp"
#include "tests/unit/span/expect_chain.hpp"

namespace spangle::raster::test {
namespace {

constexpr Size size{84, 80};

struct Hits {
    int shapes = 0, cut_below = 0, cut_above = 0, at_end = 0, tall = 0, without_low = 0, without_high = 0;
};
Hits hits;
void (*under_test)(Span<Fixed>&, const Trapezoids&);

void note_and_draw(Span<Fixed>& span, const Trapezoids& shape) {
    const Rect& clip = span.state->fragment.scissor;
    const std::int32_t end = shape.part[1].end, room = clip.x + clip.w - 8;
    EXPECT_GE(shape.y, clip.y);
    EXPECT_LT(shape.y, end);
    EXPECT_LE(end, clip.y + clip.h);
    bool at_end = false;
    std::int32_t y = shape.y;
    for (const Trapezoids::Part& part : shape.part) {
        EXPECT_LE(y, part.end);
        for (std::int32_t row = 0; y < part.end; ++y, ++row) {
            const std::int32_t first = part.left.after(row).column(), last = part.right.after(row).column();
            if (first >= last)
                continue;
            EXPECT_GE(first, clip.x);
            EXPECT_LE(last, room);
            at_end = at_end || last == room;
        }
    }
    ++hits.shapes;
    hits.at_end += at_end ? 1 : 0;
    hits.cut_below += shape.y == clip.y ? 1 : 0;
    hits.cut_above += end == clip.y + clip.h ? 1 : 0;
    hits.tall += end - shape.y >= 48 ? 1 : 0;
    hits.without_low += shape.part[0].end == shape.y ? 1 : 0;
    hits.without_high += shape.part[0].end == end ? 1 : 0;
    under_test(span, shape);
}

/// Returns a triangle that is hardly wider than 64 pixels. Some corners lie on pixel centres and corners,
/// some sides are horizontal or vertical, and some triangles reach beyond the top and bottom of the surface.
Triangle triangle(RandomVertices& source, Kind kind) {
    Triangle t = random_triangle(source, size.width, size.height, kind);
    const std::uint32_t step = source.below(2) == 0 ? 1 : 64, wide = 4 + source.below(62),
                        high = 8 + source.below(58);
    const auto left = static_cast<std::int32_t>(source.below(static_cast<std::uint32_t>(size.width) - wide)),
               low = static_cast<std::int32_t>(source.below(static_cast<std::uint32_t>(size.height))) - 20;
    const auto place = [&](std::int32_t from, std::uint32_t pixels) {
        return from * subpixel_one + static_cast<std::int32_t>(source.below(pixels * 256 / step) * step);
    };
    for (FixedVertex& v : t.v) {
        v.x = place(left, wide);
        v.y = place(low, high);
    }
    make_special(t, source, kind);
    if (source.below(3) == 0)
        for (FixedVertex& v : t.v) // makes all vertices gray
            v.color[1] = v.color[2] = v.color[0];
    return t;
}

TEST(Trapezoids, AreTheirChain) {
    int entries = 0;
    for (std::size_t i = 0; i < fused_span_count; ++i) {
        const FusedSpan& fused = fused_span(i);
        const std::string name = "entry " + std::to_string(i);
        if (fused.shapes == nullptr)
            continue;
        ++entries;
        under_test = fused.shapes->trapezoids;
        hits = {};
        const Shapes shapes = {fused.shapes->tile, &note_and_draw};
        expect_chain(fused, name, size, 1500, shapes,
                     [&](RandomVertices& source) { return triangle(source, fused.key.kind); });
        EXPECT_GE(hits.shapes, 250) << name;
        EXPECT_GE(hits.cut_below, 20) << name;
        EXPECT_GE(hits.cut_above, 20) << name;
        EXPECT_GE(hits.at_end, 1) << name;
        EXPECT_GE(hits.tall, 3) << name;
        EXPECT_GE(hits.without_low, 20) << name;
        EXPECT_GE(hits.without_high, 20) << name;
        if (fused.key.unit[0].on) // coordinates of more texels than 16 bits hold
            expect_chain(
                fused, name, size, 300, shapes,
                [&](RandomVertices& source) { return triangle(source, fused.key.kind); }, 12);
    }
    EXPECT_GE(entries, host_lanes > 1 ? 4 : 0);
}

} // namespace
} // namespace spangle::raster::test
