// Tests a build that checks the ranges of its profile. A program may do anything within them; a program that
// goes beyond one is stopped behind a sentence that names the range. Each try is a process of its own. Prints
// what is wrong, and then exits with status 1. The definitions are in tests/tools/profile/CMakeLists.txt.
#include <cstdio>
#include <string>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <spangle/message.hpp>

#include "tests/tools/bench/headless.hpp"

namespace {

using namespace spangle;

constexpr int side = 32, band = 40; ///< pixels of the largest surface, and rows in memory at once

int out = -1; ///< descriptor to which the sentence of a try is written

void triangle(float x, float z, float w) {
    glBegin(GL_TRIANGLES);
    glVertex4f(-x, -0.5f, z, w);
    glVertex4f(x, -0.5f, 0.0f, w);
    glVertex4f(0.0f, 0.5f, 0.0f, w);
    glEnd();
}
void plain() {
    triangle(0.5f, 0.0f, 1.0f);
}

void positions(float scale) {
    glMatrixMode(GL_PROJECTION);
    glScalef(0.01f, 1.0f, 1.0f);
    triangle(scale, 0.0f, 1.0f);
}

void textured(float s) {
    constexpr GLubyte texel[4] = {255, 255, 255, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    glTexCoord2f(s, 0.0f);
    plain();
}

void listed(int vertices) {
    for (GLuint list = 1; list < 3; ++list) { // each list counts for itself
        glNewList(list, GL_COMPILE);
        glBegin(GL_POINTS);
        for (int i = 0; i < vertices; ++i)
            glVertex2f(0.0f, 0.0f);
        glEnd();
        glEndList();
    }
}

void pushed(int times) {
    for (int i = 0; i < times; ++i)
        glPushAttrib(GL_CURRENT_BIT);
}

void elements(float x) {
    const float corner[3][2] = {{-x, -0.5f}, {x, -0.5f}, {0.0f, 0.5f}};
    glMatrixMode(GL_PROJECTION);
    glScalef(0.01f, 1.0f, 1.0f);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, corner);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// A try draws on a surface of this size, and goes beyond the named range, or beyond none.
struct Try {
    const char* range;
    int width, height;
    void (*draw)();
};

constexpr Try tries[] = {
    {nullptr, side, band, plain},
    {"SURFACE_WIDTH", side + 1, side, plain},
    {"SURFACE_HEIGHT", side, 49, plain},
    {"BAND_ROWS", side, band + 1, plain},
    {nullptr, side, side, [] { glPointSize(2.0f), glBegin(GL_POINTS), glVertex2f(0.0f, 0.0f), glEnd(); }},
    {"POINT_SIZE", side, side, [] { glPointSize(3.0f), glBegin(GL_POINTS), glEnd(); }},
    {nullptr, side, side, [] { glPointSize(3.0f), plain(); }},
    {nullptr, side, side, [] { glLineWidth(2.0f), glBegin(GL_LINES), glEnd(); }},
    {"LINE_WIDTH", side, side, [] { glLineWidth(2.6f), glBegin(GL_LINE_LOOP), glEnd(); }},
    {"LINE_WIDTH", side, side,
     [] {
         glLineWidth(4.0f);
         glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
         plain();
     }},
    {nullptr, side, side, [] { positions(7.9f); }},
    {"POSITION_BITS", side, side, [] { positions(8.0f); }},
    {nullptr, side, side, [] { elements(7.9f); }},
    {"POSITION_BITS", side, side, [] { elements(-8.0f); }},
    {nullptr, side, side, [] { textured(1.9f); }},
    {"TEXTURE_BITS", side, side, [] { textured(-2.0f); }},
    {"TEXTURE_BITS", side, side,
     [] {
         glMatrixMode(GL_TEXTURE);
         glScalef(4.0f, 1.0f, 1.0f);
         textured(0.6f);
     }},
    {nullptr, side, side, [] { glTexCoord2f(9.0f, 9.0f), plain(); }},
    {"PERSPECTIVE", side, side, [] { triangle(0.5f, 0.0f, 2.0f); }},
    {"CUTS", side, side, [] { triangle(0.5f, 2.0f, 1.0f); }},
    {nullptr, side, side,
     [] { // draws wholly outside of the view volume
         glTranslatef(0.0f, 0.0f, 5.0f);
         plain();
     }},
    {nullptr, side, side, [] { listed(6); }},
    {"LIST_VERTICES", side, side, [] { listed(7); }},
    {nullptr, side, side, [] { pushed(1), glPopAttrib(), pushed(1); }},
    {"ATTRIB_STACK", side, side, [] { pushed(2); }},
};

/// Returns what a try prints before it ends, and sets whether it was stopped.
std::string run(const Try& one, bool& stopped) {
    int ends[2];
    if (pipe(ends) != 0)
        return "no pipe";
    const pid_t child = fork();
    if (child == 0) {
        constexpr rlimit none = {0, 0};
        setrlimit(RLIMIT_CORE, &none);
        out = ends[1];
        on_message([](unsigned, const char* text) { dprintf(out, "%s", text); });
        bench::Headless gl;
        if (!gl.open(one.width, one.height, EGL_PRECISION_BALANCED_SPANGLE))
            _exit(2);
        one.draw();
        _exit(glGetError() == GL_NO_ERROR ? 0 : 1);
    }
    close(ends[1]);
    std::string said;
    char text[512];
    for (ssize_t n = 0; (n = read(ends[0], text, sizeof text)) > 0;)
        said.append(text, static_cast<std::size_t>(n));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    stopped = WIFSIGNALED(status);
    return stopped || (WIFEXITED(status) && WEXITSTATUS(status) == 0) ? said : said + " (and failed)";
}

} // namespace

int main() {
    int wrong = 0, number = 0;
    for (const Try& one : tries) {
        bool stopped = false;
        const std::string said = run(one, stopped);
        const bool good = one.range == nullptr ? !stopped && said.empty()
                                               : stopped && said.find("(" + std::string(one.range) + " of") !=
                                                                std::string::npos;
        if (!good)
            std::printf("try %d, beyond %s: %s, said '%s'\n", number,
                        one.range == nullptr ? "none" : one.range, stopped ? "stopped" : "not stopped",
                        said.c_str());
        wrong |= good ? 0 : 1;
        ++number;
    }
    return wrong;
}
