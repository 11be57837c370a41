#include "gl/texture/complete.hpp"

#include <bit>

#include "gl/context/tokens.hpp"
#include "gl/texture/compressed_format.hpp"
#include "gl/texture/internal_format.hpp"
#include "raster/span/fused_keys.hpp"

namespace spangle::gl {

namespace {

constexpr bool samples_volumes = raster::spans_sample_any && SPANGLE_FEATURE_TEXTURE_3D,
               samples_palettes = raster::spans_sample_any && SPANGLE_FEATURE_COMPRESSED_TEXTURES;

bool alike(const LevelShape& a, const LevelShape& b) {
    return a.internal_format == b.internal_format && a.border == b.border && a.dimensions == b.dimensions;
}

bool is_next_level(const LevelShape& shape, const LevelShape& base, int step) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::uint32_t halved = base.size_without_border(axis) >> step;
        if (shape.size_without_border(axis) != (halved > 1 ? halved : 1))
            return false;
    }
    return alike(shape, base);
}

/// Returns the number of levels of a face that are sampled, from the base level on. Returns 0 if the face is
/// incomplete.
int usable_levels(const TextureObject& texture, unsigned face) {
    const GLint first = texture.parameters.base_level;
    if (first >= texture_levels || texture.image(face, first) == nullptr)
        return 0;
    const LevelShape& base = texture.image(face, first)->shape;
    if (base.empty())
        return 0;
    // In builds whose spans do not sample every kind of texture, no span samples mipmaps, so the base level
    // is enough.
    if (!raster::spans_sample_any || !has_mipmaps(texture.parameters.min_filter))
        return 1;
    if (first > texture.parameters.max_level)
        return 0;
    // In the terms of GL, p is max(n, m, l) + base, and q is min(p, max_level). As the size of each level is
    // limited, p is less than texture_levels.
    const int chain =
        static_cast<int>(std::bit_width(base.size_without_border(0) | base.size_without_border(1) |
                                        base.size_without_border(2))); // max(n, m, l) + 1 in the terms of GL
    const int wanted = texture.parameters.max_level - first;
    const int count = wanted < chain - 1 ? wanted + 1 : chain;
    for (int step = 1; step < count; ++step) {
        const LevelImage* image = texture.image(face, first + step);
        if (image == nullptr || !is_next_level(image->shape, base, step))
            return 0;
    }
    return count;
}

/// Returns the number of levels that are sampled in every face. Returns 0 if the texture is incomplete.
int usable_levels(const TextureObject& texture) {
    if (existing_kind(texture.kind) == TextureKind::cube && !is_cube_complete(texture))
        return 0;
    const int count = usable_levels(texture, 0);
    for (unsigned face = 1; face < texture.faces(); ++face)
        if (usable_levels(texture, face) != count)
            return 0;
    return count;
}

/// Returns the address of the first texel inside the border.
const std::uint8_t* inner_texels(const LevelImage& image) {
    const LevelShape& shape = image.shape;
    if (!raster::spans_sample_any) // without spans_sample_any, no span samples a border
        return image.texels;
    return image.texels + shape.border_along(2) * image.slice() + shape.border_along(1) * image.stride +
           shape.border_along(0) * texel_size(shape.format);
}

raster::TextureLevel view_of(const LevelImage& image) {
    const LevelShape& shape = image.shape;
    const auto side = [&](unsigned axis) {
        return raster::spans_sample_any ? static_cast<std::uint16_t>(shape.size_without_border(axis))
                                        : shape.size[axis];
    };
    return {inner_texels(image), side(0), side(1), image.stride};
}

raster::Wrap wrap_of(GLenum mode) {
    if (!raster::spans_sample_any) // without spans_sample_any, all modes but REPEAT are refused
        return mode == GL_REPEAT ? raster::Wrap::repeat : raster::Wrap::clamp;
    return static_cast<raster::Wrap>(place_in(wraps, mode));
}

void set_filters(const TextureObject& texture, raster::Texture& view) {
    const GLenum min = texture.parameters.min_filter;
    view.mag = filter_of(texture.parameters.mag_filter);
    view.min = filter_of(min);
    view.mip = mip_filter_of(min);
}

raster::TextureShape shape_of(TextureKind kind) {
    switch (existing_kind(kind)) {
    case TextureKind::one:
        return raster::TextureShape::line;
    case TextureKind::two:
        break;
    case TextureKind::three:
        return raster::TextureShape::volume;
    case TextureKind::cube:
        return raster::TextureShape::cube;
    }
    return raster::TextureShape::plane;
}

void set_faces([[maybe_unused]] const TextureObject& texture, [[maybe_unused]] raster::Texture& view) {
#if SPANGLE_FEATURE_TEXTURE_CUBE_MAP
    if (texture.kind != TextureKind::cube)
        return;
    raster::CubeFaces& faces = reinterpret_cast<const CubeTexture&>(texture).view_faces;
    for (unsigned face = 0; face < cube_faces; ++face)
        for (int l = 0; l < view.level_count; ++l)
            faces.texels[face][l] = inner_texels(*texture.image(face, texture.parameters.base_level + l));
    view.faces = &faces;
#endif
}

#if SPANGLE_FEATURE_DEPTH_TEXTURES

/// Sets how a depth texel becomes a colour, and how it is compared (GL 1.4, 3.8.5 and 3.8.14).
void set_depth(const TextureParameters& p, raster::Texture& view) {
    view.base = p.depth_mode == GL_ALPHA       ? raster::BaseFormat::alpha
                : p.depth_mode == GL_INTENSITY ? raster::BaseFormat::intensity
                                               : raster::BaseFormat::luminance;
    view.compares = p.compare_mode != GL_NONE;
    view.compare = compare_of(p.compare_func);
}

#endif

void set_format(const TextureObject& texture, const LevelImage& base, raster::Texture& view) {
    const LevelShape& shape = base.shape;
    view.format = raster::sampled(shape.format);
    view.base = base_format_of(view.format, shape.internal_format);
    if (samples_palettes)
        view.palette = base.palette;
    if (samples_palettes && base.palette != nullptr)
        view.palette_format = palette_format_of(shape.internal_format);
    view.compares = false;
#if SPANGLE_FEATURE_DEPTH_TEXTURES
    if (is_depth(shape.format))
        set_depth(texture.parameters, view);
#endif
    static_cast<void>(texture);
}

/// Sets the border colour in the form that a texel of the base format has (GL 1.3, 3.8.8, table 3.15).
void set_border_color(const TextureParameters& parameters, raster::Texture& view) {
    using raster::BaseFormat;
    std::uint8_t* const c = view.border_color;
    for (int i = 0; i < 4; ++i)
        c[i] = static_cast<std::uint8_t>(numeric::to_unit(parameters.border_color[i], 8));
    const bool grey = view.base == BaseFormat::luminance || view.base == BaseFormat::luminance_alpha ||
                      view.base == BaseFormat::intensity;
    if (grey)
        c[1] = c[2] = c[0];
    if (view.base == BaseFormat::luminance || view.base == BaseFormat::rgb)
        c[3] = 255;
    if (view.base == BaseFormat::intensity)
        c[3] = c[0];
}

void build(const TextureObject& texture) {
    texture.view_valid = true;
    const int count = usable_levels(texture);
    texture.complete = count != 0;
    if (!texture.complete)
        return;
    raster::Texture& view = texture.view;
    const TextureParameters& parameters = texture.parameters;
    const LevelImage& base = *texture.level[parameters.base_level];
    view.level_count = static_cast<std::uint8_t>(count);
    for (int l = 0; l < count; ++l)
        view.level[l] = view_of(*texture.level[parameters.base_level + l]);
    view.shape = shape_of(texture.kind);
    if (samples_volumes)
        view.depth = static_cast<std::uint16_t>(base.shape.size_without_border(2));
    set_faces(texture, view);
    set_format(texture, base, view);
    view.wrap_s = wrap_of(parameters.wrap[0]);
    // 1D textures repeat their single row.
    view.wrap_t = base.shape.dimension_count() > 1 ? wrap_of(parameters.wrap[1]) : raster::Wrap::repeat;
    if (samples_volumes)
        view.wrap_r = wrap_of(parameters.wrap[2]);
    set_filters(texture, view);
    view.border_texels = base.shape.border;
    if (!raster::spans_sample_any)
        return;
    view.min_lod = numeric::to_fixed(parameters.min_lod, 8);
    view.max_lod = numeric::to_fixed(parameters.max_lod, 8);
    set_border_color(parameters, view);
}

const TextureObject* enabled_texture(const Context& context, int unit) {
    const TextureUnitState& state = context.texture.unit[unit];
    for (int kind = texture_kinds - 1; kind >= 0; --kind) // CUBE_MAP, 3D, 2D, 1D (GL 1.3, 3.8.15)
        if (state.enabled[kind])
            return &context.texture.bound(static_cast<unsigned>(unit), static_cast<TextureKind>(kind));
    return nullptr;
}

} // namespace

bool is_cube_complete(const TextureObject& texture) {
    const GLint level = texture.parameters.base_level;
    if (level >= texture_levels)
        return false;
    const LevelImage* const first = texture.image(0, level);
    for (unsigned face = 0; face < cube_faces; ++face) {
        const LevelImage* const image = texture.image(face, level);
        if (image == nullptr || image->shape.empty() || image->shape.size[0] != first->shape.size[0] ||
            !alike(image->shape, first->shape))
            return false;
    }
    return true;
}

const raster::Texture* complete_texture(const TextureObject& texture) {
    if (!texture.view_valid)
        build(texture);
    return texture.complete ? &texture.view : nullptr;
}

const TextureObject* sampled_texture(const Context& context, int unit) {
    const TextureObject* const texture = enabled_texture(context, unit);
    return texture != nullptr && complete_texture(*texture) != nullptr ? texture : nullptr;
}

} // namespace spangle::gl
