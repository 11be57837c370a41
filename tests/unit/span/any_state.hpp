// Random states of fragments, of every kind.
#pragma once

#include "raster/span/draw_state.hpp"
#include "tests/unit/span/any_texture.hpp"
#include "tests/unit/span/sweep.hpp"

namespace spangle::raster::test {

inline constexpr PixelFormat all_formats[] = {
    PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888, PixelFormat::rgba8888,
    PixelFormat::rgb666,    PixelFormat::rgb444,    PixelFormat::rgb332, PixelFormat::grey4,
    PixelFormat::mono,      PixelFormat::index8};

/// Gives a unit a random texture environment.
inline void any_unit(RandomVertices& random, TextureUnit& unit, const Texture& texture) {
    unit.texture = &texture;
    unit.env = static_cast<TexEnv>(random.below(6));
    unit.lod_bias = static_cast<std::int32_t>(random.below(513)) - 256;
    for (Combiner* c : {&unit.rgb, &unit.alpha}) {
        c->func = static_cast<CombineFunc>(random.below(c == &unit.rgb ? 8 : 6));
        c->log2_scale = static_cast<std::uint8_t>(random.below(3));
        for (auto& argument : c->argument)
            argument = {static_cast<CombineSource>(random.below(6)),
                        static_cast<CombineOperand>(random.below(4))};
    }
    for (auto& c : unit.env_color)
        c = random.below(color_one + 1);
}

inline void any_blending(RandomVertices& random, FragmentState& state) {
    const auto often = [&](std::uint32_t of) { return random.below(of) != 0; };
    const auto blending = [&] {
        return Blending{often(2) ? BlendFactor::src_alpha : static_cast<BlendFactor>(random.below(15)),
                        often(2) ? BlendFactor::one_minus_src_alpha
                                 : static_cast<BlendFactor>(random.below(15)),
                        often(2) ? BlendEquation::add : static_cast<BlendEquation>(random.below(5))};
    };
    state.blend_rgb = blending();
    state.blend_alpha = often(2) ? state.blend_rgb : blending();
    for (auto& c : state.blend_color)
        c = random.below(color_one + 1);
}

inline void any_stencil(RandomVertices& random, StencilState& stencil) {
    const auto op = [&] { return static_cast<StencilOp>(random.below(8)); };
    const auto byte = [&] { return static_cast<std::uint8_t>(random.below(256)); };
    stencil.func = static_cast<Compare>(random.below(8));
    stencil.ref = byte();
    stencil.compare_mask = byte();
    stencil.write_mask = byte();
    stencil.fail = op();
    stencil.depth_fail = op();
    stencil.pass = op();
}

/// Returns random fragment state for a surface of this size.
inline FragmentState any_fragments(RandomVertices& random, const Texture* const (&textures)[2], int width,
                                   int height) {
    FragmentState state;
    const auto often = [&](std::uint32_t of) { return random.below(of) != 0; };
    state.tier = static_cast<Tier>(random.below(3));
    state.scissor = {static_cast<int>(random.below(8)), 0, width - 16, height};
    state.dither = often(2);
    for (int i = 0; i < 2; ++i) {
        if (random.below(3) == 0)
            continue;
        any_unit(random, state.unit[i], *textures[i]);
    }
    state.color_sum = random.below(4) == 0;
    state.fog = random.below(3) == 0;
    state.fog_mode = static_cast<FogMode>(random.below(3));
    // As floats these are 0.5, 4 and 0.5.
    state.fog_start = 0x3F000000, state.fog_end = 0x40800000, state.fog_density = 0x3F000000;
    for (auto& c : state.fog_color)
        c = random.below(color_one + 1);
    state.alpha_test = random.below(4) == 0;
    state.alpha_func = static_cast<Compare>(random.below(8));
    state.alpha_ref = static_cast<std::uint8_t>(random.below(256));
    state.stencil_test = random.below(3) == 0;
    any_stencil(random, state.stencil);
    state.depth_test = often(3);
    state.depth_func = static_cast<Compare>(random.below(8));
    state.depth_write = often(3);
    state.blend = random.below(3) == 0;
    any_blending(random, state);
    state.logic = random.below(6) == 0;
    state.logic_op = static_cast<LogicOp>(random.below(16));
    state.color_mask = often(4) ? 0xF : static_cast<std::uint8_t>(1 + random.below(15));
    return state;
}

/// Random state that primitives bring along: stipple patterns, coverage and samples; and counters.
struct Extras {
    std::uint32_t pattern[32];
    std::vector<std::uint32_t> coverage;
    PrimitiveState primitive;

    Extras(RandomVertices& random, int width) : coverage(static_cast<std::size_t>(width)) {
        for (auto& row : pattern)
            row = random.word();
        for (auto& c : coverage)
            c = random.below(4) == 0 ? full_coverage : random.below(full_coverage + 1);
        primitive.antialiased = random.below(4) != 0;
        primitive.coverage = primitive.antialiased && random.below(8) != 0 ? coverage.data() : nullptr;
        primitive.sample = static_cast<std::uint8_t>(random.below(4));
        primitive.depth_offset = static_cast<std::int64_t>(random.word()) - (std::int64_t{1} << 31);
        primitive.stippled = true;
    }
    void add_to(RandomVertices& random, FragmentState& state) const {
        state.count = random.below(3) == 0;
        state.coverage = random.below(3) == 0;
        state.depth_offset = random.below(3) == 0;
        state.polygon_stipple = random.below(3) == 0 ? pattern : nullptr;
        if (random.below(4) == 0)
            add_samples(random, state);
    }
    static void add_samples(RandomVertices& random, FragmentState& state) {
        state.alpha_to_coverage = random.below(2) == 0;
        state.alpha_to_one = random.below(2) == 0;
        state.sample_coverage = random.below(2) == 0;
        state.invert_sample_coverage = random.below(2) == 0;
        state.sample_coverage_value = static_cast<std::uint8_t>(random.below(256));
    }
    void give_to(DrawState& draw, Counters& counters) const {
        draw.primitive = &primitive;
        draw.counters = &counters;
    }
};

} // namespace spangle::raster::test
