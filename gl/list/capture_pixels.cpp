// Images in display lists: the pixels are copied while the list is compiled, through the unpack state of that
// moment, and played with a state that describes the copy (GL 1.3, 3.6.1 and 5.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS

#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/list/record.hpp"
#include "gl/pixel/pixel_layout.hpp"

namespace spangle::gl {

namespace {

using list::Word;

/// Rows side by side, elements in host order.
void copy_rows(const PixelStore& store, const PixelLayout& layout, GLsizei width, GLsizei height,
               const void* pixels, unsigned char* to) {
    const ImageRows rows = image_rows(store, layout, width);
    const std::size_t row_bytes = static_cast<std::size_t>(width) * layout.group_bytes();
    const unsigned char* from = static_cast<const unsigned char*>(pixels) + rows.skip;
    for (GLsizei y = 0; y < height; ++y, from += rows.stride, to += row_bytes) {
        std::memcpy(to, from, row_bytes);
        if (!store.swap_bytes || layout.element_bytes == 1)
            continue;
        for (unsigned char* e = to; e != to + row_bytes; e += layout.element_bytes)
            for (unsigned low = 0, high = layout.element_bytes - 1u; low < high; ++low, --high) {
                const unsigned char byte = e[low];
                e[low] = e[high];
                e[high] = byte;
            }
    }
}

/// An image whose pixels are worth keeping: one that TexImage2D may accept.
bool sensible(GLenum format, GLenum type, GLsizei width, GLsizei height, const void* pixels,
              PixelLayout& layout) {
    constexpr GLsizei most = max_texture_size + 2; // with its border
    return pixels != nullptr && width >= 0 && width <= most && height >= 0 && height <= most &&
           format != GL_DEPTH_COMPONENT && format != GL_STENCIL_INDEX &&
           pixel_layout(format, type, layout) == GL_NO_ERROR && layout.kind != ElementKind::bitmap;
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
    PixelLayout layout;
    const bool keep = sensible(image.format, image.type, image.width, image.height, image.pixels, layout);
    const std::uint32_t bytes = keep ? static_cast<std::uint32_t>(image.width) *
                                           static_cast<std::uint32_t>(image.height) * layout.group_bytes()
                                     : 0;
    constexpr std::uint32_t fixed_words = 10;
    Word* to = list::record(context, player, fixed_words + (bytes + 3) / 4);
    if (to == nullptr)
        return;
    for (const GLint argument : image.arguments)
        *to++ = static_cast<Word>(argument);
    *to++ = static_cast<Word>(image.width);
    *to++ = static_cast<Word>(image.height);
    *to++ = image.format;
    *to++ = image.type;
    *to++ = keep ? pixels_follow : no_pixels;
    *to++ = (bytes + 3) / 4;
    if (bytes != 0)
        copy_rows(context.pixel_store.unpack, layout, image.width, image.height, image.pixels,
                  reinterpret_cast<unsigned char*>(to));
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
        cmd::TexImage2D(c, static_cast<GLenum>(i.arguments[0]), i.arguments[1], i.arguments[2], i.width,
                        i.height, i.arguments[3], i.format, i.type, i.pixels);
    });
}

const Word* play_tex_sub_image_2d(Context& context, const Word* words) {
    return play(context, words, [](Context& c, const Image& i) {
        cmd::TexSubImage2D(c, static_cast<GLenum>(i.arguments[0]), i.arguments[1], i.arguments[2],
                           i.arguments[3], i.width, i.height, i.format, i.type, i.pixels);
    });
}

} // namespace

namespace encode {

void TexImage2D(Context& context, GLenum target, GLint level, GLint internalformat, GLsizei width,
                GLsizei height, GLint border, GLenum format, GLenum type, const void* pixels) {
    if (target == GL_PROXY_TEXTURE_2D) { // a query: runs at once and is not stored (GL 1.3, 5.4)
        if (!context.list.execute && list::allowed_outside(context, family::TexImage2D::refusal))
            cmd::TexImage2D(context, target, level, internalformat, width, height, border, format, type,
                            pixels);
        return;
    }
    capture(
        context, &play_tex_image_2d,
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
