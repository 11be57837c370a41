// TexImage and TexSubImage (GL 1.3, 3.8.1, 3.8.2).
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/image_shape.hpp"
#include "gl/texture/level_image.hpp"

namespace spangle::gl {

namespace {

/// Finds the layout of a client image by its format and type; returns false after an error.
bool find_layout(Context& context, const ImageCommand& client, PixelLayout& layout) {
    if (client.format == GL_DEPTH_COMPONENT && !SPANGLE_FEATURE_DEPTH_TEXTURES) {
        error(context, GL_INVALID_OPERATION,
              SPANGLE_TEXT("this build has no SPANGLE_FEATURE_DEPTH_TEXTURES"));
        return false;
    }
    const bool index = client.format == GL_STENCIL_INDEX;
    const GLenum refused = index ? GLenum{GL_INVALID_ENUM} : pixel_layout(client.format, client.type, layout);
    if (refused != GL_NO_ERROR)
        error(context, refused, SPANGLE_TEXT("format and type do not go together"));
    return refused == GL_NO_ERROR;
}

/// Whether client data can become such texels. Depth textures take depths only, and other textures take no
/// depths (GL 1.4, 3.8.1).
bool goes_into(Context& context, const PixelLayout& layout, raster::TexelFormat format) {
    if ((layout.channel[0] == Channel::depth) == is_depth(format))
        return true;
    error(context, GL_INVALID_OPERATION,
          SPANGLE_TEXT("GL_DEPTH_COMPONENT and depth textures go together only"));
    return false;
}

void make_image(Context& context, const ImageRequest& request, LevelShape& shape, const PixelLayout& layout,
                const void* pixels) {
    TextureObject& texture = bound_texture(context, request.target.kind);
    shape.format = format_beside(texture, request.level, shape);
    LevelImage* const image = new_image(context.share->arena, shape);
    if (image == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for this level"));
    if (pixels != nullptr)
        store_texels(context, *image, whole_box(shape), layout, pixels);
    else
        clear_texels(*image);
    put_image(context, texture, request.target.face, request.level, image);
}

void tex_image(Context& context, unsigned dimensions, const ImageCommand& given) {
    ImageTarget of;
    if (!find_image_target(context, given.target(), dimensions, of))
        return;
    const ImageRequest request{of,
                               given.level(),
                               given.arguments[2],
                               {given.size[0], given.size[1], given.size[2]},
                               given.arguments[3]};
    PixelLayout layout;
    LevelShape shape;
    if (!find_layout(context, given, layout) || !shape_of(context, request, shape) ||
        !goes_into(context, layout, shape.format))
        return;
    if (of.proxy)
        context.texture.proxy(of.kind, request.level) = shape;
    else
        make_image(context, request, shape, layout, given.pixels);
}

void tex_sub_image(Context& context, unsigned dimensions, const ImageCommand& given) {
    ImageTarget of;
    if (!find_stored_target(context, given.target(), dimensions, of))
        return;
    PixelLayout layout;
    TexelBox box;
    if (!find_layout(context, given, layout))
        return;
    const GLint* const at = given.arguments + 2;
    LevelImage* const image = find_box(
        context, {of, given.level(), {at[0], at[1], at[2]}, {given.size[0], given.size[1], given.size[2]}},
        box);
    if (image == nullptr || !goes_into(context, layout, image->shape.format) || box.size[0] == 0 ||
        box.size[1] == 0 || box.size[2] == 0)
        return;
    if (given.pixels == nullptr)
        return error(context, GL_INVALID_VALUE);
    store_texels(context, *image, box, layout, given.pixels);
    image_written(context, bound_texture(context, of.kind), of.face, given.level());
}

} // namespace

namespace cmd {

void TexImage2D(Context& context, const ImageCommand& image) {
    tex_image(context, 2, image);
}
void TexSubImage2D(Context& context, const ImageCommand& image) {
    tex_sub_image(context, 2, image);
}
#if SPANGLE_FEATURE_TEXTURE_1D
void TexImage1D(Context& context, const ImageCommand& image) {
    tex_image(context, 1, image);
}
void TexSubImage1D(Context& context, const ImageCommand& image) {
    tex_sub_image(context, 1, image);
}
#endif
#if SPANGLE_FEATURE_TEXTURE_3D
void TexImage3D(Context& context, const ImageCommand& image) {
    tex_image(context, 3, image);
}
void TexSubImage3D(Context& context, const ImageCommand& image) {
    tex_sub_image(context, 3, image);
}
#endif

} // namespace cmd

} // namespace spangle::gl
