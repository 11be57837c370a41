// Draws a baked model as `spangle run --model` shows models. Firmware draws the model from flash and the host
// from memory, with the same calls.
#pragma once

#include "boards/scenes/model_view.hpp" // comes first, because it names the GL that draws the model

#include <spangle/baked.hpp>

namespace spangle::scenes {

/// The name of a part's texture: the number of the first part that uses the texture, counted from 1. It is 0
/// for a part without a texture.
inline GLuint texture_name(const baked::Mesh& mesh, GLsizei part) {
    const baked::Texture* const texture = mesh.part[part].texture;
    GLuint name = 1;
    while (mesh.part[name - 1].texture != texture)
        ++name;
    return texture != nullptr ? name : 0;
}

inline void setup_baked(const baked::Mesh& mesh, int width, int height) {
    // A sphere of radius 1 at a distance of 3 fits a square viewport in the middle, so the frustum is a
    // constant.
    const int side = width < height ? width : height;
    glViewport((width - side) / 2, (height - side) / 2, side, side);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-0.36, 0.36, -0.36, 0.36, 1.0, 6.0);
    baked::scale_texcoords(mesh);
    glLoadIdentity();
    light_model();
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
    turn_model(frame);
    baked::scale_positions(mesh);
    draw_opaque_first(
        mesh.parts,
        [&](GLsizei i) {
            const baked::Part& part = mesh.part[i];
            return part.diffuse[3] < 1.0f || (part.texture != nullptr && part.texture->translucent);
        },
        [&](GLsizei i) { draw_baked_part(mesh.part[i], texture_name(mesh, i)); });
}

} // namespace spangle::scenes
