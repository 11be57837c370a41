// CompressedTexImage and CompressedTexSubImage (GL 1.3, 3.8.3), for paletted images and ETC1. A paletted
// image has all levels at once, and a `level` of -n means that it has n + 1 levels
// (OES_compressed_paletted_texture). Images are sampled in compressed form, from the arena or from the
// program's constant memory.
#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/compressed_format.hpp"
#include "gl/texture/image_shape.hpp"
#include "gl/texture/level_image.hpp"

#if SPANGLE_FEATURE_COMPRESSED_TEXTURES

namespace spangle::gl {

namespace {

std::uint16_t level_size(std::uint32_t base, GLint step) {
    return static_cast<std::uint16_t>(base >> step > 1 ? base >> step : base == 0 ? 0u : 1u);
}

struct CompressedImage {
    GLenum internal_format;
    ImageTarget target;
    GLint first, levels; ///< first level, and number of levels
    std::uint32_t width, height;
    const std::uint8_t* data;
    bool constant; ///< data lies in constant memory, and is not copied

    LevelShape shape(GLint step) const {
        LevelShape shape;
        shape.size[0] = level_size(width, step);
        shape.size[1] = level_size(height, step);
        shape.size[2] = 1;
        shape.internal_format = static_cast<std::uint16_t>(internal_format);
        shape.format = compressed_texels_of(internal_format);
        return shape;
    }
    std::uint32_t bytes(GLint step) const {
        return compressed_bytes(internal_format, level_size(width, step), level_size(height, step));
    }
    /// Returns the bytes of the palette and all levels. The sum fits 32 bits, because the size of the first
    /// level is limited.
    std::uint32_t all_bytes() const {
        std::uint32_t sum = palette_bytes(internal_format);
        for (GLint step = 0; step < levels; ++step)
            sum += bytes(step);
        return sum;
    }
};

/// Makes the image of one level. If the data is copied, each level gets its own copy of the palette, so that
/// levels can be freed one by one.
LevelImage* make_level(Arena& arena, const CompressedImage& from, GLint step, const std::uint8_t* texels) {
    const std::uint32_t palette = palette_bytes(from.internal_format), bytes = from.bytes(step);
    const std::size_t kept = from.constant ? 0 : std::size_t{palette} + bytes;
    auto* const image = static_cast<LevelImage*>(arena.allocate(sizeof(LevelImage) + kept));
    if (image == nullptr)
        return nullptr;
    const std::uint8_t* entries = from.data;
    if (!from.constant) {
        std::uint8_t* const own = image->own_texels();
        std::memcpy(own, entries, palette);
        texels = static_cast<std::uint8_t*>(std::memcpy(own + palette, texels, bytes));
        entries = own;
    }
    *image = {from.shape(step), 0, bytes, texels, {palette != 0 ? entries : nullptr}};
    return image;
}

/// Puts the new levels into the texture. Older paletted levels beyond them are discarded, because their
/// palette differs.
void put_levels(Context& context, const CompressedImage& from, LevelImage* const made[]) {
    TextureObject& texture = bound_texture(context, from.target.kind);
    for (GLint l = 0; l < texture_levels; ++l) {
        const bool comes = l >= from.first && l < from.first + from.levels;
        LevelImage*& place = texture.image(from.target.face, l);
        if (!comes && (place == nullptr || !is_palette(place->shape.internal_format)))
            continue;
        discard_image(*context.share, place);
        place = comes ? made[l - from.first] : nullptr;
    }
    texture_changed(context, texture);
}

void load(Context& context, const CompressedImage& from) {
    LevelImage* made[texture_levels] = {};
    const std::uint8_t* texels = from.data + palette_bytes(from.internal_format);
    for (GLint step = 0; step < from.levels; texels += from.bytes(step), ++step) {
        made[step] = make_level(context.share->arena, from, step, texels);
        if (made[step] != nullptr)
            continue;
        for (LevelImage* image : made)
            context.share->arena.free(image);
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for this level"));
    }
    put_levels(context, from, made);
}

void compressed_image(Context& context, GLenum target, GLint level, GLenum internal_format, GLsizei width,
                      GLsizei height, GLint border, GLsizei size, const void* data, bool constant) {
    ImageTarget of;
    if (!is_compressed(internal_format) || !is_held(internal_format))
        return error(context, GL_INVALID_ENUM,
                     SPANGLE_TEXT("not a compressed format of this GL, or one that this build "
                                  "leaves out (SPANGLE_TEXTURE_FORMATS)"));
    if (!find_image_target(context, target, 2, of))
        return;
    const bool palette = is_palette(internal_format);
    const GLint levels = palette && level < 0 && level > -texture_levels ? 1 - level : 1;
    const GLint first = palette && levels > 1 ? 0 : level;
    if (!is_level(first) || (palette && level > 0) || border != 0 || width < 0 || height < 0 ||
        width > max_texture_size >> first || height > max_texture_size >> first ||
        (of.kind == TextureKind::cube && width != height))
        return error(context, GL_INVALID_VALUE,
                     SPANGLE_TEXT("border is not 0, the level or its sizes are beyond the largest texture, "
                                  "or a cube is not square"));
    const CompressedImage from{internal_format,
                               of,
                               first,
                               levels,
                               static_cast<std::uint32_t>(width),
                               static_cast<std::uint32_t>(height),
                               static_cast<const std::uint8_t*>(data),
                               constant};
    if (static_cast<std::uint32_t>(size) != from.all_bytes())
        return error(context, GL_INVALID_VALUE,
                     SPANGLE_TEXT("imageSize is not that of the format and sizes"));
    if (of.proxy) {
        context.texture.proxy(of.kind, first) = from.shape(0);
        return;
    }
    if (data == nullptr)
        return error(context, GL_INVALID_VALUE);
    load(context, from);
}

} // namespace

namespace cmd {

void CompressedTexImage2D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width,
                          GLsizei height, GLint border, GLsizei imageSize, const void* data) {
    compressed_image(context, target, level, internalformat, width, height, border, imageSize, data, false);
}

void CompressedTexConstantImage2DSPANGLE(Context& context, GLenum target, GLint level, GLenum internalformat,
                                         GLsizei width, GLsizei height, GLint border, GLsizei imageSize,
                                         const void* data) {
    compressed_image(context, target, level, internalformat, width, height, border, imageSize, data, true);
}

/// No compressed format has one or three dimensions, so these commands always fail.
void CompressedTexImage1D(Context& context, GLenum, GLint, GLenum, GLsizei, GLint, GLsizei, const void*) {
    error(context, GL_INVALID_ENUM, SPANGLE_TEXT("no compressed format has one dimension"));
}
void CompressedTexImage3D(Context& context, GLenum, GLint, GLenum, GLsizei, GLsizei, GLsizei, GLint, GLsizei,
                          const void*) {
    error(context, GL_INVALID_ENUM, SPANGLE_TEXT("no compressed format has three dimensions"));
}
void CompressedTexSubImage1D(Context& context, GLenum, GLint, GLint, GLsizei, GLenum, GLsizei, const void*) {
    error(context, GL_INVALID_ENUM, SPANGLE_TEXT("no compressed format has one dimension"));
}
void CompressedTexSubImage3D(Context& context, GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei,
                             GLenum, GLsizei, const void*) {
    error(context, GL_INVALID_ENUM, SPANGLE_TEXT("no compressed format has three dimensions"));
}
void CompressedTexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                             GLsizei width, GLsizei height, GLenum format, GLsizei imageSize,
                             const void* data) {
    ImageTarget of;
    if (!is_compressed(format))
        return error(context, GL_INVALID_ENUM,
                     SPANGLE_TEXT("format is not a compressed format of this build"));
    if (!find_stored_target(context, target, 2, of))
        return;
    if (!is_level(level) || width < 0 || height < 0 || imageSize < 0)
        return error(context, GL_INVALID_VALUE,
                     SPANGLE_TEXT("level is above the smallest image of the largest texture"));
    const LevelImage* const image = bound_texture(context, of.kind).image(of.face, level);
    const bool whole = image != nullptr && image->shape.internal_format == format && xoffset == 0 &&
                       yoffset == 0 && width == image->shape.size[0] && height == image->shape.size[1];
    if (!whole || is_palette(format))
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("only the whole of an image of that format"));
    compressed_image(context, target, level, format, width, height, 0, imageSize, data, false);
}

} // namespace cmd

} // namespace spangle::gl

#endif
