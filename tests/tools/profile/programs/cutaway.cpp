// Draws a ball in a display list, cut open by a plane and lit on both sides.
#include "tests/tools/profile/programs/program.hpp"

namespace spangle::programs {

namespace {

GLuint list = 0;

void setup(int, int) {
    glClearColor(0.2f, 0.2f, 0.2f, 1.0f);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.4, 0.4, -0.3, 0.3, 1.0, 10.0);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    constexpr GLfloat inside[4] = {0.8f, 0.1f, 0.1f, 1.0f};
    glMaterialfv(GL_BACK, GL_DIFFUSE, inside);
    list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    ball();
    glEndList();
}

void draw(int frame) {
    constexpr GLdouble plane[4] = {0.6, 0.4, -0.7, 0.1};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -3.0f);
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(GL_CLIP_PLANE0);
    glPushMatrix();
    glRotatef(12.0f * static_cast<float>(frame), 0.0f, 1.0f, 0.0f);
    glPushMatrix();
    glScalef(0.9f, 0.9f, 0.9f);
    glCallList(list);
    glPopMatrix();
    glPopMatrix();
    glDisable(GL_CLIP_PLANE0);
}

} // namespace

const Program cutaway{"cutaway", setup, draw};

} // namespace spangle::programs
