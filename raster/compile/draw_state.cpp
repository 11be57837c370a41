#include "raster/span/draw_state.hpp"

#include <cstring>
#include <type_traits>

#include "raster/chain/assemble_chain.hpp"
#include "raster/compile/instruction_sets.hpp"
#include "raster/fused/table.hpp"
#include "raster/numeric/real.hpp"
#include "raster/span/of_tier.hpp"

namespace spangle::raster {

FragmentState::FragmentState() = default;

namespace {

using numeric::Real;

/// The constants of the fog coordinates of vertices (FogConstants). GL divides by END - START (GL 1.3, 3.10).
/// Where both are equal the divisor is 1, as in Mesa: fog begins one unit before END. As START approaches END
/// from below, GL's formula becomes a step at END. At distances outside of this unit both give the same fog.
FogConstants fog_constants(const FragmentState& state) {
    // e^-dz is 2^-(log2(e) dz), and e^-(dz)^2 is 2^-(sqrt(log2(e)) dz)^2. The root is 1.20112240878645. The
    // number below is one float step less than the nearest float; the step is 2^-23 of it.
    constexpr Real log2_e = numeric::from_double(1.4426950408889634), sqrt_log2_e{0x3F99BE60};
    FogConstants fog;
    Real scale = numeric::from_float_bits(state.fog_density);
    if (state.fog_mode == FogMode::linear) {
        const Real end = numeric::from_float_bits(state.fog_end);
        const Real range = numeric::sub(numeric::from_float_bits(state.fog_start), end);
        scale = numeric::is_zero(range) ? -numeric::one : numeric::div(numeric::one, range);
        const auto offset = numeric::detail::unpack(numeric::mul(-end, scale));
        const int up = offset.exponent + 24;
        const auto magnitude = numeric::times_two_to(offset.mantissa, up < 36 ? up : 36);
        fog.offset = offset.negative ? -magnitude : magnitude;
    } else {
        scale = numeric::mul(scale, state.fog_mode == FogMode::exp ? log2_e : sqrt_log2_e);
    }
    const auto parts = numeric::detail::unpack(scale);
    fog.scale = static_cast<std::int32_t>(parts.mantissa);
    fog.scale = parts.negative ? -fog.scale : fog.scale;
    fog.scale_exponent = parts.exponent;
    return fog;
}

bool draws_nothing(const FragmentState& state, const Key& key) {
    const bool writes = state.color_mask != 0 || key.depth_write || key.stencil || key.count;
    return !writes || state.scissor.w <= 0 || state.scissor.h <= 0 || key.alpha == Compare::never ||
           (key.depth == Compare::never && !key.stencil);
}

/// Assembles the chain with the largest instruction set that this processor has.
[[maybe_unused]] void assemble_best_chain(Variant& variant, const Key& key, const FragmentState& state) {
#if SPANGLE_AVX2 && SPANGLE_CHAIN
    if (uses_avx2())
        return avx2::assemble_chain(variant, key, state);
#endif
    assemble_any(variant, key, state);
}

/// Sets the functions of a variant. Returns true where its colours are guessed.
bool choose_span(Variant& variant, const Key& key, const FragmentState& state) {
    variant.steps = key.number == Number::raw565 && key.dither;
    variant.color_bias = key.number != Number::raw565 ? 1u << 15 : variant.steps ? 0 : 1u << 23;
    if constexpr (has_chain)
        assemble_best_chain(variant, key, state);
    const FusedSpan* const fused = find_fused(key);
    if (fused == nullptr)
        return false;
    variant.run = reinterpret_cast<AnyFunction>(fused->run);
    variant.gray = fused->gray;
    variant.walk = reinterpret_cast<AnyFunction>(fused->walk);
    variant.shapes = fused->shapes;
    if (fused->guesses) {
        variant.steps = key.dither;
        variant.color_bias = key.dither ? 0 : 1u << 23;
    }
    return fused->guesses;
}

/// Sets the knobs of a draw. Narrow surfaces have the exact number system in every tier, and its texture
/// coordinates, too (key.cpp).
void set_knobs([[maybe_unused]] DrawState& draw, [[maybe_unused]] const FragmentState& state) {
#if SPANGLE_OWN_TIERS
    draw.knobs = state.own_tier ? state.knobs : knobs_of(state.tier);
    if (!drawn_narrow(draw.format))
        return;
    draw.knobs.color_bits = exact_knobs.color_bits;
    draw.knobs.runs = exact_knobs.runs;
    draw.knobs.texel_bits = exact_knobs.texel_bits;
    draw.knobs.longest_run = exact_knobs.longest_run;
#endif
}

/// The area in which lines may be paths. Both planes must have the same stride, so that one offset finds a
/// fragment in both. A line may reach pixels beside its ends, which must lie inside of the scissor rectangle.
DrawState::Area area_of_paths(const Rect& scissor, const Surface& target) {
    if ((target.depth != nullptr && target.depth_stride != target.color_stride) || scissor.w <= 2 ||
        scissor.h <= 2)
        return {};
    return {(scissor.x + 1) * subpixel_one, (scissor.y + 1) * subpixel_one,
            static_cast<std::uint32_t>((scissor.w - 2) * subpixel_one),
            static_cast<std::uint32_t>((scissor.h - 2) * subpixel_one)};
}

} // namespace

AnyFunction chain_runner(Number number, bool narrow) {
#if SPANGLE_AVX2 && SPANGLE_CHAIN
    if (uses_avx2())
        return avx2::chain_runner(number, narrow);
#endif
    return runner_of(number, narrow);
}

/// Four times the allowed error of affine colours, in colour units. A step of the target is `Step` 255ths.
template <std::uint32_t Step>
constexpr auto four_color_tolerances = [](const Knobs& k) {
    if (k.affine_color_bits == 0 || (!has_full && k == fast_knobs))
        return any_color_tolerance;
    const std::uint32_t of_scale =
        k.affine_color_bits == Knobs::never ? 0 : color_one >> (k.affine_color_bits - 2);
    const std::uint32_t of_step =
        k.affine_step_bits == Knobs::never ? 0 : 4 * Step << color_fraction_bits >> k.affine_step_bits;
    return of_scale > of_step ? of_scale : of_step;
};

constexpr auto depends_on_step = [](const Knobs& k) {
    return four_color_tolerances<1>(k) != four_color_tolerances<4>(k);
};

Key prepare(DrawState& draw, const FragmentState& state, const Surface& target) {
    static_assert(std::is_trivially_copyable_v<DrawState>); // bytes of 0 are a valid DrawState
    std::memset(static_cast<void*>(&draw), 0, sizeof draw);
    draw.fragment = state;
    draw.tier = state.tier;
    draw.format = target.format;
    set_knobs(draw, state);
    draw.step_factors =
        of_tier<[](const Knobs& k) { return k.exact_steps; }>(draw) ? exact_steps : near_steps;
    // On targets of indices or of 8 bits a step is one unit (a 255th).
    const bool units = drawn_info(target.format).green_bits == 8 || drawn_indexed(target.format);
    draw.four_color_tolerances = of_tier<four_color_tolerances<1>>(draw);
    if (!units && of_tier<depends_on_step>(draw))
        draw.four_color_tolerances = of_tier<four_color_tolerances<4>>(draw);
    const Key any = key_of_any_kind(state, target), key = key_of_kind(any, state, Kind::affine);
    draw.depth_format = key.depth_format;
    draw.color_bytes =
        drawn_narrow(target.format) ? std::uint8_t{0} : drawn_info(target.format).bytes_per_pixel;
    draw.depth_bytes = key.depth_format == DepthFormat::none  ? 0
                       : key.depth_format == DepthFormat::z16 ? 2
                                                              : 4;
    draw.nothing = draws_nothing(state, key);
    draw.pixels = key.pixels;
    draw.words = key.pixels && key.number == Number::raw565;
    draw.needs = needs_of(key);
    draw.textured_or_fogged = key.unit[0].on || key.second_unit() || key.fog;
    draw.smooth_rgb = draw.needs.rgb && !draw.needs.alpha && !draw.needs.secondary &&
                      !draw.textured_or_fogged && !state.flat;
    if (has_fog && key.fog)
        draw.fog = fog_constants(state);
    for (int i = 0; i < max_texture_units; ++i) {
        if (!has_textures || !key.unit[i].on)
            continue;
        const Texture& texture = *state.unit[i].texture;
        const auto wraps = [](Wrap wrap) { return wrap == Wrap::repeat || wrap == Wrap::mirrored_repeat; };
        draw.needs.r[i] = has_third_coordinates && wants_r(texture);
        draw.needs.lod[i] = wants_lod(texture);
        draw.wraps[i] = {wraps(texture.wrap_s), wraps(texture.wrap_t)};
        if (!draw.needs.r[i])
            draw.halves[i] = {texture.wrap_s == Wrap::mirrored_repeat,
                              texture.wrap_t == Wrap::mirrored_repeat};
        draw.log2_width[i] =
            static_cast<std::uint8_t>(ceil_log2_of(texture.level[0].width) + draw.halves[i].s);
        draw.log2_height[i] =
            static_cast<std::uint8_t>(ceil_log2_of(texture.level[0].height) + draw.halves[i].t);
    }
    return any;
}

void scissor_changed(DrawState& draw, const Surface& target) {
    if constexpr (!has_paths)
        return;
    bool walks = false;
    for (const Variant& variant : draw.variant)
        walks = walks || variant.walk != nullptr;
    draw.paths = walks ? area_of_paths(draw.fragment.scissor, target) : DrawState::Area{};
}

/// True for the kinds that at least one state of this build may ask for.
constexpr bool is_possible(Kind kind) {
    switch (kind) {
    case Kind::flat: // only colours of 16 bits are ever flat
        return spans_are_raw;
    case Kind::affine:
        return true;
    case Kind::textured:
        return has_division;
    default:
        return has_full;
    }
}

template <> void compile<FixedVertex>(const FragmentState& state, const Surface& target, DrawState& draw) {
    constexpr int first = is_possible(Kind::flat) ? 0 : 1;
    constexpr int end = is_possible(Kind::full) ? 4 : is_possible(Kind::textured) ? 3 : 2;
    static_assert(kind_count == 4);
    bool lacks_span = false;
    const Key any = prepare(draw, state, target);
    for (int i = first; i < end && !draw.nothing; ++i) {
        const auto kind = static_cast<Kind>(i);
        const Key key = key_of_kind(any, state, kind);
        const bool plain = !draw.needs.any_unit() && !draw.needs.fog;
        // A separate list for a flat colour pays where the colour is stored unchanged.
        if (kind == Kind::flat && !(plain && key.number == Number::raw565))
            continue;
        if (kind == Kind::textured && plain)
            continue;
        if (!has_affine_textures && kind == Kind::affine && draw.needs.any_unit())
            continue;
        if (!is_possible(kind))
            continue;
        draw.guesses = choose_span(draw.variant[i], key, state);
        if constexpr (!has_chain) {
            // Colours of the fast tier stay affine where the build has no span that divides them.
            const bool may_be_affine = kind == Kind::full && drawn(state.tier) == Tier::fast;
            if (may_be_affine && draw.variant[i].run == nullptr)
                draw.four_color_tolerances = any_color_tolerance;
            // A flat colour without a span of its own is drawn as affine colours are.
            const bool optional =
                may_be_affine ||
                (first == 0 &&
                 (i == 0 || (plain && state.flat && !draw.pixels && draw.variant[0].run != nullptr)));
            lacks_span = lacks_span || (draw.variant[i].run == nullptr && !optional);
        }
        const Shapes* const shapes = draw.variant[i].shapes;
        draw.shapes = draw.shapes || shapes != nullptr;
        draw.tiles = draw.tiles || (shapes != nullptr && shapes->tile != nullptr);
    }
#if !SPANGLE_CHAIN
    draw.lacks_span = lacks_span;
#endif
    draw.nothing = draw.nothing || lacks_span;
    scissor_changed(draw, target);
}

} // namespace spangle::raster
