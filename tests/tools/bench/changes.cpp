// Changes one thing and draws a triangle of a few pixels, many times. Under callgrind with
// --dump-before=mark, the dump between the two marks of a case has the instructions of its repetitions.
//
// usage: changes    prints the name of each case, the lighting or texture under which it is drawn, and the
//                   number of its repetitions
#include <cstdint>
#include <cstdio>
#include <vector>

#include "tests/tools/bench/headless.hpp"

/// Callgrind writes a dump before each call of this function.
extern "C" [[gnu::noinline]] void mark() {
    asm volatile("");
}

namespace {

constexpr int size = 64, repetitions = 64;

GLuint textures[2];

/// Returns one of two values in turn, so that each repetition really changes the state.
template <class T> T turn(int i, T even, T odd) {
    return i % 2 == 0 ? even : odd;
}

struct Change {
    const char* name;
    void (*apply)(int i); ///< changes the state in repetition i; the state differs from that of i - 1
};

void load(int i) {
    const float x = turn(i, 0.01f, 0.02f);
    const float matrix[16] = {0.9f, 0, 0, 0, 0, 1.1f, 0, 0, 0, 0, 1.2f, 0, x, -x, -0.1f, 1};
    glLoadMatrixf(matrix);
}

void load_turned(int i) {
    const float x = turn(i, 0.01f, 0.02f);
    const float matrix[16] = {0.8f,  0.6f,   0,    0, -0.48f, 0.64f, 0.6f,  0,
                              0.36f, -0.48f, 0.8f, 0, x,      -x,    -0.1f, 1};
    glLoadMatrixf(matrix);
}

void load_projection(int i) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(-1, 1, -1, 1, turn(i, -1, -2), 2);
    glMatrixMode(GL_MODELVIEW);
}

void light_color(int i) {
    const float color[4] = {turn(i, 0.5f, 0.6f), 0.5f, 0.5f, 1};
    glLightfv(GL_LIGHT0, GL_DIFFUSE, color);
}

void light_position(int i) {
    const float position[4] = {turn(i, 0.5f, 0.6f), 0.5f, 1, 0};
    glLightfv(GL_LIGHT0, GL_POSITION, position);
}

void material(int i) {
    const float color[4] = {turn(i, 0.5f, 0.6f), 0.5f, 0.5f, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color);
}

const Change changes[] = {
    {"nothing", [](int) {}},
    {"glColor", [](int i) { glColor3f(turn(i, 0.5f, 0.6f), 0.5f, 0.5f); }},
    {"glLoadIdentity", [](int i) { i % 2 == 0 ? glLoadIdentity() : glTranslatef(0.01f, 0.0f, 0.0f); }},
    {"glLoadMatrix of a scale and a translation", load},
    {"glLoadMatrix of a rotation and a translation", load_turned},
    {"glPushMatrix, glTranslate and glPopMatrix",
     [](int i) {
         glPopMatrix();
         glPushMatrix();
         glTranslatef(turn(i, 0.01f, 0.02f), 0.0f, 0.0f);
     }},
    {"glRotate", [](int i) { glRotatef(turn(i, 10.0f, -10.0f), 0.0f, 0.0f, 1.0f); }},
    {"glOrtho", load_projection},
    {"glViewport", [](int i) { glViewport(0, 0, size, turn(i, size, size - 1)); }},
    {"glDepthRange", [](int i) { glDepthRange(0.0, turn(i, 1.0, 0.5)); }},
    {"glLight, colour", light_color},
    {"glLight, direction", light_position},
    {"glMaterial", material},
    {"glBindTexture", [](int i) { glBindTexture(GL_TEXTURE_2D, textures[i % 2]); }},
    {"glTexEnv",
     [](int i) { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, turn(i, GL_MODULATE, GL_REPLACE)); }},
    {"glEnable and glDisable, GL_BLEND",
     [](int i) { i % 2 == 0 ? glEnable(GL_BLEND) : glDisable(GL_BLEND); }},
    {"glDepthFunc", [](int i) { glDepthFunc(turn<GLenum>(i, GL_LESS, GL_LEQUAL)); }},
    {"glScissor", [](int i) { glScissor(0, 0, size, turn(i, size, size - 1)); }},
    {"glCullFace", [](int i) { glCullFace(turn<GLenum>(i, GL_BACK, GL_FRONT_AND_BACK)); }},
    {"glPushAttrib(GL_ALL_ATTRIB_BITS) and glPopAttrib",
     [](int) {
         glPushAttrib(GL_ALL_ATTRIB_BITS);
         glPopAttrib();
     }},
};

void make_texture(GLuint name, int seed) {
    std::vector<std::uint8_t> texels(8 * 8 * 4);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = static_cast<std::uint8_t>(i * 37 + static_cast<std::size_t>(seed));
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

/// A triangle of a few pixels near the middle, with normals and texture coordinates.
const float positions[] = {0, 0, 0, 0.1f, 0, 0, 0, 0.1f, 0}, normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1},
            texture_coords[] = {0, 0, 1, 0, 0, 1};

/// Returns false if there is no context, or if GL reports an error.
bool run(const Change& change, const char* how, bool lit, bool textured) {
    spangle::bench::Headless gl;
    if (!gl.open(size, size, EGL_PRECISION_BALANCED_SPANGLE))
        return false;
    glGenTextures(2, textures);
    make_texture(textures[1], 0);
    make_texture(textures[0], 99);
    glDisable(GL_DITHER);
    glEnable(GL_DEPTH_TEST);
    if (lit) {
        glEnable(GL_LIGHTING);
        glEnable(GL_LIGHT0);
    }
    if (textured)
        glEnable(GL_TEXTURE_2D);
    glVertexPointer(3, GL_FLOAT, 0, positions);
    glNormalPointer(GL_FLOAT, 0, normals);
    glTexCoordPointer(2, GL_FLOAT, 0, texture_coords);
    glEnableClientState(GL_VERTEX_ARRAY);
    if (lit)
        glEnableClientState(GL_NORMAL_ARRAY);
    if (textured)
        glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glPushMatrix();
    const auto repeat = [&](int count) {
        for (int i = 0; i < count; ++i) {
            change.apply(i);
            glDrawArrays(GL_TRIANGLES, 0, 3);
        }
    };
    repeat(4); // what is done once is done here
    mark();
    repeat(repetitions);
    mark();
    const bool good = glGetError() == GL_NO_ERROR;
    gl.close();
    std::printf("%s, %s: %d\n", change.name, how, repetitions);
    return good;
}

} // namespace

int main() {
    for (const Change& change : changes)
        if (!run(change, "unlit", false, false) || !run(change, "lit", true, false) ||
            !run(change, "textured", false, true)) {
            std::fprintf(stderr, "changes: '%s' fails\n", change.name);
            return 1;
        }
    return 0;
}
