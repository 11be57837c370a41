// GetTexImage and GetCompressedTexImage (GL 1.3, 6.1.4).
#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/batches.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/row_converter.hpp"
#include "gl/texture/compressed_format.hpp"
#include "gl/texture/image_shape.hpp"

namespace spangle::gl {

namespace {

/// Finds the image of a level. Returns null after an error, and an empty image for a level that has none.
const LevelImage* find_image(Context& context, GLenum target, GLint level) {
    static constexpr LevelImage none{};
    ImageTarget of;
    if (!find_stored_target(context, target, 0, of))
        return nullptr;
    if (!is_level(level)) {
        error(context, GL_INVALID_VALUE,
              SPANGLE_TEXT("level is above the smallest image of the largest texture"));
        return nullptr;
    }
    const LevelImage* const image = bound_texture(context, of.kind).image(of.face, level);
    return image != nullptr ? image : &none;
}

/// Writes an image to client memory. Colours that the texels lack are written as 0, and a missing alpha as 1
/// (GL 1.3, table 6.1).
void pack_image(const LevelImage& image, const PixelStore& pack, const PixelLayout& layout, void* pixels) {
    const LevelShape& shape = image.shape;
    const PixelLayout texels = texel_layout(shape.format);
    const Groups groups(texels);
    const ImageRows rows = image_rows(pack, layout, shape.size[0]);
    const std::size_t next_image = image_stride(pack, rows, shape.size[1]);
    const bool volume = shape.is_volume();
    unsigned char* slice = static_cast<unsigned char*>(pixels) + rows.skip +
                           (volume ? static_cast<std::size_t>(pack.skip_images) * next_image : 0);
    const std::uint8_t* texel = image.texels;
    if constexpr (has_row_codes) {
        RowConverter row(GroupForm(texels, false), GroupForm(layout, pack.swap_bytes));
        for (unsigned z = 0; row.is_supported() && z < shape.images(); ++z, slice += next_image)
            for (unsigned y = 0; y < shape.size[1]; ++y, texel += shape.size[0] * texels.group_bytes())
                row.convert_row(texel, slice + y * rows.stride, shape.size[0]);
        if (row.is_supported())
            return;
    }
    for (unsigned z = 0; z < shape.images(); ++z, slice += next_image)
        for (unsigned y = 0; y < shape.size[1]; ++y)
            for (unsigned x = 0; x < shape.size[0]; ++x, texel += texels.group_bytes())
                pack_pixel(layout, pack.swap_bytes, groups.color(texel, 0),
                           slice + y * rows.stride + x * std::size_t{layout.group_bytes()});
}

} // namespace

namespace cmd {

void GetTexImage(Context& context, GLenum target, GLint level, GLenum format, GLenum type, void* pixels) {
    if (format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX)
        return error(context, GL_INVALID_ENUM);
    PixelLayout layout;
    if (const GLenum refused = pixel_layout(format, type, layout); refused != GL_NO_ERROR)
        return error(context, refused, SPANGLE_TEXT("format and type do not go together"));
    const LevelImage* const image = find_image(context, target, level);
    if (image == nullptr)
        return;
    const bool depth = layout.channel[0] == Channel::depth;
    // Luminance is red only, not the sum of R, G and B as in ReadPixels, because texels are not converted
    // from RGB to L (GL 1.3, 6.1.4).
    if (layout.channel[0] == Channel::luminance)
        layout.channel[0] = Channel::red;
    if (is_compressed(image->shape.internal_format) || depth != is_depth(image->shape.format))
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("the image has no such components, or is compressed"));
    if (image->shape.empty())
        return;
    if (pixels == nullptr)
        return error(context, GL_INVALID_VALUE);
    // The image may have been copied from this band, so its pixels may differ from band to band.
    distrust_batches(context);
    pack_image(*image, context.pixel_store.pack, layout, pixels);
}

#if SPANGLE_FEATURE_COMPRESSED_TEXTURES

void GetCompressedTexImage(Context& context, GLenum target, GLint level, void* pixels) {
    const LevelImage* const image = find_image(context, target, level);
    if (image == nullptr)
        return;
    if (!is_compressed(image->shape.internal_format))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("the image is not compressed"));
    if (pixels == nullptr)
        return error(context, GL_INVALID_VALUE);
    auto* to = static_cast<unsigned char*>(pixels);
    const std::size_t palette = palette_bytes(image->shape.internal_format);
    if (palette != 0)
        std::memcpy(to, image->palette, palette);
    std::memcpy(to + palette, image->texels, image->bytes);
}

#endif

} // namespace cmd

} // namespace spangle::gl
