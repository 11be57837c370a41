#include "gl/texture/level_image.hpp"

#include <cstring>

#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/complete.hpp"
#include "gl/texture/internal_format.hpp"
#include "gl/texture/mipmap.hpp"
#include "gl/texture/texture_target.hpp"

namespace spangle::gl {

#if SPANGLE_FEATURE_TEXTURE_CUBE_MAP
/// The function is not inline, because many places call it.
[[gnu::noinline]] LevelImage*& TextureObject::image(unsigned face, GLint l) {
    return face == 0 ? level[l] : reinterpret_cast<CubeTexture*>(this)->other[face - 1][l];
}
#endif

LevelImage* new_image(Arena& arena, const LevelShape& shape) {
    const std::uint32_t stride = shape.size[0] * texel_size(shape.format);
    const std::uint64_t bytes = std::uint64_t{stride} * shape.size[1] * shape.size[2];
    if (bytes > INT32_MAX)
        return nullptr;
    auto* image =
        static_cast<LevelImage*>(arena.allocate(sizeof(LevelImage) + static_cast<std::size_t>(bytes)));
    if (image == nullptr)
        return nullptr;
    *image = {shape, stride, static_cast<std::uint32_t>(bytes), image->own_texels(), {nullptr}};
    return image;
}

void clear_texels(LevelImage& image) {
    std::memset(image.own_texels(), 0, image.bytes);
}

#if SPANGLE_HAS_RECORDS

bool is_recorded(const ShareGroup& share, const LevelImage& image) {
    return image.frame == share.frame;
}

void discard_image(ShareGroup& share, LevelImage* image) {
    if (image == nullptr || !is_recorded(share, *image))
        return share.arena.free(image);
    image->next_kept = share.kept_images;
    share.kept_images = image;
}

void forget_kept_images(ShareGroup& share) {
    for (LevelImage* image = share.kept_images; image != nullptr;) {
        LevelImage* const next = image->next_kept;
        share.arena.free(image);
        image = next;
    }
    share.kept_images = nullptr;
    ++share.frame;
}

void hold_textures(Context& context) {
    for (int unit = 0; unit < texture_units; ++unit) {
        const TextureObject* const texture = sampled_texture(context, unit);
        for (unsigned face = 0; texture != nullptr && face < texture->faces(); ++face)
            for (GLint level = 0; level < texture_levels; ++level)
                if (LevelImage* const image = const_cast<TextureObject*>(texture)->image(face, level);
                    image != nullptr)
                    image->frame = context.share->frame;
    }
}

#else

bool is_recorded(const ShareGroup&, const LevelImage&) {
    return false;
}
void discard_image(ShareGroup& share, LevelImage* image) {
    share.arena.free(image);
}

#endif

void put_image(Context& context, TextureObject& texture, unsigned face, GLint level, LevelImage* image) {
    LevelImage*& place = texture.image(face, level);
    discard_image(*context.share, place);
    place = image;
    image_written(context, texture, face, level);
}

void image_written(Context& context, TextureObject& texture, unsigned face, GLint level) {
    texture_changed(context, texture);
    if (texture.parameters.generate_mipmap && level == texture.parameters.base_level)
        generate_mipmaps(context, texture, face, texture_levels);
}

raster::TexelFormat format_beside(const TextureObject& texture, GLint level, const LevelShape& shape) {
    if constexpr ((raster::color_formats & (raster::color_formats - 1)) == 0)
        return shape.format; // all surfaces have one format, so texel formats agree
    for (unsigned face = 0; face < texture.faces(); ++face)
        for (GLint l = 0; l < texture_levels; ++l) {
            const LevelImage* const other = texture.image(face, l);
            if (l != level && other != nullptr && other->shape.internal_format == shape.internal_format)
                return other->shape.format;
        }
    return shape.format;
}

} // namespace spangle::gl
