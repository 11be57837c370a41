// The memory of a display list: a chain of chunks in the arena.
#pragma once

#include "gl/list/record.hpp"

namespace spangle::gl::list {

/// Records never straddle chunks. The last record of a chunk is a link to the next one, of a list the end: a
/// null player.
struct Chunk {
    Chunk* next;
    std::uint32_t words; ///< in `data`

    Word* data() { return reinterpret_cast<Word*>(this + 1); }
};

inline constexpr std::uint32_t link_words = player_words + address_words;

void begin_recording(Context& context);

/// Closes the list and gives its chain; null when there was not memory enough for all of it (nothing is kept
/// then).
Chunk* end_recording(Context& context);

/// Frees a whole chain; null is an empty list.
void free_chain(Arena& arena, Chunk* first);

} // namespace spangle::gl::list
