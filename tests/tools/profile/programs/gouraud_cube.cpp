#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

namespace {

void setup(int, int) {
    glClearColor(0.1f, 0.1f, 0.2f, 1.0f);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.4, 0.4, -0.3, 0.3, 1.0, 10.0);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_DEPTH_TEST);
}

constexpr GLubyte face[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};

void draw(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -5.0f);
    glRotatef(25.0f + 7.0f * static_cast<float>(frame), 0.4f, 1.0f, 0.2f);
    glBegin(GL_QUADS);
    for (const auto& corners : face)
        for (const GLubyte corner : corners) {
            const float x = (corner & 1) != 0 ? 1.0f : -1.0f, y = (corner & 2) != 0 ? 1.0f : -1.0f,
                        z = (corner & 4) != 0 ? 1.0f : -1.0f;
            glColor3f(0.5f + 0.5f * x, 0.5f + 0.5f * y, 0.5f + 0.5f * z);
            glVertex3f(x, y, z);
        }
    glEnd();
}

} // namespace

const Program gouraud_cube{"gouraud_cube", setup, draw};

} // namespace spangle::programs
