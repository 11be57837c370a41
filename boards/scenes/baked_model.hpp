// A baked model as `spangle run --model` shows models: turning in front of one light, opaque parts first.
// Images of firmware draw it from flash, and the host from memory, with the same calls.
#pragma once

#include <initializer_list>

#include "boards/scenes/gl.hpp" // first: the model is drawn with that GL

#include <spangle/baked.hpp>

namespace spangle::scenes {

/// Parts that share a texture share its name, which is that of the first of them; 0: the part has none.
inline GLuint texture_name(const baked::Mesh& mesh, GLsizei part) {
    const baked::Texture* const texture = mesh.part[part].texture;
    GLuint name = 1;
    while (mesh.part[name - 1].texture != texture)
        ++name;
    return texture != nullptr ? name : 0;
}

inline void setup_baked(const baked::Mesh& mesh, int width, int height) {
    static constexpr GLfloat light[4] = {0.4f, 0.7f, 1.0f, 0.0f};
    // The sphere of radius 1 at a distance of 3 fits a square in the middle, so that no frustum is computed.
    const int side = width < height ? width : height;
    glViewport((width - side) / 2, (height - side) / 2, side, side);
    glClearColor(0.125f, 0.25f, 0.375f, 1.0f);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-0.36, 0.36, -0.36, 0.36, 1.0, 6.0);
    baked::scale_texcoords(mesh);
    glLoadIdentity();
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (GLsizei i = 0; i < mesh.parts; ++i) {
        const GLuint name = texture_name(mesh, i);
        if (name != static_cast<GLuint>(i) + 1)
            continue;
        glBindTexture(GL_TEXTURE_2D, name);
        baked::load(*mesh.part[i].texture);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }
}

inline void draw_baked_part(const baked::Part& part, GLuint texture) {
    (texture != 0 ? glEnable : glDisable)(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, texture);
    (part.color.first != nullptr ? glEnable : glDisable)(GL_COLOR_MATERIAL);
    baked::material(part);
    baked::point_arrays(part);
    baked::draw(part);
}

inline void draw_baked(const baked::Mesh& mesh, int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -3.0f);
    glRotatef(18.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(static_cast<float>(30 + 2 * (frame % 180)), 0.0f, 1.0f, 0.0f);
    baked::scale_positions(mesh);
    for (const bool translucent : {false, true})
        for (GLsizei i = 0; i < mesh.parts; ++i) {
            const baked::Part& part = mesh.part[i];
            const bool see_through =
                part.diffuse[3] < 1.0f || (part.texture != nullptr && part.texture->translucent);
            if (see_through != translucent)
                continue;
            (translucent ? glEnable : glDisable)(GL_BLEND);
            draw_baked_part(part, texture_name(mesh, i));
        }
    glDisable(GL_BLEND);
}

} // namespace spangle::scenes
