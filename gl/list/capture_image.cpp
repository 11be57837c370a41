#include "gl/list/capture_image.hpp"

#if SPANGLE_FEATURE_LISTS

#include <cstring>

#include "gl/pixel/group.hpp"

namespace spangle::gl::list {

namespace {

/// Upper bound of bytes in an arena.
constexpr std::uint32_t most_bytes = std::uint32_t{1} << 30;

[[gnu::noinline]] std::uint32_t bounded_product(std::uint32_t a, std::uint32_t b) {
    std::uint32_t product;
    return __builtin_mul_overflow(a, b, &product) || product > most_bytes ? most_bytes : product;
}

struct Extent {
    std::uint32_t row_bytes, rows, images;
    bool is_empty() const { return row_bytes == 0 || rows == 0 || images == 0; }
    /// Words of all pixels. If there are too many bytes, the number is one that makes record() fail.
    std::uint32_t words() const {
        return (bounded_product(bounded_product(row_bytes, rows), images) + 3) / 4;
    }
};

Extent extent_of(const ImageCommand& image, const PixelLayout& layout) {
    const auto width = static_cast<std::uint32_t>(image.size[0]);
    return {layout.kind == ElementKind::bitmap ? (width + 7) / 8
                                               : bounded_product(width, layout.group_bytes()),
            static_cast<std::uint32_t>(image.size[1]), static_cast<std::uint32_t>(image.size[2])};
}

bool is_readable_image(const ImageCommand& image, GLsizei most, PixelLayout& layout) {
    for (const GLsizei side : image.size)
        if (side < 0 || side > most)
            return false;
    return image.pixels != nullptr && pixel_layout(image.format, image.type, layout) == GL_NO_ERROR;
}

/// Copies a row of pixel groups. Elements get the host's byte order, and bits start at the most significant
/// one.
void copy_row(const PixelStore& store, const PixelLayout& layout, const unsigned char* from,
              unsigned skip_bits, std::size_t groups, std::size_t bytes, unsigned char* to) {
    if (layout.kind == ElementKind::bitmap) {
        std::memset(to, 0, bytes);
        for (std::size_t i = 0; i < groups; ++i)
            if (bit_of(from, i + skip_bits, store.lsb_first))
                to[i / 8] = static_cast<unsigned char>(to[i / 8] | bit_mask(i, false));
        return;
    }
    std::memcpy(to, from, bytes);
    if (!store.swap_bytes || layout.element_bytes == 1)
        return;
    for (unsigned char* e = to; e != to + bytes; e += layout.element_bytes)
        for (unsigned low = 0, high = layout.element_bytes - 1u; low < high; ++low, --high) {
            const unsigned char byte = e[low];
            e[low] = e[high];
            e[high] = byte;
        }
}

void copy_image(const PixelStore& store, const PixelLayout& layout, const ImageCommand& image,
                const Extent& extent, unsigned char* to) {
    const ImageRows rows = image_rows(store, layout, image.size[0]);
    const std::size_t next_image = image_stride(store, rows, image.size[1]);
    const unsigned char* slice =
        static_cast<const unsigned char*>(image.pixels) + rows.skip +
        (image.volume ? static_cast<std::size_t>(store.skip_images) * next_image : 0);
    for (std::size_t z = 0; z < extent.images; ++z, slice += next_image)
        for (std::size_t y = 0; y < extent.rows; ++y, to += extent.row_bytes)
            copy_row(store, layout, slice + y * rows.stride, rows.skip_bits,
                     static_cast<std::size_t>(image.size[0]), extent.row_bytes, to);
}

enum : Word { no_pixels, pixels_follow };
constexpr std::uint32_t fixed_words = 13;

} // namespace

void capture_image(Context& context, const Player* player, const ImageCommand& image, GLsizei most) {
    PixelLayout layout;
    const bool keep = is_readable_image(image, most, layout);
    const Extent extent = keep ? extent_of(image, layout) : Extent{0, 0, 0};
    const std::uint32_t data_words = extent.words();
    Word* to = record(context, player, fixed_words + data_words);
    if (to == nullptr)
        return;
    for (const GLint argument : image.arguments)
        *to++ = static_cast<Word>(argument);
    for (const GLsizei side : image.size)
        *to++ = static_cast<Word>(side);
    *to++ = image.format;
    *to++ = image.type;
    *to++ = image.volume ? 1 : 0;
    *to++ = keep ? pixels_follow : no_pixels;
    *to++ = data_words;
    if (!extent.is_empty())
        copy_image(context.pixel_store.unpack, layout, image, extent, reinterpret_cast<unsigned char*>(to));
}

const Word* play_image(Context& context, const Word* words, const CommandText* text,
                       void (*run)(Context&, const ImageCommand&)) {
    ImageCommand image;
    for (GLint& argument : image.arguments)
        argument = static_cast<GLint>(*words++);
    for (GLsizei& side : image.size)
        side = static_cast<GLsizei>(*words++);
    image.format = *words++;
    image.type = *words++;
    image.volume = *words++ != 0;
    const bool follow = *words++ == pixels_follow;
    const Word size = *words++;
    image.pixels = follow ? words : nullptr;
    if (allowed_outside(context, text)) {
        const PixelStore before = context.pixel_store.unpack;
        context.pixel_store.unpack = PixelStore{};
        context.pixel_store.unpack.alignment = 1;
        run(context, image);
        context.pixel_store.unpack = before;
    }
    return words + size;
}

} // namespace spangle::gl::list

#endif
