// Makes the canonical key of GL's state.
#include "raster/ops/texel.hpp"
#include "raster/ops/texture_combine.hpp"
#include "raster/span/draw_state.hpp"
#include "raster/span/fused_keys.hpp"
#include "raster/span/of_tier.hpp"
#include <spangle/raster/features.hpp>

namespace spangle::raster {

namespace {

bool unit_on(const TextureUnit& unit) {
    return has_textures && unit.texture != nullptr;
}

/// Sets the texture modes that a fused loop can have. Such a loop has one image with packed rows, no border
/// and wrap mode REPEAT on both axes.
void set_unit(UnitKey& key, const TextureUnit& unit) {
    if (!unit_on(unit))
        return;
    key.on = true;
    const Texture& texture = *unit.texture;
    const TextureLevel& image = texture.level[0];
    const TexelFormat format = sampled(texture.format);
    const bool packed = image.stride == static_cast<std::uint32_t>(image.width * texel_bytes(format));
    key.general = !is_common(format) || texture.shape > TextureShape::plane ||
                  !is_power_of_two(image.width) || !is_power_of_two(image.height) ||
                  texture.mip != MipFilter::none || texture.mag != texture.min ||
                  texture.wrap_s != Wrap::repeat || texture.wrap_t != Wrap::repeat ||
                  texture.border_texels != 0 || !packed || unit.env == TexEnv::combine;
    if (key.general)
        return;
    key.texels = format;
    key.base = texture.base;
    key.filter = texture.mag;
    key.env = unit.env;
}

/// Whether the primary colour, or its alpha, reaches the stages after the texture units (GL 1.3, tables 3.21
/// and 3.22).
bool color_survives(const FragmentState& state, bool alpha) {
    if (spans_only_modulate)
        return true;
    for (const TextureUnit& unit : state.unit) {
        if (!unit_on(unit) || unit.env != TexEnv::replace)
            continue;
        const BaseFormat base = unit.texture->base;
        const bool has_alpha = base != BaseFormat::rgb && base != BaseFormat::luminance;
        const bool has_color = base != BaseFormat::alpha;
        if (alpha ? has_alpha : has_color)
            return false;
    }
    return true;
}

bool source_alpha(BlendFactor f) {
    return f == BlendFactor::src_alpha || f == BlendFactor::one_minus_src_alpha ||
           f == BlendFactor::src_alpha_saturate;
}

bool has_alpha(PixelFormat format) {
    return drawn_info(format).alpha_bits != 0;
}

void blend_key(Key& key, const FragmentState& state) {
    key.blend = state.blend;
    if (!spans_blend)
        return;
    const Blending& rgb = state.blend_rgb;
    const bool same = !has_alpha(key.format) || rgb == state.blend_alpha;
    key.blend = state.blend && !state.logic && !(same && rgb == Blending{});
    if (!key.blend)
        return;
    const auto constant = [](BlendFactor f) { return f >= BlendFactor::constant_color; };
    key.blend_general = !same || rgb.equation != BlendEquation::add || constant(rgb.src) || constant(rgb.dst);
    if (!key.blend_general)
        key.blending = rgb;
}

/// Whether a stage after the texture units reads alpha, in a build whose spans include such stages. `writes`
/// says that colours are written.
bool alpha_is_read(const Key& key, const FragmentState& state, bool writes) {
    return (spans_test_alpha && key.alpha != Compare::always) || (writes && has_alpha(key.format)) ||
           (has_samples && state.alpha_to_coverage) ||
           (spans_blend && key.blend &&
            (source_alpha(state.blend_rgb.src) || source_alpha(state.blend_rgb.dst)));
}

/// Sets the keys of the units whose colour reaches what is read after the texture units. REPLACE hides the
/// units before it. A combiner may read the colours of all units.
void set_units(Key& key, const FragmentState& state, bool reads_color, bool reads_alpha) {
    const bool all = uses_combiners(state) && (reads_color || reads_alpha);
    for (int i = max_texture_units - 1; i >= 0; --i) {
        const TextureUnit& unit = state.unit[i];
        if (!unit_on(unit))
            continue;
        const BaseFormat base = unit.texture->base;
        const bool color = base != BaseFormat::alpha,
                   alpha = base != BaseFormat::rgb && base != BaseFormat::luminance;
        if (all || (reads_color && color) || (reads_alpha && alpha))
            set_unit(key.unit[i], unit);
        if (unit.env == TexEnv::replace) {
            reads_color = reads_color && !color;
            reads_alpha = reads_alpha && !alpha;
        }
    }
}

/// Whether the colour is the 16 bits R5 G6 B5 from its source to the surface.
bool is_raw_565(const Key& key, const FragmentState& state) {
    if (!spans_are_raw || (!has_format(PixelFormat::rgb565_be) && !has_format(PixelFormat::rgb565_le)))
        return false;
    if (!is_565(key.format) || key.fog || key.color_sum || key.alpha != Compare::always || key.blend ||
        key.masked || key.logic || key.stencil || key.samples)
        return false;
    const UnitKey& unit = key.unit[0];
    if (!unit.on && !key.second_unit())
        return has_pixel_colors && key.pixels
                   ? key.kind <= Kind::affine && (!state.dither || state.colors == Colors::of_pixels_565)
                   : key.kind <= Kind::affine;
    if (key.second_unit() || unit.general || unit.filter != Filter::nearest || unit.env != TexEnv::replace ||
        unit.base != BaseFormat::rgb)
        return false;
    if (key.kind == Kind::flat || key.kind == Kind::full)
        return false;
    // Dithering leaves colours of 5 and 6 bits as they are.
    return unit.texels == TexelFormat::rgb565 || (unit.texels == TexelFormat::rgb888 && !state.dither);
}

/// Sets the parts of the key that surfaces of colours and surfaces of indices have in common.
void common_key(Key& key, const FragmentState& state, const Surface& target) {
    key.fog = has_fog && state.fog;
    if (key.fog)
        key.fog_mode = state.fog_mode;
    const bool has_depth =
        depth_formats > 1 && target.depth != nullptr && target.depth_format != DepthFormat::none;
    key.stencil = has_format(DepthFormat::z24s8) && state.stencil_test && target.depth != nullptr &&
                  target.depth_format == DepthFormat::z24s8;
    if (has_depth && state.depth_test) {
        key.depth = state.depth_func;
        key.depth_write = state.depth_write;
    }
    if (key.stencil || key.depth != Compare::always || key.depth_write)
        key.depth_format = target.depth_format;
    key.logic = state.logic && state.logic_op != LogicOp::copy;
    key.count = state.count;
    key.polygon_stipple = SPANGLE_FEATURE_STIPPLE && state.polygon_stipple != nullptr;
    key.depth_offset =
        SPANGLE_FEATURE_POLYGON_OFFSET && state.depth_offset && key.depth_format != DepthFormat::none;
}

/// Sets the key of a surface of indices. GL does not texture, sum, alpha-test or blend indices (GL 1.3, 3.8,
/// 3.9, 4.1.4, 4.1.7). One number system serves all such surfaces.
void index_key(Key& key, const FragmentState& state) {
    key.number = Number::exact;
    key.pixels = has_pixel_colors && state.colors != Colors::of_vertices;
    key.color = !key.pixels;
    key.masked = state.color_mask != 0xFF;
    key.coverage = SPANGLE_FEATURE_ANTIALIASING && state.coverage;
    key.dither = state.dither;
}

} // namespace

Key key_of_any_kind(const FragmentState& state, const Surface& target) {
    Key key;
    key.format = drawn(target.format);
    common_key(key, state, target);
    if (drawn_indexed(key.format)) {
        index_key(key, state);
        return key;
    }
    const std::uint8_t channels = has_alpha(target.format) ? 0xF : 0x7;
    key.masked = (state.color_mask & channels) != channels;
    // Where no channel is written, only the tests read a colour.
    const bool writes = (state.color_mask & channels) != 0;
    if (writes) {
        // In builds without a chain no span has a colour sum.
        key.color_sum = (has_color_sum || !has_chain) && state.color_sum;
        blend_key(key, state);
    } else {
        key.fog = key.logic = false;
        key.fog_mode = {};
    }
    key.samples = has_samples && (state.alpha_to_coverage || state.alpha_to_one || state.sample_coverage);
    const bool any_alpha = (state.alpha_func == Compare::lequal && state.alpha_ref == 255) ||
                           (state.alpha_func == Compare::gequal && state.alpha_ref == 0);
    if (state.alpha_test && !any_alpha)
        key.alpha = state.alpha_func;
    const bool reads_alpha = alpha_is_read(key, state, writes);
    set_units(key, state, writes, reads_alpha);
    key.coverage = SPANGLE_FEATURE_ANTIALIASING && state.coverage && reads_alpha;
    // Combiners may ask for the primary colour in any unit, and for alpha as a colour.
    key.combine = uses_combiners(state) && (writes || reads_alpha);
    key.color = writes && color_survives(state, false);
    key.color_alpha = key.combine || (color_survives(state, true) && reads_alpha);
    key.color = key.color || key.color_alpha;
    if (has_pixel_colors && key.color && state.colors != Colors::of_vertices) {
        key.pixels = true;
        key.color = key.color_alpha = false;
    }
    return key;
}

Key key_of_kind(const Key& any, const FragmentState& state, Kind kind) {
    Key key = any;
    key.kind = kind;
    if (drawn_indexed(key.format))
        return key;
    if (is_raw_565(key, state)) {
        key.number = Number::raw565;
        key.color_alpha = false;
        key.dither = state.dither && key.color; // without a colour of vertices dithering changes nothing
        key.cubic = key.unit[0].on && key.kind == Kind::textured && of_tier<has_cubic_runs>(state);
    } else {
        // Narrow formats, which are those of small displays, have one copy of the code, in the exact number
        // system.
        const bool exact = !has_balanced || of_tier<has_exact_colors>(state) || drawn_narrow(key.format);
        key.number = has_exact && exact ? Number::exact : Number::balanced;
        key.dither = state.dither && is_565(key.format);
        key.coarse = !exact && of_tier<[](const Knobs& k) { return k.coarse_blend; }>(state) &&
                     is_565(key.format) && key.blend && !key.blend_general && key.blending == blend_over;
#if SPANGLE_MIXES_RUNS
        key.other_runs = has_mixed_runs && key.kind >= Kind::textured &&
                         (key.unit[0].on || key.second_unit()) && !drawn_narrow(key.format) &&
                         of_tier<has_cubic_runs>(state) != exact;
#endif
    }
    return key;
}

} // namespace spangle::raster
