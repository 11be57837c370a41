// Render mode, and what selection and feedback have written (GL 1.3, 5.2 and 5.3).
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/limits.hpp"
#include "gl/context/types.hpp"

/// Some POLYGONs are drawn as wholes: those that are fed back, or antialiased.
#define SPANGLE_GATHERS_POLYGONS (SPANGLE_FEATURE_FEEDBACK || SPANGLE_FEATURE_ANTIALIASING)

namespace spangle::gl {

struct SelectState {
    const void* buffer = nullptr; ///< of GLuint
    GLsizei size = 0;             ///< of the buffer, as given
    GLsizei written = 0;
    GLint hits = 0;     ///< records that are whole
    bool given = false; ///< SelectBuffer was called
    bool overflow = false, hit = false;
    std::uint32_t nearest = 0xFFFFFFFF, farthest = 0; ///< of the hits since the last record
    GLint depth = 0;
    GLuint name[name_stack_entries] = {};
};

struct FeedbackState {
    const void* buffer = nullptr; ///< of GLfloat, or of GLfixed
    GLsizei size = 0;             ///< of the buffer, as given
    GLsizei written = 0;
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
    void* gathered = nullptr; ///< corners of a polygon that has not ended: the pipeline's, in the arena
#endif
#if SPANGLE_GROWS_CACHE
    void* kept_vertices = nullptr; ///< a vertex cache that has grown: the pipeline's, in the arena
#endif
    bool draws() const {
        return mode == GL_RENDER;
    }
};

} // namespace spangle::gl
