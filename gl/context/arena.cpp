// A TLSF allocator, after M. Masmano et al., "TLSF: a new dynamic memory allocator for real-time systems",
// ECRTS 2004. Sizes below 64 bytes have one class per 8 bytes, and larger sizes have 8 classes per power of
// two. Two bitmaps find a class whose blocks all fit, so that every operation takes constant time. A block
// knows its neighbours, so that free blocks are joined at once and never adjacent.
#include "gl/context/arena.hpp"

#include <bit>

namespace spangle::gl {

/// The header of a block. A region is a sequence of blocks that ends with a used block of size 0.
struct ReusingArena::Block {
    std::size_t size_and_free; ///< payload bytes, a multiple of `alignment`; bit 0 is set in a free block
    Block* before;             ///< neighbour below; null for the first block of a region
    // The payload of a free block starts with its two links:
    Block* next_free;
    Block* previous_free;

    static constexpr std::size_t header = 2 * sizeof(void*);
    static constexpr std::size_t smallest = 2 * sizeof(void*); ///< payload bytes that hold the two links

    std::size_t size() const { return size_and_free & ~std::size_t{1}; }
    bool is_free() const { return (size_and_free & 1) != 0; }
    void set(std::size_t size, bool free) { size_and_free = size | (free ? 1u : 0u); }
    unsigned char* payload() { return reinterpret_cast<unsigned char*>(this) + header; }
    Block* after() { return reinterpret_cast<Block*>(payload() + size()); }
};

namespace {

/// Sizes below this number of bytes have one class per multiple of 8.
constexpr std::size_t small_sizes = 64;

constexpr std::size_t round_up(std::size_t bytes) {
    return (bytes + ReusingArena::alignment - 1) & ~(ReusingArena::alignment - 1);
}

} // namespace

ReusingArena::Block* ReusingArena::block_of(void* memory) {
    return reinterpret_cast<Block*>(static_cast<unsigned char*>(memory) - Block::header);
}

ReusingArena::Slot ReusingArena::slot_of(std::size_t size) {
    if (size < small_sizes)
        return {0, static_cast<unsigned>(size / alignment)};
    const unsigned log = static_cast<unsigned>(std::bit_width(size)) - 1;
    return {log - 5, static_cast<unsigned>(size >> (log - second_bits)) & (second_count - 1)};
}

void ReusingArena::insert(Block* block) {
    const Slot slot = slot_of(block->size());
    Block*& head = free_blocks_[slot.first][slot.second];
    block->next_free = head;
    block->previous_free = nullptr;
    if (head != nullptr)
        head->previous_free = block;
    head = block;
    first_level_map_ |= 1u << slot.first;
    second_level_map_[slot.first] =
        static_cast<std::uint8_t>(second_level_map_[slot.first] | 1u << slot.second);
}

void ReusingArena::remove(Block* block) {
    const Slot slot = slot_of(block->size());
    if (block->next_free != nullptr)
        block->next_free->previous_free = block->previous_free;
    if (block->previous_free != nullptr) {
        block->previous_free->next_free = block->next_free;
        return;
    }
    free_blocks_[slot.first][slot.second] = block->next_free;
    if (block->next_free != nullptr)
        return;
    second_level_map_[slot.first] =
        static_cast<std::uint8_t>(second_level_map_[slot.first] & ~(1u << slot.second));
    if (second_level_map_[slot.first] == 0)
        first_level_map_ &= ~(1u << slot.first);
}

/// Returns a free block of at least `size` bytes: the first one of the smallest class whose blocks are all
/// large enough.
ReusingArena::Block* ReusingArena::find(std::size_t size) const {
    if (size >= small_sizes)
        size += (std::size_t{1} << (static_cast<unsigned>(std::bit_width(size)) - 1 - second_bits)) - 1;
    Slot slot = slot_of(size);
    if (slot.first >= first_count)
        return nullptr;
    std::uint32_t seconds = second_level_map_[slot.first] & (~0u << slot.second);
    if (seconds == 0) {
        const std::uint32_t firsts = slot.first + 1 < 32 ? first_level_map_ & (~0u << (slot.first + 1)) : 0;
        if (firsts == 0)
            return nullptr;
        slot.first = static_cast<unsigned>(std::countr_zero(firsts));
        seconds = second_level_map_[slot.first];
    }
    return free_blocks_[slot.first][std::countr_zero(seconds)];
}

void ReusingArena::give(void* memory, std::size_t bytes) {
    const auto start = reinterpret_cast<std::uintptr_t>(memory);
    std::uintptr_t begin = (start + alignment - 1) & ~std::uintptr_t{alignment - 1};
    if (memory == nullptr || bytes <= begin - start)
        return;
    std::size_t left = (bytes - (begin - start)) & ~(alignment - 1);
    constexpr std::size_t largest = std::size_t{1} << (first_count + 4);
    while (left >= 2 * Block::header + Block::smallest) {
        const std::size_t part = left < largest ? left : largest;
        give_region(begin, part);
        begin += part;
        left -= part;
    }
}

void ReusingArena::give_region(std::uintptr_t begin, std::size_t bytes) {
    auto* block = reinterpret_cast<Block*>(begin);
    block->before = nullptr;
    block->set(bytes - 2 * Block::header, true);
    Block* end = block->after();
    end->set(0, false);
    end->before = block;
    insert(block);
    ++region_count_;
    capacity_ += block->size() + Block::header;
}

/// Cuts a used block down to `size` bytes, if the bytes cut off can be a block of their own.
void ReusingArena::split_block(Block* block, std::size_t size) {
    if (block->size() < size + Block::header + Block::smallest)
        return;
    const std::size_t rest = block->size() - size - Block::header;
    block->set(size, false);
    Block* tail = block->after();
    tail->before = block;
    tail->set(rest, false);
    tail->after()->before = tail;
    release(tail);
}

/// Makes a used block free and joins it with free neighbours.
void ReusingArena::release(Block* block) {
    Block* after = block->after();
    std::size_t size = block->size();
    if (after->is_free()) {
        remove(after);
        size += after->size() + Block::header;
    }
    Block* first = block;
    if (block->before != nullptr && block->before->is_free()) {
        first = block->before;
        remove(first);
        size += first->size() + Block::header;
    }
    first->set(size, true);
    first->after()->before = first;
    insert(first);
}

void* ReusingArena::allocate(std::size_t bytes) {
    if (bytes > ~std::size_t{0} / 4)
        return nullptr;
    const std::size_t size = bytes < Block::smallest ? Block::smallest : round_up(bytes);
    Block* block = find(size);
    if (block == nullptr)
        return nullptr;
    remove(block);
    block->set(block->size(), false);
    split_block(block, size);
    used_ += block->size() + Block::header;
    peak_ = used_ > peak_ ? used_ : peak_;
    return block->payload();
}

void ReusingArena::free(void* memory) {
    if (memory == nullptr)
        return;
    Block* block = block_of(memory);
    used_ -= block->size() + Block::header;
    release(block);
}

void ReusingArena::shrink(void* memory, std::size_t bytes) {
    Block* block = block_of(memory);
    const std::size_t size = bytes < Block::smallest ? Block::smallest : round_up(bytes);
    if (size >= block->size())
        return;
    const std::size_t before = block->size();
    split_block(block, size);
    used_ -= before - block->size();
}

bool ReusingArena::consistent() const {
    std::size_t free_bytes = 0, free_blocks = 0;
    for (unsigned first = 0; first < first_count; ++first) {
        if (((first_level_map_ >> first & 1u) != 0) != (second_level_map_[first] != 0))
            return false;
        for (unsigned second = 0; second < second_count; ++second) {
            const Block* previous = nullptr;
            if (((second_level_map_[first] >> second & 1) != 0) != (free_blocks_[first][second] != nullptr))
                return false;
            for (Block* b = free_blocks_[first][second]; b != nullptr; previous = b, b = b->next_free) {
                const Slot slot = slot_of(b->size());
                const bool alone = !b->after()->is_free() && (b->before == nullptr || !b->before->is_free());
                if (!b->is_free() || b->previous_free != previous || slot.first != first ||
                    slot.second != second || !alone || b->after()->before != b ||
                    (b->before != nullptr && b->before->after() != b))
                    return false;
                free_bytes += b->size() + Block::header;
                ++free_blocks;
            }
        }
    }
    return free_bytes + used_ == capacity_ && (used_ != 0 || free_blocks == region_count_);
}

void GrowingArena::give(void* memory, std::size_t bytes) {
    const auto start = reinterpret_cast<std::uintptr_t>(memory);
    const std::size_t skipped = (0 - start) & (alignment - 1);
    if (memory == nullptr || bytes < skipped)
        return;
    next_ = static_cast<unsigned char*>(memory) + skipped;
    remaining_ = bytes - skipped;
}

void* GrowingArena::allocate(std::size_t bytes) {
    if (bytes > remaining_)
        return nullptr;
    const std::size_t wanted = round_up(bytes < alignment ? alignment : bytes);
    if (wanted > remaining_)
        return nullptr;
    unsigned char* const memory = next_;
    next_ += wanted;
    remaining_ -= wanted;
    used_ += wanted;
    return memory;
}

} // namespace spangle::gl
