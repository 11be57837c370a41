// Draws of vertex arrays in display lists: their elements are copied as they lie in the arrays, each once,
// with indices that say which comes when (GL 1.3, 2.8 and 5.4). They are drawn as the arrays are.
#pragma once

#include "gl/list/record.hpp"
#include "gl/vertex/array_element.hpp"

namespace spangle::gl::list {

/// Records a draw of `count` elements from the arrays of this moment, which lie in memory, as one primitive.
void record_mesh(Context& context, const Player* player, GLenum mode, std::uint32_t count,
                 const Indices& indices);

/// Draws it, unless between Begin and End; `text` names the command then. Returns the next record.
const Word* play_mesh(Context& context, const Word* words, const CommandText* text);

} // namespace spangle::gl::list
