// What `spangle bake` writes: models and pictures as constants that GL reads where they lie, in flash, and
// the few calls that draw them. Not a byte of them is copied.
#pragma once

#ifndef GL_NO_ERROR // behind the header of another GL: that one
#include <spangle/GL/gl.h>
#endif

namespace spangle::baked {

/// An image of a texture: rows from t = 0 upwards, without gaps. Of a palette: its entries, then all levels.
struct Level {
    GLsizei width, height, bytes;
    const void* texels;
};

struct Texture {
    GLenum internal_format;
    GLenum format, type; ///< of TexImage, for other GLs; 0, 0: compressed
    GLint first;         ///< level of the first image; 1 - n where one image holds the n levels of a palette
    GLsizei images;
    const Level* image;
    bool mipmaps;     ///< the chain is whole
    bool translucent; ///< the picture it was made of has alpha below 1
};

/// An array in interleaved vertices; null: the part has none.
struct Array {
    GLenum type;
    const void* first;
};

/// Elements of one material.
struct Part {
    GLenum mode;
    GLsizei indices;
    GLenum index_type;
    const void* index;
    GLsizei stride; ///< of the arrays
    Array position, normal, texcoord, color;
    GLfloat diffuse[4], specular[4], emission[4]; ///< diffuse is ambient, too
    GLfloat shininess;
    const Texture* texture; ///< null: none
};

struct Mesh {
    GLfloat position_scale; ///< of what the arrays hold to the model, which has radius 1; 1: none
    GLfloat texcoord_scale;
    GLsizei parts;
    const Part* part;
};

/// Gives the images to the bound two-dimensional texture and sets its filters: NEAREST, and the nearest level
/// where there is a chain.
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

/// Multiplies the current matrix (the modelview, mostly) with what makes the model of the arrays. Normals
/// then have another length: GL_RESCALE_NORMAL or GL_NORMALIZE.
inline void scale_positions(const Mesh& mesh) {
    if (mesh.position_scale != 1.0f)
        glScalef(mesh.position_scale, mesh.position_scale, mesh.position_scale);
}

/// Sets the texture matrix; the modelview is current afterwards.
inline void scale_texcoords(const Mesh& mesh) {
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    if (mesh.texcoord_scale != 1.0f)
        glScalef(mesh.texcoord_scale, mesh.texcoord_scale, 1.0f);
    glMatrixMode(GL_MODELVIEW);
}

/// The part's material, where lighting is on; parts with colours of their own want GL_COLOR_MATERIAL instead.
inline void material(const Part& part) {
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, part.diffuse);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, part.specular);
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, part.emission);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, part.shininess);
}

/// Points the arrays at the part and enables those that it has, of the client's first texture unit.
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

/// Draws the elements of the arrays as they are pointed at.
inline void draw(const Part& part) {
    glDrawElements(part.mode, part.indices, part.index_type, part.index);
}

} // namespace spangle::baked
