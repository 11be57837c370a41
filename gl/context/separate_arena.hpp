// An arena whose blocks are separate heap allocations, so that a memory checker sees the bounds of each. Only
// tests are built with it (SPANGLE_SEPARATE_BLOCKS).
#pragma once

#include <cstddef>
#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__)
#define SPANGLE_POISONS 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SPANGLE_POISONS 1
#endif
#endif
#ifdef SPANGLE_POISONS
#include <sanitizer/asan_interface.h>
#endif

namespace spangle::gl {

/// Has the interface of ReusingArena. Memory that is given is not used; its size only bounds how much is
/// handed out at a time.
class SeparateArena {
  public:
    static constexpr std::size_t alignment = 8;

    void give(void*, std::size_t bytes) { capacity_ += bytes; }
    void* allocate(std::size_t bytes) {
        if (bytes > capacity_ - used_)
            return nullptr;
        void* const memory = std::malloc(sizeof(Header) + bytes);
        if (memory == nullptr)
            return nullptr;
        auto* const header = static_cast<Header*>(memory);
        header->bytes = bytes;
        used_ += bytes;
        peak_ = used_ > peak_ ? used_ : peak_;
        poison(header, sizeof(Header)); // writes below a block are caught, too
        return header + 1;
    }
    void free(void* block) {
        if (block == nullptr)
            return;
        Header* const header = header_of(block);
        used_ -= header->bytes;
        std::free(header);
    }
    /// Cuts a block down to `bytes`. The block keeps its tail, but the checker reports accesses to the tail.
    void shrink(void* block, std::size_t bytes) {
        Header* const header = header_of(block);
        if (bytes < header->bytes) {
            poison(static_cast<unsigned char*>(block) + bytes, header->bytes - bytes);
            used_ -= header->bytes - bytes;
            header->bytes = bytes;
        }
        poison(header, sizeof(Header));
    }
    std::size_t used() const { return used_; }
    std::size_t peak() const { return peak_; }
    std::size_t capacity() const { return capacity_; }
    /// Checks the byte counts only, since the memory checker reports damage.
    bool consistent() const { return used_ <= capacity_; }

  private:
    /// The header has the largest alignment, so that the block behind it has it, too.
    struct alignas(std::max_align_t) Header {
        std::size_t bytes;
    };

    static Header* header_of(void* block) {
        Header* const header = static_cast<Header*>(block) - 1;
#ifdef SPANGLE_POISONS
        ASAN_UNPOISON_MEMORY_REGION(header, sizeof(Header));
#endif
        return header;
    }
    static void poison([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef SPANGLE_POISONS
        ASAN_POISON_MEMORY_REGION(memory, bytes);
#endif
    }

    std::size_t used_ = 0, peak_ = 0, capacity_ = 0;
};

} // namespace spangle::gl
