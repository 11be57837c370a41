#include "host_sim/trade/corpus_parts.hpp"

#include <cmath>

#include <spangle/GL/gl.h>

namespace spangle::trade {

namespace {

float height_of(int width, int height) {
    return static_cast<float>(height) / static_cast<float>(width);
}

} // namespace

void look(int width, int height, float nearest, float farthest) {
    const float h = height_of(width, height);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, double{-h}, double{h}, double{nearest}, double{farthest});
    glMatrixMode(GL_MODELVIEW);
    glClearColor(0.125f, 0.25f, 0.375f, 1);
    glEnable(GL_DEPTH_TEST);
}

void clear() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glLoadIdentity();
}

void sheet(float left, float bottom, float right, float top, float z, float alpha) {
    glBegin(GL_QUADS);
    glColor4f(0.9f, 0.2f, 0.1f, alpha), glVertex3f(left, bottom, z);
    glColor4f(0.1f, 0.8f, 0.2f, alpha), glVertex3f(right, bottom, z);
    glColor4f(0.2f, 0.3f, 0.9f, alpha), glVertex3f(right, top, z);
    glColor4f(0.9f, 0.9f, 0.2f, alpha), glVertex3f(left, top, z);
    glEnd();
}

void ground() {
    constexpr float far = 1000, side = 1000;
    glBegin(GL_QUADS);
    glTexCoord2f(-side, 0), glVertex3f(-side, -1, 0);
    glTexCoord2f(side, 0), glVertex3f(side, -1, 0);
    glTexCoord2f(side, far), glVertex3f(side, -1, -far);
    glTexCoord2f(-side, far), glVertex3f(-side, -1, -far);
    glEnd();
}

void sphere(int rings) {
    constexpr float pi = 3.14159265f;
    for (int i = 0; i < rings; ++i) {
        glBegin(GL_QUAD_STRIP);
        for (int k = 0; k <= 2 * rings; ++k)
            for (int ring = 0; ring < 2; ++ring) {
                const float a = pi * static_cast<float>(i + ring) / static_cast<float>(rings),
                            b = pi * static_cast<float>(k) / static_cast<float>(rings);
                const float x = std::sin(a) * std::cos(b), y = std::cos(a), z = std::sin(a) * std::sin(b);
                glTexCoord2f(static_cast<float>(k) / static_cast<float>(rings),
                             static_cast<float>(i + ring) / static_cast<float>(rings));
                glNormal3f(x, y, z);
                glVertex3f(x, y, z);
            }
        glEnd();
    }
}

} // namespace spangle::trade
