#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

namespace {

constexpr int cells = 16;

void setup(int, int) {
    constexpr GLfloat haze[4] = {0.6f, 0.7f, 0.8f, 1.0f};
    glClearColor(haze[0], haze[1], haze[2], 1.0f);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.4, 0.4, -0.3, 0.3, 1.0, 40.0);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_EXP2);
    glFogf(GL_FOG_DENSITY, 0.08f);
    glFogfv(GL_FOG_COLOR, haze);
    GLubyte texel[32][32][3];
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const int noise = (x * 73 + y * 151 + x * y * 7) % 64;
            texel[y][x][0] = static_cast<GLubyte>(60 + noise);
            texel[y][x][1] = static_cast<GLubyte>(110 + noise);
            texel[y][x][2] = static_cast<GLubyte>(40 + noise / 2);
        }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 32, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, texel);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glEnable(GL_TEXTURE_2D);
}

void corner(int x, int z) {
    const float height = static_cast<float>((x * 29 + z * 17 + x * z) % 11) * 0.12f,
                shade = 0.5f + 0.4f * height;
    glColor3f(shade, shade, shade);
    glTexCoord2f(static_cast<float>(x), static_cast<float>(z));
    glVertex3f(static_cast<float>(x - cells / 2), height - 1.5f, static_cast<float>(-z));
}

void draw(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glRotatef(4.0f * static_cast<float>(frame), 0.0f, 1.0f, 0.0f);
    glTranslatef(0.0f, 0.0f, -1.0f);
    for (int z = 0; z < cells; ++z) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int x = 0; x <= cells; ++x) {
            corner(x, z + 1);
            corner(x, z);
        }
        glEnd();
    }
}

} // namespace

const Program terrain_fog{"terrain_fog", setup, draw};

} // namespace spangle::programs
