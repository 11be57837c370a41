#include "gl/pixel/fragment_setup.hpp"

#include <new>
#include <type_traits>

#include "gl/context/features.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/share_group.hpp"
#include "gl/context/tokens.hpp"
#include "gl/pixel/index.hpp"
#include "gl/pixel/targets.hpp"
#include "gl/pixel/viewport_box.hpp"
#include "gl/pixel/zoom.hpp"
#include "gl/texture/level_image.hpp"
#include "gl/texture/texture_setup.hpp"
#include "gl/vertex/engine.hpp"
#include "raster/band/batch_rows.hpp"
#include "raster/band/record.hpp"
#include "raster/numeric/real.hpp"
#include "raster/span/fused_keys.hpp"

namespace spangle::gl {

namespace {

raster::StencilOp stencil_op_of(GLenum op) {
    return static_cast<raster::StencilOp>(place_in(stencil_ops, op));
}

raster::BlendEquation equation_of(GLenum mode) {
    return static_cast<raster::BlendEquation>(place_in(blend_equations, mode));
}

raster::Blending blending_of(const BlendPart& part) {
    return {blend_factor_of(part.src), blend_factor_of(part.dst), equation_of(part.equation)};
}

raster::StencilState stencil_of(const StencilSide& side) {
    const GLint ref = side.ref < 0 ? 0 : side.ref > 255 ? 255 : side.ref;
    return {compare_of(side.func),
            static_cast<std::uint8_t>(ref),
            static_cast<std::uint8_t>(side.value_mask),
            static_cast<std::uint8_t>(side.write_mask),
            stencil_op_of(side.fail),
            stencil_op_of(side.pass_depth_fail),
            stencil_op_of(side.pass_depth_pass)};
}

void fill_fog(const Context& context, raster::FragmentState& out) {
#if SPANGLE_FEATURE_FOG
    const FogState& fog = context.fog;
    out.fog = fog.fog;
    out.fog_mode = static_cast<raster::FogMode>(place_in(fog_modes, fog.mode));
    if (is_indexed(context.drawable))
        out.fog_color[0] = index_units(fog.index, context.drawable.index_bits);
    else
        for (int c = 0; c < 3; ++c)
            out.fog_color[c] = color_units(fog.color[c]);
    out.fog_density = numeric::to_float_bits(fog.density);
    out.fog_start = numeric::to_float_bits(fog.start);
    out.fog_end = numeric::to_float_bits(fog.end);
#else
    static_cast<void>(context);
    out.fog = false;
#endif
}

void fill_tests(const Context& context, raster::FragmentState& out) {
    const FragmentOpsState& ops = context.fragment_ops;
    const DepthFormat format = context.drawable.surface.depth_format;
    // Without a stencil or depth buffer its test always passes and nothing is written (GL 1.3, 4.1.5, 4.1.6).
    if (raster::has_format(DepthFormat::z24s8)) {
        out.stencil_test = ops.stencil_test && format == DepthFormat::z24s8;
        out.stencil = stencil_of(ops.stencil[0]);
    }
    out.depth_test = ops.depth_test && format != DepthFormat::none;
    out.depth_write = ops.depth_mask;
    out.depth_func = compare_of(ops.depth_func);
}

/// Whether polygon offset is on for any polygon mode.
bool offsets(const PolygonState& polygon) {
    return SPANGLE_FEATURE_POLYGON_OFFSET &&
           (polygon.offset_fill || polygon.offset_line || polygon.offset_point);
}

bool has_stipple(const PolygonState& polygon) {
    return SPANGLE_FEATURE_STIPPLE && polygon.polygon_stipple;
}

bool has_mode(const PolygonState& polygon, GLenum mode) {
    return polygon.mode[0] == mode || polygon.mode[1] == mode;
}

/// Whether antialiasing is on for any kind of primitive. Multisampling replaces it (GL 1.3, 3.2.1).
bool is_antialiased(const Context& context) {
    const PolygonState& polygon = context.polygon;
    return SPANGLE_FEATURE_ANTIALIASING && !multisampling(context) &&
           (polygon.point_smooth || polygon.line_smooth || polygon.polygon_smooth);
}

/// Whether fragments of this kind of primitive may have antialiasing coverage.
bool has_coverage(const PolygonState& polygon, PrimitiveKind drawn) {
    switch (drawn) {
    case PrimitiveKind::points:
        return polygon.point_smooth;
    case PrimitiveKind::lines:
        return polygon.line_smooth;
    case PrimitiveKind::polygons:
        return (polygon.polygon_smooth && has_mode(polygon, GL_FILL)) ||
               (polygon.line_smooth && has_mode(polygon, GL_LINE)) ||
               (polygon.point_smooth && has_mode(polygon, GL_POINT));
    case PrimitiveKind::pixels:
        break;
    }
    return false;
}

/// Fills in multisample fragment operations (GL 1.3, 4.1.3).
void fill_samples(const Context& context, raster::FragmentState& out) {
    const FragmentOpsState& ops = context.fragment_ops;
    if (!multisampling(context))
        return;
    out.alpha_to_coverage = ops.sample_alpha_to_coverage;
    out.alpha_to_one = ops.sample_alpha_to_one;
    out.sample_coverage = ops.sample_coverage;
    out.invert_sample_coverage = ops.sample_coverage_invert;
    out.sample_coverage_value = static_cast<std::uint8_t>(numeric::to_unit(ops.sample_coverage_value, 8));
}

/// Whether fragments of such primitives must be cut off at the viewport. Their geometry is clipped to the
/// guard band only, so it may reach beyond the view volume. Wide lines, and polygons of which points and
/// lines are drawn, are clipped to the view volume itself, and their fragments may lie beyond the viewport
/// (GL 1.3, 2.11).
bool ends_at_viewport(const Context& context, PrimitiveKind drawn) {
    if (drawn == PrimitiveKind::polygons)
        return !SPANGLE_FEATURE_POLYGON_MODE ||
               (context.polygon.mode[0] == GL_FILL && context.polygon.mode[1] == GL_FILL);
    return drawn == PrimitiveKind::lines && (!has_clipping || lines_are_thin(context));
}

/// Fills in the state that depends on the kind of primitive.
void fill_modes(const Context& context, PrimitiveKind drawn, raster::FragmentState& out) {
    const PolygonState& polygon = context.polygon;
    out.coverage = is_antialiased(context) && has_coverage(polygon, drawn);
    if (ends_at_viewport(context, drawn) && !viewport_holds(context, out.scissor))
        out.scissor = in_viewport(context, out.scissor);
    if (drawn != PrimitiveKind::polygons)
        return;
    out.depth_offset = offsets(polygon);
#if SPANGLE_FEATURE_STIPPLE
    out.polygon_stipple = has_stipple(polygon) ? polygon.stipple.row : nullptr;
#endif
}

/// Fills in the state that applies to RGBA colours only. Colour indices are not textured, summed,
/// alpha-tested or blended.
void fill_colors(const Context& context, raster::FragmentState& out) {
    const FragmentOpsState& ops = context.fragment_ops;
    fill_textures(context, out);
    out.color_sum = sums_colors(context.lighting);
    out.alpha_test = ops.alpha_test;
    out.alpha_func = compare_of(ops.alpha_func);
    if (raster::spans_test_alpha)
        out.alpha_ref = static_cast<std::uint8_t>(numeric::to_unit(ops.alpha_ref, 8));
    out.blend = ops.blend;
    if (!raster::spans_blend)
        return;
    out.blend_rgb = blending_of(ops.blend_rgb);
    out.blend_alpha = blending_of(ops.blend_alpha);
    for (int c = 0; c < 4; ++c)
        out.blend_color[c] = color_units(ops.blend_color[c]);
}

void fill_fragment_state(const Context& context, raster::FragmentState& out) {
    const FragmentOpsState& ops = context.fragment_ops;
    const bool indexed = is_indexed(context.drawable);
    if (!indexed)
        fill_colors(context, out);
    fill_fog(context, out);
    fill_tests(context, out);
    fill_samples(context, out);
    out.flat = context.polygon.shade_model == GL_FLAT;
    out.logic = indexed ? ops.index_logic_op : ops.color_logic_op;
    out.logic_op = logic_op_of(ops.logic_op);
    out.dither = ops.dither;
    out.color_mask = written_channels(context);
    out.scissor = drawing_rect(context);
    out.tier = tier_of(context, context.hint.mode[hint_perspective_correction]);
#if SPANGLE_OWN_TIERS
    out.own_tier = context.own_tier && context.hint.mode[hint_perspective_correction] == GL_DONT_CARE;
    out.knobs = context.knobs;
#endif
    out.count = counts_passed(context);
}

/// Compiles fragment state for the drawable by the context's engine. Type Kept is CompiledStateCache, or
/// empty where no states are kept.
template <class Kept>
void compile(Context& context, [[maybe_unused]] Kept& kept, const raster::FragmentState& fragment,
             raster::DrawState& out) {
    const raster::Surface& target = context.drawable.surface;
    if constexpr (compiled_state_count != 0)
        kept.compile(*context.engine, fragment, target, context.share->texture_changes, out);
    else
        context.engine->compile(fragment, target, out);
}

/// Makes `recorder` receive the primitives that are drawn with the current states.
template <class Recorder> [[maybe_unused]] void take_states(Context& context, Recorder& recorder) {
    recorder.take(context.fragments.state);
#if SPANGLE_FEATURE_STENCIL_SIDES
    if (stencil_sides(context))
        recorder.take(context.fragments.back);
#endif
}

/// Sends primitives to the record where drawing is recorded. While the first band of a callback is drawn,
/// primitives go to BatchRows, which notes the rows that each batch reaches.
void record_states([[maybe_unused]] Context& context) {
#if SPANGLE_FEATURE_BANDS
    if (raster::BatchRows* const batches = context.drawable.batches;
        batches != nullptr && batches->is_recording())
        take_states(context, *batches);
#endif
#if SPANGLE_HAS_RECORDS
    if (context.drawable.recording == nullptr)
        return;
    hold_textures(context);
    take_states(context, *context.drawable.recording->record);
#endif
}

} // namespace

std::uint32_t color_units(Real component) {
    const auto c = static_cast<std::uint64_t>(numeric::to_fixed(numeric::clamp01(component), 30));
    return static_cast<std::uint32_t>((c * raster::color_one + (1u << 29)) >> 30);
}

Rect drawing_rect(const Context& context) {
    const Rect all = context.drawable.surface.area();
    if (!context.fragment_ops.scissor_test)
        return all;
    const GLint* const box = context.fragment_ops.scissor_box;
    const Interval columns = clip_interval(box[0], box[2], 0, all.w),
                   rows = clip_interval(box[1], box[3], all.y, all.y + all.h);
    return {columns.begin, rows.begin, columns.end - columns.begin, rows.end - rows.begin};
}

std::uint8_t written_channels(const Context& context) {
    const FragmentOpsState& ops = context.fragment_ops;
    if (ops.draw_buffer == GL_NONE)
        return 0;
    if (is_indexed(context.drawable))
        return static_cast<std::uint8_t>(ops.index_mask & ((1u << context.drawable.index_bits) - 1));
    unsigned mask = 0;
    for (unsigned c = 0; c < 4; ++c)
        mask |= ops.color_mask[c] ? 1u << c : 0u;
    return static_cast<std::uint8_t>(mask);
}

raster::Tier tier_of(const Context& context, GLenum hint) {
    const raster::Tier asked = hint == GL_FASTEST  ? raster::Tier::fast
                               : hint == GL_NICEST ? raster::Tier::exact
                                                   : context.tier;
    return raster::has_tier(asked) ? asked : context.tier; // a hint may be ignored (GL 1.3, 5.6)
}

void observe(Context& context, raster::Counters* counters, bool count_passed) {
    change_counters(context, counters);
    context.fragments.count_passed = count_passed;
    context.changed(dirty_fragment);
}

bool stencil_sides([[maybe_unused]] const Context& context) {
#if SPANGLE_FEATURE_STENCIL_SIDES
    const FragmentOpsState& ops = context.fragment_ops;
    return ops.stencil_test && ops.stencil[0] != ops.stencil[1];
#else
    return false;
#endif
}

const raster::DrawState& draw_state_of(const Context& context, [[maybe_unused]] int side) {
#if SPANGLE_FEATURE_STENCIL_SIDES
    if (side != 0)
        return context.fragments.back;
#endif
    return context.fragments.state;
}

const raster::DrawState& draw_state(Context& context, PrimitiveKind drawn, raster::Colors colors) {
    FragmentCache& cache = context.fragments;
    const std::uint32_t texture_changes = context.share->texture_changes;
    if ((context.dirty & dirty_fragment) != 0 || cache.texture_changes != texture_changes ||
        (cache.differs && cache.drawn != drawn) || cache.colors != colors) {
        cache.texture_changes = texture_changes;
        cache.drawn = drawn;
        cache.colors = colors;
        cache.differs = offsets(context.polygon) || has_stipple(context.polygon) || is_antialiased(context) ||
                        !viewport_holds(context, drawing_rect(context));
        // Members that are not filled in, and padding, are 0. A state never uses the members that it leaves
        // out.
        static_assert(std::is_trivially_copyable_v<raster::FragmentState>);
        alignas(raster::FragmentState) unsigned char memory[sizeof(raster::FragmentState)] = {};
        auto& fragment = *std::launder(reinterpret_cast<raster::FragmentState*>(memory));
        fragment.perspective = true;
        fill_fragment_state(context, fragment);
        fill_modes(context, drawn, fragment);
        fragment.colors = colors;
        compile(context, cache.kept, fragment, cache.state);
        cache.state.counters = counters_of(context);
        cache.state.primitive = &cache.primitive;
#if SPANGLE_WATCHED
        if ((context.gate & gate_watched) != 0)
            context.watcher->compiled(context, fragment, cache.state);
#endif
#if !SPANGLE_CHAIN
        if (cache.state.lacks_span)
            drawing_error(
                context, GL_INVALID_OPERATION,
                SPANGLE_TEXT("nothing is drawn: this build has no span for this state (SPANGLE_FUSED) and no "
                             "chain"));
#endif
#if SPANGLE_FEATURE_STENCIL_SIDES
        if (stencil_sides(context)) {
            fragment.stencil = stencil_of(context.fragment_ops.stencil[1]);
            compile(context, cache.kept, fragment, cache.back);
            cache.back.counters = cache.state.counters;
#if SPANGLE_WATCHED
            if ((context.gate & gate_watched) != 0)
                context.watcher->compiled(context, fragment, cache.back);
#endif
            cache.back.primitive = &cache.primitive;
        }
#endif
        record_states(context);
        context.dirty = static_cast<std::uint16_t>(context.dirty & ~dirty_fragment);
    }
    return cache.state;
}

} // namespace spangle::gl
