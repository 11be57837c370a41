#include "gauge.hpp"

#include <spangle/GL/gl.h>

namespace {

void bar(GLint left, GLint bottom, GLint right, GLint top, const GLubyte color[3]) {
    glColor3ubv(color);
    glBegin(GL_QUADS);
    glVertex2i(left, bottom);
    glVertex2i(right, bottom);
    glVertex2i(right, top);
    glVertex2i(left, top);
    glEnd();
}

} // namespace

void draw_gauge(int charge) {
    static constexpr GLubyte black[3] = {0, 0, 0}, white[3] = {255, 255, 255}, green[3] = {0, 255, 0},
                             red[3] = {255, 0, 0};
    glDisable(GL_DITHER);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, 240, 0, 240, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClear(GL_COLOR_BUFFER_BIT);
    bar(16, 72, 216, 168, white); // the case of the battery cell
    bar(20, 76, 212, 164, black);
    bar(216, 104, 224, 136, white); // the contact of the battery cell
    const GLint right = 24 + 184 * charge / 100;
    if (charge <= 20) {
        bar(24, 80, right, 160, red);
        return;
    }
    glBegin(GL_QUADS); // green fades in towards the tip of the bar
    glColor3ubv(white);
    glVertex2i(24, 160);
    glVertex2i(24, 80);
    glColor3ubv(green);
    glVertex2i(right, 80);
    glVertex2i(right, 160);
    glEnd();
}
