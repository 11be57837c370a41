#include "gl/texture/store_texels.hpp"

#include "gl/context/context.hpp"
#include "gl/pixel/group.hpp"
#include "gl/texture/internal_format.hpp"

namespace spangle::gl {

using raster::TexelFormat;

namespace {

void store_texel(TexelFormat format, const std::uint32_t rgba[4], std::uint8_t* to) {
    const auto byte = [&](unsigned c) { return static_cast<std::uint8_t>(rgba[c]); };
    switch (format) {
    case TexelFormat::a8:
        to[0] = byte(3);
        break;
    case TexelFormat::l8:
    case TexelFormat::i8:
        to[0] = byte(0);
        break;
    case TexelFormat::la88:
        to[0] = byte(0);
        to[1] = byte(3);
        break;
    case TexelFormat::rgb565:
        store_element(to, 2, false, rgba[0] << 11 | rgba[1] << 5 | rgba[2]);
        break;
    case TexelFormat::rgba8888:
        to[3] = byte(3);
        [[fallthrough]];
    case TexelFormat::rgb888:
        for (unsigned c = 0; c < 3; ++c)
            to[c] = byte(c);
        break;
    }
}

/// Groups that are texels already: rows are copied.
bool same_layout(const PixelLayout& layout, TexelFormat format) {
    const Channel first = layout.channel[0], last = layout.channel[layout.components - 1u];
    if (layout.packed)
        return format == TexelFormat::rgb565 && layout.bits[0] == 5 && layout.components == 3 &&
               layout.shift[0] == 11;
    if (layout.kind != ElementKind::unsigned_integer || layout.element_bytes != 1)
        return false;
    switch (format) {
    case TexelFormat::a8:
        return layout.components == 1 && first == Channel::alpha;
    case TexelFormat::l8:
    case TexelFormat::i8:
        return layout.components == 1 && (first == Channel::luminance || first == Channel::red);
    case TexelFormat::la88:
        return layout.components == 2;
    case TexelFormat::rgb888:
        return layout.components == 3 && first == Channel::red;
    case TexelFormat::rgba8888:
        return layout.components == 4 && first == Channel::red && last == Channel::alpha;
    default:
        return false;
    }
}

} // namespace

void store_texels(const Context& context, LevelImage& image, const TexelRect& rect, const PixelLayout& layout,
                  const void* pixels) {
    const TexelFormat format = image.shape.format;
    const unsigned bytes = texel_bytes(format);
    const ColorBits bits = texel_bits(format);
    const ColorImage colors(context, layout);
    const bool copy = colors.is_plain() && same_layout(layout, format);
    const ImageRows rows = image_rows(context.pixel_store.unpack, layout, static_cast<GLsizei>(rect.width));
    const unsigned char* from = static_cast<const unsigned char*>(pixels) + rows.skip;
    std::uint8_t* to = image.texels() + std::size_t{rect.y} * image.stride + std::size_t{rect.x} * bytes;
    for (std::uint32_t y = 0; y < rect.height; ++y, from += rows.stride, to += image.stride) {
        if (copy) {
            std::memcpy(to, from, std::size_t{rect.width} * bytes);
            continue;
        }
        for (std::uint32_t x = 0; x < rect.width; ++x) {
            std::uint32_t rgba[4];
            colors.codes(from, rows.skip_bits + x, bits, rgba);
            store_texel(format, rgba, to + std::size_t{x} * bytes);
        }
    }
}

} // namespace spangle::gl
