// How models are shown: they turn in front of one light, and opaque parts are drawn first. Models from files
// and baked models share this code.
#pragma once

#include <initializer_list>

#include "boards/scenes/gl.hpp"

namespace spangle::scenes {

/// Sets the light and the state of all parts. The modelview matrix must be current, and the identity.
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

/// Clears the picture, and turns the model by two degrees a frame.
inline void turn_model(int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -3.0f);
    glRotatef(18.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(static_cast<float>(30 + 2 * (frame % 180)), 0.0f, 1.0f, 0.0f);
}

/// Draws the opaque parts before the translucent parts that they show through. `is_translucent` and `draw`
/// take the number of a part.
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
