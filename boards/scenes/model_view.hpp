// How models are shown: turning in front of one light, opaque parts first. Models of files and baked ones
// share it.
#pragma once

#include <initializer_list>

#include "boards/scenes/gl.hpp"

namespace spangle::scenes {

/// Sets the light and the state of all parts. The modelview matrix is the identity, and is current.
inline void light_model() {
    static constexpr GLfloat light[4] = {0.4f, 0.7f, 1.0f, 0.0f};
    glClearColor(0.125f, 0.25f, 0.375f, 1.0f);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

/// Clears, and turns the model by two degrees a frame.
inline void turn_model(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -3.0f);
    glRotatef(18.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(static_cast<float>(30 + 2 * (frame % 180)), 0.0f, 1.0f, 0.0f);
}

/// Draws the opaque parts first, so that what shows through the others is there. `is_translucent` and
/// `draw` take the number of a part.
template <class Number, class Is, class Draw>
void draw_opaque_first(Number parts, Is is_translucent, Draw draw) {
    for (const bool translucent : {false, true})
        for (Number i = 0; i < parts; ++i) {
            if (is_translucent(i) != translucent)
                continue;
            (translucent ? glEnable : glDisable)(GL_BLEND);
            draw(i);
        }
    glDisable(GL_BLEND);
}

} // namespace spangle::scenes
