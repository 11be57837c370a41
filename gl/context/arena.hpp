// Allocates memory that the board hands over, in bounded time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "gl/context/limits.hpp"
#include "gl/context/threads.hpp"
#ifdef SPANGLE_SEPARATE_BLOCKS
#include "gl/context/separate_arena.hpp"
#endif

namespace spangle::gl {

/// An allocator with two-level segregated fit and immediate coalescing. allocate(), free() and shrink() take
/// constant time, whatever was allocated before. Exhaustion gives null and changes nothing, so that a caller
/// can store a replacement before it frees the old block.
class ReusingArena {
  public:
    static constexpr std::size_t alignment = 8;

    ReusingArena() = default;
    ReusingArena(const ReusingArena&) = delete;
    ReusingArena& operator=(const ReusingArena&) = delete;

    /// Takes over `bytes` bytes at `memory`. Several calls are allowed; their regions are never joined.
    void give(void* memory, std::size_t bytes);

    /// Returns a block aligned to `alignment`, with undefined contents. 0 bytes give a unique block, as
    /// malloc may.
    void* allocate(std::size_t bytes);

    /// Frees a block. Null is ignored.
    void free(void* block);

    /// Returns the tail of a block to the arena, in place. It never fails: a tail too small for a block of
    /// its own stays.
    void shrink(void* block, std::size_t bytes);

    std::size_t used() const { return used_; }         ///< bytes in allocated blocks, their headers included
    std::size_t peak() const { return peak_; }         ///< largest value of used() so far
    std::size_t capacity() const { return capacity_; } ///< bytes that can be handed out in all

    /// Checks every free list, for tests. False: a link, a size, a flag or a bitmap is wrong.
    bool consistent() const;

  private:
    struct Block;
    static constexpr unsigned second_bits = 3;
    static constexpr unsigned second_count = 1u << second_bits;
    static constexpr unsigned first_count = arena_log2 - 5;

    struct Slot {
        unsigned first, second;
    };
    static Slot slot_of(std::size_t size);
    static Block* block_of(void* memory);
    void give_region(std::uintptr_t begin, std::size_t bytes);
    Block* find(std::size_t size) const;
    void insert(Block* block);
    void remove(Block* block);
    void split_block(Block* block, std::size_t size);
    void release(Block* block);

    std::uint32_t first_level_map_ = 0;
    std::uint8_t second_level_map_[first_count] = {};
    Block* free_blocks_[first_count][second_count] = {};
    std::size_t region_count_ = 0;
    std::size_t used_ = 0, peak_ = 0, capacity_ = 0;
};

/// An arena for programs that allocate once. Freed memory is never given out again.
class GrowingArena {
  public:
    static constexpr std::size_t alignment = 8;

    /// Replaces the rest of the memory that was given before.
    void give(void* memory, std::size_t bytes);
    void* allocate(std::size_t bytes);
    void free(void*) {}
    void shrink(void*, std::size_t) {}
    std::size_t used() const { return used_; }
    std::size_t peak() const { return used_; }
    std::size_t capacity() const { return used_ + remaining_; }

  private:
    unsigned char* next_ = nullptr;
    std::size_t used_ = 0, remaining_ = 0;
};

#ifdef SPANGLE_SEPARATE_BLOCKS
using UnguardedArena = SeparateArena;
#else
using UnguardedArena = std::conditional_t<reuses_memory, ReusingArena, GrowingArena>;
#endif

#if SPANGLE_THREADS

/// An arena for all threads. Every call holds its lock.
class Arena : public UnguardedArena {
  public:
    void give(void* memory, std::size_t bytes) {
        const LockGuard held(lock_);
        UnguardedArena::give(memory, bytes);
    }
    /// Gives the memory unless the arena has some already.
    void give_first(void* memory, std::size_t bytes) {
        const LockGuard held(lock_);
        if (UnguardedArena::capacity() == 0)
            UnguardedArena::give(memory, bytes);
    }
    void* allocate(std::size_t bytes) {
        const LockGuard held(lock_);
        return UnguardedArena::allocate(bytes);
    }
    void free(void* block) {
        const LockGuard held(lock_);
        UnguardedArena::free(block);
    }
    void shrink(void* block, std::size_t bytes) {
        const LockGuard held(lock_);
        UnguardedArena::shrink(block, bytes);
    }
    std::size_t used() const {
        const LockGuard held(lock_);
        return UnguardedArena::used();
    }
    std::size_t peak() const {
        const LockGuard held(lock_);
        return UnguardedArena::peak();
    }
    std::size_t capacity() const {
        const LockGuard held(lock_);
        return UnguardedArena::capacity();
    }

  private:
    mutable Lock lock_;
};

#else

class Arena : public UnguardedArena {
  public:
    /// Gives the memory unless the arena has some already.
    void give_first(void* memory, std::size_t bytes) {
        if (capacity() == 0)
            give(memory, bytes);
    }
};

#endif

} // namespace spangle::gl
