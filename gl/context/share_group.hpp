// What contexts share: texture objects, display lists, and the memory they lie in (GL 1.3, 2.2;
// EGL 1.4, 2.4). Contexts of one group may be current on several threads of a host at once. A command that
// reads or writes what they share holds the group's lock meanwhile (`shares` in gl/api/commands), and a
// primitive holds it from Begin to End: the textures it samples stay as they are.
#pragma once

#include "gl/context/arena.hpp"
#include "gl/context/features.hpp"
#include "gl/context/name_table.hpp"
#include "gl/context/threads.hpp"

namespace spangle::gl {

struct LevelImage; // gl/texture/texture_object.hpp

struct ShareGroup {
    explicit ShareGroup(Arena& memory) : arena(memory) {}

    Arena& arena;
    [[no_unique_address]] Lock lock; ///< guards all but `references`
    std::uint32_t references = 0;    ///< contexts and records; EGL's lock guards it
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
