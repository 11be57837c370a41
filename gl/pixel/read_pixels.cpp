// ReadPixels (GL 1.3, 4.3.2). Pixels outside the surface are undefined; here their memory stays as it is.
#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/group.hpp"

namespace spangle::gl {

namespace {

/// A component of 0 to 8 bits of a colour buffer; a missing one reads as 1 (alpha without an alpha plane).
Component stored(std::uint32_t code, unsigned bits) {
    return bits == 0 ? Component{1, 1} : Component{code, static_cast<std::uint8_t>(bits)};
}

Pixel fetch_color(PixelFormat format, const std::uint8_t* at) {
    if (format == PixelFormat::rgb565_be || format == PixelFormat::rgb565_le) {
        const unsigned high = at[format == PixelFormat::rgb565_be ? 0 : 1];
        const unsigned low = at[format == PixelFormat::rgb565_be ? 1 : 0];
        return {
            {stored(high >> 3, 5), stored((high & 7) << 3 | low >> 5, 6), stored(low & 31, 5), stored(0, 0)}};
    }
    const bool alpha = format == PixelFormat::rgba8888;
    return {{stored(at[0], 8), stored(at[1], 8), stored(at[2], 8), alpha ? stored(at[3], 8) : stored(0, 0)}};
}

Component fetch_depth(DepthFormat format, const std::uint8_t* at) {
    if (format == DepthFormat::z16)
        return {load_element(at, 2, false), 16};
    return {load_element(at, 4, false) >> 8, 24};
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

void read_color_row(const Read& r, std::int32_t x, std::int32_t y, std::int32_t count, unsigned char* to) {
    const unsigned bytes = format_info(r.surface.format).bytes_per_pixel;
    const std::uint8_t* from = r.surface.color_row(y) + static_cast<std::size_t>(x) * bytes;
    for (std::int32_t i = 0; i < count; ++i, from += bytes, to += r.layout.group_bytes())
        pack_pixel(r.layout, r.swap_bytes, fetch_color(r.surface.format, from), to);
}

void read_depth_row(const Read& r, std::int32_t x, std::int32_t y, std::int32_t count, unsigned char* to) {
    const unsigned bytes = r.surface.depth_format == DepthFormat::z16 ? 2 : 4;
    const std::uint8_t* from = r.surface.depth_row(y) + static_cast<std::size_t>(x) * bytes;
    for (std::int32_t i = 0; i < count; ++i, from += bytes, to += r.layout.group_bytes())
        pack_pixel(r.layout, r.swap_bytes, {{fetch_depth(r.surface.depth_format, from)}}, to);
}

/// `to` is the first byte of a row; `group` the first group to write, skipped bits included.
void read_stencil_row(const Read& r, std::int32_t x, std::int32_t y, std::int32_t count, unsigned char* to,
                      std::size_t group) {
    const std::uint8_t* from = r.surface.depth_row(y) + static_cast<std::size_t>(x) * 4;
    for (std::int32_t i = 0; i < count; ++i, from += 4, ++group) {
        const std::uint32_t index = load_element(from, 4, false) & 0xFF;
        if (r.layout.kind == ElementKind::bitmap)
            put_bit(to, group, r.lsb_first, index);
        else
            pack_index(r.layout, r.swap_bytes, index, to + group * r.layout.group_bytes());
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
        if (r.source == Source::stencil)
            read_stencil_row(r, columns.begin, line, count, row, first + rows.skip_bits);
        else if (r.source == Source::depth)
            read_depth_row(r, columns.begin, line, count, row + first * r.layout.group_bytes());
        else
            read_color_row(r, columns.begin, line, count, row + first * r.layout.group_bytes());
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
    const raster::Surface& surface = context.drawable.surface;
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
