// Objects that contexts share: textures, buffers, display lists, and the arena with their memory (GL 1.3,
// 2.2; EGL 1.4, 2.4). Contexts of one group may be current on several threads of a host at once. A command
// that reads or writes shared objects holds the group's lock meanwhile (`shares` in gl/api/commands). A
// primitive holds the lock from Begin to End, so that the textures it samples do not change.
#pragma once

#include "gl/context/arena.hpp"
#include "gl/context/features.hpp"
#include "gl/context/name_table.hpp"
#include "gl/context/threads.hpp"

namespace spangle::gl {

struct LevelImage; // gl/texture/texture_object.hpp defines it

struct ShareGroup {
    explicit ShareGroup(Arena& memory) : arena(memory) {}

    Arena& arena;
    [[no_unique_address]] Lock lock; ///< guards all members except `references`
    std::uint32_t references = 0;    ///< number of contexts and records; the lock of EGL guards it
    /// Counts changes of images and parameters of textures. State that a context compiled from textures at
    /// another count is out of date.
    std::uint32_t texture_changes = 0;
#if SPANGLE_HAS_RECORDS
    /// Number of the current record. Images with this number are used by recorded draws, and must not change.
    std::uint32_t frame = 1;
    LevelImage* kept_images = nullptr; ///< images that only recorded draws still use
#endif
    NameTable textures; ///< names of TextureObject objects
    NameTable buffers;  ///< names of BufferObject objects
    /// Names of lists; each object is the first list::Chunk of a chain, or null for an empty list.
    NameTable lists;
};

} // namespace spangle::gl
