// What contexts share: texture objects, display lists, and the memory they lie in (GL 1.3, 2.2;
// EGL 1.4, 2.4). Contexts of one group, and the arena under them, belong to one thread at a time.
#pragma once

#include "gl/context/arena.hpp"
#include "gl/context/features.hpp"
#include "gl/context/name_table.hpp"

namespace spangle::gl {

struct LevelImage; // gl/texture/texture_object.hpp

struct ShareGroup {
    explicit ShareGroup(Arena& memory) : arena(memory) {}

    Arena& arena;
    std::uint32_t references = 0; ///< contexts
    /// Images and parameters stored: what any context compiled of textures before is stale.
    std::uint32_t texture_changes = 0;
#if SPANGLE_HAS_RECORDS
    /// Images with this number are looked at by draws that were recorded, and stay as they are.
    std::uint32_t frame = 1;
    LevelImage* kept_images = nullptr; ///< such images of no texture any more
#endif
    NameTable textures; ///< to TextureObject
    NameTable buffers;  ///< to BufferObject
    NameTable lists;    ///< to list::Chunk, the first of its chain; null for an empty list
};

} // namespace spangle::gl
