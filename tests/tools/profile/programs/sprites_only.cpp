#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

namespace {

void setup(int width, int height) {
    glClearColor(0.0f, 0.3f, 0.5f, 1.0f);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0.0, width, height, 0.0, -1.0, 1.0);
    glMatrixMode(GL_MODELVIEW);
    GLubyte texel[16][16][4];
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const int r = (2 * x - 15) * (2 * x - 15) + (2 * y - 15) * (2 * y - 15);
            texel[y][x][0] = static_cast<GLubyte>(16 * x);
            texel[y][x][1] = static_cast<GLubyte>(255 - 16 * y);
            texel[y][x][2] = 80;
            texel[y][x][3] = static_cast<GLubyte>(r < 225 ? 255 - r : 0);
        }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void draw(int frame) {
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_QUADS);
    for (int i = 0; i < 40; ++i) {
        const int x = (i * 53 + frame * 3) % 280, y = (i * 37 + frame * 2) % 200;
        glTexCoord2i(0, 0);
        glVertex2i(x, y);
        glTexCoord2i(0, 1);
        glVertex2i(x, y + 32);
        glTexCoord2i(1, 1);
        glVertex2i(x + 32, y + 32);
        glTexCoord2i(1, 0);
        glVertex2i(x + 32, y);
    }
    glEnd();
}

} // namespace

const Program sprites_only{"sprites_only", setup, draw};

} // namespace spangle::programs
