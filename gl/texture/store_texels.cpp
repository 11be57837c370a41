#include "gl/texture/store_texels.hpp"

#include "gl/context/context.hpp"
#include "gl/pixel/group.hpp"

namespace spangle::gl {

using raster::TexelFormat;

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
    case TexelFormat::rgb332:
        to[0] = static_cast<std::uint8_t>(rgba[0] << 5 | rgba[1] << 2 | rgba[2]);
        break;
    case TexelFormat::rgb565:
        store_element(to, 2, false, rgba[0] << 11 | rgba[1] << 5 | rgba[2]);
        break;
    case TexelFormat::rgba4444:
        store_element(to, 2, false, rgba[0] << 12 | rgba[1] << 8 | rgba[2] << 4 | rgba[3]);
        break;
    case TexelFormat::rgba5551:
        store_element(to, 2, false, rgba[0] << 11 | rgba[1] << 6 | rgba[2] << 1 | rgba[3]);
        break;
    case TexelFormat::z16:
        store_element(to, 2, false, rgba[0]);
        break;
    case TexelFormat::z24:
        store_element(to, 4, false, rgba[0]);
        break;
    case TexelFormat::rgba8888:
        to[3] = byte(3);
        [[fallthrough]];
    case TexelFormat::rgb888:
        for (unsigned c = 0; c < 3; ++c)
            to[c] = byte(c);
        break;
    case TexelFormat::p4: // compressed images are stored as they come
    case TexelFormat::p8:
    case TexelFormat::etc1:
        break;
    }
}

void load_texel(TexelFormat format, const std::uint8_t* from, std::uint32_t rgba[4]) {
    const ColorBits bits = texel_bits(format);
    rgba[0] = rgba[1] = rgba[2] = 0;
    rgba[3] = all_ones(bits.of[3]);
    const auto fields = [&](std::uint32_t word, unsigned components) {
        for (unsigned c = components; c-- > 0; word >>= bits.of[c])
            rgba[c] = word & all_ones(bits.of[c]);
    };
    switch (format) {
    case TexelFormat::a8:
        rgba[3] = from[0];
        break;
    case TexelFormat::la88:
        rgba[3] = from[1];
        [[fallthrough]];
    case TexelFormat::l8:
    case TexelFormat::i8:
        rgba[0] = from[0];
        break;
    case TexelFormat::rgb332:
        return fields(from[0], 3);
    case TexelFormat::rgb565:
        return fields(load_element(from, 2, false), 3);
    case TexelFormat::rgba4444:
    case TexelFormat::rgba5551:
        return fields(load_element(from, 2, false), 4);
    case TexelFormat::z16:
        rgba[0] = load_element(from, 2, false);
        break;
    case TexelFormat::z24:
        rgba[0] = load_element(from, 4, false);
        break;
    case TexelFormat::rgba8888:
        rgba[3] = from[3];
        [[fallthrough]];
    case TexelFormat::rgb888:
        for (unsigned c = 0; c < 3; ++c)
            rgba[c] = from[c];
        break;
    case TexelFormat::p4:
    case TexelFormat::p8:
    case TexelFormat::etc1:
        break;
    }
}

namespace {

/// Groups that are texels already: rows are copied.
bool same_layout(const PixelLayout& layout, TexelFormat format) {
    const Channel first = layout.channel[0], last = layout.channel[layout.components - 1u];
    if (layout.packed) {
        const ColorBits bits = texel_bits(format);
        const unsigned kept = format == TexelFormat::rgb565 || format == TexelFormat::rgb332       ? 3
                              : format == TexelFormat::rgba4444 || format == TexelFormat::rgba5551 ? 4
                                                                                                   : 0;
        bool same = layout.components == kept && first == Channel::red &&
                    layout.element_bytes == texel_size(format) && layout.shift[0] != 0;
        for (unsigned i = 0; i < kept; ++i)
            same = same && layout.bits[i] == bits.of[i];
        return same;
    }
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

/// One row of groups, each through pixel transfer.
class RowOfTexels {
  public:
    RowOfTexels(const Context& context, const PixelLayout& layout, TexelFormat format)
        : format_(format), bits_(texel_bits(format)), groups_(layout, context.pixel_store.unpack),
          transfer_(context.pixel_mode), colors_(context, layout) {}

    bool copies(const PixelLayout& layout) const {
        return colors_.is_plain() && same_layout(layout, format_);
    }

    void codes(const unsigned char* row, std::size_t group, std::uint32_t rgba[4]) const {
        if (is_depth(format_))
            rgba[0] = code_of(transfer_.depth(groups_.depth(row, group)), bits_.of[0]);
        else
            colors_.codes(row, group, bits_, rgba);
    }

  private:
    TexelFormat format_;
    ColorBits bits_;
    Groups groups_;
    Transfer transfer_;
    ColorImage colors_;
};

} // namespace

void store_texels(const Context& context, LevelImage& image, const TexelBox& box, const PixelLayout& layout,
                  const void* pixels) {
    const PixelStore& unpack = context.pixel_store.unpack;
    const TexelFormat format = image.shape.format;
    const unsigned bytes = texel_size(format);
    const RowOfTexels texels(context, layout, format);
    const bool copy = texels.copies(layout);
    const ImageRows rows = image_rows(unpack, layout, static_cast<GLsizei>(box.size[0]));
    const bool volume = image.shape.dimensions == 3;
    const std::size_t next_image = image_stride(unpack, rows, static_cast<GLsizei>(box.size[1]));
    const unsigned char* slice = static_cast<const unsigned char*>(pixels) + rows.skip +
                                 (volume ? static_cast<std::size_t>(unpack.skip_images) * next_image : 0);
    for (std::uint32_t z = 0; z < box.size[2]; ++z, slice += next_image) {
        const unsigned char* from = slice;
        std::uint8_t* to = image.own_texels() + std::size_t{box.at[2] + z} * image.slice() +
                           std::size_t{box.at[1]} * image.stride + std::size_t{box.at[0]} * bytes;
        for (std::uint32_t y = 0; y < box.size[1]; ++y, from += rows.stride, to += image.stride) {
            if (copy) {
                std::memcpy(to, from, std::size_t{box.size[0]} * bytes);
                continue;
            }
            for (std::uint32_t x = 0; x < box.size[0]; ++x) {
                std::uint32_t rgba[4] = {}; // of a depth there is one
                texels.codes(from, rows.skip_bits + x, rgba);
                store_texel(format, rgba, to + std::size_t{x} * bytes);
            }
        }
    }
}

} // namespace spangle::gl
