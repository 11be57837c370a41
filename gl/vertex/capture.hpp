// Where primitives go that are not drawn: hits of selection, tokens of feedback (GL 1.3, 5.2 and 5.3).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct Context;

/// A vertex of a primitive that reached the view volume while the mode is SELECT; its depth is window z times
/// 2^32 - 1.
void record_hit(Context& context, std::uint32_t depth);

/// A vertex as feedback returns it.
struct FeedbackVertex {
    Real window[4];  ///< x, y, z in the window, w in clip coordinates
    Real color[4];   ///< or the index
    int colors;      ///< how many of them
    Real texture[4]; ///< behind the texture matrix
};

/// While the mode is FEEDBACK: a token, then its vertices.
void feed_token(Context& context, GLenum token);
void feed_count(Context& context, GLint count);
void feed_vertex(Context& context, const FeedbackVertex& vertex);

} // namespace spangle::gl
