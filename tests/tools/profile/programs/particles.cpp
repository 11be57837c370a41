#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

namespace {

void setup(int, int) {
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.4, 0.4, -0.3, 0.3, 1.0, 20.0);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    glPointSize(5.0f);
}

void draw(int frame) {
    glClear(GL_COLOR_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, -1.0f, -5.0f);
    glBegin(GL_POINTS);
    for (int i = 0; i < 400; ++i) {
        const int age = (i * 7 + frame) % 60;
        const float t = static_cast<float>(age) / 60.0f, across = static_cast<float>(i % 41 - 20) * 0.06f;
        glColor4f(1.0f, 1.0f - t, 0.3f * (1.0f - t), 1.0f - t);
        glVertex3f(across * t, 3.0f * t - 1.2f * t * t, static_cast<float>(i % 17 - 8) * 0.1f * t);
    }
    glEnd();
}

} // namespace

const Program particles{"particles", setup, draw};

} // namespace spangle::programs
