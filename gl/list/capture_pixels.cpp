// Images in display lists: the pixels are copied while the list is compiled, through the unpack state of that moment,
// and played with a state that describes the copy (GL 1.3, 3.6.1 and 5.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS

#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/list/record.hpp"

namespace spangle::gl {

namespace {

using list::Word;

/// Shape of a client image that holds colours; element_bytes 0: not one.
struct Layout {
    std::uint32_t elements = 0; ///< per pixel
    std::uint32_t element_bytes = 0;
};

std::uint32_t components(GLenum format) {
    switch (format) {
    case GL_RED:
    case GL_GREEN:
    case GL_BLUE:
    case GL_ALPHA:
    case GL_LUMINANCE:
        return 1;
    case GL_LUMINANCE_ALPHA:
        return 2;
    case GL_RGB:
    case GL_BGR:
        return 3;
    case GL_RGBA:
    case GL_BGRA:
        return 4;
    default:
        return 0;
    }
}

Layout layout_of(GLenum format, GLenum type) {
    const std::uint32_t count = components(format);
    switch (type) {
    case GL_UNSIGNED_BYTE:
    case GL_BYTE:
        return {count, 1};
    case GL_UNSIGNED_SHORT:
    case GL_SHORT:
        return {count, 2};
    case GL_UNSIGNED_INT:
    case GL_INT:
    case GL_FLOAT:
        return {count, 4};
    case GL_UNSIGNED_BYTE_3_3_2:
    case GL_UNSIGNED_BYTE_2_3_3_REV:
        return {1, 1};
    case GL_UNSIGNED_SHORT_5_6_5:
    case GL_UNSIGNED_SHORT_5_6_5_REV:
    case GL_UNSIGNED_SHORT_4_4_4_4:
    case GL_UNSIGNED_SHORT_4_4_4_4_REV:
    case GL_UNSIGNED_SHORT_5_5_5_1:
    case GL_UNSIGNED_SHORT_1_5_5_5_REV:
        return {1, 2};
    case GL_UNSIGNED_INT_8_8_8_8:
    case GL_UNSIGNED_INT_8_8_8_8_REV:
    case GL_UNSIGNED_INT_10_10_10_2:
    case GL_UNSIGNED_INT_2_10_10_10_REV:
        return {1, 4};
    default:
        return {};
    }
}

/// GL 1.3, 3.6.4: rows of `length` pixels start at multiples of the alignment.
std::uint64_t row_stride(const PixelStore& store, const Layout& layout, std::uint32_t width) {
    const std::uint32_t length = store.row_length > 0 ? static_cast<std::uint32_t>(store.row_length) : width;
    const auto alignment = static_cast<std::uint32_t>(store.alignment);
    const std::uint64_t bytes = std::uint64_t{length} * layout.elements * layout.element_bytes;
    return layout.element_bytes >= alignment ? bytes : (bytes + alignment - 1) / alignment * alignment;
}

/// Rows side by side, bytes in host order.
void copy_rows(const PixelStore& store, const Layout& layout, std::uint32_t width, std::uint32_t height,
               const void* pixels, unsigned char* to) {
    const std::uint64_t stride = row_stride(store, layout, width);
    const std::uint32_t pixel_bytes = layout.elements * layout.element_bytes;
    const std::size_t row_bytes = std::size_t{width} * pixel_bytes;
    const unsigned char* from = static_cast<const unsigned char*>(pixels) +
                                static_cast<std::size_t>(static_cast<std::uint32_t>(store.skip_rows) * stride) +
                                std::size_t{static_cast<std::uint32_t>(store.skip_pixels)} * pixel_bytes;
    for (std::uint32_t y = 0; y < height; ++y, from += stride, to += row_bytes) {
        std::memcpy(to, from, row_bytes);
        if (!store.swap_bytes || layout.element_bytes == 1)
            continue;
        for (unsigned char* e = to; e != to + row_bytes; e += layout.element_bytes)
            for (std::uint32_t low = 0, high = layout.element_bytes - 1; low < high; ++low, --high) {
                const unsigned char byte = e[low];
                e[low] = e[high];
                e[high] = byte;
            }
    }
}

/// What TexImage2D and TexSubImage2D have in common.
struct Image {
    GLint arguments[4]; ///< target, level, and the two others
    GLsizei width, height;
    GLenum format, type;
    const void* pixels;
};

enum : Word { no_pixels, pixels_follow };

void capture(Context& context, list::Player player, const Image& image) {
    Layout layout = layout_of(image.format, image.type);
    // An image that will be refused anyway is stored without its pixels; so is one no arena could hold.
    const bool sensible = image.width >= 0 && image.height >= 0 && image.width <= 0x4000 && image.height <= 0x4000 &&
                          layout.elements != 0 && image.pixels != nullptr;
    const std::uint64_t bytes = sensible ? std::uint64_t{static_cast<std::uint32_t>(image.width)} *
                                               static_cast<std::uint32_t>(image.height) * layout.elements *
                                               layout.element_bytes
                                         : 0;
    constexpr std::uint32_t fixed_words = 10;
    Word* to = list::record(context, player, fixed_words + static_cast<std::uint32_t>((bytes + 3) / 4));
    if (to == nullptr)
        return;
    for (const GLint argument : image.arguments)
        *to++ = static_cast<Word>(argument);
    *to++ = static_cast<Word>(image.width);
    *to++ = static_cast<Word>(image.height);
    *to++ = image.format;
    *to++ = image.type;
    *to++ = sensible ? pixels_follow : no_pixels;
    *to++ = static_cast<Word>((bytes + 3) / 4);
    if (bytes != 0)
        copy_rows(context.pixel_store.unpack, layout, static_cast<std::uint32_t>(image.width),
                  static_cast<std::uint32_t>(image.height), image.pixels, reinterpret_cast<unsigned char*>(to));
}

const Word* play(Context& context, const Word* words, void (*run)(Context&, const Image&)) {
    Image image;
    for (GLint& argument : image.arguments)
        argument = static_cast<GLint>(*words++);
    image.width = static_cast<GLsizei>(*words++);
    image.height = static_cast<GLsizei>(*words++);
    image.format = *words++;
    image.type = *words++;
    const bool follow = *words++ == pixels_follow;
    const Word size = *words++;
    image.pixels = follow ? words : nullptr;
    if (list::allowed_outside(context, SPANGLE_TEXT("glTexImage in a list between glBegin and glEnd"))) {
        const PixelStore before = context.pixel_store.unpack;
        context.pixel_store.unpack = PixelStore{};
        context.pixel_store.unpack.alignment = 1;
        run(context, image);
        context.pixel_store.unpack = before;
    }
    return words + size;
}

const Word* play_tex_image_2d(Context& context, const Word* words) {
    return play(context, words, [](Context& c, const Image& i) {
        cmd::TexImage2D(c, static_cast<GLenum>(i.arguments[0]), i.arguments[1], i.arguments[2], i.width, i.height,
                        i.arguments[3], i.format, i.type, i.pixels);
    });
}

const Word* play_tex_sub_image_2d(Context& context, const Word* words) {
    return play(context, words, [](Context& c, const Image& i) {
        cmd::TexSubImage2D(c, static_cast<GLenum>(i.arguments[0]), i.arguments[1], i.arguments[2], i.arguments[3],
                           i.width, i.height, i.format, i.type, i.pixels);
    });
}

} // namespace

namespace encode {

void TexImage2D(Context& context, GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,
                GLint border, GLenum format, GLenum type, const void* pixels) {
    if (target == GL_PROXY_TEXTURE_2D) { // a query: runs at once and is not stored (GL 1.3, 5.4)
        if (!context.list.execute && list::allowed_outside(context, family::TexImage2D::refusal))
            cmd::TexImage2D(context, target, level, internalformat, width, height, border, format, type, pixels);
        return;
    }
    capture(context, &play_tex_image_2d,
            {{static_cast<GLint>(target), level, internalformat, border}, width, height, format, type, pixels});
}

void TexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                   GLsizei height, GLenum format, GLenum type, const void* pixels) {
    capture(context, &play_tex_sub_image_2d,
            {{static_cast<GLint>(target), level, xoffset, yoffset}, width, height, format, type, pixels});
}

} // namespace encode

} // namespace spangle::gl

#endif
