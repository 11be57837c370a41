// Texture images and priorities in display lists.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS

#include <cstring>

#include "gl/api/command.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/list/capture_image.hpp"
#include "gl/texture/texture_object.hpp"

namespace spangle::gl {

namespace {

using list::Word;

// Texels of the largest side, border included.
constexpr GLsizei most = max_texture_size + 2;

/// True if a target is a proxy. Commands with proxies are queries, which run at once and are not stored (GL
/// 1.3, 5.4). If the list is also executed, the entry point has run them already.
bool is_query(GLenum target) {
    return target == GL_PROXY_TEXTURE_1D || target == GL_PROXY_TEXTURE_2D || target == GL_PROXY_TEXTURE_3D ||
           target == GL_PROXY_TEXTURE_CUBE_MAP;
}
bool runs_now(Context& context, const CommandText* text) {
    return !context.list.execute && allowed_outside(context, text);
}

template <class F> const Word* play_texels(Context& context, const Word* words) {
    return list::play_image(context, words, F::text, [](Context& c, const ImageCommand& image) {
        F::run(c, image);
        explain_run<F>(c, F::run, image);
    });
}

void capture_texels(Context& context, const list::Player* player, const ImageCommand& image) {
    list::capture_image(context, player, image, image.volume ? max_3d_texture_size + 2 : most);
}
[[gnu::noinline]] void capture_unless_query(Context& context, const list::Player* player,
                                            const ImageCommand& image, const CommandText* text,
                                            void (*run)(Context&, const ImageCommand&)) {
    if (!is_query(image.target()))
        capture_texels(context, player, image);
    else if (runs_now(context, text))
        run(context, image);
}

template <class F> void capture_sub_image(Context& context, const ImageCommand& image) {
    capture_texels(context, &list::player<&play_texels<F>>, image);
}
template <class F> void capture_whole_image(Context& context, const ImageCommand& image) {
    capture_unless_query(context, &list::player<&play_texels<F>>, image, F::text, F::run);
}

} // namespace

namespace encode {

void TexImage2D(Context& context, const ImageCommand& image) {
    capture_whole_image<family::TexImage2D>(context, image);
}
void TexSubImage2D(Context& context, const ImageCommand& image) {
    capture_sub_image<family::TexSubImage2D>(context, image);
}
#if SPANGLE_FEATURE_TEXTURE_1D
void TexImage1D(Context& context, const ImageCommand& image) {
    capture_whole_image<family::TexImage1D>(context, image);
}
void TexSubImage1D(Context& context, const ImageCommand& image) {
    capture_sub_image<family::TexSubImage1D>(context, image);
}
#endif
#if SPANGLE_FEATURE_TEXTURE_3D
void TexImage3D(Context& context, const ImageCommand& image) {
    capture_whole_image<family::TexImage3D>(context, image);
}
void TexSubImage3D(Context& context, const ImageCommand& image) {
    capture_sub_image<family::TexSubImage3D>(context, image);
}
#endif

} // namespace encode

#if SPANGLE_FEATURE_COMPRESSED_TEXTURES

namespace {

/// Words of a record before its data: seven arguments, and the number of bytes, or -1 for a null pointer.
constexpr std::uint32_t compressed_words = 8;

void capture_compressed(Context& context, const list::Player* player, const GLint (&arguments)[7],
                        GLsizei size, const void* data) {
    const auto bytes = static_cast<std::uint32_t>(data != nullptr && size > 0 ? size : 0);
    Word* to = list::record(context, player, compressed_words + (bytes + 3) / 4);
    if (to == nullptr)
        return;
    for (const GLint argument : arguments)
        *to++ = static_cast<Word>(argument);
    *to++ = data != nullptr ? bytes : UINT32_MAX;
    if (bytes != 0)
        std::memcpy(to, data, bytes);
}

/// Plays a compressed image by run(arguments, data). Between Begin and End, it raises an error. Returns the
/// next record.
template <class Run>
const Word* play_compressed(Context& context, const Word* words, const CommandText* text, Run run) {
    const bool data = words[7] != UINT32_MAX;
    GLint a[7];
    for (int i = 0; i < 7; ++i)
        a[i] = static_cast<GLint>(words[i]);
    if (allowed_outside(context, text))
        run(a, data ? words + compressed_words : nullptr);
    return words + compressed_words + (data ? (words[7] + 3) / 4 : 0);
}

const Word* play_compressed_image(Context& context, const Word* words) {
    return play_compressed(
        context, words, family::CompressedTexImage2D::text, [&](const GLint* a, const void* data) {
            using F = family::CompressedTexImage2D;
            const auto target = static_cast<GLenum>(a[0]), format = static_cast<GLenum>(a[2]);
            cmd::CompressedTexImage2D(context, target, a[1], format, a[3], a[4], a[5], a[6], data);
            explain_run<F>(context, F::run, target, a[1], format, a[3], a[4], a[5], a[6], data);
        });
}
/// Plays a part of a compressed image. Both offsets share one word, because only 0 is accepted for them.
const Word* play_compressed_sub_image(Context& context, const Word* words) {
    return play_compressed(
        context, words, family::CompressedTexSubImage2D::text, [&](const GLint* a, const void* data) {
            using F = family::CompressedTexSubImage2D;
            const auto target = static_cast<GLenum>(a[0]), format = static_cast<GLenum>(a[5]);
            cmd::CompressedTexSubImage2D(context, target, a[1], a[2], a[2], a[3], a[4], format, a[6], data);
            explain_run<F>(context, F::run, target, a[1], a[2], a[2], a[3], a[4], format, a[6], data);
        });
}

} // namespace

namespace encode {

void CompressedTexImage2D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width,
                          GLsizei height, GLint border, GLsizei imageSize, const void* data) {
    if (is_query(target)) {
        if (runs_now(context, family::CompressedTexImage2D::text))
            cmd::CompressedTexImage2D(context, target, level, internalformat, width, height, border,
                                      imageSize, data);
        return;
    }
    capture_compressed(context, &list::player<&play_compressed_image>,
                       {static_cast<GLint>(target), level, static_cast<GLint>(internalformat), width, height,
                        border, imageSize},
                       imageSize, data);
}

void CompressedTexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                             GLsizei width, GLsizei height, GLenum format, GLsizei imageSize,
                             const void* data) {
    capture_compressed(context, &list::player<&play_compressed_sub_image>,
                       {static_cast<GLint>(target), level, xoffset | yoffset, width, height,
                        static_cast<GLint>(format), imageSize},
                       imageSize, data);
}

} // namespace encode

#endif

namespace {

/// Plays priorities. Its words are the number of names, the names and the priorities.
const Word* play_priorities(Context& context, const Word* words) {
    const Word count = words[0];
    if (allowed_outside(context, family::PrioritizeTextures::text))
        cmd::PrioritizeTextures(context, static_cast<GLsizei>(count),
                                reinterpret_cast<const GLuint*>(words + 1),
                                reinterpret_cast<const GLclampf*>(words + 1 + count));
    return words + 1 + 2 * count;
}

} // namespace

void encode::PrioritizeTextures(Context& context, GLsizei n, const GLuint* textures,
                                const GLclampf* priorities) {
    if (n < 0 || (n > 0 && (textures == nullptr || priorities == nullptr)))
        return list::record_error(context, GL_INVALID_VALUE, false);
    const auto count = static_cast<std::uint32_t>(n);
    Word* const to =
        list::record(context, &list::player<&play_priorities, family::PrioritizeTextures>, 1 + 2 * count);
    if (to == nullptr)
        return;
    to[0] = count;
    if (count == 0)
        return;
    std::memcpy(to + 1, textures, count * sizeof(Word));
    std::memcpy(to + 1 + count, priorities, count * sizeof(Word));
}

} // namespace spangle::gl

#endif
