#include "gl/texture/store_texels.hpp"

#include <type_traits>

#include "gl/context/context.hpp"
#include "gl/pixel/group.hpp"
#include "gl/pixel/row_converter.hpp"

namespace spangle::gl {

namespace {

/// Whether groups in client memory have the layout of the texels. If so, rows can be copied.
[[maybe_unused]] bool same_layout(PixelLayout layout, const PixelLayout& texels) {
    if (layout.channel[0] == Channel::luminance)
        layout.channel[0] = Channel::red;
    static_assert(std::has_unique_object_representations_v<PixelLayout>);
    return std::memcmp(&layout, &texels, sizeof layout) == 0;
}

/// Calls each(from, to) for every row of the box, in client memory and in the image.
template <class Each>
[[gnu::always_inline]] inline void each_row(const PixelStore& unpack, LevelImage& image, const TexelBox& box,
                                            const ImageRows& rows, unsigned bytes, const void* pixels,
                                            Each each) {
    const bool volume = image.shape.is_volume();
    const std::size_t next_image = image_stride(unpack, rows, static_cast<GLsizei>(box.size[1]));
    const unsigned char* slice = static_cast<const unsigned char*>(pixels) + rows.skip +
                                 (volume ? static_cast<std::size_t>(unpack.skip_images) * next_image : 0);
    for (std::uint32_t z = 0; z < box.images(); ++z, slice += next_image) {
        const unsigned char* from = slice;
        std::uint8_t* to = image.own_texels() + std::size_t{box.first_image() + z} * image.slice() +
                           std::size_t{box.at[1]} * image.stride + std::size_t{box.at[0]} * bytes;
        for (std::uint32_t y = 0; y < box.size[1]; ++y, from += rows.stride, to += image.stride)
            each(from, to);
    }
}

} // namespace

void store_texels(const Context& context, LevelImage& image, const TexelBox& box, const PixelLayout& layout,
                  const void* pixels) {
    const PixelStore& unpack = context.pixel_store.unpack;
    const raster::TexelFormat format = image.shape.format;
    const unsigned bytes = texel_size(format);
    const PixelLayout kept = texel_layout(format);
    const ColorImage groups(context, layout);
    const Content content = is_depth(format) ? Content::depth : Content::color;
    const ImageRows rows = image_rows(unpack, layout, static_cast<GLsizei>(box.size[0]));
    const auto each = [&](auto store) { each_row(unpack, image, box, rows, bytes, pixels, store); };
    const bool copy = content == Content::color && groups.is_plain() && same_layout(layout, kept);
    if constexpr (has_row_codes) {
        const std::int64_t all = std::int64_t{box.size[0]} * box.size[1] * box.images();
        if (!copy && content == Content::color && pays_converter(all) && groups.keeps_colors()) {
            RowConverter row(GroupForm(layout, unpack.swap_bytes), GroupForm(kept, false));
            return each([&](const std::uint8_t* from, std::uint8_t* to) {
                row.convert_row(from, to, static_cast<std::int32_t>(box.size[0]));
            });
        }
    }
    each([&](const std::uint8_t* from, std::uint8_t* to) {
        if (copy) {
            std::memcpy(to, from, std::size_t{box.size[0]} * bytes);
            return;
        }
        for (std::uint32_t x = 0; x < box.size[0]; ++x)
            pack_pixel(kept, false, groups.group(content, from, rows.skip_bits + x).color,
                       to + std::size_t{x} * bytes);
    });
}

} // namespace spangle::gl
