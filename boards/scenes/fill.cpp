// S1 to S3 measure what filling the screen costs.
#include "boards/scenes/scene.hpp"
#include "boards/scenes/view.hpp"

namespace spangle::scenes {

namespace {

float half_height;

void setup_clear(int width, int height) {
    glViewport(0, 0, width, height);
    clear_color();
    glEnable(GL_DEPTH_TEST);
}

void draw_clear(int) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void setup_fill(int width, int height) {
    half_height = static_cast<float>(height) / static_cast<float>(width);
    clear_color();
    perspective(width, height, 1.0f, 16.0f);
}

/// Sends corner `i` of a rectangle that covers the screen at distance `d`. The corners are bottom left,
/// bottom right, top right, top left.
void corner(int i, float d) {
    const float x = i == 1 || i == 2 ? d : -d, y = i >= 2 ? d : -d;
    glVertex3f(x, y * half_height, -d);
}

void draw_two_triangles(int frame) {
    glColor3f((frame & 1) != 0 ? 0.2f : 0.9f, 0.5f, (frame & 2) != 0 ? 0.3f : 0.8f);
    glBegin(GL_TRIANGLES);
    for (const int i : {0, 1, 2, 0, 2, 3})
        corner(i, 4.0f);
    glEnd();
}

void setup_gouraud(int width, int height) {
    setup_fill(width, height);
    glEnable(GL_DEPTH_TEST);
}

void draw_gouraud(int) {
    static constexpr float colors[4][4][3] = {
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}},
        {{0, 1, 1}, {1, 0, 1}, {1, 1, 1}, {0, 0, 0}},
        {{1, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
        {{.9f, .1f, .2f}, {.1f, .8f, .3f}, {.2f, .3f, .9f}, {.9f, .9f, .7f}},
    };
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for (int layer = 0; layer < 4; ++layer)
        for (const int i : {0, 1, 2, 0, 2, 3}) {
            glColor3fv(colors[layer][i]);
            corner(i, static_cast<float>(8 - 2 * layer));
        }
    glEnd();
}

} // namespace

const Scene clear{"S1", "clear of colour and depth", setup_clear, draw_clear};
const Scene two_triangles{"S2", "two full-screen triangles of one colour", setup_fill, draw_two_triangles};
const Scene gouraud{"S3", "four full-screen Gouraud quads with depth", setup_gouraud, draw_gouraud};

} // namespace spangle::scenes
