// DrawPixels and PixelZoom (GL 1.3, 3.6.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_DRAW_PIXELS

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/group.hpp"
#include "gl/pixel/rectangle.hpp"

namespace spangle::gl {

namespace {

/// A client image.
struct ClientGroups : GroupSource {
    ClientGroups(const Context& context, const PixelLayout& layout, GLsizei width, GLsizei height,
                 const void* pixels)
        : GroupSource{group_of<ClientGroups>, {0, width}, {0, height}}, colors(context, layout),
          groups(layout, context.pixel_store.unpack), transfer(context.pixel_mode),
          rows(image_rows(context.pixel_store.unpack, layout, width)),
          first(static_cast<const unsigned char*>(pixels) + rows.skip) {}

    const unsigned char* row(std::int32_t m) const {
        return first + static_cast<std::size_t>(m) * rows.stride;
    }
    std::size_t column(std::int32_t n) const { return rows.skip_bits + static_cast<std::size_t>(n); }

    Pixel color(std::int32_t n, std::int32_t m) const { return colors.color(row(m), column(n)); }
    Index index(std::int32_t n, std::int32_t m) const {
        return transfer.index(groups.index(row(m), column(n)));
    }
    Component depth(std::int32_t n, std::int32_t m) const {
        return transfer.depth(groups.depth(row(m), column(n)));
    }
    Index stencil(std::int32_t n, std::int32_t m) const {
        return transfer.stencil(groups.index(row(m), column(n)));
    }

    ColorImage colors;
    Groups groups;
    Transfer transfer;
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
        return error(context, refused, SPANGLE_TEXT("glDrawPixels: format and type do not go together"));
    if (width < 0 || height < 0)
        return error(context, GL_INVALID_VALUE);
    const bool index_mode = is_indexed(context.drawable);
    const Content content = content_of(layout, index_mode);
    if (content == Content::color && index_mode)
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("glDrawPixels: colours, but this surface holds colour indices"));
    if (content == Content::stencil && context.drawable.surface.depth_format != DepthFormat::z24s8)
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("glDrawPixels: the surface has no stencil buffer"));
    if (pixels == nullptr)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("glDrawPixels: null pointer"));
    if (!raster_position_draws(context, GL_DRAW_PIXEL_TOKEN))
        return;
    const ClientGroups source(context, layout, width, height, pixels);
    const bool exact = is_565(layout) && source.colors.is_plain();
    draw_rectangle(context, source, content,
                   exact ? raster::Colors::of_pixels_565 : raster::Colors::of_pixels, {});
}

} // namespace cmd

} // namespace spangle::gl

#endif
