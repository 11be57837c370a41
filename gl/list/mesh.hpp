// Draws of vertex arrays in display lists. Elements are copied in the types of their arrays, with indices
// where elements repeat. They are drawn like arrays (GL 1.3, 2.8 and 5.4).
#pragma once

#include "gl/list/record.hpp"
#include "gl/vertex/array_element.hpp"

namespace spangle::gl::list {

/// Records a draw of `count` elements as one primitive. The current arrays must be in memory, not in buffers.
void record_mesh(Context& context, const Player* player, GLenum mode, std::uint32_t count,
                 const Indices& indices);

/// Plays a mesh. Between Begin and End, it raises an error in which `text` names the command. Returns the
/// next record.
const Word* play_mesh(Context& context, const Word* words, const CommandText* text);

} // namespace spangle::gl::list
