// S7: two hundred blended sprites.
#include "boards/scenes/scene.hpp"
#include "boards/scenes/textures.hpp"
#include "boards/scenes/view.hpp"

namespace spangle::scenes {

namespace {

constexpr int size = 32;
unsigned room_x, room_y;

void setup(int width, int height) {
    room_x = width > size ? static_cast<unsigned>(width - size) : 1;
    room_y = height > size ? static_cast<unsigned>(height - size) : 1;
    clear_color();
    pixels(width, height);
    make_ball();
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void draw(int) {
    unsigned seed = 12345;
    const auto next = [&seed](unsigned room) {
        seed = seed * 1664525u + 1013904223u;
        return static_cast<int>((seed >> 8) % room);
    };
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_QUADS);
    for (int i = 0; i < 200; ++i) {
        const int x = next(room_x), y = next(room_y);
        glTexCoord2i(0, 0);
        glVertex2i(x, y);
        glTexCoord2i(0, 1);
        glVertex2i(x, y + size);
        glTexCoord2i(1, 1);
        glVertex2i(x + size, y + size);
        glTexCoord2i(1, 0);
        glVertex2i(x + size, y);
    }
    glEnd();
}

} // namespace

const Scene sprites{"S7", "200 alpha-blended sprites", setup, draw};

} // namespace spangle::scenes
