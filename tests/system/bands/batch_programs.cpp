// Programs whose bands leave batches out: long batches of every mode, and many short ones.
#include <array>
#include <cmath>

#include "tests/system/bands/programs.hpp"

namespace spangle::test {

namespace {

constexpr int longest = 201; ///< elements: several pieces of a batch, the last one not whole

struct Arrays {
    std::array<GLfloat, std::size_t{longest} * 2> place;
    std::array<GLubyte, std::size_t{longest} * 4> color;
    std::array<GLushort, std::size_t{longest}> index;
};

/// Returns a zigzag that climbs through the picture and beyond it, so that each band meets a part of it in
/// every mode.
Arrays zigzag(int frame) {
    Arrays made;
    for (unsigned i = 0; i < longest; ++i) {
        const auto t = static_cast<float>(i);
        made.place[2 * i] =
            (i % 2 == 0 ? 30.F : 75.F) + 40.F * std::sin(t * 0.31F + static_cast<float>(frame));
        made.place[2 * i + 1] = -9.F + t * 0.49F + (i % 3 == 0 ? 2.2F : 0.F);
        for (unsigned c = 0; c < 4; ++c)
            made.color[4 * i + c] = static_cast<GLubyte>(40 + (i * (31 + 12 * c)) % 200);
        made.index[i] = static_cast<GLushort>(longest - 1 - i);
    }
    return made;
}

constexpr GLenum all_modes[] = {GL_POINTS,         GL_LINES,        GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES,
                                GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,     GL_QUAD_STRIP, GL_POLYGON};

/// Draws all modes from arrays, by number and by index.
void draw_arrays(int frame) {
    const Arrays arrays = zigzag(frame);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, arrays.place.data());
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, arrays.color.data());
    for (const GLenum mode : all_modes) {
        glDrawElements(mode, longest, GL_UNSIGNED_SHORT, arrays.index.data());
        glTranslatef(4.F, 1.F, 0.F);
        glDrawArrays(mode, 3, longest - 3);
        glTranslatef(3.F, 0.F, 0.F);
    }
    glDisableClientState(GL_COLOR_ARRAY);
    glColor3f(1.F, 0.5F, 0.2F); // the current colour, for draws without a colour array
    for (const GLenum mode : {GL_TRIANGLE_STRIP, GL_LINE_STRIP, GL_QUAD_STRIP})
        glDrawElements(mode, longest, GL_UNSIGNED_SHORT, arrays.index.data());
    glDisableClientState(GL_VERTEX_ARRAY);
    glLoadIdentity();
}

Program arrays() {
    return {"arrays", start_program, [](int f) {
                glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                draw_arrays(f);
                glShadeModel(GL_FLAT);
                glEnable(GL_CULL_FACE); // all pieces of a strip turn the same way
                draw_arrays(f + 1);
                glCullFace(GL_FRONT);
                glTranslatef(20.F, 0.F, 0.F);
                draw_arrays(f + 2);
                glCullFace(GL_BACK);
                glDisable(GL_CULL_FACE);
                glShadeModel(GL_SMOOTH);
            }};
}

Program stippled_arrays() {
    return {"stippled arrays", start_program, [](int f) {
                glClear(GL_COLOR_BUFFER_BIT);
                glEnable(GL_LINE_STIPPLE); // the stipple continues along a strip
                glLineStipple(5, 0x2F31);
                glLineWidth(3.F);
                glPointSize(6.F);
                draw_arrays(f);
                glDisable(GL_LINE_STIPPLE);
                glLineWidth(1.F);
                glPointSize(1.F);
            }};
}

Program outlined_arrays() {
    return {"outlined arrays", start_program, [](int f) {
                glClear(GL_COLOR_BUFFER_BIT);
                glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
                draw_arrays(f + 3);
                glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
                draw_arrays(f + 4);
                glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
            }};
}

Program smooth_arrays(GLenum what) {
    return {"smooth arrays, " + std::to_string(what), start_program, [what](int f) {
                glClear(GL_COLOR_BUFFER_BIT);
                glEnable(GL_BLEND);
                glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                glEnable(what);
                glLineWidth(2.5F);
                glPointSize(4.F);
                draw_arrays(f + 1);
                glPointSize(1.F);
                glLineWidth(1.F);
                glDisable(what);
                glDisable(GL_BLEND);
            }};
}

/// Draws more batches than there are entries for, most of them small; some have more vertices than they need.
Program many_batches() {
    return {"many batches", start_program, [](int f) {
                glClear(GL_COLOR_BUFFER_BIT);
                for (int i = 0; i < 700; ++i) {
                    const auto x = static_cast<float>(i * 37 % 157),
                               y = static_cast<float>((i * 53 + f) % 83 - 2);
                    glColor3ub(static_cast<GLubyte>(i * 7), static_cast<GLubyte>(i * 3 + 50), 90);
                    switch (i % 5) {
                    case 0:
                        glRectf(x, y, x + 3.F, y + 2.F);
                        break;
                    case 1:
                        glBegin(GL_POINTS);
                        glVertex2f(x + 0.5F, y + 0.5F);
                        glEnd();
                        break;
                    case 2:
                        glBegin(GL_LINE_LOOP);
                        glVertex2f(x, y);
                        glVertex2f(x + 5.F, y + 4.F);
                        glVertex2f(x + 1.F, y + 6.F);
                        glEnd();
                        break;
                    default:
                        glBegin(GL_TRIANGLE_FAN);
                        for (int k = 0; k < 3 + i % 4; ++k)
                            glVertex2f(x + static_cast<float>(k % 3) * 2.F,
                                       y + static_cast<float>(k * k % 5));
                        glEnd();
                    }
                }
            }};
}

void make_lists() {
    glNewList(1, GL_COMPILE);
    for (int row = 0; row < 6; ++row) {
        glBegin(GL_QUAD_STRIP);
        for (int i = 0; i < 14; ++i) {
            glColor3f(static_cast<float>(i) / 14.F, 0.5F, static_cast<float>(row) / 6.F);
            glVertex2f(static_cast<float>(i) * 10.F,
                       static_cast<float>(row) * 13.F + (i % 2 == 0 ? 0.F : 9.F));
        }
        glEnd();
        glTranslatef(1.F, 0.5F, 0.F); // lists move the matrix between batches that are left out
    }
    glLoadIdentity();
    glEndList();
    static const GLfloat control[] = {10, 5, 0, 60, 70, 0, 110, 10, 0, 20, 40, 0, 70, 20, 0, 140, 75, 0};
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 3, 0, 1, 9, 2, control);
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 6, control);
    glMapGrid2f(12, 0, 1, 9, 0, 1);
    glMapGrid1f(30, 0, 1);
}

Program lists_and_meshes() {
    return {"lists and meshes",
            [](int w, int h) {
                start_program(w, h);
                make_lists();
            },
            [](int f) {
                glClear(GL_COLOR_BUFFER_BIT);
                glTranslatef(static_cast<float>(f), 0.F, 0.F);
                glCallList(1);
                glEnable(GL_MAP2_VERTEX_3);
                glEnable(GL_MAP1_VERTEX_3);
                glColor3f(0.2F, 0.9F, 0.4F);
                glEvalMesh2(GL_FILL, 0, 12, 0, 9);
                glColor3f(0.9F, 0.2F, 0.4F);
                glEvalMesh2(GL_LINE, 0, 12, 0, 9);
                glEvalMesh1(GL_LINE, 0, 30);
                glPointSize(3.F);
                glEvalMesh2(GL_POINT, 0, 12, 0, 9);
                glPointSize(1.F);
                glDisable(GL_MAP2_VERTEX_3);
                glDisable(GL_MAP1_VERTEX_3);
            }};
}

/// State that is set inside of a batch is current afterwards, materials included, also if the batch is left
/// out.
Program attributes_inside() {
    return {"attributes inside",
            [](int w, int h) {
                start_program(w, h);
                glEnable(GL_LIGHT0);
                glLightModelfv(GL_LIGHT_MODEL_AMBIENT, std::array<GLfloat, 4>{0.6F, 0.6F, 0.6F, 1}.data());
            },
            [](int f) {
                glClear(GL_COLOR_BUFFER_BIT);
                glNormal3f(0, 0, 1);
                glColor3f(1, 1, 1);
                glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, std::array<GLfloat, 4>{0, 0, 1, 1}.data());
                glEnable(GL_LIGHTING);
                for (int i = 0; i < 20; ++i) {
                    const auto y = static_cast<float>(i * 29 % 80);
                    glBegin(GL_TRIANGLES);
                    glVertex2f(5.F + static_cast<float>(f), y);
                    const GLfloat color[] = {0.05F * static_cast<float>(i), 0.5F, 0.3F, 1};
                    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, color);
                    glVertex2f(150.F, y + 1.F);
                    glVertex2f(80.F, y + 9.F);
                    glEnd();
                    glRectf(120.F, 79.F - y, 140.F, 75.F - y); // must have the material of the triangle
                }
                glDisable(GL_LIGHTING);
                for (int i = 0; i < 20; ++i) {
                    const auto y = static_cast<float>(i * 31 % 80);
                    glBegin(GL_LINES);
                    glColor3f(0.05F * static_cast<float>(i), 0.2F, 0.9F);
                    glVertex2f(2.F, y);
                    glVertex2f(30.F, y + 3.F);
                    glEnd();
                    glRectf(40.F, 79.F - y, 60.F, 76.F - y); // must have the colour of the line
                }
            }};
}

} // namespace

std::vector<Program> batch_programs() {
    return {arrays(),
            stippled_arrays(),
            outlined_arrays(),
            smooth_arrays(GL_POINT_SMOOTH),
            smooth_arrays(GL_LINE_SMOOTH),
            smooth_arrays(GL_POLYGON_SMOOTH),
            many_batches(),
            lists_and_meshes(),
            attributes_inside()};
}

} // namespace spangle::test
