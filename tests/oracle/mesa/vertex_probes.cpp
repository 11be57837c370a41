#include "tests/oracle/mesa/vertex_probes.hpp"

#include <cmath>
#include <initializer_list>

#include "boards/scenes/gl.hpp"

namespace spangle::oracle {

namespace {

/// Makes one unit a pixel, with y up.
void pixels(int width, int height) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, width, 0, height, -100, 100);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

void clear() {
    glClearColor(0.1f, 0.1f, 0.2f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// Draws a ring of n vertices around (x, y); the bits of `flags` are its edge flags.
void ring(GLenum mode, int n, float x, float y, float radius, unsigned flags) {
    glBegin(mode);
    for (int i = 0; i < n; ++i) {
        const float a = 0.3f + 6.2831853f * static_cast<float>(i) / static_cast<float>(n);
        glEdgeFlag((flags >> i & 1) != 0 ? GL_TRUE : GL_FALSE);
        glColor3f(0.5f + 0.5f * std::cos(a), 0.9f, 0.5f + 0.5f * std::sin(a));
        glVertex3f(x + radius * std::cos(a), y + radius * std::sin(a), 0.1f * static_cast<float>(i));
    }
    glEnd();
}

/// In Mesa edge flags also hide edges of strips and fans, which GL 1.3, 2.6.2 does not; so these have all
/// flags set.
void draw_outlines(int) {
    clear();
    const GLenum modes[] = {GL_TRIANGLES,    GL_QUADS,          GL_POLYGON,
                            GL_TRIANGLE_FAN, GL_TRIANGLE_STRIP, GL_QUAD_STRIP};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 6; ++column) {
            glShadeModel(row == 1 ? GL_FLAT : GL_SMOOTH);
            glPolygonMode(GL_FRONT, row == 2 ? GL_POINT : GL_LINE);
            glPolygonMode(GL_BACK, row == 0 ? GL_LINE : GL_FILL);
            ring(modes[column], 12, 22.0f + 42.0f * static_cast<float>(column),
                 32.0f + 64.0f * static_cast<float>(row), 18, row == 1 && column < 3 ? 0x5B6u : 0xFFFu);
        }
}

void set_up_two_units(int width, int height) {
    pixels(width, height);
    for (int unit = 0; unit < 2; ++unit) {
        static GLuint names[2];
        GLubyte texels[16][16][3];
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const bool on = unit == 0 ? (x / 4 + y / 4) % 2 == 0 : x > y;
                texels[y][x][0] = static_cast<GLubyte>(on ? 255 : 60);
                texels[y][x][1] = static_cast<GLubyte>(16 * x);
                texels[y][x][2] = static_cast<GLubyte>(unit == 0 ? 16 * y : 200);
            }
        glActiveTexture(unit == 0 ? GL_TEXTURE0 : GL_TEXTURE1);
        glGenTextures(1, &names[unit]);
        glBindTexture(GL_TEXTURE_2D, names[unit]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, unit == 0 ? GL_NEAREST : GL_LINEAR);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
        glEnable(GL_TEXTURE_2D);
        glMatrixMode(GL_TEXTURE); // its own texture matrix turns the second picture
        const GLfloat turn[16] = {0.8f, -0.6f, 0, 0.1f, 0.6f, 0.8f, 0, 0.2f, 0, 0, 1, 0, 0, 0, 0, 1};
        if (unit == 1)
            glLoadTransposeMatrixf(turn);
    }
    glActiveTexture(GL_TEXTURE0);
    glMatrixMode(GL_MODELVIEW);
}

void draw_two_units(int) {
    clear();
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 4; ++i) {
        const float x = static_cast<float>(i % 2), y = static_cast<float>(i / 2);
        glColor3f(1, 0.6f + 0.4f * x, 0.7f + 0.3f * y);
        glTexCoord2f(2 * x, 2 * y);
        glMultiTexCoord2f(GL_TEXTURE1, 1.5f * x - 0.25f, y);
        glVertex2f(20 + 200 * x, 20 + 150 * y);
    }
    glEnd();
}

/// Sets a camera above objects of size 1, which are lit on both sides.
void in_perspective(int width, int height) {
    const double aspect = static_cast<double>(width) / height;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-0.5 * aspect, 0.5 * aspect, -0.5, 0.5, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -3.2f);
    glRotatef(35, 1, 0.3f, 0);
    glEnable(GL_DEPTH_TEST);
}

void light(bool two_sided) {
    const float front[4] = {0.9f, 0.6f, 0.2f, 1}, back[4] = {0.2f, 0.5f, 0.9f, 1}, white[4] = {1, 1, 1, 1},
                from[4] = {0.5f, 0.6f, 1, 0};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, from);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_sided ? 1 : 0);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, front);
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
}

void torus(int sides, int rings) {
    const float turn = 6.2831853f;
    for (int i = 0; i < rings; ++i) {
        glBegin(GL_QUAD_STRIP);
        for (int k = 0; k <= sides; ++k)
            for (int next = 1; next >= 0; --next) {
                const float a = turn * static_cast<float>(i + next) / static_cast<float>(rings),
                            b = turn * static_cast<float>(k) / static_cast<float>(sides);
                const float nx = std::cos(a) * std::cos(b), ny = std::sin(a) * std::cos(b), nz = std::sin(b);
                glNormal3f(nx, ny, nz);
                glVertex3f(0.9f * std::cos(a) + 0.4f * nx, 0.9f * std::sin(a) + 0.4f * ny, 0.4f * nz);
            }
        glEnd();
    }
}

void set_up_cut_torus(int width, int height) {
    in_perspective(width, height);
    light(true);
    const double planes[3][4] = {{0.8, 0.4, 0.2, 0.3}, {-0.3, 0.7, -0.5, 0.6}, {0, -1, 0, 0.95}};
    for (int i = 0; i < 3; ++i) {
        glClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(2 * i), planes[i]);
        glEnable(GL_CLIP_PLANE0 + static_cast<GLenum>(2 * i));
    }
}

/// Draws rows of quads and strips with a colour in each vertex. The colours show where the diagonals are.
void draw_divided_quads(int) {
    glClear(GL_COLOR_BUFFER_BIT);
    const auto corner = [](int column, int row) {
        const auto mixed = static_cast<unsigned>(column * 97 + row * 57 + column * row * 31);
        glColor3ub(static_cast<GLubyte>(mixed * 89), static_cast<GLubyte>(mixed * 151),
                   static_cast<GLubyte>(mixed * 211));
        glVertex2i(8 + 30 * column + (row % 2 != 0 ? 9 : 0), 8 + 29 * row + (column % 2 != 0 ? 7 : 0));
    };
    for (int row = 0; row < 6; ++row) {
        const bool strip = row % 2 != 0;
        glBegin(strip ? GL_QUAD_STRIP : GL_QUADS);
        for (int column = 0; column < 8; ++column) {
            corner(column, row);
            if (!strip) {
                corner(column + 1, row);
                corner(column + 1, row + 1);
            }
            corner(column, row + 1);
        }
        glEnd();
    }
}

void draw_torus(int) {
    clear();
    torus(16, 32);
}

/// Makes a texture of coloured rings, so fine that they show where the coordinates are.
void ring_texture() {
    GLubyte texels[64][64][3];
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const int u = x - 32, v = y - 32, far = u * u + v * v;
            texels[y][x][0] = static_cast<GLubyte>(far / 9 % 256);
            texels[y][x][1] = static_cast<GLubyte>(4 * x);
            texels[y][x][2] = static_cast<GLubyte>(255 - 4 * y);
        }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_TEXTURE_2D);
}

void set_up_sphere_map(int width, int height) {
    in_perspective(width, height);
    ring_texture();
    glEnable(GL_NORMALIZE);
    for (const GLenum coord : std::initializer_list<GLenum>{GL_S, GL_T}) {
        glTexGeni(coord, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
        glEnable(coord == GL_S ? GL_TEXTURE_GEN_S : GL_TEXTURE_GEN_T);
    }
    glColor3f(1, 1, 1);
}

/// Generates s by an object plane, and t by an eye plane under another matrix, with separate specular light.
void set_up_planes(int width, int height) {
    in_perspective(width, height);
    light(false);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    ring_texture();
    const GLfloat object[4] = {0.8f, 0.5f, 0.1f, 0.2f}, eye[4] = {0.2f, 0.9f, -0.4f, 0.3f};
    glTexGenfv(GL_S, GL_OBJECT_PLANE, object);
    glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glPushMatrix();
    glRotatef(50, 0.1f, 0.2f, 1);
    glTexGenfv(GL_T, GL_EYE_PLANE, eye);
    glPopMatrix();
    glEnable(GL_TEXTURE_GEN_S);
    glEnable(GL_TEXTURE_GEN_T);
}

} // namespace

const scenes::Scene sphere_mapped = {"P-sphere-map", "SPHERE_MAP", set_up_sphere_map, draw_torus};
const scenes::Scene planes_mapped = {"P-texgen-planes", "OBJECT_LINEAR, EYE_LINEAR, separate specular",
                                     set_up_planes, draw_torus};
const scenes::Scene cut_torus = {"P-clip-planes", "a torus cut open", set_up_cut_torus, draw_torus};
const scenes::Scene outlines = {"P-outlines", "PolygonMode and edge flags", pixels, draw_outlines};
const scenes::Scene divided_quads = {"P-divided-quads", "quads of four colours", pixels, draw_divided_quads};
const scenes::Scene two_units = {"P-two-units", "two textures", set_up_two_units, draw_two_units};

} // namespace spangle::oracle
