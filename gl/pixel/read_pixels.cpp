// ReadPixels (GL 1.3, 4.3.2). Pixels outside the surface are undefined; here their memory stays as it is.
#include <bit>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/group.hpp"
#include "raster/surface/pixel.hpp"

namespace spangle::gl {

namespace {

/// k / max, max = 2^bits - 1.
Component fraction(std::uint32_t k, std::uint32_t max) {
    return {k, static_cast<std::uint8_t>(std::bit_width(max))};
}

Pixel fetch_color(const raster::Surface& surface, std::int32_t x, std::int32_t y) {
    const raster::StoredColor stored = raster::read_color(surface, x, y);
    Pixel pixel;
    for (int i = 0; i < 4; ++i)
        pixel.value[i] = fraction(stored.c[i].k, stored.c[i].max);
    return pixel;
}

Pixel fetch_depth(const raster::Surface& surface, std::int32_t x, std::int32_t y) {
    const raster::StoredDepth stored = raster::read_depth(surface, x, y);
    return {{fraction(stored.k, stored.max)}};
}

enum class Source { color, depth, stencil };

struct Read {
    const raster::Surface& surface;
    const PixelLayout& layout;
    Source source;
    bool swap_bytes, lsb_first;
};

void put_bit(unsigned char* row, std::size_t bit, bool lsb_first, std::uint32_t value) {
    const unsigned place = static_cast<unsigned>(bit % 8);
    const unsigned mask = lsb_first ? 1u << place : 0x80u >> place;
    row[bit / 8] = static_cast<unsigned char>((value & 1) != 0 ? row[bit / 8] | mask : row[bit / 8] & ~mask);
}

/// Columns [x, x + count) of a line; `row` is its first byte, `group` the first group to write, skipped bits
/// included.
void read_row(const Read& r, std::int32_t x, std::int32_t y, std::int32_t count, unsigned char* row,
              std::size_t group) {
    const std::uint32_t bytes = r.layout.group_bytes();
    for (const std::int32_t end = x + count; x < end; ++x, ++group) {
        if (r.source == Source::color)
            pack_pixel(r.layout, r.swap_bytes, fetch_color(r.surface, x, y), row + group * bytes);
        else if (r.source == Source::depth)
            pack_pixel(r.layout, r.swap_bytes, fetch_depth(r.surface, x, y), row + group * bytes);
        else if (r.layout.kind == ElementKind::bitmap)
            put_bit(row, group, r.lsb_first, raster::read_stencil(r.surface, x, y));
        else
            pack_index(r.layout, r.swap_bytes, raster::read_stencil(r.surface, x, y), row + group * bytes);
    }
}

/// The part of [at, at + size) inside [0, limit): empty when begin >= end. Whatever the integers are.
struct Inside {
    std::int32_t begin, end;
};
Inside inside(GLint at, GLsizei size, std::int32_t limit) {
    const std::int64_t end = std::int64_t{at} + size;
    return {at < 0 ? 0 : at, static_cast<std::int32_t>(end < limit ? (end < 0 ? 0 : end) : limit)};
}

void read(const Read& r, const PixelStore& pack, GLint x, GLint y, GLsizei width, GLsizei height,
          unsigned char* pixels) {
    const Inside columns = inside(x, width, r.surface.width), lines = inside(y, height, r.surface.height);
    const std::int32_t count = columns.end - columns.begin;
    if (columns.begin >= columns.end)
        return;
    const ImageRows rows = image_rows(pack, r.layout, width);
    const auto first = static_cast<std::size_t>(std::int64_t{columns.begin} - x);
    for (std::int32_t line = lines.begin; line < lines.end; ++line) {
        unsigned char* row =
            pixels + rows.skip + static_cast<std::size_t>(std::int64_t{line} - y) * rows.stride;
        read_row(r, columns.begin, line, count, row, first + rows.skip_bits);
    }
}

Source source_of(const PixelLayout& layout) {
    return layout.channel[0] == Channel::depth     ? Source::depth
           : layout.channel[0] == Channel::stencil ? Source::stencil
                                                   : Source::color;
}

} // namespace

namespace cmd {

void ReadPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                void* pixels) {
    if (format == GL_COLOR_INDEX)
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("glReadPixels: GL_COLOR_INDEX, but the colours of this surface are RGBA"));
    PixelLayout layout;
    const GLenum refused = pixel_layout(format, type, layout);
    if (refused != GL_NO_ERROR)
        return error(context, refused, SPANGLE_TEXT("glReadPixels: format and type do not go together"));
    if (width < 0 || height < 0)
        return error(context, GL_INVALID_VALUE);
    const raster::Surface& surface = context.drawable.read;
    const Source source = source_of(layout);
    if ((source == Source::depth && surface.depth_format == DepthFormat::none) ||
        (source == Source::stencil && surface.depth_format != DepthFormat::z24s8))
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("glReadPixels: the surface has no such buffer"));
    if (pixels == nullptr)
        return error(context, GL_INVALID_VALUE, SPANGLE_TEXT("glReadPixels: null pointer"));
    const gl::PixelStore& pack = context.pixel_store.pack;
    read({surface, layout, source, pack.swap_bytes, pack.lsb_first}, pack, x, y, width, height,
         static_cast<unsigned char*>(pixels));
}

} // namespace cmd

} // namespace spangle::gl
