// CopyTexImage and CopyTexSubImage: texels from the framebuffer (GL 1.3, 3.8.2). Those of pixels outside the
// surface are undefined: here they are 0 in a new image, and stay in one that is there.
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/pixel/fetch.hpp"
#include "gl/pixel/targets.hpp"
#include "gl/texture/image_shape.hpp"
#include "gl/texture/level_image.hpp"

#if SPANGLE_FEATURE_COPY_TEXTURE

namespace spangle::gl {

namespace {

bool has_depth(const Context& context) {
    return context.drawable.read.depth_format != DepthFormat::none;
}

class Copy {
  public:
    Copy(const Context& context, LevelImage& image)
        : rows_(context), image_(image), bits_(texel_bits(image.shape.format)),
          transfer_(context.pixel_mode) {}

    /// Pixels from (x, y) on into a box one texel deep.
    void run(const TexelBox& box, GLint x, GLint y) {
        const std::size_t bytes = texel_size(image_.shape.format);
        const Rect all = rows_.area();
        for (std::uint32_t j = 0; j < box.size[1]; ++j) {
            const std::int64_t py = std::int64_t{y} + j;
            if (py < all.y || py >= std::int64_t{all.y} + all.h)
                continue;
            from_ = rows_.with_row(static_cast<std::int32_t>(py));
            for (std::uint32_t i = 0; from_ != nullptr && i < box.size[0]; ++i) {
                const std::int64_t px = std::int64_t{x} + i;
                if (px < 0 || px >= all.w)
                    continue;
                pixel(static_cast<std::int32_t>(px), static_cast<std::int32_t>(py),
                      image_.own_texels() + std::size_t{box.at[2]} * image_.slice() +
                          std::size_t{box.at[1] + j} * image_.stride + (box.at[0] + i) * bytes);
            }
        }
    }

  private:
    void pixel(std::int32_t x, std::int32_t y, std::uint8_t* to) const {
        std::uint32_t codes[4];
        if (is_depth(image_.shape.format)) {
            codes[0] = code_of(transfer_.depth(fetch_depth(*from_, x, y)), bits_.of[0]);
        } else {
            const Pixel color = transferred_color(*from_, transfer_, x, y);
            for (unsigned c = 0; c < 4; ++c)
                codes[c] = code_of(color.value[c], bits_.of[c]);
        }
        store_texel(image_.shape.format, codes, to);
    }

    ReadRows rows_;
    const raster::Surface* from_ = nullptr; ///< with the row at hand
    LevelImage& image_;
    ColorBits bits_;
    Transfer transfer_;
};

/// Unlike TexImage, which takes component counts and calls others wrong values (GL 1.3, 3.8.2).
bool copies_to(const Context& context, GLint internal_format) {
    raster::TexelFormat unused;
    return (internal_format < 1 || internal_format > 4) &&
           texel_format_of(internal_format, context.drawable.surface.format, unused);
}

void copy_image(Context& context, const ImageRequest& request, GLint x, GLint y) {
    LevelShape shape;
    if (!copies_to(context, request.internal_format))
        return error(context, GL_INVALID_ENUM, SPANGLE_TEXT("glCopyTexImage: not an internal format"));
    if (!shape_of(context, request, shape))
        return;
    if (is_depth(shape.format) && !has_depth(context))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("glCopyTexImage: there is no depth buffer"));
    TextureObject& texture = bound_texture(context, request.target.kind);
    shape.format = format_beside(texture, request.level, shape);
    LevelImage* const image = new_image(context.share->arena, shape);
    if (image == nullptr)
        return error(context, GL_OUT_OF_MEMORY,
                     SPANGLE_TEXT("glCopyTexImage: no room in the arena for this level"));
    clear_texels(*image);
    Copy(context, *image).run(whole_box(shape), x, y);
    put_image(context, texture, request.target.face, request.level, image);
}

void copy_sub_image(Context& context, const SubImage& sub, GLint x, GLint y) {
    TexelBox box;
    LevelImage* const image = find_box(context, sub, box);
    if (image == nullptr)
        return;
    if (is_depth(image->shape.format) && !has_depth(context))
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("glCopyTexSubImage: there is no depth buffer"));
    Copy(context, *image).run(box, x, y);
    image_written(context, bound_texture(context, sub.target.kind), sub.target.face, sub.level);
}

} // namespace

namespace cmd {

void CopyTexImage2D(Context& context, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                    GLsizei width, GLsizei height, GLint border) {
    ImageTarget of;
    if (find_stored_target(context, target, 2, of))
        copy_image(context, {of, level, static_cast<GLint>(internalformat), {width, height, 1}, border}, x,
                   y);
}

void CopyTexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x,
                       GLint y, GLsizei width, GLsizei height) {
    ImageTarget of;
    if (find_stored_target(context, target, 2, of))
        copy_sub_image(context, {of, level, {xoffset, yoffset, 0}, {width, height, 1}}, x, y);
}

#if SPANGLE_FEATURE_TEXTURE_1D

void CopyTexImage1D(Context& context, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y,
                    GLsizei width, GLint border) {
    ImageTarget of;
    if (find_stored_target(context, target, 1, of))
        copy_image(context, {of, level, static_cast<GLint>(internalformat), {width, 1, 1}, border}, x, y);
}

void CopyTexSubImage1D(Context& context, GLenum target, GLint level, GLint xoffset, GLint x, GLint y,
                       GLsizei width) {
    ImageTarget of;
    if (find_stored_target(context, target, 1, of))
        copy_sub_image(context, {of, level, {xoffset, 0, 0}, {width, 1, 1}}, x, y);
}

#endif
#if SPANGLE_FEATURE_TEXTURE_3D

void CopyTexSubImage3D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                       GLint zoffset, GLint x, GLint y, GLsizei width, GLsizei height) {
    ImageTarget of;
    if (find_stored_target(context, target, 3, of))
        copy_sub_image(context, {of, level, {xoffset, yoffset, zoffset}, {width, height, 1}}, x, y);
}

#endif

} // namespace cmd

} // namespace spangle::gl

#endif
