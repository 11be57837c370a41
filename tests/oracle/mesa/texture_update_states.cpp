// Changes of texture images (GL 1.3, 3.8.1, 3.8.2, 6.1.4): parts are replaced from memory in any layout and
// from the framebuffer, transferred, and read back.
#include <algorithm>
#include <cstring>

#include "tests/oracle/mesa/random_image.hpp"
#include "tests/oracle/mesa/random_texture.hpp"
#include "tests/oracle/mesa/state_families.hpp"

namespace spangle::oracle {

namespace {

using test::Random;

/// A part of an image.
struct Box {
    GLint at[3] = {};
    GLsizei size[3] = {1, 1, 1};
    GLenum target;
    Box(Random& random, const RandomTexture& texture) : target(texture.target) {
        for (int axis = 0; axis < texture.dimensions(); ++axis) {
            at[axis] = whole(random, 0, texture.size[axis] - 1);
            size[axis] = whole(random, 1, texture.size[axis] - at[axis]);
        }
        if (texture.cube())
            target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + random.below(6);
    }
};

void replace(Random& random, const RandomTexture& texture) {
    const Box box(random, texture);
    Layout layout = color_layout(random);
    if (texture.few_bits) // Mesa rounds twice to few bits
        layout = {GL_BGRA, GL_UNSIGNED_BYTE};
    store(random, box.size[0], false);
    glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, maybe(random) ? box.size[1] + whole(random, 0, 2) : 0);
    glPixelStorei(GL_UNPACK_SKIP_IMAGES, whole(random, 0, 2));
    const Client client(random, layout.type);
    if (!texture.few_bits && maybe(random)) {
        store_tight(); // Mesa skips pixels twice, before the transfer and after it
        transfer(random);
    }
    if (texture.dimensions() == 1)
        glTexSubImage1D(box.target, 0, box.at[0], box.size[0], layout.format, layout.type, client.bytes);
    else if (texture.dimensions() == 3)
        glTexSubImage3D(box.target, 0, box.at[0], box.at[1], box.at[2], box.size[0], box.size[1], box.size[2],
                        layout.format, layout.type, client.bytes);
    else
        glTexSubImage2D(box.target, 0, box.at[0], box.at[1], box.size[0], box.size[1], layout.format,
                        layout.type, client.bytes);
    untransferred();
}

void copy_part(Random& random, const RandomTexture& texture) {
    const Box box(random, texture);
    const int y = whole(random, 0, state_size - box.size[1]), x = whole(random, 0, state_size - box.size[0]);
    if (texture.dimensions() == 1)
        glCopyTexSubImage1D(box.target, 0, box.at[0], x, y, box.size[0]);
    else if (texture.dimensions() == 3)
        glCopyTexSubImage3D(box.target, 0, box.at[0], box.at[1], box.at[2], x, y, box.size[0], box.size[1]);
    else
        glCopyTexSubImage2D(box.target, 0, box.at[0], box.at[1], x, y, box.size[0], box.size[1]);
}

/// Copies a new image of one or two dimensions from the framebuffer.
void copy_whole(Random& random, RandomTexture& texture) {
    constexpr GLenum formats[] = {GL_ALPHA8,     GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8,
                                  GL_INTENSITY8, GL_RGB8,       GL_RGBA8,
                                  GL_RGBA4,      GL_RGB5_A1};
    const GLenum format = one_of(random, formats);
    const int w = whole(random, 1, 16), h = whole(random, 1, 16);
    const int y = whole(random, 0, state_size - h), x = whole(random, 0, state_size - w);
    texture.few_bits = format == GL_RGBA4 || format == GL_RGB5_A1;
    texture.size[0] = w;
    if (texture.target == GL_TEXTURE_1D) {
        glCopyTexImage1D(GL_TEXTURE_1D, 0, format, x, y, w, 0);
        return;
    }
    texture.size[1] = h;
    glCopyTexImage2D(GL_TEXTURE_2D, 0, format, x, y, w, h, 0);
}

/// Draws a slice or face, one texel to a pixel.
void show(Random& random, const RandomTexture& texture) {
    const int x = whole(random, 0, 8), y = whole(random, 0, 8);
    const int w = texture.size[0], h = std::max(texture.size[1], 2);
    const GLdouble r = (whole(random, 0, texture.size[2] - 1) + 0.5) / texture.size[2];
    const GLdouble most = texture.cube() ? 1 - 1e-5 : 1;
    const GLdouble least = texture.cube() ? -most : 0, third = !texture.cube() ? r : maybe(random) ? 1 : -1;
    glEnable(texture.target);
    glBegin(GL_QUADS);
    glTexCoord3d(least, least, third);
    glVertex2i(x, y);
    glTexCoord3d(most, least, third);
    glVertex2i(x + w, y);
    glTexCoord3d(most, most, third);
    glVertex2i(x + w, y + h);
    glTexCoord3d(least, most, third);
    glVertex2i(x, y + h);
    glEnd();
    glDisable(texture.target);
}

/// Reads the image by GetTexImage, and draws it.
void read_back(Random& random, const RandomTexture& texture, Quads& quads) {
    constexpr GLenum formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_BGR, GL_RGBA, GL_BGRA};
    if (texture.target != GL_TEXTURE_2D)
        return;
    static GLubyte bytes[40000];
    std::memset(bytes, 0, sizeof bytes);
    const Random same = random; // both ways must draw the same random numbers
    store(random, texture.size[0], true);
    const GLenum format = formats[random.below(8)];
    glGetTexImage(GL_TEXTURE_2D, 0, format, GL_UNSIGNED_BYTE, bytes);
    Random again = same;
    store(again, texture.size[0], false);
    glRasterPos2i(1, 1);
    quads.add(1, 1, 1 + texture.size[0], 1 + texture.size[1]);
    glDrawPixels(texture.size[0], texture.size[1], format, GL_UNSIGNED_BYTE, bytes);
}

void updates(Random& random, Quads& quads) {
    background(random);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
    for (int i = 0; i < 2; ++i) {
        RandomTexture::Wishes wishes;
        wishes.linear = false;
        wishes.borders = false;
        wishes.same_bits = true;
        RandomTexture texture(random, wishes);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t what = random.below(4);
            if (what < 2)
                replace(random, texture);
            else if (what == 2 || texture.dimensions() == 3 || texture.cube())
                copy_part(random, texture);
            else
                copy_whole(random, texture);
        }
        if (maybe(random))
            read_back(random, texture, quads);
        show(random, texture);
    }
}

} // namespace

void add_texture_update_families(std::vector<Family>& all) {
    all.push_back({"TextureUpdates", 2000, 1, 0.99, updates});
}

} // namespace spangle::oracle
