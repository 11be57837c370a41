#include "gl/texture/image_shape.hpp"

#include <cstring>

#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/compressed_format.hpp"
#include "gl/texture/level_image.hpp"

namespace spangle::gl {

namespace {

/// Whether the length of a side is legal. It may be 0, which makes the null texture, and up to the largest
/// length of the level. It need not be a power of two (GL 2.0, 3.8.1). `side` and `border` must not be
/// negative.
bool legal_side(GLsizei side, std::uint32_t border, std::uint32_t most) {
    const std::uint32_t inner = static_cast<std::uint32_t>(side) - 2 * border;
    return side == 0 ? border == 0 : inner - 1 < most;
}

/// The message for a side that legal_side() refuses.
const char* rule_of_side([[maybe_unused]] unsigned axis) {
    return axis == 0
               ? SPANGLE_TEXT("width is above the largest of this level (SPANGLE_TEXTURE_LEVELS), or no "
                              "more than its border")
           : axis == 1
               ? SPANGLE_TEXT("height is above the largest of this level (SPANGLE_TEXTURE_LEVELS), or no "
                              "more than its border")
               : SPANGLE_TEXT("depth is above the largest of this level (SPANGLE_TEXTURE_LEVELS), or no "
                              "more than its border");
}

/// Returns the existing image of a level, ready to be written. If the image lies in constant memory or
/// recorded draws use it, a copy in the arena replaces it first.
LevelImage* writable(Context& context, const SubImage& sub) {
    TextureObject& texture = bound_texture(context, sub.target.kind);
    LevelImage*& place = texture.image(sub.target.face, sub.level);
    if (place->texels == place->own_texels() && !is_recorded(*context.share, *place))
        return place;
    LevelImage* const copy = new_image(context.share->arena, place->shape);
    if (copy == nullptr) {
        error(context, GL_OUT_OF_MEMORY,
              SPANGLE_TEXT("no room in the arena for a copy of the image, which is constant "
                           "or recorded"));
        return nullptr;
    }
    std::memcpy(copy->own_texels(), place->texels, place->bytes);
    discard_image(*context.share, place);
    place = copy;
    texture_changed(context, texture);
    return copy;
}

} // namespace

bool shape_of(Context& context, const ImageRequest& request, LevelShape& shape) {
    const TextureKind kind = existing_kind(request.target.kind);
    GLint internal_format = request.internal_format;
    if (!texel_format_of(internal_format, context.drawable.surface.format, shape.format)) {
        error(context, GL_INVALID_VALUE,
              SPANGLE_TEXT("internalformat is not an internal format, or one that this build leaves out "
                           "(SPANGLE_TEXTURE_FORMATS)"));
        return false;
    }
    if (is_depth(shape.format) && kind != TextureKind::one && kind != TextureKind::two) {
        error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("depths are 1D and 2D (GL 1.4, 3.8.1)"));
        return false;
    }
    shape.internal_format = static_cast<std::uint16_t>(internal_format);
    shape.border = static_cast<std::uint8_t>(request.border);
    shape.dimensions = static_cast<std::uint8_t>(dimensions_of(kind));
    const std::uint32_t most = static_cast<std::uint32_t>(
        (kind == TextureKind::three ? max_3d_texture_size : max_texture_size) >> (request.level & 15));
    bool negative = false, legal = kind != TextureKind::cube || request.size[0] == request.size[1];
    [[maybe_unused]] const char* rule = SPANGLE_TEXT("height is not the width, as a cube's is");
    for (unsigned axis = 0; axis < 3; ++axis) {
        const GLsizei side = request.size[axis];
        negative = negative || side < 0;
        const bool fits = legal_side(side, shape.border_along(axis), most);
        rule = fits ? rule : rule_of_side(axis);
        legal = legal && fits;
        shape.size[axis] = static_cast<std::uint16_t>(side);
    }
    if (!is_level(request.level) || request.border < 0 || request.border > 1 || negative) {
        error(context, GL_INVALID_VALUE,
              is_level(request.level)
                  ? SPANGLE_TEXT("border is neither 0 nor 1")
                  : SPANGLE_TEXT("level is above the smallest image of the largest texture "
                                 "(SPANGLE_TEXTURE_LEVELS)"));
        return false;
    }
    if (!legal && !request.target.proxy) {
        error(context, GL_INVALID_VALUE, rule);
        return false;
    }
    if (!legal) { // a proxy answers with an empty shape instead of an error (GL 1.3, 3.8.10)
        const raster::TexelFormat format = shape.format;
        shape = {};
        shape.format = format;
    }
    return true;
}

LevelImage* find_box(Context& context, const SubImage& sub, TexelBox& out) {
    bool negative = !is_level(sub.level);
    for (const GLsizei size : sub.size)
        negative = negative || size < 0;
    if (negative) {
        error(context, GL_INVALID_VALUE,
              SPANGLE_TEXT("level is above the smallest image of the largest texture "
                           "(SPANGLE_TEXTURE_LEVELS)"));
        return nullptr;
    }
    LevelImage* const image = bound_texture(context, sub.target.kind).image(sub.target.face, sub.level);
    if (image == nullptr) {
        error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("the level has no image yet"));
        return nullptr;
    }
    if (is_compressed(image->shape.internal_format)) {
        error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("the image is compressed"));
        return nullptr;
    }
    for (unsigned axis = 0; axis < 3; ++axis) {
        // The offset counts from the array's first texel, whose coordinate is -border. For a texel before the
        // first, the unsigned offset is larger than any size.
        const std::uint32_t at = static_cast<std::uint32_t>(sub.at[axis]) + image->shape.border_along(axis),
                            size = static_cast<std::uint32_t>(sub.size[axis]), all = image->shape.size[axis];
        if (at > all || size > all - at) {
            error(context, GL_INVALID_VALUE, SPANGLE_TEXT("the box leaves the image"));
            return nullptr;
        }
        out.at[axis] = at;
        out.size[axis] = size;
    }
    return writable(context, sub);
}

TexelBox whole_box(const LevelShape& shape) {
    return {{0, 0, 0}, {shape.size[0], shape.size[1], shape.size[2]}};
}

} // namespace spangle::gl
