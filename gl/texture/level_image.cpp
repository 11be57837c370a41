#include "gl/texture/level_image.hpp"

#include <cstring>

#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/internal_format.hpp"
#include "gl/texture/mipmap.hpp"
#include "gl/texture/texture_target.hpp"

namespace spangle::gl {

LevelImage* new_image(Arena& arena, const LevelShape& shape) {
    const std::uint32_t stride = shape.size[0] * texel_size(shape.format);
    const std::uint64_t bytes = std::uint64_t{stride} * shape.size[1] * shape.size[2];
    if (bytes > INT32_MAX)
        return nullptr;
    auto* image =
        static_cast<LevelImage*>(arena.allocate(sizeof(LevelImage) + static_cast<std::size_t>(bytes)));
    if (image == nullptr)
        return nullptr;
    *image = {shape, stride, static_cast<std::uint32_t>(bytes), image->own_texels(), nullptr};
    return image;
}

void clear_texels(LevelImage& image) {
    std::memset(image.own_texels(), 0, image.bytes);
}

void put_image(Context& context, TextureObject& texture, unsigned face, GLint level, LevelImage* image) {
    LevelImage*& place = texture.image(face, level);
    context.share->arena.free(place);
    place = image;
    image_written(context, texture, face, level);
}

void image_written(Context& context, TextureObject& texture, unsigned face, GLint level) {
    texture_changed(context, texture);
    if (texture.parameters.generate_mipmap && level == texture.parameters.base_level)
        generate_mipmaps(context, texture, face, texture_levels);
}

raster::TexelFormat format_beside(const TextureObject& texture, GLint level, const LevelShape& shape) {
    for (unsigned face = 0; face < texture.faces(); ++face)
        for (GLint l = 0; l < texture_levels; ++l) {
            const LevelImage* const other = texture.image(face, l);
            if (l != level && other != nullptr && other->shape.internal_format == shape.internal_format)
                return other->shape.format;
        }
    return shape.format;
}

} // namespace spangle::gl
