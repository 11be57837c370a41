#include "gl/texture/image_shape.hpp"

#include <cstring>

#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/compressed_format.hpp"
#include "gl/texture/level_image.hpp"

namespace spangle::gl {

namespace {

/// 0, the null texture, or a side that is not above the largest of the level. It need not be a power of two
/// (GL 2.0, 3.8.1).
bool legal_side(GLsizei side, GLint border, GLsizei most) {
    if (side == 0)
        return border == 0;
    const std::int64_t inner = std::int64_t{side} - 2 * border;
    return inner > 0 && inner <= most;
}

bool legal_sides(const ImageRequest& request) {
    const TextureKind kind = request.target.kind;
    const GLsizei most =
        (kind == TextureKind::three ? max_3d_texture_size : max_texture_size) >> request.level;
    for (unsigned axis = 0; axis < dimensions_of(kind); ++axis)
        if (!legal_side(request.size[axis], request.border, most))
            return false;
    return kind != TextureKind::cube || request.size[0] == request.size[1];
}

/// The image, which is there: constant memory is not written, nor what recorded draws look at, so these
/// become a copy in the arena.
LevelImage* writable(Context& context, const SubImage& sub) {
    TextureObject& texture = bound_texture(context, sub.target.kind);
    LevelImage*& place = texture.image(sub.target.face, sub.level);
    if (place->texels == place->own_texels() && !is_recorded(*context.share, *place))
        return place;
    LevelImage* const copy = new_image(context.share->arena, place->shape);
    if (copy == nullptr) {
        error(context, GL_OUT_OF_MEMORY,
              SPANGLE_TEXT("glTexSubImage: no room in the arena for a copy of the image, which is constant "
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

bool shape_of(Context& context, ImageRequest request, LevelShape& out) {
    out = {};
    const TextureKind kind = request.target.kind;
    if (!texel_format_of(request.internal_format, context.drawable.surface.format, out.format)) {
        error(context, GL_INVALID_VALUE,
              SPANGLE_TEXT("glTexImage: not an internal format, or one that this build leaves out "
                           "(SPANGLE_TEXTURE_FORMATS)"));
        return false;
    }
    if (is_depth(out.format) && kind != TextureKind::one && kind != TextureKind::two) {
        error(context, GL_INVALID_OPERATION,
              SPANGLE_TEXT("glTexImage: depths are 1D and 2D (GL 1.4, 3.8.1)"));
        return false;
    }
    bool negative = false;
    for (unsigned axis = 0; axis < dimensions_of(kind); ++axis)
        negative = negative || request.size[axis] < 0;
    if (!is_level(request.level) || request.border < 0 || request.border > 1 || negative) {
        error(context, GL_INVALID_VALUE);
        return false;
    }
    const bool legal = legal_sides(request);
    if (!legal && !request.target.proxy) {
        error(context, GL_INVALID_VALUE, SPANGLE_TEXT("glTexImage: too large, or a cube that is not square"));
        return false;
    }
    if (!legal) // too large is an answer, all zero, and not an error (GL 1.3, 3.8.10)
        return true;
    out.dimensions = static_cast<std::uint8_t>(dimensions_of(kind));
    for (unsigned axis = 0; axis < 3; ++axis)
        out.size[axis] =
            axis < out.dimensions ? static_cast<std::uint16_t>(request.size[axis]) : std::uint16_t{1};
    out.internal_format = static_cast<std::uint16_t>(request.internal_format);
    out.border = static_cast<std::uint8_t>(request.border);
    return true;
}

LevelImage* find_box(Context& context, const SubImage& sub, TexelBox& out) {
    const unsigned dimensions = dimensions_of(sub.target.kind);
    bool negative = !is_level(sub.level);
    for (unsigned axis = 0; axis < dimensions; ++axis)
        negative = negative || sub.size[axis] < 0;
    if (negative) {
        error(context, GL_INVALID_VALUE);
        return nullptr;
    }
    LevelImage* const image = bound_texture(context, sub.target.kind).image(sub.target.face, sub.level);
    if (image == nullptr) {
        error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("glTexSubImage: the level has no image yet"));
        return nullptr;
    }
    if (is_compressed(image->shape.internal_format)) {
        error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("glTexSubImage: the image is compressed"));
        return nullptr;
    }
    for (unsigned axis = 0; axis < 3; ++axis) {
        // From the array's first texel, which is -border.
        const std::int64_t at = axis < dimensions ? std::int64_t{sub.at[axis]} + image->shape.border : 0;
        const GLsizei size = axis < dimensions ? sub.size[axis] : 1;
        if (at < 0 || at + size > image->shape.size[axis]) {
            error(context, GL_INVALID_VALUE, SPANGLE_TEXT("glTexSubImage: the box leaves the image"));
            return nullptr;
        }
        out.at[axis] = static_cast<std::uint32_t>(at);
        out.size[axis] = static_cast<std::uint32_t>(size);
    }
    return writable(context, sub);
}

TexelBox whole_box(const LevelShape& shape) {
    return {{0, 0, 0}, {shape.size[0], shape.size[1], shape.size[2]}};
}

} // namespace spangle::gl
