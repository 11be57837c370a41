// Makes textures and images of exactly their memory.
#include "tests/system/streams/stream_scenes.hpp"

#include <algorithm>
#include <iterator>

#include <spangle/GL/gl.h>

namespace spangle::test {
namespace {

constexpr GLenum targets[] = {GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D,
                              GL_TEXTURE_CUBE_MAP};
constexpr GLint texel_formats[] = {GL_RGBA,
                                   GL_RGB,
                                   GL_LUMINANCE,
                                   GL_ALPHA,
                                   GL_LUMINANCE_ALPHA,
                                   GL_INTENSITY,
                                   GL_RGB5,
                                   GL_RGBA4,
                                   GL_RGBA8,
                                   GL_RGB5_A1,
                                   GL_R3_G3_B2,
                                   GL_RGB8,
                                   GL_DEPTH_COMPONENT16,
                                   GL_DEPTH_COMPONENT24};

/// How pixels lie in client memory. `words` is true if the type holds all components; otherwise each
/// component has one of its size.
struct Layout {
    GLenum format, type;
    int components, bytes;
    bool words = false;
};
constexpr Layout layouts[] = {
    {GL_RGBA, GL_UNSIGNED_BYTE, 4, 1},
    {GL_RGB, GL_UNSIGNED_BYTE, 3, 1},
    {GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 1, 2, true},
    {GL_LUMINANCE, GL_UNSIGNED_BYTE, 1, 1},
    {GL_ALPHA, GL_UNSIGNED_BYTE, 1, 1},
    {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2, 1},
    {GL_BGRA, GL_UNSIGNED_BYTE, 4, 1},
    {GL_BGR, GL_BYTE, 3, 1},
    {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 1, 2, true},
    {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 1, 2, true},
    {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, 1, 4, true},
    {GL_RGB, GL_UNSIGNED_BYTE_3_3_2, 1, 1, true},
    {GL_RGBA, GL_FLOAT, 4, 4},
    {GL_RED, GL_SHORT, 1, 2},
    {GL_LUMINANCE, GL_UNSIGNED_INT, 1, 4},
    {GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 1, 2},
    {GL_DEPTH_COMPONENT, GL_FLOAT, 1, 4},
    {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 1, 4},
    {GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 1, 1},
    {GL_COLOR_INDEX, GL_UNSIGNED_BYTE, 1, 1},
    {GL_COLOR_INDEX, GL_BITMAP, 1, 0},
};

void store(bool pack, GLenum row, GLint value) {
    glPixelStorei(pack ? row - GL_UNPACK_ROW_LENGTH + GL_PACK_ROW_LENGTH : row, value);
}

} // namespace

/// Makes a block of exactly the bytes that GL may read or write of an image, and sets the pixel store for it.
void Scenes::image_source(int width, int height, int depth, bool pack, GLenum& format, GLenum& type,
                          std::uint8_t*& pixels) {
    const Layout& layout = layouts[in_.byte() % 4 != 0 ? pick(in_, 8) : pick(in_, std::size(layouts))];
    format = layout.format;
    type = layout.type;
    reset_pixel_store();
    const int alignment = 1 << pick(in_, 4);
    int row = width, skip_rows = 0, skip_pixels = 0;
    if (in_.byte() % 4 == 0) {
        row = width + static_cast<int>(pick(in_, 5));
        skip_rows = static_cast<int>(pick(in_, 3));
        skip_pixels = layout.bytes != 0 ? static_cast<int>(pick(in_, 4)) : 0;
        store(pack, GL_UNPACK_ROW_LENGTH, row);
        store(pack, GL_UNPACK_SKIP_ROWS, skip_rows);
        store(pack, GL_UNPACK_SKIP_PIXELS, skip_pixels);
    }
    store(pack, GL_UNPACK_ALIGNMENT, alignment);
    store(pack, GL_UNPACK_SWAP_BYTES, in_.byte() % 8 == 0);
    // Rows are aligned if `alignment` is more than the size of an element (GL 1.3, 3.6.4).
    const auto size = [](int n) { return static_cast<std::size_t>(n); };
    const std::size_t group = size(layout.components * layout.bytes);
    std::size_t line = layout.bytes != 0 ? size(row) * group : (size(row) + 7) / 8;
    if (layout.bytes < alignment)
        line = (line + size(alignment) - 1) / size(alignment) * size(alignment);
    const std::size_t last = layout.bytes != 0 ? size(skip_pixels + width) * group : (size(width) + 7) / 8;
    const int rows = skip_rows + height * (depth - 1) + height;
    pixels = memory_.make(room(width == 0 || rows <= 0 ? 0 : size(rows - 1) * line + last));
}

void Scenes::reset_pixel_store() {
    for (const bool pack : {false, true}) {
        for (const GLenum name : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
                                  GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST})
            store(pack, static_cast<GLenum>(name), 0);
        store(pack, GL_UNPACK_ALIGNMENT, 4);
    }
    for (const GLenum name :
         {GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES})
        glPixelStorei(name, 0);
}

/// Makes a texture that is complete, or nearly so, with all levels if its filter asks for them.
void Scenes::texture() {
    const std::size_t kept = memory_.blocks();
    glActiveTexture(GL_TEXTURE0 + pick(in_, 2));
    const GLenum target = pick(in_, targets);
    glBindTexture(target, 1 + pick(in_, 6));
    const bool cube = target == GL_TEXTURE_CUBE_MAP;
    const int most = target == GL_TEXTURE_3D ? 3 : cube ? 5 : 7;
    int log_width = static_cast<int>(pick(in_, static_cast<unsigned>(most + 1)));
    const int log_height = target == GL_TEXTURE_1D ? 0
                           : cube                  ? log_width
                                  : static_cast<int>(pick(in_, static_cast<unsigned>(most + 1)));
    const int log_depth = target == GL_TEXTURE_3D ? static_cast<int>(pick(in_, 4)) : 0;
    if (!cube && log_height <= 2 && log_depth == 0 && in_.byte() % 4 == 0)
        log_width = 11; // the longest row that textures may have
    const GLint internal = pick(in_, texel_formats);
    const int border = in_.byte() % 8 == 0 ? 1 : 0;
    const GLenum filters[] = {GL_NEAREST,
                              GL_LINEAR,
                              GL_NEAREST_MIPMAP_NEAREST,
                              GL_LINEAR_MIPMAP_NEAREST,
                              GL_NEAREST_MIPMAP_LINEAR,
                              GL_LINEAR_MIPMAP_LINEAR};
    const unsigned filter = pick(in_, 6);
    const auto wrap = [&] {
        return static_cast<GLint>(
            pick(in_, {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT}));
    };
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filters[filter]));
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filters[pick(in_, 2)]));
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(target, name, wrap());
    if (in_.byte() % 8 == 0) {
        glTexParameteri(target, GL_TEXTURE_BASE_LEVEL, static_cast<GLint>(pick(in_, 4)));
        glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(pick(in_, 13)));
    }
    if (in_.byte() % 8 == 0)
        glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    const bool makes_levels = in_.byte() % 4 == 0;
    glTexParameteri(target, GL_GENERATE_MIPMAP, makes_levels);
    const int levels = filter < 2 || makes_levels ? 1 : 1 + std::max({log_width, log_height, log_depth});
    for (int level = 0; level < levels; ++level) {
        const auto side = [&](int log) { return (1 << std::max(log - level, 0)) + 2 * border; };
        const int w = side(log_width), h = target == GL_TEXTURE_1D ? 1 : side(log_height),
                  d = target == GL_TEXTURE_3D ? side(log_depth) : 1;
        GLenum format = 0, type = 0;
        std::uint8_t* pixels = nullptr;
        image_source(w, h, d, false, format, type, pixels);
        if (target == GL_TEXTURE_1D)
            glTexImage1D(target, level, internal, w, border, format, type, pixels);
        else if (target == GL_TEXTURE_3D)
            glTexImage3D(target, level, internal, w, h, d, border, format, type, pixels);
        for (unsigned face = 0; face < (cube ? 6u : target == GL_TEXTURE_2D ? 1u : 0u); ++face)
            glTexImage2D(cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + face : target, level, internal, w, h, border,
                         format, type, pixels);
    }
    in_.byte() % 8 != 0 ? glEnable(target) : glDisable(target);
    reset_pixel_store();
    memory_.drop_to(kept);
}

/// Draws and reads images, with gaps between their rows, and zoomed ones.
void Scenes::images() {
    const std::size_t kept = memory_.blocks();
    const int w = static_cast<int>(pick(in_, 40)), h = static_cast<int>(pick(in_, 24));
    GLenum format = 0, type = 0;
    std::uint8_t* pixels = nullptr;
    glRasterPos2f(coordinate(in_, width_), coordinate(in_, height_));
    if (in_.byte() % 4 == 0)
        glWindowPos2f(coordinate(in_, width_), coordinate(in_, height_));
    if (in_.byte() % 3 == 0)
        glPixelZoom(unit_number(in_) * 4, unit_number(in_) * 4);
    else
        glPixelZoom(1, in_.byte() % 2 != 0 ? 1 : -1);
    if (in_.byte() % 8 == 0)
        glPixelTransferf(pick(in_, {GL_RED_SCALE, GL_GREEN_BIAS, GL_ALPHA_SCALE, GL_DEPTH_BIAS, GL_MAP_COLOR,
                                    GL_INDEX_SHIFT, GL_INDEX_OFFSET}),
                         unit_number(in_));
    if (in_.byte() % 8 == 0)
        glPixelMapfv(GL_PIXEL_MAP_I_TO_I + pick(in_, 10), 1 << pick(in_, 6),
                     reinterpret_cast<const GLfloat*>(memory_.make(4 * 32)));
    image_source(w, h, 1, false, format, type, pixels);
    switch (pick(in_, 4)) {
    case 0: {
        reset_pixel_store();
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        pixels = memory_.make(room(static_cast<std::size_t>((w + 7) / 8 * h)));
        glBitmap(w, h, unit_number(in_), unit_number(in_), unit_number(in_) * 9, unit_number(in_) * 9,
                 pixels);
        break;
    }
    case 1:
        glBindTexture(GL_TEXTURE_2D, 1 + pick(in_, 6));
        glTexSubImage2D(GL_TEXTURE_2D, static_cast<GLint>(pick(in_, 3)), static_cast<GLint>(pick(in_, 9)) - 1,
                        static_cast<GLint>(pick(in_, 9)) - 1, w, h, format, type, pixels);
        break;
    default:
        glDrawPixels(w, h, format, type, pixels);
    }
    image_source(w, h, 1, true, format, type, pixels);
    glReadPixels(static_cast<GLint>(pick(in_, 64)) - 8, static_cast<GLint>(pick(in_, 64)) - 8, w, h, format,
                 type, pixels);
    reset_pixel_store();
    memory_.drop_to(kept);
}

void Scenes::copies() {
    const auto x = whole_coordinate(in_, width_), y = whole_coordinate(in_, height_);
    glBindTexture(GL_TEXTURE_2D, 1 + pick(in_, 6));
    switch (pick(in_, 4)) {
    case 0:
        glRasterPos2f(coordinate(in_, width_), coordinate(in_, height_));
        glCopyPixels(x, y, static_cast<GLsizei>(pick(in_, 64)), static_cast<GLsizei>(pick(in_, 64)),
                     pick(in_, {GL_COLOR, GL_DEPTH, GL_STENCIL}));
        break;
    case 1:
        glCopyTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLenum>(pick(in_, texel_formats)), x, y,
                         1 << pick(in_, 7), 1 << pick(in_, 7), 0);
        break;
    case 2:
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(pick(in_, 8)),
                            static_cast<GLint>(pick(in_, 8)), x, y, static_cast<GLsizei>(pick(in_, 64)),
                            static_cast<GLsizei>(pick(in_, 64)));
        break;
    default:
        glReadBuffer(pick(in_, {GL_BACK, GL_FRONT}));
        glCopyTexImage1D(GL_TEXTURE_1D, 0, static_cast<GLenum>(pick(in_, texel_formats)), x, y,
                         1 << pick(in_, 7), 0);
    }
}

} // namespace spangle::test
