#include "gl/texture/complete.hpp"

#include <bit>

#include "gl/texture/internal_format.hpp"

namespace spangle::gl {

namespace {

bool has_mipmaps(GLenum min_filter) {
    return min_filter >= GL_NEAREST_MIPMAP_NEAREST;
}

std::uint32_t inner(std::uint32_t side, const LevelShape& shape) {
    return side - 2u * shape.border;
}

bool follows(const LevelShape& shape, const LevelShape& base, int step) {
    const auto side = [&](std::uint32_t base_side) {
        const std::uint32_t halved = inner(base_side, base) >> step;
        return halved > 1 ? halved : 1;
    };
    return shape.internal_format == base.internal_format && shape.border == base.border &&
           inner(shape.width, shape) == side(base.width) && inner(shape.height, shape) == side(base.height);
}

/// Levels to sample, the base level first; 0: incomplete.
int usable_levels(const TextureObject& texture) {
    if (texture.parameters.base_level >= texture_levels ||
        texture.level[texture.parameters.base_level] == nullptr)
        return 0;
    const LevelShape& base = texture.level[texture.parameters.base_level]->shape;
    if (base.width == 0 || base.height == 0)
        return 0;
    if (!has_mipmaps(texture.parameters.min_filter))
        return 1;
    if (texture.parameters.base_level > texture.parameters.max_level)
        return 0;
    // p = max(n, m) + base, q = min(p, max_level); a level's largest size keeps p below texture_levels.
    const int chain =
        static_cast<int>(std::bit_width(inner(base.width, base) | inner(base.height, base))); // max(n, m) + 1
    const int wanted = texture.parameters.max_level - texture.parameters.base_level;
    const int count = wanted < chain - 1 ? wanted + 1 : chain;
    for (int step = 1; step < count; ++step) {
        const LevelImage* image = texture.level[texture.parameters.base_level + step];
        if (image == nullptr || !follows(image->shape, base, step))
            return 0;
    }
    return count;
}

raster::TextureLevel view_of(const LevelImage& image) {
    const LevelShape& shape = image.shape;
    const std::uint32_t border_bytes = shape.border * (image.stride + texel_bytes(shape.format));
    return {image.texels() + border_bytes, static_cast<std::uint16_t>(inner(shape.width, shape)),
            static_cast<std::uint16_t>(inner(shape.height, shape)), image.stride};
}

raster::Wrap wrap_of(GLenum mode) {
    switch (mode) {
    case GL_CLAMP:
        return raster::Wrap::clamp;
    case GL_CLAMP_TO_EDGE:
        return raster::Wrap::clamp_to_edge;
    case GL_CLAMP_TO_BORDER:
        return raster::Wrap::clamp_to_border;
    default:
        return raster::Wrap::repeat;
    }
}

void set_filters(const TextureObject& texture, raster::Texture& view) {
    view.mag = texture.parameters.mag_filter == GL_LINEAR ? raster::Filter::linear : raster::Filter::nearest;
    const GLenum min = texture.parameters.min_filter;
    const bool linear = min == GL_LINEAR || min == GL_LINEAR_MIPMAP_NEAREST || min == GL_LINEAR_MIPMAP_LINEAR;
    view.min = linear ? raster::Filter::linear : raster::Filter::nearest;
    view.mip = !has_mipmaps(min) ? raster::MipFilter::none
               : min == GL_NEAREST_MIPMAP_NEAREST || min == GL_LINEAR_MIPMAP_NEAREST
                   ? raster::MipFilter::nearest
                   : raster::MipFilter::linear;
}

void build(const TextureObject& texture) {
    texture.view_valid = true;
    const int count = usable_levels(texture);
    texture.complete = count != 0;
    if (!texture.complete)
        return;
    raster::Texture& view = texture.view;
    const LevelShape& base = texture.level[texture.parameters.base_level]->shape;
    view.level_count = static_cast<std::uint8_t>(count);
    for (int l = 0; l < count; ++l)
        view.level[l] = view_of(*texture.level[texture.parameters.base_level + l]);
    view.format = base.format;
    view.base = base_format_of(base.format);
    view.wrap_s = wrap_of(texture.parameters.wrap_s);
    view.wrap_t = wrap_of(texture.parameters.wrap_t);
    set_filters(texture, view);
    view.border_texels = base.border;
    view.min_lod = numeric::to_fixed(texture.parameters.min_lod, 8);
    view.max_lod = numeric::to_fixed(texture.parameters.max_lod, 8);
    for (int c = 0; c < 4; ++c)
        view.border_color[c] =
            static_cast<std::uint8_t>(numeric::to_unit(texture.parameters.border_color[c], 8));
}

} // namespace

const raster::Texture* complete_texture(const Context& context, int unit) {
    const TextureObject& texture = context.texture.bound(static_cast<unsigned>(unit));
    if (!texture.view_valid)
        build(texture);
    return texture.complete ? &texture.view : nullptr;
}

} // namespace spangle::gl
