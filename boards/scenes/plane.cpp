// S4, S4b and S4r: a tilted, textured plane that covers the screen.
#include "boards/scenes/scene.hpp"
#include "boards/scenes/textures.hpp"
#include "boards/scenes/view.hpp"

namespace spangle::scenes {

namespace {

float half_height;

void setup(int width, int height, GLint filter) {
    half_height = static_cast<float>(height) / static_cast<float>(width);
    clear_color();
    perspective(width, height, 1.0f, 16.0f);
    make_checkerboard(filter);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}

void setup_nearest(int width, int height) {
    setup(width, height, GL_NEAREST);
}

void setup_linear(int width, int height) {
    setup(width, height, GL_LINEAR);
}

void setup_rolled(int width, int height) {
    setup(width, height, GL_NEAREST);
    glRotatef(30.0f, 0.0f, 0.0f, 1.0f);
    glScalef(1.75f, 1.75f, 1.0f); // the plane covers the corners of any screen from 4:3 to 5:3
}

/// Sends corner `i` of the plane that has depth 1.5 at the lower edge of the screen and depth 4 at the upper
/// edge.
void corner(int i) {
    const float d = i >= 2 ? 4.0f : 1.5f;
    const float x = i == 1 || i == 2 ? d : -d;
    const float y = (i >= 2 ? d : -d) * half_height;
    glTexCoord2f(x / 2.0f + 2.0f, y / (2.0f * half_height) + 2.0f);
    glVertex3f(x, y, -d);
}

void draw(int) {
    glBegin(GL_TRIANGLES);
    for (const int i : {0, 1, 2, 0, 2, 3})
        corner(i);
    glEnd();
}

} // namespace

const Scene plane{"S4", "tilted textured plane, nearest", setup_nearest, draw};
const Scene plane_linear{"S4b", "tilted textured plane, bilinear", setup_linear, draw};
const Scene plane_rolled{"S4r", "the plane rolled by 30 degrees: the test of perspective", setup_rolled,
                         draw};

} // namespace spangle::scenes
