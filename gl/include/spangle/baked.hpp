// Types of the constants that `spangle bake` writes from models and pictures, and the few calls that draw
// them. Spangle reads the constants where they lie, in flash, and copies no byte of them. A function raises
// the GL errors of the GL commands that it calls.
#pragma once

#ifndef GL_NO_ERROR // if the header of another GL was included first, that GL is used
#include <spangle/GL/gl.h>
#endif

namespace spangle::baked {

/// An image of a texture: rows of texels from t = 0 upwards, without gaps. The image of a texture with a
/// palette has the palette's entries first, then the indices of all levels.
struct Level {
    GLsizei width, height, bytes; ///< size in texels, and of `texels` in bytes
    /// The texels, constant and static.
    const void* texels;
};

/// A texture with its images, for load().
struct Texture {
    /// The internal format of glTexImage2D or glCompressedTexImage2D.
    GLenum internal_format;
    GLenum format, type; ///< arguments of glTexImage2D, for other GLs; 0, 0: a compressed format
    GLint first;         ///< level of the first image; 1 - n where one image has all n levels and a palette
    GLsizei images;      ///< number of images in `image`
    /// The images, from the largest on.
    const Level* image;
    bool mipmaps;     ///< the texture has its whole chain of levels
    bool translucent; ///< the baked picture had alpha below 1
};

/// One array of a part's interleaved vertices. `first` is null where the part has no such array.
struct Array {
    GLenum type;       ///< type of a component, such as GL_SHORT
    const void* first; ///< the first element
};

/// A part of a model: elements with one material.
struct Part {
    GLenum mode;       ///< mode of glDrawElements
    GLsizei indices;   ///< number of indices
    GLenum index_type; ///< GL_UNSIGNED_BYTE, SHORT or INT
    /// The indices, constant and static.
    const void* index;
    GLsizei stride; ///< bytes from one vertex to the next, in all arrays
    /// The arrays: three components of a position, three of a normal, two texture coordinates, four of a
    /// colour.
    Array position, normal, texcoord, color;
    GLfloat diffuse[4], specular[4], emission[4]; ///< RGBA, 1 is full; `diffuse` is the ambient colour, too
    GLfloat shininess;                            ///< exponent, 0 to 128
    const Texture* texture;                       ///< null: the part has no texture
};

/// A model, which has radius 1, as `spangle bake` writes it.
struct Mesh {
    GLfloat position_scale; ///< model units per unit of the position arrays; 1: not scaled
    GLfloat texcoord_scale; ///< coordinate units per unit of the texture coordinate arrays; 1: not scaled
    GLsizei parts;          ///< number of parts in `part`
    /// The parts, in the order in which they are drawn.
    const Part* part;
};

/// Gives the images to the bound two-dimensional texture, and sets its filters: GL_NEAREST, and the nearest
/// level where the texture has mipmaps.
inline void load(const Texture& texture) {
    for (GLsizei i = 0; i < texture.images; ++i) {
        const Level& level = texture.image[i];
#ifdef SPANGLE_GL
        if (texture.format == 0)
            glCompressedTexConstantImage2DSPANGLE(GL_TEXTURE_2D, texture.first + i, texture.internal_format,
                                                  level.width, level.height, 0, level.bytes, level.texels);
        else
            glTexConstantImage2DSPANGLE(GL_TEXTURE_2D, texture.first + i, texture.internal_format,
                                        level.width, level.height, 0, level.bytes, level.texels);
#else
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, texture.first + i, static_cast<GLint>(texture.internal_format),
                     level.width, level.height, 0, texture.format, texture.type, level.texels);
#endif
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    texture.mipmaps ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

/// Scales the current matrix, which is usually the modelview matrix, so that the position arrays have the
/// size of the model. The scale also changes the length of normals, so lighting needs GL_RESCALE_NORMAL or
/// GL_NORMALIZE.
inline void scale_positions(const Mesh& mesh) {
    if (mesh.position_scale != 1.0f)
        glScalef(mesh.position_scale, mesh.position_scale, mesh.position_scale);
}

/// Sets the texture matrix to scale the texture coordinate arrays. Afterwards the matrix mode is
/// GL_MODELVIEW.
inline void scale_texcoords(const Mesh& mesh) {
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    if (mesh.texcoord_scale != 1.0f)
        glScalef(mesh.texcoord_scale, mesh.texcoord_scale, 1.0f);
    glMatrixMode(GL_MODELVIEW);
}

/// Sets the part's material for both faces, for use with lighting. A part with a colour array needs
/// GL_COLOR_MATERIAL instead.
inline void material(const Part& part) {
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, part.diffuse);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, part.specular);
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, part.emission);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, part.shininess);
}

/// Sets the vertex arrays to those of the part. Enables the arrays that the part has and disables the others.
/// Texture coordinates go to the unit that glClientActiveTexture has set.
inline void point_arrays(const Part& part) {
    const auto enable = [](GLenum array, const void* has) {
        if (has != nullptr)
            glEnableClientState(array);
        else
            glDisableClientState(array);
    };
    glVertexPointer(3, part.position.type, part.stride, part.position.first);
    if (part.normal.first != nullptr)
        glNormalPointer(part.normal.type, part.stride, part.normal.first);
    if (part.texcoord.first != nullptr)
        glTexCoordPointer(2, part.texcoord.type, part.stride, part.texcoord.first);
    if (part.color.first != nullptr)
        glColorPointer(4, part.color.type, part.stride, part.color.first);
    enable(GL_VERTEX_ARRAY, part.position.first);
    enable(GL_NORMAL_ARRAY, part.normal.first);
    enable(GL_TEXTURE_COORD_ARRAY, part.texcoord.first);
    enable(GL_COLOR_ARRAY, part.color.first);
}

/// Draws the part's elements from the arrays that point_arrays() has set.
inline void draw(const Part& part) {
    glDrawElements(part.mode, part.indices, part.index_type, part.index);
}

} // namespace spangle::baked
