// The render mode, and the state of selection and feedback (GL 1.3, 5.2 and 5.3).
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/limits.hpp"
#include "gl/context/types.hpp"

/// True if this build gathers POLYGONs that are drawn as a whole, because they are fed back or antialiased.
#define SPANGLE_GATHERS_POLYGONS (SPANGLE_FEATURE_FEEDBACK || SPANGLE_FEATURE_ANTIALIASING)

namespace spangle::gl {

struct SelectState {
    const void* buffer = nullptr; ///< the program's array of GLuint
    GLsizei size = 0;             ///< size of the buffer in words
    GLsizei written = 0;          ///< number of words written
    GLint hits = 0;               ///< number of complete hit records
    bool given = false;           ///< true after SelectBuffer
    bool overflow = false, hit = false;
    /// Window z times 2^32 - 1, of hits since the last record.
    std::uint32_t nearest = 0xFFFFFFFF, farthest = 0;
    GLint depth = 0; ///< number of names on the stack
    GLuint name[name_stack_entries] = {};
};

struct FeedbackState {
    const void* buffer = nullptr; ///< the program's array of GLfloat or GLfixed
    GLsizei size = 0;             ///< size of the buffer in words
    GLsizei written = 0;          ///< number of words written
    GLenum type = GL_2D;
    bool given = false; ///< true after FeedbackBuffer
    bool overflow = false, fixed = false;
};

struct RenderState {
#if SPANGLE_FEATURE_SELECTION || SPANGLE_FEATURE_FEEDBACK
    GLenum mode = GL_RENDER;
#else
    static constexpr GLenum mode = GL_RENDER;
#endif
#if SPANGLE_FEATURE_SELECTION
    SelectState select;
#endif
#if SPANGLE_FEATURE_FEEDBACK
    FeedbackState feedback;
#endif
#if SPANGLE_GATHERS_POLYGONS
    /// Corners of a POLYGON that has not ended, which the pipeline keeps in the arena.
    void* gathered = nullptr;
#endif
#if SPANGLE_GROWS_CACHE
    void* kept_vertices = nullptr; ///< vertex cache of the pipeline in the arena, if the cache has grown
#endif
    bool draws() const {
        return mode == GL_RENDER;
    }
};

} // namespace spangle::gl
