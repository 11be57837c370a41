// A table from names, such as those of textures or display lists, to objects. A share group has one for each
// kind of object.
#pragma once

#include <cstdint>

namespace spangle::gl {

class Arena;

/// A hash table with open addressing and linear probing. Its size is a power of two, and at most three
/// quarters are used. A name may be present with a null object: GenTextures reserves names, and GenLists
/// makes empty lists.
class NameTable {
  public:
    struct Entry {
        std::uint32_t name; ///< 0 marks a free entry
        void* object;
    };

    /// Returns where the object of a name is stored, valid until the table changes. Null: the name is not
    /// present.
    void** find(std::uint32_t name) const;

    /// Adds a name, which must not be 0. False: there is no memory, and nothing changed.
    bool insert(Arena& arena, std::uint32_t name, void* object);

    /// Makes room for `more` names, so that as many calls of insert() cannot fail.
    bool reserve(Arena& arena, std::uint32_t more);

    /// Removes a name and returns its object. Null: the name was not present.
    void* remove(std::uint32_t name);

    /// Returns the first of `range` consecutive unused names, or 0 if there are none. `range` must be above
    /// 0.
    std::uint32_t unused(std::uint32_t range) const;

    /// Frees the array, not the objects.
    void clear(Arena& arena);

    std::uint32_t count() const { return count_; }
    std::uint32_t capacity() const { return capacity_; }
    /// Returns entry `index`, from 0 to capacity() - 1, for visits of all names. Free entries have the name
    /// 0.
    Entry& slot(std::uint32_t index) const { return entries_[index]; }

  private:
    std::uint32_t hash_slot(std::uint32_t name) const { return name * 2654435769u >> hash_shift_; }
    void place(std::uint32_t name, void* object);
    std::uint32_t index_of(std::uint32_t name) const;

    Entry* entries_ = nullptr;
    std::uint32_t capacity_ = 0, count_ = 0;
    unsigned hash_shift_ = 0; ///< 32 - log2(capacity), if the capacity is not 0
};

} // namespace spangle::gl
