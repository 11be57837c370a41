// Draws leaves that an alpha test cuts out, between PushAttrib and PopAttrib.
#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

namespace {

void setup(int, int) {
    glClearColor(0.5f, 0.6f, 0.9f, 1.0f);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.4, 0.4, -0.3, 0.3, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
    GLubyte texel[32][32][4];
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            texel[y][x][0] = 30;
            texel[y][x][1] = static_cast<GLubyte>(100 + 4 * y);
            texel[y][x][2] = 20;
            texel[y][x][3] = static_cast<GLubyte>((x * 5 ^ y * 3) % 16 > 5 ? 255 : 0);
        }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB5_A1, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void draw(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushAttrib(GL_ENABLE_BIT | GL_COLOR_BUFFER_BIT);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    for (int i = 0; i < 8; ++i) {
        glLoadIdentity();
        glTranslatef(static_cast<float>(i - 4) * 0.6f, 0.0f, -4.0f - 0.3f * static_cast<float>(i));
        glRotatef(static_cast<float>(37 * i + 5 * frame), 0.0f, 1.0f, 0.3f);
        glBegin(GL_QUADS);
        glTexCoord2i(0, 0);
        glVertex2i(-1, -1);
        glTexCoord2i(1, 0);
        glVertex2i(1, -1);
        glTexCoord2i(1, 1);
        glVertex2i(1, 1);
        glTexCoord2i(0, 1);
        glVertex2i(-1, 1);
        glEnd();
    }
    glPopAttrib();
}

} // namespace

const Program foliage{"foliage", setup, draw};

} // namespace spangle::programs
