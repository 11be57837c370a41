// TexConstantImage2DSPANGLE: makes an image that stays in the program's constant memory. There the texels
// have the form in which Spangle stores them, row by row without gaps. The internal format must therefore be
// a sized one.
#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/texture/image_shape.hpp"
#include "gl/texture/level_image.hpp"

namespace spangle::gl {

namespace {

/// Whether the format is a sized one, and is stored in the same form for all formats of the surface.
bool has_sizes(GLenum internal_format) {
    switch (internal_format) {
    case GL_ALPHA8:
    case GL_LUMINANCE8:
    case GL_INTENSITY8:
    case GL_LUMINANCE8_ALPHA8:
    case GL_R3_G3_B2:
    case GL_RGB5:
    case GL_RGB565:
    case GL_RGB8:
    case GL_RGBA4:
    case GL_RGB5_A1:
    case GL_RGBA8:
        return true;
    default:
        return false;
    }
}

void constant_image(Context& context, const ImageRequest& request, GLsizei size, const void* data) {
    LevelShape shape;
    if (!shape_of(context, request, shape))
        return;
    const std::uint32_t stride = shape.size[0] * texel_size(shape.format), bytes = stride * shape.size[1];
    if (request.target.proxy) {
        context.texture.proxy(request.target.kind, request.level) = shape;
        return;
    }
    if (request.border != 0 || size < 0 || static_cast<std::uint32_t>(size) != bytes || data == nullptr)
        return error(context, GL_INVALID_VALUE,
                     SPANGLE_TEXT("imageSize is not that of the format and sizes, "
                                  "a border, or a null pointer"));
    // Texels of 16 and 32 bits are read as words.
    const std::uint32_t word = texel_size(shape.format);
    if (word != 3 && (reinterpret_cast<std::uintptr_t>(data) & (word - 1)) != 0)
        return error(context, GL_INVALID_VALUE,
                     SPANGLE_TEXT("texels of 16 or 32 bits at an address that is "
                                  "no multiple of their size"));
    auto* const image = static_cast<LevelImage*>(context.share->arena.allocate(sizeof(LevelImage)));
    if (image == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for this level"));
    *image = {shape, stride, bytes, static_cast<const std::uint8_t*>(data), {nullptr}};
    put_image(context, bound_texture(context, request.target.kind), request.target.face, request.level,
              image);
}

} // namespace

namespace cmd {

void TexConstantImage2DSPANGLE(Context& context, GLenum target, GLint level, GLenum internalformat,
                               GLsizei width, GLsizei height, GLint border, GLsizei imageSize,
                               const void* data) {
    ImageTarget of;
    if (!has_sizes(internalformat))
        return error(context, GL_INVALID_ENUM,
                     SPANGLE_TEXT("not a format of 8, 16, 24 or 32 bits with sizes"));
    if (find_image_target(context, target, 2, of))
        constant_image(context, {of, level, static_cast<GLint>(internalformat), {width, height, 1}, border},
                       imageSize, data);
}

} // namespace cmd

} // namespace spangle::gl
