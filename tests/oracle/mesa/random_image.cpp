#include "tests/oracle/mesa/random_image.hpp"

#include <cstring>

namespace spangle::oracle {

using test::Random;

namespace {

constexpr GLenum color_formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA,     GL_RGB,
                                    GL_BGR, GL_RGBA,  GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
/// Signed types are left out: since GL 4.2 they are converted otherwise, and Mesa does that.
constexpr GLenum plain_types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_FLOAT};
constexpr GLenum rgb_types[] = {GL_UNSIGNED_BYTE_3_3_2, GL_UNSIGNED_BYTE_2_3_3_REV, GL_UNSIGNED_SHORT_5_6_5,
                                GL_UNSIGNED_SHORT_5_6_5_REV};
constexpr GLenum rgba_types[] = {GL_UNSIGNED_SHORT_4_4_4_4,  GL_UNSIGNED_SHORT_4_4_4_4_REV,
                                 GL_UNSIGNED_SHORT_5_5_5_1,  GL_UNSIGNED_SHORT_1_5_5_5_REV,
                                 GL_UNSIGNED_INT_8_8_8_8,    GL_UNSIGNED_INT_8_8_8_8_REV,
                                 GL_UNSIGNED_INT_10_10_10_2, GL_UNSIGNED_INT_2_10_10_10_REV};

} // namespace

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
    const int values[] = {0, // Mesa's softpipe misreads swapped elements
                          static_cast<int>(random.below(2)),
                          maybe(random) ? width + whole(random, 0, 3) : 0,
                          whole(random, 0, 2),
                          whole(random, 0, 9),
                          1 << random.below(4)};
    for (GLenum i = 0; i < 6; ++i)
        glPixelStorei(first + i, values[i]);
}

void store_tight() {
    for (GLenum name = GL_UNPACK_SWAP_BYTES; name < GL_UNPACK_ALIGNMENT; ++name)
        glPixelStorei(name, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 0);
    glPixelStorei(GL_UNPACK_SKIP_IMAGES, 0);
}

Client::Client(Random& random, GLenum type) {
    for (GLubyte& b : bytes)
        b = static_cast<GLubyte>(random.below(256));
    if (type != GL_FLOAT)
        return;
    for (std::size_t i = 0; i < sizeof bytes; i += 4) {
        const GLfloat v = static_cast<GLfloat>(random.below(1500)) / 1000 - 0.25f;
        std::memcpy(&bytes[i], &v, sizeof v);
    }
}

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

/// Pixel maps have other tests: softpipe addresses them by floor(256 c), and blue by another component.
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

} // namespace spangle::oracle
