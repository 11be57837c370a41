// HUD: the parts of a dashboard. It has a round gauge with a needle, bars, text, and blended sprites.
// Pictures smaller than 320x240 get a layout of their own, on black. Its text consists of whole pixels, so
// that it can be read on displays of one colour.
#include "boards/scenes/font.hpp"
#include "boards/scenes/scene.hpp"
#include "boards/scenes/textures.hpp"
#include "boards/scenes/trig.hpp"
#include "boards/scenes/view.hpp"

namespace spangle::scenes {

namespace {

constexpr int steps = 160; // steps of the gauge in a full turn
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

/// Draws a segment of a ring from step `from` to step `to`, clockwise on screen. Its colour goes from `a` to
/// `b` by Gouraud shading.
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

/// A number as three decimal digits and a terminating zero.
struct Digits {
    char text[4];
};
Digits digits(int value) {
    return {{static_cast<char>('0' + value / 100 % 10), static_cast<char>('0' + value / 10 % 10),
             static_cast<char>('0' + value % 10), '\0'}};
}

// --- The layout of small pictures

/// Whether the layout for large pictures would have to shrink its text or cut something off.
bool has_little_room() {
    return screen_height < 200.0f || 3.0f * screen_width < 4.0f * screen_height;
}

// Pixels that a glyph and a line of the font take, with the space around.
constexpr int glyph_width = 6, line_height = 9;

/// A rectangle of the screen in pixels, which is filled from the top down.
struct Column {
    int left, top, width, height;

    void take(int rows) {
        top += rows;
        height -= rows;
    }
};

int least(int a, int b) {
    return a < b ? a : b;
}
int most(int a, int b) {
    return a < b ? b : a;
}

void set_text() {
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBindTexture(GL_TEXTURE_2D, font_texture);
    glColor3f(1.0f, 1.0f, 1.0f);
}
void set_shapes() {
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_BLEND);
}

void write(int x, int y, int scale, const char* text) {
    set_text();
    draw_text(static_cast<float>(x), static_cast<float>(y), static_cast<float>(scale), text);
}
/// Writes a line in the middle of the column, and takes its height from the column.
void write_line(Column& column, int scale, int letters, const char* text) {
    if (column.height < 7 * scale || column.width < letters * glyph_width * scale)
        return;
    write(column.left + (column.width - letters * glyph_width * scale) / 2, column.top, scale, text);
    column.take(line_height * scale);
}

/// Draws a frame that is filled to the fraction `value`. Frame and filling can be told apart on displays
/// without shades.
void framed_bar(int x, int y, int w, int h, float value) {
    const float left = static_cast<float>(x), top = static_cast<float>(y), right = static_cast<float>(x + w),
                bottom = static_cast<float>(y + h), full = left + (right - left) * value;
    set_shapes();
    glColor3f(1.0f, 1.0f, 1.0f);
    glBegin(GL_LINE_LOOP);
    glVertex2f(left + 0.5f, top + 0.5f);
    glVertex2f(right - 0.5f, top + 0.5f);
    glVertex2f(right - 0.5f, bottom - 0.5f);
    glVertex2f(left + 0.5f, bottom - 0.5f);
    glEnd();
    glBegin(GL_QUADS);
    glColor3f(0.4f, 1.0f, 0.6f);
    glVertex2f(left, top);
    glVertex2f(left, bottom);
    glColor3f(1.0f, 0.9f, 0.4f);
    glVertex2f(full, bottom);
    glVertex2f(full, top);
    glEnd();
}
/// Writes a name of three letters, and draws a bar beside it.
void bar_line(Column& column, int scale, const char* name, float value) {
    const int label = 3 * glyph_width * scale;
    if (column.height < 7 * scale || column.width < label + 8)
        return;
    write(column.left, column.top, scale, name);
    framed_bar(column.left + label, column.top, column.width - label, 7 * scale, value);
    column.take(line_height * scale);
}

/// Draws the gauge, which fills the square.
void small_gauge(const Column& square, int speed) {
    static constexpr GLfloat low[3] = {0.4f, 1.0f, 0.6f}, high[3] = {1.0f, 0.55f, 0.45f};
    const float size = static_cast<float>(square.width), radius = 0.48f * size;
    const Point centre = {static_cast<float>(square.left) + 0.5f * size,
                          static_cast<float>(square.top) + 0.54f * size};
    const float ring = radius * 0.14f < 2.0f ? radius - 2.0f : radius * 0.86f;
    set_shapes();
    arc(centre, ring, radius, 60, 180, low, high);
    if (radius > 24.0f)
        ticks(centre, radius * 0.7f, radius * 0.82f);
    const Point d = circle[static_cast<unsigned>((60 + speed) % steps)];
    const float length = 0.8f * radius, w = length * 0.06f < 1.0f ? 1.0f : length * 0.06f;
    glColor3f(1.0f, 0.75f, 0.65f);
    glBegin(GL_TRIANGLES);
    glVertex2f(centre.x + length * d.x, centre.y + length * d.y);
    glVertex2f(centre.x + w * d.y, centre.y - w * d.x);
    glVertex2f(centre.x - w * d.y, centre.y + w * d.x);
    glEnd();
}

void small_sprites(const Column& column, int phase) {
    const int size = least(column.height, 24);
    if (size < 8)
        return;
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_BLEND);
    glBindTexture(GL_TEXTURE_2D, ball_texture);
    glColor4f(1.0f, 1.0f, 1.0f, 0.9f);
    const int free = column.width - 3 * (size + 2), wander = free > 0 ? free / 2 - 10 : 0;
    for (int i = 0, x = phase % 20 + most(0, wander); i < 3 && x + size <= column.width; ++i, x += size + 2)
        sprite(static_cast<float>(column.left + x), static_cast<float>(column.top), static_cast<float>(size));
}

/// Draws the gauge at the left, or at the top of pictures that are not much wider than high. All else stands
/// beside or below the gauge. What does not fit is left out: a picture of 96x16 pixels has no gauge.
void draw_small(int phase, int speed) {
    const int width = static_cast<int>(screen_width), height = static_cast<int>(screen_height);
    const bool beside = 5 * width >= 7 * height, has_gauge = height >= 24;
    Column rest = {0, 0, width, height};
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    const Digits number = digits(speed);
    bool numbered = false;
    if (has_gauge) {
        const int side = beside ? height : least(width, height * 3 / 5);
        const Column square = {beside ? 0 : (width - side) / 2, 0, side, side};
        // Round glass hides the corners of the picture, so what stands below the gauge keeps away from them.
        rest = beside ? Column{side + 2, 2, width - side - 4, height - 2}
                      : Column{width / 8, side + 2, width - width / 4, height - side - 2};
        small_gauge(square, speed);
        numbered = side >= 80 || rest.width < 6 * glyph_width;
        if (numbered) {
            const int scale = side < 80 ? 1 : side / 40, letters = 3 * glyph_width * scale;
            write(square.left + (side - letters) / 2, square.top + side * 3 / 4, scale, number.text);
        }
    }
    const int scale = most(1, least(rest.width / 64, rest.height / 44));
    if (!numbered && rest.height < 24) { // the speed stands at the left of the bars
        write(rest.left, rest.top, 2, number.text);
        rest = {rest.left + 38, rest.top, rest.width - 38, rest.height};
    } else if (!numbered)
        write_line(rest, 2 * scale, 3, number.text);
    bar_line(rest, scale, "PWR", static_cast<float>(speed) / 120.0f);
    bar_line(rest, scale, "BAT", 1.0f - static_cast<float>(phase) / 240.0f);
    if (rest.width < 12 * glyph_width * scale)
        write_line(rest, scale, 6, "214 KM");
    else
        write_line(rest, scale, 12, "RANGE 214 KM");
    small_sprites(rest, phase);
}

void draw(int frame) {
    static constexpr GLfloat green[3] = {0.1f, 0.8f, 0.4f}, red[3] = {0.95f, 0.25f, 0.15f};
    static constexpr GLfloat dark[3] = {0.08f, 0.1f, 0.14f}, darker[3] = {0.05f, 0.06f, 0.1f};
    const float unit = screen_height / 240.0f;
    const Point centre = {screen_width * 0.34f, screen_height * 0.52f};
    const float radius = (screen_width < screen_height ? screen_width : screen_height) * 0.4f;
    // The speed goes from 0 up to 120, and down to 0.
    const int phase = frame % 120, speed = phase < 60 ? 2 * phase : 2 * (120 - phase);

    if (has_little_room())
        return draw_small(phase, speed);
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
