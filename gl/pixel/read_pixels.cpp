// ReadPixels (GL 1.3, 4.3.2). GL leaves pixels outside of the surface undefined; here their memory is not
// written.
#include "gl/api/generated/commands.hpp"
#include "gl/context/batches.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/fetch.hpp"
#include "gl/pixel/row_converter.hpp"
#include "gl/pixel/targets.hpp"
#include "gl/pixel/zoom.hpp"

namespace spangle::gl {

namespace {

struct Read {
    const raster::Surface* surface; ///< surface with the current row in memory
    const PixelLayout& layout;
    Content content;
    Transfer transfer;
    bool swap_bytes, lsb_first;
};

void put_bit(unsigned char* row, std::size_t at, bool lsb_first, std::uint32_t value) {
    const unsigned char mask = bit_mask(at, lsb_first);
    row[at / 8] = static_cast<unsigned char>((value & 1) != 0 ? row[at / 8] | mask : row[at / 8] & ~mask);
}

/// Reads columns [x, x + count) of line y. `row` is the first byte of the client's row, and `group` the first
/// group to write, counting skipped bits.
void read_row(const Read& r, std::int32_t x, std::int32_t y, std::int32_t count, unsigned char* row,
              std::size_t group) {
    for (const std::int32_t end = x + count; x < end; ++x, ++group) {
        const PixelGroup found = fetch(*r.surface, r.transfer, r.content, x, y);
        unsigned char* const to = row + group * r.layout.group_bytes();
        if (r.layout.kind == ElementKind::bitmap)
            put_bit(row, group, r.lsb_first, rounded(found.index));
        else if (r.content == Content::stencil || r.content == Content::index)
            pack_index(r.layout, r.swap_bytes, found.index, to);
        else
            pack_pixel(r.layout, r.swap_bytes, found.color, to);
    }
}

void read(Read& r, const raster::Surface& surface, ReadRows& source, const PixelStore& pack, GLint x, GLint y,
          GLsizei width, GLsizei height, unsigned char* pixels) {
    const Rect& all = source.area();
    const Interval columns = clip_interval(x, width, 0, all.w),
                   lines = clip_interval(y, height, all.y, all.y + all.h);
    const std::int32_t count = columns.end - columns.begin;
    if (columns.begin == columns.end)
        return;
    const ImageRows rows = image_rows(pack, r.layout, width);
    const auto first = static_cast<std::size_t>(columns.begin - x);
    const auto each_row = [&](auto read_from) {
        for (std::int32_t line = lines.begin; line < lines.end; ++line) {
            unsigned char* row = pixels + rows.skip + static_cast<std::size_t>(line - y) * rows.stride;
            r.surface = source.with_row(line);
            if (r.surface != nullptr)
                read_from(line, row);
        }
    };
    if constexpr (has_row_codes) {
        if (pays_converter(std::int64_t{count} * height) && keeps_colors(surface, r.transfer, r.content)) {
            SurfaceConverter converter(surface.format, GroupForm(r.layout, r.swap_bytes));
            if (converter.is_supported())
                return each_row([&](std::int32_t line, unsigned char* row) {
                    converter.convert(*r.surface, columns.begin, line, count,
                                      row + first * r.layout.group_bytes());
                });
        }
    }
    each_row([&](std::int32_t line, unsigned char* row) {
        read_row(r, columns.begin, line, count, row, first + rows.skip_bits);
    });
}

} // namespace

namespace cmd {

void ReadPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                void* pixels) {
    const bool index_mode = is_indexed(context.drawable);
    if (format == GL_COLOR_INDEX && !index_mode)
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("GL_COLOR_INDEX, but the colours of this surface are RGBA"));
    PixelLayout layout;
    const GLenum refused = pixel_layout(format, type, layout);
    if (refused != GL_NO_ERROR)
        return error(context, refused, SPANGLE_TEXT("format and type do not go together"));
    if (width < 0 || height < 0)
        return error(context, GL_INVALID_VALUE);
    const raster::Surface& surface = read_surface(context);
    const Content content = content_of(layout, index_mode);
    if ((content == Content::depth && surface.depth_format == DepthFormat::none) ||
        (content == Content::stencil && surface.depth_format != DepthFormat::z24s8))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("the surface has no such buffer"));
    if (pixels == nullptr)
        return error(context, GL_INVALID_VALUE);
    const gl::PixelStore& pack = context.pixel_store.pack;
    distrust_batches(context);
    Read to{nullptr, layout, content, Transfer(context.pixel_mode), pack.swap_bytes, pack.lsb_first};
    ReadRows source(context);
    read(to, surface, source, pack, x, y, width, height, static_cast<unsigned char*>(pixels));
}

} // namespace cmd

} // namespace spangle::gl
