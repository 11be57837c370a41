// Draws a lit ball without a texture, in a parallel projection and in perspective.
#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

namespace {

void light() {
    constexpr GLfloat position[4] = {0.3f, 0.5f, 0.8f, 0.0f}, color[4] = {0.9f, 0.6f, 0.3f, 1.0f};
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glLightfv(GL_LIGHT0, GL_POSITION, position);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
}

void parallel(int, int) {
    glMatrixMode(GL_PROJECTION);
    glOrtho(-1.6, 1.6, -1.2, 1.2, -2.0, 2.0);
    glMatrixMode(GL_MODELVIEW);
    light();
}

void perspective(int, int) {
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.4, 0.4, -0.3, 0.3, 1.0, 10.0);
    glMatrixMode(GL_MODELVIEW);
    light();
}

void turn(int frame, float distance) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -distance);
    glRotatef(10.0f * static_cast<float>(frame), 1.0f, 0.3f, 0.0f);
    ball();
}
void draw_parallel(int frame) {
    turn(frame, 0.0f);
}
void draw_perspective(int frame) {
    turn(frame, 3.0f);
}

} // namespace

const Program lit_parallel{"lit_parallel", parallel, draw_parallel};
const Program lit_perspective{"lit_perspective", perspective, draw_perspective};

} // namespace spangle::programs
