// DrawPixels and PixelZoom (GL 1.3, 3.6.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_DRAW_PIXELS

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/group.hpp"
#include "gl/pixel/rectangle.hpp"

namespace spangle::gl {

namespace {

/// The groups of an image in client memory.
struct ClientGroups : GroupSource {
    ClientGroups(const Context& context, const PixelLayout& layout, Content of, GLsizei width, GLsizei height,
                 const void* pixels)
        : GroupSource(group_of, of, {0, width}, {0, height}), image(context, layout),
          rows(image_rows(context.pixel_store.unpack, layout, width)),
          first(static_cast<const unsigned char*>(pixels) + rows.skip) {
#if SPANGLE_ROW_CODES
        form = GroupForm(layout, context.pixel_store.unpack.swap_bytes);
        if (of == Content::color && image.keeps_colors())
            groups = groups_of;
#endif
    }

    static PixelGroup group_of(const GroupSource& source, std::int32_t n, std::int32_t m) {
        const auto& s = static_cast<const ClientGroups&>(source);
        return s.image.group(s.content, s.first + static_cast<std::size_t>(m) * s.rows.stride,
                             s.rows.skip_bits + static_cast<std::size_t>(n));
    }

#if SPANGLE_ROW_CODES
    static const std::uint8_t* groups_of(const GroupSource& source, std::int32_t n, std::int32_t m,
                                         std::int32_t) {
        const auto& s = static_cast<const ClientGroups&>(source);
        return s.first + static_cast<std::size_t>(m) * s.rows.stride +
               static_cast<std::size_t>(n) * s.form.bytes();
    }
#endif

    ColorImage image;
    ImageRows rows;
    const unsigned char* first;
};

bool is_565(const PixelLayout& layout) {
    return layout.packed && layout.bits[0] == 5 && layout.bits[1] == 6;
}

} // namespace

namespace cmd {

void PixelZoom(Context& context, Real xfactor, Real yfactor) {
    context.pixel_mode.zoom[0] = xfactor;
    context.pixel_mode.zoom[1] = yfactor;
}

void DrawPixels(Context& context, GLsizei width, GLsizei height, GLenum format, GLenum type,
                const void* pixels) {
    PixelLayout layout;
    const GLenum refused = pixel_layout(format, type, layout);
    if (refused != GL_NO_ERROR)
        return error(context, refused, SPANGLE_TEXT("format and type do not go together"));
    if (width < 0 || height < 0)
        return error(context, GL_INVALID_VALUE);
    const bool index_mode = is_indexed(context.drawable);
    const Content content = content_of(layout, index_mode);
    if (content == Content::color && index_mode)
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("colours, but this surface holds colour indices"));
    if (content == Content::stencil && context.drawable.surface.depth_format != DepthFormat::z24s8)
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("the surface has no stencil buffer"));
    if (pixels == nullptr)
        return error(context, GL_INVALID_VALUE);
    if (!raster_position_draws(context, GL_DRAW_PIXEL_TOKEN))
        return;
    const ClientGroups source(context, layout, content, width, height, pixels);
    const bool exact = is_565(layout) && source.image.is_plain();
    draw_rectangle(context, source, exact ? raster::Colors::of_pixels_565 : raster::Colors::of_pixels, {});
}

} // namespace cmd

} // namespace spangle::gl

#endif
