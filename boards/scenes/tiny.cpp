// TINY: a dashboard of text, sprites and a bar for displays from 96x16 pixels on, of one colour or more.
// Glyphs and sprites consist of points, one for each pixel, so the scene needs no textures and only integers.
#include "boards/scenes/font.hpp"
#include "boards/scenes/scene.hpp"
#include "boards/scenes/view.hpp"

namespace spangle::scenes {

namespace {

constexpr int most_width = 128, most_height = 64; // largest area of the picture that has sprites, in pixels
int screen_width, screen_height;

void setup(int width, int height) {
    screen_width = width;
    screen_height = height;
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    pixels(width, height);
    glShadeModel(GL_FLAT);
}

/// A picture of eight rows; bit 7 of a row is its leftmost pixel.
struct Sprite {
    GLubyte row[8];
};
constexpr Sprite invader[2] = {{{0x24, 0x7E, 0xDB, 0xFF, 0xFF, 0x5A, 0x81, 0x42}},
                               {{0x24, 0x7E, 0xDB, 0xFF, 0x7E, 0x24, 0x42, 0xA5}}};

void plot(const Sprite& sprite, int x, int y) {
    glBegin(GL_POINTS);
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 8; ++column)
            if ((sprite.row[row] >> (7 - column) & 1) != 0)
                glVertex2i(x + column, y + row);
    glEnd();
}

void box(int left, int top, int right, int bottom, GLubyte grey) {
    glColor3ub(grey, grey, grey);
    glBegin(GL_QUADS);
    glVertex2i(left, top);
    glVertex2i(left, bottom);
    glVertex2i(right, bottom);
    glVertex2i(right, top);
    glEnd();
}

void draw(int frame) {
    // The speed goes from 0 up to 120, and down to 0.
    const int phase = frame % 60, speed = phase < 30 ? 4 * phase : 4 * (60 - phase);
    const char text[] = {'S',
                         'P',
                         'D',
                         ' ',
                         static_cast<char>('0' + speed / 100),
                         static_cast<char>('0' + speed / 10 % 10),
                         static_cast<char>('0' + speed % 10),
                         '\0'};
    const int bottom = screen_height;
    glClear(GL_COLOR_BUFFER_BIT);
    glLoadIdentity();
    box(0, bottom - 6, screen_width, bottom, 255);
    box(1, bottom - 5, screen_width - 1, bottom - 1, 0);
    box(2, bottom - 4, 2 + (screen_width - 4) * speed / 120, bottom - 2, 140);
    glTranslatef(0.5f, 0.5f, 0.0f); // points lie in the middle of their pixels
    glColor3ub(255, 255, 255);
    plot_text(1, 0, text);
    const int lowest = (bottom < most_height ? bottom : most_height) - 14,
              last = (screen_width < most_width ? screen_width : most_width) - 22;
    for (int y = 0; y <= lowest; y += 10)
        for (int x = y == 0 ? 46 : 4; x <= last; x += 12)
            plot(invader[(frame / 4 + x + y) & 1], x + (phase + y) % 14, y);
}

} // namespace

const Scene tiny{"TINY", "a dashboard for 96x16 pixels and up, without textures", setup, draw};

} // namespace spangle::scenes
