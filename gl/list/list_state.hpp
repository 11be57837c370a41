// State of display lists: base, nesting, and the list that is being compiled (GL 1.3, 5.4).
#pragma once

#include "gl/context/features.hpp"
#include "gl/context/types.hpp"
#include "gl/context/watch.hpp"

namespace spangle::gl {

namespace list {
using Word = std::uint32_t;
struct Chunk;
} // namespace list

/// A list that is being compiled: a chain of chunks, and the run of vertices that is still open.
struct ListRecorder {
    list::Chunk* first = nullptr;
    list::Chunk* last = nullptr;
    list::Word* write = nullptr; ///< next free word in `last`
    list::Word* end = nullptr;   ///< end of `last`, less the words of a link
    /// True if the list is lost. EndList reports that and keeps the old list.
    bool out_of_memory = false;
    list::Word* run = nullptr; ///< header word of the open run, or null
#if SPANGLE_TELLS_REACH
    std::uint32_t vertices = 0; ///< number of vertices recorded so far
#endif
    std::uint32_t pending = 0;              ///< attributes given since the last vertex (list::Field bits)
    Real color[4], normal[3], tex_coord[4]; ///< values of the pending attributes
};

struct ListState {
    GLuint base = 0;
    GLuint index = 0;     ///< name of the list being compiled; 0: none
    GLenum mode = 0;      ///< COMPILE, COMPILE_AND_EXECUTE, or 0
    bool execute = false; ///< true if `mode` is COMPILE_AND_EXECUTE
#if SPANGLE_FEATURE_LISTS
    std::uint32_t depth = 0;
    const list::Word* return_to[max_list_nesting] = {}; ///< positions at which calling lists continue
    ListRecorder recorder;
#endif
};

} // namespace spangle::gl
