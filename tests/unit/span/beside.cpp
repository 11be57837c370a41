// Draws states one step beside those of fused spans: whatever compile() chooses for them must be equal to
// their chain.
#include <gtest/gtest.h>

#include "tests/unit/span/any_state.hpp"
#include "tests/unit/span/state_of_key.hpp"

namespace spangle::raster::test {
namespace {

constexpr int width = 56, height = 12;

/// Changes one or two modes to values that no fused span has, or that choose another fused span.
void step_aside(RandomVertices& random, FragmentState& state, const Extras& extras, const Texture& texture) {
    for (std::uint32_t steps = 1 + random.below(2); steps > 0; --steps)
        switch (random.below(10)) {
        case 0:
            state.count = true;
            break;
        case 1:
            state.coverage = true;
            break;
        case 2:
            state.depth_offset = true;
            break;
        case 3:
            state.polygon_stipple = extras.pattern;
            break;
        case 4:
            state.logic = true;
            state.logic_op = static_cast<LogicOp>(random.below(16));
            break;
        case 5:
            state.color_mask = static_cast<std::uint8_t>(1 + random.below(15));
            break;
        case 6:
            state.stencil_test = true;
            any_stencil(random, state.stencil);
            break;
        case 7:
            state.blend = true;
            any_blending(random, state);
            break;
        case 8:
            any_unit(random, state.unit[1], texture);
            break;
        default:
            state.alpha_test = !state.alpha_test;
            state.alpha_func = Compare::greater;
            break;
        }
}

TEST(Fused, StatesBesideItsKeysAreTheirChain) {
    RandomVertices random(77);
    Random texels{77};
    for (int round = 0; round < 3000; ++round) {
        const FusedSpan& fused = fused_span(random.below(static_cast<std::uint32_t>(fused_span_count)));
        const Extras extras(random, width);
        const AnyTexture texture(texels);
        StateOfKey of(fused.key, width, height);
        step_aside(random, of.state, extras, texture.texture);
        const DepthFormat depth = random.below(3) == 0 ? DepthFormat::z24s8 : DepthFormat::z16;
        Canvas canvas[2] = {{width, height, fused.key.format, depth},
                            {width, height, fused.key.format, depth}};
        const DrawState compiled = compile<FixedVertex>(of.state, canvas[0].surface);
        if (compiled.nothing)
            continue;
        const Kind kind = fused.key.kind == Kind::flat ? Kind::affine : fused.key.kind;
        DrawState draws[2] = {compiled, in_chain(compiled, make_key(of.state, canvas[1].surface, kind))};
        Counters counters[2];
        for (int i = 0; i < 2; ++i)
            extras.give_to(draws[i], counters[i]);
        for (int n = 0; n < 4; ++n) {
            const Triangle t = random_triangle(random, width, height, kind);
            for (int i = 0; i < 2; ++i) {
                canvas[i].noise(static_cast<std::uint32_t>(4 * round + n));
                draw(draws[i], canvas[i].surface, t);
            }
            ASSERT_EQ(canvas[0].color, canvas[1].color) << round << ' ' << n;
            ASSERT_EQ(canvas[0].depth, canvas[1].depth) << round << ' ' << n;
            ASSERT_EQ(counters[0].passed, counters[1].passed) << round << ' ' << n;
        }
    }
}

} // namespace
} // namespace spangle::raster::test
