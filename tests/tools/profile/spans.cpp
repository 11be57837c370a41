// Tests a build in the fast tier that has one span, for smooth shading, and no chain: what it draws, what it
// refuses, and its messages. Prints what is wrong, and then exits with status 1.
#include <cstdio>
#include <cstring>
#include <string>

#include <spangle/message.hpp>

#include "tests/tools/bench/headless.hpp"

namespace {

std::string said;
int wrong = 0;

void check(bool good, const char* what) {
    if (good)
        return;
    std::printf("%s (said: %s)\n", what, said.c_str());
    wrong = 1;
}

constexpr int size = 32;
using Picture = GLubyte[size * size * 4];

/// Draws a triangle over the whole picture, in perspective.
void triangle(const float (&color)[3][3]) {
    constexpr float corner[3][3] = {{-3.0f, -3.0f, -1.5f}, {9.0f, -3.0f, -3.0f}, {-3.0f, 9.0f, -2.0f}};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) {
        glColor3fv(color[i]);
        glVertex3fv(corner[i]);
    }
    glEnd();
}

void read(Picture& picture) {
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, picture);
}

bool draws(const float (&color)[3][3]) {
    static Picture drawn;
    said.clear();
    triangle(color);
    read(drawn);
    bool all = true;
    for (int i = 0; i < size * size; ++i)
        all = all && (drawn[4 * i] | drawn[4 * i + 1] | drawn[4 * i + 2]) != 0;
    return glGetError() == GL_NO_ERROR && said.empty() && all;
}

constexpr float several[3][3] = {{1.0f, 0.2f, 0.2f}, {0.2f, 1.0f, 0.2f}, {0.2f, 0.2f, 1.0f}};
constexpr float one[3][3] = {{0.7f, 0.4f, 0.9f}, {0.7f, 0.4f, 0.9f}, {0.7f, 0.4f, 0.9f}};

/// Returns whether every pixel has the colour of a clear.
bool as_cleared() {
    static Picture drawn, cleared;
    triangle(one);
    read(drawn);
    glClearColor(one[0][0], one[0][1], one[0][2], 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    read(cleared);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    return std::memcmp(drawn, cleared, sizeof drawn) == 0;
}

/// Returns whether the picture is dithered: every pixel has one of the two colours of 5 and 6 bits beside the
/// given one, and their mean is the given one within an eighth of a step.
bool as_dithered() {
    static Picture drawn;
    glEnable(GL_DITHER);
    triangle(one);
    glDisable(GL_DITHER);
    read(drawn);
    bool near = true;
    for (int c = 0; c < 3; ++c) {
        const float step = 255.0f / (c == 1 ? 63.0f : 31.0f), given = one[0][c] * 255.0f;
        float sum = 0.0f;
        for (int i = 0; i < size * size; ++i) {
            const float is = drawn[4 * i + c];
            near = near && is > given - step - 1.0f && is < given + step + 1.0f;
            sum += is;
        }
        const float off = sum / (size * size) - given;
        near = near && off < step / 8.0f && off > -step / 8.0f;
    }
    return near;
}

bool is_refused() {
    said.clear();
    triangle(several);
    static Picture drawn;
    read(drawn);
    const bool error = glGetError() == GL_INVALID_OPERATION;
    bool none = true;
    for (int i = 0; i < size * size; ++i)
        none = none && (drawn[4 * i] | drawn[4 * i + 1] | drawn[4 * i + 2]) == 0;
    return error && none && said.find("SPANGLE_FUSED") != std::string::npos;
}

} // namespace

int main() {
    spangle::bench::Headless gl;
    spangle::on_message([](unsigned, const char* text) { said = text; });
    check(gl.open(size, size, EGL_PRECISION_FAST_SPANGLE), "a context");
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1.0, 1.0, -1.0, 1.0, 1.0, 10.0);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
    check(draws(several), "smooth shading in perspective is drawn");
    check(draws(one), "one colour is drawn where only smooth shading has a span");
    check(as_cleared(), "one colour is the one that was given");
    check(as_dithered(), "dithered, one colour has the mean that was given");
    constexpr GLfloat front[4] = {0.0f, 0.0f, 1.0f, 0.0f};
    glLightfv(GL_LIGHT0, GL_POSITION, front);
    glNormal3f(0.0f, 0.0f, 1.0f);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    check(draws(several), "what is lit has one colour here, and is drawn");
    glDisable(GL_LIGHTING);
    glShadeModel(GL_FLAT);
    check(draws(several), "FLAT shading has one colour, and is drawn");
    glShadeModel(GL_SMOOTH);
    glDepthFunc(GL_GREATER);
    check(is_refused(), "another test of depths has no span here");
    glDepthFunc(GL_LESS);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    check(is_refused(), "blending has no span here");
    glDisable(GL_BLEND);
    check(draws(several), "and after a refusal all is as before");
    return wrong;
}
