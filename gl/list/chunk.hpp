// Memory of a display list, as a chain of chunks in the arena.
#pragma once

#include "gl/list/record.hpp"

namespace spangle::gl::list {

/// A part of a display list. No record crosses the end of a chunk. The last record of a chunk links to the
/// next chunk; in the last chunk it is a null player, which ends the list.
struct Chunk {
    Chunk* next;
    std::uint32_t words; ///< number of words at data()

    Word* data() { return reinterpret_cast<Word*>(this + 1); }
};

inline constexpr std::uint32_t link_words = player_words + address_words;

void begin_recording(Context& context);

/// Ends the list and returns its chain. Null: memory ran out, and the list was freed.
Chunk* end_recording(Context& context);

/// Frees a whole chain. Null is an empty list.
void free_chain(Arena& arena, Chunk* first);

} // namespace spangle::gl::list
