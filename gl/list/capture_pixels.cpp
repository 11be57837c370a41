// DrawPixels and Bitmap in display lists.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS

#include "gl/api/command.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/list/capture_image.hpp"

namespace spangle::gl {

namespace {

using list::Word;

/// No image is too large to be recorded.
[[maybe_unused]] constexpr GLsizei largest = INT32_MAX;

#if SPANGLE_FEATURE_DRAW_PIXELS
const Word* play_draw_pixels(Context& context, const Word* words) {
    return list::play_image(context, words, family::DrawPixels::text, [](Context& c, const ImageCommand& i) {
        using F = family::DrawPixels;
        cmd::DrawPixels(c, i.size[0], i.size[1], i.format, i.type, i.pixels);
        explain_run<F>(c, F::run, i.size[0], i.size[1], i.format, i.type, i.pixels);
    });
}
#endif

#if SPANGLE_FEATURE_BITMAPS
const Word* play_bitmap(Context& context, const Word* words) {
    return list::play_image(context, words, family::Bitmap::text, [](Context& c, const ImageCommand& i) {
        const auto real = [&i](int n) { return Real{static_cast<std::uint32_t>(i.arguments[n])}; };
        const auto* const bits = static_cast<const GLubyte*>(i.pixels);
        cmd::Bitmap(c, i.size[0], i.size[1], real(0), real(1), real(2), real(3), bits);
        explain_run<family::Bitmap>(c, family::Bitmap::run, i.size[0], i.size[1], real(0), real(1), real(2),
                                    real(3), bits);
    });
}
#endif

} // namespace

namespace encode {

#if SPANGLE_FEATURE_DRAW_PIXELS
void DrawPixels(Context& context, GLsizei width, GLsizei height, GLenum format, GLenum type,
                const void* pixels) {
    list::capture_image(context, &list::player<&play_draw_pixels>,
                        {{}, {width, height, 1}, format, type, pixels}, largest);
}
#endif

#if SPANGLE_FEATURE_BITMAPS
void Bitmap(Context& context, GLsizei width, GLsizei height, Real xorig, Real yorig, Real xmove, Real ymove,
            const GLubyte* bitmap) {
    const auto word = [](Real v) { return static_cast<GLint>(v.bits); };
    list::capture_image(context, &list::player<&play_bitmap>,
                        {{word(xorig), word(yorig), word(xmove), word(ymove)},
                         {width, height, 1},
                         GL_COLOR_INDEX,
                         GL_BITMAP,
                         bitmap},
                        largest);
}
#endif

} // namespace encode

} // namespace spangle::gl

#endif
