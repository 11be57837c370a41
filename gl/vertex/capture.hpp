// Takes primitives that are not drawn: as hits of selection, or as words of feedback (GL 1.3, 5.2 and 5.3).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct Context;

/// Records a vertex of a primitive that meets the view volume, while the mode is SELECT. `depth` is window z
/// times 2^32 - 1.
void record_hit(Context& context, std::uint32_t depth);

/// A vertex as feedback returns it.
struct FeedbackVertex {
    Real window[4];  ///< window x, y, z; w of the clip coordinates
    Real color[4];   ///< RGBA, or the colour index in color[0]
    int colors;      ///< values in `color`: 4 or 1
    Real texture[4]; ///< s, t, r, q behind the texture matrix
};

/// Write a primitive to the feedback buffer, while the mode is FEEDBACK: a token, the number of vertices if
/// the token is that of a polygon, then each vertex.
void feed_token(Context& context, GLenum token);
void feed_count(Context& context, GLint count);
void feed_vertex(Context& context, const FeedbackVertex& vertex);

} // namespace spangle::gl
