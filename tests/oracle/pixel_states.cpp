// Pixel paths (GL 1.3, 3.6, 3.7, 4.3): images of every format and type,
// transferred, zoomed, read, copied; bitmaps.
#include "tests/oracle/state_families.hpp"

#include <cmath>
#include <cstring>

namespace spangle::oracle {

namespace {

using test::Random;

bool maybe(Random& random) {
    return random.below(2) != 0;
}
int whole(Random& random, int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1)));
}
GLfloat unit(Random& random) {
    return static_cast<GLfloat>(random.below(256)) / 255;
}

struct Layout {
    GLenum format, type;
};

constexpr GLenum color_formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA,     GL_RGB,
                                    GL_BGR, GL_RGBA,  GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
/// Signed ones convert otherwise since GL 4.2, and Mesa does it that way.
constexpr GLenum plain_types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_FLOAT};
constexpr GLenum rgb_types[] = {GL_UNSIGNED_BYTE_3_3_2, GL_UNSIGNED_BYTE_2_3_3_REV, GL_UNSIGNED_SHORT_5_6_5,
                                GL_UNSIGNED_SHORT_5_6_5_REV};
constexpr GLenum rgba_types[] = {GL_UNSIGNED_SHORT_4_4_4_4,  GL_UNSIGNED_SHORT_4_4_4_4_REV,
                                 GL_UNSIGNED_SHORT_5_5_5_1,  GL_UNSIGNED_SHORT_1_5_5_5_REV,
                                 GL_UNSIGNED_INT_8_8_8_8,    GL_UNSIGNED_INT_8_8_8_8_REV,
                                 GL_UNSIGNED_INT_10_10_10_2, GL_UNSIGNED_INT_2_10_10_10_REV};

Layout color_layout(Random& random) {
    const std::uint32_t kind = random.below(4);
    if (kind == 0)
        return {GL_RGB, rgb_types[random.below(4)]};
    const GLenum rgba = maybe(random) ? GL_RGBA : GL_BGRA;
    if (kind == 1)
        return {rgba, rgba_types[random.below(8)]};
    return {color_formats[random.below(10)], plain_types[random.below(4)]};
}

void store(Random& random, int width, bool pack) {
    const GLenum first = pack ? GL_PACK_SWAP_BYTES : GL_UNPACK_SWAP_BYTES;
    const int values[] = {0, // Mesa's softpipe takes swapped elements for others
                          static_cast<int>(random.below(2)),
                          maybe(random) ? width + whole(random, 0, 3) : 0,
                          whole(random, 0, 2),
                          whole(random, 0, 9),
                          1 << random.below(4)};
    for (GLenum i = 0; i < 6; ++i)
        glPixelStorei(first + i, values[i]);
}

/// Bytes, or floats a little beyond 0 and 1.
struct Client {
    alignas(8) GLubyte bytes[40000];
    Client(Random& random, GLenum type) {
        for (GLubyte& b : bytes)
            b = static_cast<GLubyte>(random.below(256));
        if (type != GL_FLOAT)
            return;
        for (std::size_t i = 0; i < sizeof bytes; i += 4) {
            const GLfloat v = static_cast<GLfloat>(random.below(1500)) / 1000 - 0.25f;
            std::memcpy(&bytes[i], &v, sizeof v);
        }
    }
};

/// Colours, depths and stencil values to read, copy and draw over.
void background(Random& random) {
    for (int i = 0; i < 10; ++i) {
        const GLfloat r = unit(random), g = unit(random), b = unit(random), a = unit(random);
        glClearColor(r, g, b, a);
        glClearStencil(whole(random, 0, 255));
        glClearDepth(static_cast<GLfloat>(random.below(8)) / 8 + 0.0625f);
        const int x = whole(random, 0, 20), y = whole(random, 0, 20), w = whole(random, 1, 12);
        glScissor(x, y, w, whole(random, 1, 12));
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
    }
    glDisable(GL_SCISSOR_TEST);
}

/// What fragments of images meet.
void operations(Random& random) {
    constexpr GLenum compare[] = {GL_LESS, GL_GEQUAL, GL_ALWAYS, GL_NOTEQUAL};
    constexpr GLenum source[] = {GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR, GL_ZERO};
    constexpr GLenum destination[] = {GL_ZERO, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_SRC_COLOR};
    if (maybe(random))
        glEnable(GL_BLEND);
    const GLenum dst = destination[random.below(4)], src = source[random.below(4)]; // one order everywhere
    glBlendFunc(src, dst);
    if (maybe(random))
        glEnable(GL_DEPTH_TEST);
    glDepthFunc(compare[random.below(4)]);
    glDepthMask(static_cast<GLboolean>(random.below(2)));
    if (random.below(4) == 0)
        glEnable(GL_STENCIL_TEST);
    const int ref = whole(random, 0, 255);
    glStencilFunc(compare[random.below(4)], ref, ~0u);
    glStencilOp(GL_KEEP, GL_INVERT, GL_INCR);
    if (random.below(4) == 0) {
        const bool blue = random.below(2) != 0, red = random.below(2) != 0;
        glColorMask(red ? GL_TRUE : GL_FALSE, GL_TRUE, blue ? GL_TRUE : GL_FALSE, GL_TRUE);
    }
    if (maybe(random))
        glEnable(GL_SCISSOR_TEST);
    const int y = whole(random, 0, 9), x = whole(random, 0, 9);
    glScissor(x, y, 14, 13);
}

/// Maps are left to tests of our own: softpipe addresses them by floor(256 c)
/// and blue by another component.
void transfer(Random& random) {
    constexpr GLenum scale[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
    constexpr GLenum bias[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
    for (int c = 0; c < 4; ++c) {
        if (maybe(random))
            glPixelTransferf(scale[c], static_cast<GLfloat>(whole(random, -8, 12)) / 4);
        if (maybe(random))
            glPixelTransferf(bias[c], static_cast<GLfloat>(whole(random, -8, 8)) / 16);
    }
}

void untransferred() {
    constexpr GLenum scale[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
    constexpr GLenum bias[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
    for (int c = 0; c < 4; ++c) {
        glPixelTransferf(scale[c], 1);
        glPixelTransferf(bias[c], 0);
    }
}

/// A raster position between pixels' corners is Mesa's own affair: it rounds
/// it.
void place(Random& random, bool zooms) {
    const GLfloat a = unit(random), b = unit(random), g = unit(random), r = unit(random);
    glColor4f(r, g, b, a);
    const int x = whole(random, 0, 20), y = whole(random, 0, 20);
    glRasterPos3f(static_cast<GLfloat>(x), static_cast<GLfloat>(y),
                  static_cast<GLfloat>(random.below(8)) / 4 - 0.75f); // no depth of the background
    constexpr GLfloat zoom[] = {1, 2, -1, 4, 3, -2};
    if (zooms) {
        const GLfloat zx = zoom[random.below(6)], zy = zoom[random.below(6)];
        glPixelZoom(zx, zy);
    }
}

/// As one is drawn next.
void note_image(Quads& quads, int width, int height) {
    GLfloat at[4], zoom_x = 1, zoom_y = 1;
    glGetFloatv(GL_CURRENT_RASTER_POSITION, at);
    glGetFloatv(GL_ZOOM_X, &zoom_x);
    glGetFloatv(GL_ZOOM_Y, &zoom_y);
    quads.add(at[0], at[1], at[0] + zoom_x * static_cast<GLfloat>(width),
              at[1] + zoom_y * static_cast<GLfloat>(height));
}

void draw_image(Random& random, Quads& quads, bool transfers) {
    background(random);
    const int width = whole(random, 1, 14), height = whole(random, 1, 12);
    const Layout layout = color_layout(random);
    store(random, width, false);
    const Client client(random, layout.type);
    operations(random);
    if (transfers)
        transfer(random);
    place(random, maybe(random));
    note_image(quads, width, height);
    glDrawPixels(width, height, layout.format, layout.type, client.bytes);
    glPixelZoom(1, 1);
    untransferred();
}
void draw_images(Random& random, Quads& quads) {
    draw_image(random, quads, false);
}
void draw_transferred(Random& random, Quads& quads) {
    draw_image(random, quads, true);
}

void draw_depths(Random& random, Quads& quads) {
    background(random);
    const int width = whole(random, 1, 14), height = whole(random, 1, 12);
    constexpr GLenum types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_FLOAT};
    const GLenum type = types[random.below(4)];
    store(random, width, false);
    const Client client(random, type);
    operations(random);
    glDepthFunc(GL_ALWAYS); // equal depths are another matter in floats
    if (maybe(random)) {
        glPixelTransferf(GL_DEPTH_SCALE, static_cast<GLfloat>(whole(random, -4, 8)) / 4);
        glPixelTransferf(GL_DEPTH_BIAS, static_cast<GLfloat>(whole(random, -4, 4)) / 8);
    }
    place(random, false);
    note_image(quads, width, height);
    glDrawPixels(width, height, GL_DEPTH_COMPONENT, type, client.bytes);
    glPixelZoom(1, 1);
    glPixelTransferf(GL_DEPTH_SCALE, 1);
    glPixelTransferf(GL_DEPTH_BIAS, 0);
}

/// What was read is drawn again as it was read.
void read_images(Random& random, Quads& quads) {
    background(random);
    const int width = whole(random, 1, 24), height = whole(random, 1, 24);
    Layout layout = color_layout(random);
    if (layout.format == GL_LUMINANCE ||
        layout.format == GL_LUMINANCE_ALPHA) // clamped before the sum in Mesa
        layout.format = GL_RED;
    static GLubyte bytes[40000];
    std::memset(bytes, 0, sizeof bytes);
    const Random same = random; // one pixel storage for both ways
    store(random, width, true);
    // A component of a few bits may be halfway between two of them, and 1 overflows Mesa's unsigned integers.
    const bool few_bits =
        layout.type != GL_UNSIGNED_BYTE && layout.type != GL_UNSIGNED_SHORT && layout.type != GL_FLOAT;
    if (layout.type == GL_UNSIGNED_INT)
        layout.type = GL_UNSIGNED_SHORT;
    if (!few_bits && maybe(random))
        transfer(random);
    const int y = whole(random, 0, state_size - height), x = whole(random, 0, state_size - width);
    glReadPixels(x, y, width, height, layout.format, layout.type, bytes);
    untransferred();
    Random again = same;
    store(again, width, false);
    glRasterPos2i(0, 0);
    note_image(quads, width, height);
    glDrawPixels(width, height, layout.format, layout.type, bytes);
}

/// Mesa's blits forget the colour mask, its depths come out of floats, its stencil values turn round a pixel
/// late.
void copy_pixels(Random& random, Quads& quads) {
    background(random);
    if (maybe(random))
        operations(random);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (maybe(random))
        transfer(random);
    const int width = whole(random, 1, 14), height = whole(random, 1, 14);
    constexpr GLenum types[] = {GL_COLOR, GL_COLOR, GL_STENCIL, GL_DEPTH};
    const GLenum type = types[random.below(4)];
    if (type == GL_DEPTH)
        glDepthFunc(GL_ALWAYS);
    place(random, type != GL_STENCIL && maybe(random));
    const int x = whole(random, 0, state_size - width), y = whole(random, 0, state_size - height);
    note_image(quads, width, height);
    glCopyPixels(x, y, width, height, type);
    glPixelZoom(1, 1);
    untransferred();
}

void bitmaps(Random& random, Quads& quads) {
    background(random);
    operations(random);
    for (int i = 0; i < 4; ++i) {
        const int width = whole(random, 0, 20), height = whole(random, 0, 14);
        store(random, width, false);
        const Client client(random, GL_BITMAP);
        place(random, false);
        const GLfloat xo = static_cast<GLfloat>(whole(random, -16, 16)) / 4,
                      yo = static_cast<GLfloat>(whole(random, -16, 16)) / 4;
        for (int twice = 0; twice < 2; ++twice) {
            const GLfloat xm = static_cast<GLfloat>(whole(random, -9, 9)),
                          ym = static_cast<GLfloat>(whole(random, -9, 9));
            GLfloat at[4];
            glGetFloatv(GL_CURRENT_RASTER_POSITION, at);
            // Mesa gathers bitmaps in an image of this size, this one in the middle of its left side.
            constexpr int gathered_width = 512, gathered_height = 32;
            const double left = std::floor(double{at[0]} - xo);
            const double low = std::floor(double{at[1]} - yo) - (gathered_height - height) / 2;
            quads.add(left, low, left + gathered_width, low + gathered_height);
            glBitmap(width, height, xo, yo, xm, ym, client.bytes);
            glFlush(); // Mesa gathers bitmaps and draws what overlaps once
        }
    }
}

} // namespace

void add_pixel_families(std::vector<Family>& all) {
    all.push_back({"DrawPixels", 1500, 1, 0.99, draw_images});
    all.push_back({"DrawPixelsTransferred", 1500, 1, 0.99, draw_transferred});
    all.push_back({"DrawPixelsOfDepths", 1000, 1, 0.99, draw_depths});
    all.push_back({"ReadPixels", 1500, 1, 0.99, read_images});
    all.push_back({"CopyPixels", 1500, 1, 0.99, copy_pixels});
    all.push_back({"Bitmaps", 1500, 1, 0.99, bitmaps});
}

} // namespace spangle::oracle
