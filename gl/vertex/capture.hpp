// Takes primitives that are not drawn: as hits in render mode SELECT, and as words in FEEDBACK (GL 1.3, 5.2
// and 5.3).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct Context;

/// Records a hit for a vertex of a primitive that meets the view volume, in render mode SELECT. `depth` is
/// window z times 2^32 - 1.
void record_hit(Context& context, std::uint32_t depth);

/// A vertex in the form that feedback returns.
struct FeedbackVertex {
    Real window[4];  ///< window x, y and z, and w of the clip coordinates
    Real color[4];   ///< RGBA, or the colour index in color[0]
    int colors;      ///< number of values in `color`, 4 or 1
    Real texture[4]; ///< s, t, r and q after the texture matrix
};

/// These functions write a primitive to the feedback buffer, in render mode FEEDBACK: first its token, then
/// each vertex. A polygon has its number of vertices after the token.
void feed_token(Context& context, GLenum token);
void feed_count(Context& context, GLint count);
void feed_vertex(Context& context, const FeedbackVertex& vertex);

} // namespace spangle::gl
