// Set-up code that several scenes share.
#pragma once

#include <initializer_list>

#include "boards/scenes/gl.hpp"

namespace spangle::scenes {

/// The clear colour of every scene.
inline void clear_color() {
    glClearColor(0.125f, 0.25f, 0.375f, 1.0f);
}

/// Sets a viewport of the whole picture and a perspective projection, whose near plane shows x from -1 to 1.
/// The modelview matrix becomes current, and the identity.
inline void perspective(int width, int height, float z_near, float z_far) {
    const float h = static_cast<float>(height) / static_cast<float>(width);
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1.0, 1.0, static_cast<GLdouble>(-h), static_cast<GLdouble>(h), static_cast<GLdouble>(z_near),
              static_cast<GLdouble>(z_far));
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

/// Sets a projection of one unit per pixel with y down, as user interfaces count.
inline void pixels(int width, int height) {
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0.0, width, height, 0.0, -1.0, 1.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

} // namespace spangle::scenes
