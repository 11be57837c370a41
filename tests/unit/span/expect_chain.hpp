// Draws triangles by a fused form and by the chain, which must store the same bytes and touch the same rows.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/span/state_of_key.hpp"

namespace spangle::raster::test {

struct Size {
    int width, height;
};

/// Makes some triangles special: 1/w varies little, or a side is horizontal or vertical.
inline void make_special(Triangle& t, RandomVertices& source, Kind kind) {
    if (kind == Kind::full && source.below(2) == 0)
        for (FixedVertex& v : t.v)
            v.w_mantissa = 0xB0000000u + source.below(1u << source.below(28)), v.w_exponent = -32;
    if (source.below(4) == 0)
        t.v[1].y = t.v[0].y;
    if (source.below(4) == 0)
        t.v[2].x = t.v[1].x;
}

/// Draws `rounds` triangles, which next(source) returns, with `shapes` in place of the key's shapes. The
/// scissor cuts every fourth triangle, and every third triangle records touched rows.
template <class Next>
void expect_chain(const FusedSpan& fused, const std::string& name, Size size, int rounds,
                  const Shapes& shapes, Next next, int log2_texels = 6) {
    const auto [width, height] = size;
    const StateOfKey of(fused.key, width, height, log2_texels);
    const DepthFormat depth =
        fused.key.depth_format == DepthFormat::none ? DepthFormat::z16 : fused.key.depth_format;
    Canvas chain_canvas(width, height, fused.key.format, depth),
        canvas(width, height, fused.key.format, depth);
    std::vector<RowSpan> touched[2];
    DrawState state = compile<FixedVertex>(of.state, chain_canvas.surface);
    DrawState chained = in_chain(state, fused.key);
    ASSERT_TRUE(state.shapes) << name;
    state.variant[static_cast<unsigned>(fused.key.kind)].shapes = &shapes;
    RandomVertices source(31);
    for (int round = 0; round < rounds; ++round) {
        chain_canvas.noise(static_cast<std::uint32_t>(round));
        canvas.noise(static_cast<std::uint32_t>(round));
        const Rect cut = {static_cast<int>(source.below(16)), static_cast<int>(source.below(16)),
                          4 + static_cast<int>(source.below(static_cast<std::uint32_t>(width) / 2)),
                          4 + static_cast<int>(source.below(static_cast<std::uint32_t>(height) / 2))};
        state.fragment.scissor = chained.fragment.scissor = round % 4 == 0 ? cut : of.state.scissor;
        for (int i = 0; i < 2; ++i) {
            Surface& surface = (i == 0 ? chain_canvas : canvas).surface;
            touched[i].assign(static_cast<std::size_t>(height), RowSpan{5, 30});
            surface.touched = round % 3 == 0 ? touched[i].data() : nullptr;
            surface.touched_step = 1;
        }
        const Triangle t = next(source);
        draw(chained, chain_canvas.surface, t);
        draw(state, canvas.surface, t);
        ASSERT_EQ(chain_canvas.color, canvas.color) << name << " round " << round;
        ASSERT_EQ(chain_canvas.depth, canvas.depth) << name << " round " << round;
        for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
            ASSERT_EQ(touched[0][y].begin, touched[1][y].begin) << name << " round " << round;
            ASSERT_EQ(touched[0][y].end, touched[1][y].end) << name << " round " << round;
        }
    }
}

} // namespace spangle::raster::test
