#include "gl/context/name_table.hpp"

#include <cstring>

#include "gl/context/arena.hpp"

namespace spangle::gl {

/// Returns the index of `name`, or of the free entry where `name` would be stored. The loop ends because the
/// table is never full.
std::uint32_t NameTable::index_of(std::uint32_t name) const {
    std::uint32_t i = hash_slot(name);
    while (entries_[i].name != 0 && entries_[i].name != name)
        i = (i + 1) & (capacity_ - 1);
    return i;
}

void** NameTable::find(std::uint32_t name) const {
    if (name == 0 || count_ == 0)
        return nullptr;
    Entry& entry = entries_[index_of(name)];
    return entry.name == 0 ? nullptr : &entry.object;
}

void NameTable::place(std::uint32_t name, void* object) {
    entries_[index_of(name)] = {name, object};
}

bool NameTable::reserve(Arena& arena, std::uint32_t more) {
    // More names need more than 2 GiB, for which no arena has room.
    constexpr std::uint32_t most_names = 3u << 26;
    if (more > most_names - count_)
        return false;
    const std::uint32_t wanted = count_ + more;
    if (wanted * 4 <= capacity_ * 3)
        return true;
    unsigned log = 3;
    while (wanted * 4 > 3u << log)
        ++log;
    auto* larger = static_cast<Entry*>(arena.allocate(sizeof(Entry) << log));
    if (larger == nullptr)
        return false;
    Entry* const old = entries_;
    const std::uint32_t old_capacity = capacity_;
    entries_ = larger;
    capacity_ = std::uint32_t{1} << log;
    hash_shift_ = 32 - log;
    std::memset(static_cast<void*>(entries_), 0, sizeof(Entry) << log);
    for (std::uint32_t i = 0; i < old_capacity; ++i)
        if (old[i].name != 0)
            place(old[i].name, old[i].object);
    arena.free(old);
    return true;
}

bool NameTable::insert(Arena& arena, std::uint32_t name, void* object) {
    if (!reserve(arena, 1))
        return false;
    place(name, object);
    ++count_;
    return true;
}

void* NameTable::remove(std::uint32_t name) {
    void** const found = find(name);
    if (found == nullptr)
        return nullptr;
    void* const object = *found;
    std::uint32_t hole = index_of(name);
    // Later entries of the same cluster are moved over the hole (D. Knuth, TAOCP 3, 6.4, algorithm R).
    for (std::uint32_t i = (hole + 1) & (capacity_ - 1); entries_[i].name != 0;
         i = (i + 1) & (capacity_ - 1)) {
        const std::uint32_t from_home = (i - hash_slot(entries_[i].name)) & (capacity_ - 1);
        const std::uint32_t from_hole = (i - hole) & (capacity_ - 1);
        if (from_home >= from_hole) {
            entries_[hole] = entries_[i];
            hole = i;
        }
    }
    entries_[hole] = {0, nullptr};
    --count_;
    return object;
}

std::uint32_t NameTable::unused(std::uint32_t range) const {
    std::uint32_t highest = 0;
    for (std::uint32_t i = 0; i < capacity_; ++i)
        highest = entries_[i].name > highest ? entries_[i].name : highest;
    if (UINT32_MAX - highest >= range)
        return highest + 1;
    // Names near 2^32 are taken. The search therefore steps over the highest name in the way until no name is
    // in the way.
    std::uint32_t first = 1;
    for (std::uint32_t tries = 0; tries <= count_ && UINT32_MAX - first >= range - 1; ++tries) {
        std::uint32_t in_the_way = 0;
        for (std::uint32_t i = 0; i < capacity_; ++i) {
            const std::uint32_t name = entries_[i].name;
            if (name >= first && name - first < range && name > in_the_way)
                in_the_way = name;
        }
        if (in_the_way == 0)
            return first;
        if (in_the_way == UINT32_MAX)
            return 0;
        first = in_the_way + 1;
    }
    return 0;
}

void NameTable::clear(Arena& arena) {
    arena.free(entries_);
    *this = NameTable{};
}

} // namespace spangle::gl
