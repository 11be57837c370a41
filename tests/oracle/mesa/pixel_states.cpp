// Pixel paths (GL 1.3, 3.6, 3.7, 4.3): images of every format and type, transferred, zoomed, read and copied;
// and bitmaps.

#include <cmath>
#include <cstring>

#include "tests/oracle/mesa/random_image.hpp"
#include "tests/oracle/mesa/state_families.hpp"

namespace spangle::oracle {

namespace {

using test::Random;

/// Sets operations on the fragments of images.
void operations(Random& random) {
    constexpr GLenum compare[] = {GL_LESS, GL_GEQUAL, GL_ALWAYS, GL_NOTEQUAL};
    constexpr GLenum source[] = {GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR, GL_ZERO};
    constexpr GLenum destination[] = {GL_ZERO, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_SRC_COLOR};
    if (maybe(random))
        glEnable(GL_BLEND);
    // Declared one after the other, so that every compiler takes the random numbers in one order.
    const GLenum dst = destination[random.below(4)], src = source[random.below(4)];
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

/// Sets a raster position. Positions between the corners of pixels are not compared, because Mesa rounds
/// them.
void place(Random& random, bool zooms) {
    const GLfloat a = unit(random), b = unit(random), g = unit(random), r = unit(random);
    glColor4f(r, g, b, a);
    const int x = whole(random, 0, 20), y = whole(random, 0, 20);
    glRasterPos3f(static_cast<GLfloat>(x), static_cast<GLfloat>(y),
                  static_cast<GLfloat>(random.below(8)) / 4 - 0.75f); // a depth that is not in the background
    constexpr GLfloat zoom[] = {1, 2, -1, 4, 3, -2};
    if (zooms) {
        const GLfloat zx = zoom[random.below(6)], zy = zoom[random.below(6)];
        glPixelZoom(zx, zy);
    }
}

/// Notes where the next image will be drawn.
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
    glDepthFunc(GL_ALWAYS); // equal depths may differ in floats
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

/// Draws what was read again as it was read.
void read_images(Random& random, Quads& quads) {
    background(random);
    const int width = whole(random, 1, 24), height = whole(random, 1, 24);
    Layout layout = color_layout(random);
    if (layout.format == GL_LUMINANCE || layout.format == GL_LUMINANCE_ALPHA) // Mesa clamps before the sum
        layout.format = GL_RED;
    static GLubyte bytes[40000];
    std::memset(bytes, 0, sizeof bytes);
    const Random same = random; // both ways must draw the same random numbers
    store(random, width, true);
    // A component of a few bits may be halfway between two, and 1 overflows Mesa's unsigned integers.
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

/// Mesa's copies ignore the colour mask, its depths come out of floats, and its stencil values wrap a pixel
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
            // Mesa gathers bitmaps in an image of this size, with this bitmap in the middle of its left side.
            constexpr int gathered_width = 512, gathered_height = 32;
            const double left = std::floor(double{at[0]} - xo);
            const double low = std::floor(double{at[1]} - yo) - (gathered_height - height) / 2;
            quads.add(left, low, left + gathered_width, low + gathered_height);
            glBitmap(width, height, xo, yo, xm, ym, client.bytes);
            glFlush(); // Mesa gathers bitmaps, and draws overlapping ones once
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
