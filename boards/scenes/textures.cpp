#include "boards/scenes/textures.hpp"

#include "boards/scenes/trig.hpp"

namespace spangle::scenes {

namespace {

struct Checkerboard {
    GLubyte texel[64][64][3];
};

constexpr Checkerboard checkerboard() {
    Checkerboard image{};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const bool odd = (((x >> 3) ^ (y >> 3)) & 1) != 0;
            const int rgb[3] = {odd ? 230 : 40 + 2 * x, odd ? 200 - 2 * y : 60, odd ? 60 : 90 + 2 * y};
            for (int c = 0; c < 3; ++c)
                image.texel[y][x][c] = static_cast<GLubyte>(x == 0 || y == 0 ? 255 : rgb[c]);
        }
    return image;
}

struct Ball {
    GLubyte texel[32][32][4];
};

constexpr Ball ball() {
    Ball image{};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const double dx = x - 15.5, dy = y - 15.5;
            const double d2 = (dx * dx + dy * dy) / (15.5 * 15.5);
            GLubyte* out = image.texel[y][x];
            out[0] = static_cast<GLubyte>(255 - 4 * x);
            out[1] = static_cast<GLubyte>(120 + 4 * y);
            out[2] = static_cast<GLubyte>(8 * x < 255 ? 8 * x : 255);
            out[3] = static_cast<GLubyte>(d2 >= 1.0 ? 0.0 : 255.0 * (1.0 - d2) * 0.9);
        }
    return image;
}

void start_texture(GLint filter, GLint wrap) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

} // namespace

void make_checkerboard(GLint filter) {
    static constexpr Checkerboard image = checkerboard();
    start_texture(filter, GL_REPEAT);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, image.texel);
}

void make_ball() {
    static constexpr Ball image = ball();
    start_texture(GL_NEAREST, GL_REPEAT);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.texel);
}

} // namespace spangle::scenes
