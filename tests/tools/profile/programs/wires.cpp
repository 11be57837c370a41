// Draws stippled lines, and a word of bitmaps.
#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

namespace {

void setup(int width, int height) {
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0.0, width, 0.0, height, -1.0, 1.0);
    glMatrixMode(GL_MODELVIEW);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

void draw(int frame) {
    constexpr GLubyte letter[8] = {0x18, 0x24, 0x42, 0x7E, 0x42, 0x42, 0x42, 0x00};
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3ub(20, 40, 160);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(2, static_cast<GLushort>(0x3F07 + frame));
    glBegin(GL_LINE_LOOP);
    for (int i = 0; i < 9; ++i)
        glVertex2i(20 + i * 31 % 280, 15 + i * i * 23 % 210);
    glEnd();
    glDisable(GL_LINE_STIPPLE);
    glBegin(GL_LINES);
    for (int i = 0; i < 20; ++i) {
        glColor3ub(static_cast<GLubyte>(12 * i), 0, 90);
        glVertex2i(10 + 15 * i, 5);
        glVertex2i(310 - 15 * i + frame, 235);
    }
    glEnd();
    glColor3ub(180, 0, 0);
    glRasterPos2i(40 + frame, 120);
    for (int i = 0; i < 5; ++i)
        glBitmap(8, 8, 0.0f, 0.0f, 10.0f, 0.0f, letter);
}

} // namespace

const Program wires{"wires", setup, draw};

} // namespace spangle::programs
