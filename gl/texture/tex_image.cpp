// TexImage2D and TexSubImage2D (GL 1.3, 3.8.1, 3.8.2).
#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/internal_format.hpp"
#include "gl/texture/store_texels.hpp"

namespace spangle::gl {

namespace {

/// Format and type of a client image of colours.
GLenum color_layout(GLenum format, GLenum type, PixelLayout& layout) {
    if (format == GL_DEPTH_COMPONENT || format == GL_STENCIL_INDEX)
        return GL_INVALID_ENUM;
    return pixel_layout(format, type, layout);
}

/// 2^n + 2b, not above the largest size of the level; or 0, the null texture.
bool legal_side(GLsizei side, GLint border, GLint level) {
    if (side == 0)
        return border == 0;
    const GLsizei inner = side - 2 * border;
    return inner > 0 && (inner & (inner - 1)) == 0 && inner <= max_texture_size >> level;
}

/// Levels of one texture and one internal format are kept alike, whichever surface was current.
raster::TexelFormat format_beside(const TextureObject& texture, GLint level, LevelShape shape) {
    for (int l = 0; l < texture_levels; ++l)
        if (l != level && texture.level[l] != nullptr &&
            texture.level[l]->shape.internal_format == shape.internal_format)
            return texture.level[l]->shape.format;
    return shape.format;
}

LevelImage* new_image(Arena& arena, const LevelShape& shape) {
    const std::uint32_t stride = shape.width * texel_bytes(shape.format);
    const std::size_t texels = std::size_t{stride} * shape.height;
    auto* image = static_cast<LevelImage*>(arena.allocate(sizeof(LevelImage) + texels));
    if (image != nullptr)
        *image = {shape, stride};
    return image;
}

void replace_level(Context& context, GLint level, LevelShape shape, const PixelLayout& layout,
                   const void* pixels) {
    TextureObject& texture = context.texture.bound(context.texture.active);
    Arena& arena = context.share->arena;
    shape.format = format_beside(texture, level, shape);
    LevelImage* image = new_image(arena, shape);
    if (image == nullptr)
        return error(context, GL_OUT_OF_MEMORY,
                     SPANGLE_TEXT("glTexImage2D: no room in the arena for this level"));
    if (pixels != nullptr)
        store_texels(context, *image, {0, 0, shape.width, shape.height}, layout, pixels);
    else // GL leaves them undefined; here no earlier texels shine through
        std::memset(image->texels(), 0, std::size_t{image->stride} * shape.height);
    arena.free(texture.level[level]);
    texture.level[level] = image;
    texture.view_valid = false;
    ++context.share->texture_changes; // another context's compiled state may point at the old texels
    context.changed(dirty_fragment);
}

} // namespace

namespace cmd {

void TexImage2D(Context& context, GLenum target, GLint level, GLint internalformat, GLsizei width,
                GLsizei height, GLint border, GLenum format, GLenum type, const void* pixels) {
    if (target != GL_TEXTURE_2D && target != GL_PROXY_TEXTURE_2D)
        return error(context, GL_INVALID_ENUM);
    PixelLayout layout;
    const GLenum refused = color_layout(format, type, layout);
    if (refused != GL_NO_ERROR)
        return error(context, refused, SPANGLE_TEXT("glTexImage2D: format and type do not go together"));
    LevelShape shape;
    if (!texel_format_of(internalformat, context.drawable.surface.format, shape.format))
        return error(context, GL_INVALID_VALUE,
                     SPANGLE_TEXT("glTexImage2D: not an internal format of GL 1.3"));
    if (level < 0 || level >= texture_levels || border < 0 || border > 1 || width < 0 || height < 0)
        return error(context, GL_INVALID_VALUE);
    const bool legal = legal_side(width, border, level) && legal_side(height, border, level);
    if (legal) {
        shape.width = static_cast<std::uint16_t>(width);
        shape.height = static_cast<std::uint16_t>(height);
        shape.internal_format = static_cast<std::uint16_t>(internalformat);
        shape.border = static_cast<std::uint8_t>(border);
    }
    if (target ==
        GL_PROXY_TEXTURE_2D) { // too large is an answer, all zero, and not an error (GL 1.3, 3.8.10)
        context.texture.proxy_2d[level] = shape;
        return;
    }
    if (!legal)
        return error(context, GL_INVALID_VALUE,
                     SPANGLE_TEXT("glTexImage2D: sides are 2^n + 2 border, up to 2048"));
    replace_level(context, level, shape, layout, pixels);
}

void TexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                   GLsizei height, GLenum format, GLenum type, const void* pixels) {
    if (target != GL_TEXTURE_2D)
        return error(context, GL_INVALID_ENUM);
    PixelLayout layout;
    const GLenum refused = color_layout(format, type, layout);
    if (refused != GL_NO_ERROR)
        return error(context, refused, SPANGLE_TEXT("glTexSubImage2D: format and type do not go together"));
    if (level < 0 || level >= texture_levels || width < 0 || height < 0)
        return error(context, GL_INVALID_VALUE);
    LevelImage* image = context.texture.bound(context.texture.active).level[level];
    if (image == nullptr)
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("glTexSubImage2D: the level has no image yet"));
    const LevelShape& shape = image->shape;
    // From the array's first texel, which is -border.
    const std::int64_t x = std::int64_t{xoffset} + shape.border, y = std::int64_t{yoffset} + shape.border;
    if (x < 0 || y < 0 || x + width > shape.width || y + height > shape.height)
        return error(context, GL_INVALID_VALUE,
                     SPANGLE_TEXT("glTexSubImage2D: the rectangle leaves the image"));
    if (width == 0 || height == 0)
        return;
    if (pixels == nullptr)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("glTexSubImage2D: null pointer"));
    const TexelRect rect{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                         static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
    store_texels(context, *image, rect, layout, pixels);
}

} // namespace cmd

} // namespace spangle::gl
