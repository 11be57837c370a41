// Draws a floor with levels of detail, and a light map on the second unit.
#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

namespace {

void image(int size, int level, bool map) {
    static GLubyte texel[64 * 64 * 3];
    for (int i = 0; i < size * size; ++i)
        for (int c = 0; c < 3; ++c) {
            const int x = i % size * 8 / size, y = i / size * 8 / size;
            texel[3 * i + c] = static_cast<GLubyte>(map                ? 255 - 24 * (x > y ? x : y)
                                                    : (x + y) % 2 != 0 ? 230
                                                                       : 60 + 50 * c);
        }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, level, GL_RGB, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, texel);
}

void setup(int, int) {
    glClearColor(0.0f, 0.0f, 0.3f, 1.0f);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.4, 0.4, -0.3, 0.3, 1.0, 60.0);
    glMatrixMode(GL_MODELVIEW);
    GLuint names[2];
    glGenTextures(2, names);
    glBindTexture(GL_TEXTURE_2D, names[0]);
    for (int level = 0; level <= 6; ++level)
        image(64 >> level, level, false);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glEnable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, names[1]);
    image(32, 0, true);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glEnable(GL_TEXTURE_2D);
}

void draw(int frame) {
    glClear(GL_COLOR_BUFFER_BIT);
    glLoadIdentity();
    glRotatef(3.0f * static_cast<float>(frame), 0.0f, 1.0f, 0.0f);
    glBegin(GL_TRIANGLE_FAN);
    constexpr float corner[4][2] = {{-20.0f, -1.0f}, {20.0f, -1.0f}, {20.0f, -40.0f}, {-20.0f, -40.0f}};
    for (const auto& at : corner) {
        glMultiTexCoord2f(GL_TEXTURE0, at[0] * 0.5f, at[1] * 0.5f);
        glMultiTexCoord2f(GL_TEXTURE1, at[0] * 0.025f + 0.5f, at[1] * 0.025f);
        glVertex3f(at[0], -1.5f, at[1]);
    }
    glEnd();
}

} // namespace

const Program two_textures{"two_textures", setup, draw};

} // namespace spangle::programs
