#include "boards/scenes/font.hpp"

namespace spangle::scenes {

namespace {

constexpr const char* characters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ.:/%-+";

/// The shape of each character, in the order of `characters`: seven rows of five columns.
constexpr const char* shapes[] = {
    ".###.#...##..###.#.###..##...#.###.", "..#...##....#....#....#....#...###.",
    ".###.#...#....#...#...#...#...#####", "#####...#...#.....#.....##...#.###.",
    "...#...##..#.#.#..#.#####...#....#.", "######....####.....#....##...#.###.",
    "..##..#...#....####.#...##...#.###.", "#####....#...#...#...#...#....#....",
    ".###.#...##...#.###.#...##...#.###.", ".###.#...##...#.####....#...#..##..",
    "..#...#.#.#...##...#######...##...#", "####.#...##...#####.#...##...#####.",
    ".###.#...##....#....#....#...#.###.", "###..#..#.#...##...##...##..#.###..",
    "######....#....####.#....#....#####", "######....#....####.#....#....#....",
    ".###.#...##....#.####...##...#.####", "#...##...##...#######...##...##...#",
    ".###...#....#....#....#....#...###.", "..###...#....#....#....#.#..#..##..",
    "#...##..#.#.#..##...#.#..#..#.#...#", "#....#....#....#....#....#....#####",
    "#...###.###.#.##.#.##...##...##...#", "#...##...###..##.#.##..###...##...#",
    ".###.#...##...##...##...##...#.###.", "####.#...##...#####.#....#....#....",
    ".###.#...##...##...##.#.##..#..##.#", "####.#...##...#####.#.#..#..#.#...#",
    ".#####....#.....###.....#....#####.", "#####..#....#....#....#....#....#..",
    "#...##...##...##...##...##...#.###.", "#...##...##...##...##...#.#.#...#..",
    "#...##...##...##.#.##.#.##.#.#.#.#.", "#...##...#.#.#...#...#.#.#...##...#",
    "#...##...##...#.#.#...#....#....#..", "#####....#...#...#...#...#....#####",
    "..........................##...##..", "......##...##........##...##.......",
    ".........#...#...#...#...#.........", "##...##..#...#...#...#...#..##...##",
    "...............#####...............", ".......#....#..#####..#....#.......",
};

constexpr int cell = 8, glyphs_per_row = 16, texture_width = 128, texture_height = 32;

struct FontImage {
    GLubyte texel[texture_height][texture_width];
};

constexpr FontImage font_image() {
    FontImage image{};
    for (int i = 0; characters[i] != '\0'; ++i)
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 5; ++x)
                if (shapes[i][5 * y + x] == '#')
                    image.texel[i / glyphs_per_row * cell + y][i % glyphs_per_row * cell + x] = 255;
    return image;
}

int index_of(char c) {
    for (int i = 0; characters[i] != '\0'; ++i)
        if (characters[i] == c)
            return i;
    return -1;
}

} // namespace

void make_font() {
    static constexpr FontImage image = font_image();
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, texture_width, texture_height, 0, GL_ALPHA, GL_UNSIGNED_BYTE,
                 image.texel);
}

void draw_text(float x, float y, float scale, const char* text) {
    glBegin(GL_QUADS);
    for (; *text != '\0'; ++text, x += 6.0f * scale) {
        const int i = index_of(*text);
        if (i < 0)
            continue;
        const int column = i % glyphs_per_row, row = i / glyphs_per_row;
        const float s0 = static_cast<float>(column * cell) / texture_width;
        const float t0 = static_cast<float>(row * cell) / texture_height;
        const float s1 = s0 + 5.0f / texture_width, t1 = t0 + 7.0f / texture_height;
        const float x1 = x + 5.0f * scale, y1 = y + 7.0f * scale;
        glTexCoord2f(s0, t0);
        glVertex2f(x, y);
        glTexCoord2f(s0, t1);
        glVertex2f(x, y1);
        glTexCoord2f(s1, t1);
        glVertex2f(x1, y1);
        glTexCoord2f(s1, t0);
        glVertex2f(x1, y);
    }
    glEnd();
}

void plot_text(int x, int y, const char* text) {
    glBegin(GL_POINTS);
    for (; *text != '\0'; ++text, x += 6) {
        const int i = index_of(*text);
        for (int pixel = 0; i >= 0 && pixel < 35; ++pixel)
            if (shapes[i][pixel] == '#')
                glVertex2i(x + pixel % 5, y + pixel / 5);
    }
    glEnd();
}

} // namespace spangle::scenes
