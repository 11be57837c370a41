// CopyTexImage and CopyTexSubImage: texels from the framebuffer (GL 1.3, 3.8.2). GL leaves texels of pixels
// outside of the surface undefined. Here they are 0 in a new image, and unchanged in an existing one.
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "gl/pixel/fetch.hpp"
#include "gl/pixel/row_converter.hpp"
#include "gl/pixel/targets.hpp"
#include "gl/pixel/zoom.hpp"
#include "gl/texture/image_shape.hpp"
#include "gl/texture/level_image.hpp"

#if SPANGLE_FEATURE_COPY_TEXTURE

namespace spangle::gl {

namespace {

bool has_depth(const Context& context) {
    return context.drawable.read.depth_format != DepthFormat::none;
}

/// Copies pixels from (x, y) on into a box that is one texel deep.
void copy_pixels(const Context& context, LevelImage& image, const TexelBox& box, GLint x, GLint y) {
    const PixelLayout texels = texel_layout(image.shape.format);
    const Content content = is_depth(image.shape.format) ? Content::depth : Content::color;
    const Transfer transfer(context.pixel_mode);
    ReadRows rows(context);
    const Rect& all = rows.area();
    const Interval columns = clip_interval(x, static_cast<GLsizei>(box.size[0]), 0, all.w),
                   lines = clip_interval(y, static_cast<GLsizei>(box.size[1]), all.y, all.y + all.h);
    if (columns.begin >= columns.end)
        return; // The distance to x might exceed 32 bits.
    const auto row_of = [&](std::int32_t py) {
        return image.own_texels() + std::size_t{box.at[2]} * image.slice() +
               (box.at[1] + static_cast<std::uint32_t>(py - y)) * std::size_t{image.stride};
    };
    if constexpr (has_row_codes) {
        if (keeps_colors(context.drawable.read, transfer, content)) {
            SurfaceConverter row(context.drawable.read.format, GroupForm(texels, false));
            const std::size_t first = box.at[0] + static_cast<std::uint32_t>(columns.begin - x);
            for (std::int32_t py = lines.begin; py < lines.end; ++py)
                if (const raster::Surface* const from = rows.with_row(py); from != nullptr)
                    row.convert(*from, columns.begin, py, columns.end - columns.begin,
                                row_of(py) + first * texels.group_bytes());
            return;
        }
    }
    for (std::int32_t py = lines.begin; py < lines.end; ++py) {
        std::uint8_t* const row = row_of(py);
        const raster::Surface* const from = rows.with_row(py);
        for (std::int32_t px = columns.begin; from != nullptr && px < columns.end; ++px)
            pack_pixel(texels, false, fetch(*from, transfer, content, px, py).color,
                       row + (box.at[0] + static_cast<std::uint32_t>(px - x)) * texels.group_bytes());
    }
}

/// Whether the internal format can be copied to. Unlike TexImage, CopyTexImage takes no component counts and
/// raises INVALID_ENUM for bad formats (GL 1.3, 3.8.2).
bool copies_to(const Context& context, GLint internal_format) {
    raster::TexelFormat unused;
    return (internal_format < 1 || internal_format > 4) &&
           texel_format_of(internal_format, context.drawable.surface.format, unused);
}

void copy_image(Context& context, const ImageRequest& request, GLint x, GLint y) {
    LevelShape shape;
    if (!copies_to(context, request.internal_format))
        return error(context, GL_INVALID_ENUM,
                     SPANGLE_TEXT("internalformat is not an internal format that is copied to"));
    if (!shape_of(context, request, shape))
        return;
    if (is_depth(shape.format) && !has_depth(context))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("there is no depth buffer"));
    TextureObject& texture = bound_texture(context, request.target.kind);
    shape.format = format_beside(texture, request.level, shape);
    LevelImage* const image = new_image(context.share->arena, shape);
    if (image == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for this level"));
    clear_texels(*image);
    copy_pixels(context, *image, whole_box(shape), x, y);
    put_image(context, texture, request.target.face, request.level, image);
}

void copy_sub_image(Context& context, const SubImage& sub, GLint x, GLint y) {
    TexelBox box;
    LevelImage* const image = find_box(context, sub, box);
    if (image == nullptr)
        return;
    if (is_depth(image->shape.format) && !has_depth(context))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("there is no depth buffer"));
    copy_pixels(context, *image, box, x, y);
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
