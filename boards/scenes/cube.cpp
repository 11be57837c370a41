// CUBE: a turning cube with one grey for each face. It uses neither depth, lights nor textures, and its
// coordinates are integers: it is for boards with a few kilobytes of memory.
#include "boards/scenes/gl.hpp"
#include "boards/scenes/scene.hpp"

namespace spangle::scenes {

namespace {

void setup(int width, int height) {
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    // The cube has radius sqrt(3) and a distance of 5, and fits a square viewport in the middle.
    const int side = width < height ? width : height;
    glViewport((width - side) / 2, (height - side) / 2, side, side);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-0.36, 0.36, -0.36, 0.36, 1.0, 9.0);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_CULL_FACE);
    glShadeModel(GL_FLAT);
}

/// The corners of each face, counter-clockwise seen from outside. Bit i of a corner says whether its
/// coordinate i is 1 or -1.
constexpr GLubyte face[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
constexpr GLubyte grey[6] = {255, 40, 200, 64, 140, 100};

void draw(int frame) {
    const int degrees = 6 * (frame % 60);
    glClear(GL_COLOR_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -5.0f);
    glRotatef(static_cast<float>(degrees), 0.3f, 1.0f, 0.0f);
    glRotatef(static_cast<float>(2 * degrees), 0.0f, 0.2f, 1.0f);
    glBegin(GL_QUADS);
    for (int i = 0; i < 6; ++i) {
        glColor3ub(grey[i], grey[i], grey[i]);
        for (const GLubyte corner : face[i])
            glVertex3i((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    }
    glEnd();
}

} // namespace

const Scene cube{"CUBE", "a turning cube: flat faces, nothing optional", setup, draw};

} // namespace spangle::scenes
