// HUD: what a dashboard draws. A round gauge with a needle, bars, text, and blended sprites.
#include "boards/scenes/font.hpp"
#include "boards/scenes/scene.hpp"
#include "boards/scenes/textures.hpp"
#include "boards/scenes/trig.hpp"
#include "boards/scenes/view.hpp"

namespace spangle::scenes {

namespace {

constexpr int steps = 160; // of a full turn
struct Point {
    float x, y;
};
constexpr auto make_circle() {
    std::array<Point, steps + 1> table{};
    for (unsigned i = 0; i <= steps; ++i)
        table[i] = {static_cast<float>(cosine(turn * i / steps)), static_cast<float>(sine(turn * i / steps))};
    return table;
}
constexpr auto circle = make_circle();

float screen_width, screen_height;
GLuint font_texture, ball_texture;

GLuint bound_texture() {
    GLint name = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &name);
    return static_cast<GLuint>(name);
}

void setup(int width, int height) {
    screen_width = static_cast<float>(width);
    screen_height = static_cast<float>(height);
    glClearColor(0.02f, 0.03f, 0.06f, 1.0f);
    pixels(width, height);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    make_font();
    font_texture = bound_texture();
    make_ball();
    ball_texture = bound_texture();
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
}

/// A ring segment from step `from` to step `to` (clockwise on screen), Gouraud shaded from end to end.
void arc(Point centre, float inner, float outer, int from, int to, const GLfloat (&a)[3],
         const GLfloat (&b)[3]) {
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = from; i <= to; ++i) {
        const float f = static_cast<float>(i - from) / static_cast<float>(to - from);
        const Point d = circle[static_cast<unsigned>(i % steps)];
        glColor3f(a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2]));
        glVertex2f(centre.x + outer * d.x, centre.y + outer * d.y);
        glVertex2f(centre.x + inner * d.x, centre.y + inner * d.y);
    }
    glEnd();
}

void needle(Point centre, float length, int step) {
    const Point d = circle[static_cast<unsigned>(step % steps)];
    const float w = length * 0.05f;
    glColor3f(1.0f, 0.35f, 0.2f);
    glBegin(GL_TRIANGLES);
    glVertex2f(centre.x + length * d.x, centre.y + length * d.y);
    glVertex2f(centre.x + w * d.y, centre.y - w * d.x);
    glVertex2f(centre.x - w * d.y, centre.y + w * d.x);
    glEnd();
}

void ticks(Point centre, float inner, float outer) {
    glColor3f(0.8f, 0.85f, 0.9f);
    glBegin(GL_LINES);
    for (unsigned i = 60; i <= 180; i += 10) {
        const Point d = circle[i % steps];
        glVertex2f(centre.x + inner * d.x, centre.y + inner * d.y);
        glVertex2f(centre.x + outer * d.x, centre.y + outer * d.y);
    }
    glEnd();
}

void bar(float x, float y, float w, float h, float value) {
    glColor3f(0.12f, 0.15f, 0.2f);
    glBegin(GL_QUADS);
    glVertex2f(x, y);
    glVertex2f(x, y + h);
    glVertex2f(x + w, y + h);
    glVertex2f(x + w, y);
    glEnd();
    glBegin(GL_QUADS);
    glColor3f(0.1f, 0.7f, 0.4f);
    glVertex2f(x, y);
    glVertex2f(x, y + h);
    glColor3f(0.9f, 0.8f, 0.2f);
    glVertex2f(x + w * value, y + h);
    glVertex2f(x + w * value, y);
    glEnd();
}

void sprite(float x, float y, float size) {
    glBegin(GL_QUADS);
    glTexCoord2f(0.0f, 0.0f);
    glVertex2f(x, y);
    glTexCoord2f(0.0f, 1.0f);
    glVertex2f(x, y + size);
    glTexCoord2f(1.0f, 1.0f);
    glVertex2f(x + size, y + size);
    glTexCoord2f(1.0f, 0.0f);
    glVertex2f(x + size, y);
    glEnd();
}

/// Three decimal digits.
struct Digits {
    char text[4];
};
Digits digits(int value) {
    return {{static_cast<char>('0' + value / 100 % 10), static_cast<char>('0' + value / 10 % 10),
             static_cast<char>('0' + value % 10), '\0'}};
}

void draw(int frame) {
    static constexpr GLfloat green[3] = {0.1f, 0.8f, 0.4f}, red[3] = {0.95f, 0.25f, 0.15f};
    static constexpr GLfloat dark[3] = {0.08f, 0.1f, 0.14f}, darker[3] = {0.05f, 0.06f, 0.1f};
    const float unit = screen_height / 240.0f;
    const Point centre = {screen_width * 0.34f, screen_height * 0.52f};
    const float radius = (screen_width < screen_height ? screen_width : screen_height) * 0.4f;
    const int phase = frame % 120, speed = phase < 60 ? 2 * phase : 2 * (120 - phase); // 0..120..0

    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_BLEND);
    arc(centre, 0.0f, radius, 0, steps, dark, darker);
    arc(centre, radius * 0.86f, radius * 0.98f, 60, 180, green, red);
    ticks(centre, radius * 0.72f, radius * 0.84f);
    needle(centre, radius * 0.8f, 60 + speed);
    const float left = screen_width * 0.7f;
    bar(left, 40.0f * unit, screen_width * 0.26f, 10.0f * unit, static_cast<float>(speed) / 120.0f);
    bar(left, 80.0f * unit, screen_width * 0.26f, 10.0f * unit, 1.0f - static_cast<float>(phase) / 240.0f);

    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBindTexture(GL_TEXTURE_2D, font_texture);
    glColor3f(0.9f, 0.95f, 1.0f);
    draw_text(centre.x - 27.0f * unit, centre.y + 30.0f * unit, 3.0f * unit, digits(speed).text);
    glColor3f(0.5f, 0.6f, 0.7f);
    draw_text(centre.x - 12.0f * unit, centre.y + 58.0f * unit, unit, "KM/H");
    draw_text(left, 28.0f * unit, unit, "POWER");
    draw_text(left, 68.0f * unit, unit, "BATTERY");
    draw_text(left, 110.0f * unit, unit, "RANGE 214 KM");
    glBindTexture(GL_TEXTURE_2D, ball_texture);
    glColor4f(1.0f, 1.0f, 1.0f, 0.9f);
    for (int i = 0; i < 3; ++i)
        sprite(left + static_cast<float>(i) * 26.0f * unit + static_cast<float>(phase % 20), 140.0f * unit,
               24.0f * unit);
}

} // namespace

const Scene hud{"HUD", "a dashboard: gauge, bars, text, sprites", setup, draw};

} // namespace spangle::scenes
