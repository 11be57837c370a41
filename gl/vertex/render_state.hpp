// The render mode, and the state of selection and feedback (GL 1.3, 5.2 and 5.3).
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/limits.hpp"
#include "gl/context/types.hpp"

/// This build gathers POLYGONs that are drawn as a whole, because they are fed back or antialiased.
#define SPANGLE_GATHERS_POLYGONS (SPANGLE_FEATURE_FEEDBACK || SPANGLE_FEATURE_ANTIALIASING)

namespace spangle::gl {

struct SelectState {
    const void* buffer = nullptr; ///< the program's array of GLuint
    GLsizei size = 0;             ///< size of the buffer in words, as given
    GLsizei written = 0;          ///< words written so far
    GLint hits = 0;               ///< records that have ended
    bool given = false;           ///< SelectBuffer was called
    bool overflow = false, hit = false;
    std::uint32_t nearest = 0xFFFFFFFF, farthest = 0; ///< window z times 2^32 - 1, since the last record
    GLint depth = 0;                                  ///< names on the stack
    GLuint name[name_stack_entries] = {};
};

struct FeedbackState {
    const void* buffer = nullptr; ///< the program's array of GLfloat or GLfixed
    GLsizei size = 0;             ///< size of the buffer in words, as given
    GLsizei written = 0;          ///< words written so far
    GLenum type = GL_2D;
    bool given = false; ///< FeedbackBuffer was called
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
    void* gathered = nullptr; ///< in the arena: the pipeline's corners of a POLYGON that has not ended
#endif
#if SPANGLE_GROWS_CACHE
    void* kept_vertices = nullptr; ///< in the arena: the pipeline's vertex cache, if it has grown
#endif
    bool draws() const {
        return mode == GL_RENDER;
    }
};

} // namespace spangle::gl
