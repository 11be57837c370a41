#include "tests/oracle/mesa/eval_probes.hpp"

#include <initializer_list>

#include "boards/scenes/gl.hpp"

namespace spangle::oracle {

namespace {

/// Maps a sheet that is bent both ways, of 4 x 4 points; it is the same for both sizes of vertices.
void map_sheet() {
    GLfloat points[4][4][4], colors[2][2][4];
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const auto x = static_cast<GLfloat>(i), y = static_cast<GLfloat>(j);
            const GLfloat w = 1 + static_cast<GLfloat>((i * j) % 3) / 3;
            points[i][j][0] = (x - 1.5f) * w;
            points[i][j][1] = (y - 1.5f) * w;
            points[i][j][2] = static_cast<GLfloat>((i * 2 + j * 3) % 4 - 1) * w;
            points[i][j][3] = w;
            GLfloat(&color)[4] = colors[i / 2][j / 2];
            color[0] = x / 3;
            color[1] = 1 - y / 3;
            color[2] = color[3] = 1;
        }
    glMap2f(GL_MAP2_VERTEX_4, 0, 1, 16, 4, 0, 1, 4, 4, &points[0][0][0]);
    glMap2f(GL_MAP2_COLOR_4, 0, 1, 8, 2, 0, 1, 4, 2, &colors[0][0][0]);
    glMap1f(GL_MAP1_VERTEX_4, 0, 1, 4, 4, &points[2][0][0]);
    glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 2, &colors[1][0][0]);
}

void set_up_patches(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 1, -0.75, 0.75, 2, 30);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    map_sheet();
    for (const GLenum on : std::initializer_list<GLenum>{GL_MAP2_VERTEX_4, GL_AUTO_NORMAL, GL_NORMALIZE,
                                                         GL_LIGHT0, GL_DEPTH_TEST})
        glEnable(on);
    glMapGrid1f(20, 0, 1);
}

/// Draws lit patches, a coloured patch, its lines, and a curve.
void draw_patches(int) {
    glClearColor(0.1f, 0.1f, 0.2f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int n = 0; n < 4; ++n) {
        glPushMatrix();
        glTranslatef(n % 2 == 0 ? -2.2f : 2.2f, n / 2 == 0 ? -1.8f : 1.8f, -10);
        glRotatef(40, 1, 0.5f, static_cast<GLfloat>(n));
        (n < 2 ? glEnable : glDisable)(GL_LIGHTING);
        (n < 2 ? glDisable : glEnable)(GL_MAP2_COLOR_4);
        glColor3f(1, 1, 1);
        const GLint fine = n == 3 ? 1 : 4; // the quads are so small that their diagonals do not show
        glMapGrid2f(12 * fine, 0, 1, 9 * fine, 0, 1);
        glEvalMesh2(n == 3 ? GL_LINE : GL_FILL, 0, (n == 1 ? 7 : 12) * fine, 0, 9 * fine);
        glPopMatrix();
    }
    glEnable(GL_MAP1_VERTEX_4);
    glEnable(GL_MAP1_COLOR_4);
    glTranslatef(0, 0, -8);
    glEvalMesh1(GL_LINE, 0, 20);
    glTranslatef(0, 0, 8);
}

} // namespace

const scenes::Scene patches = {"P-patches", "curved patches of evaluators", set_up_patches, draw_patches};

} // namespace spangle::oracle
