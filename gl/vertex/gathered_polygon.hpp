// The corners of a POLYGON that is drawn as a whole, when it ends.
//
// GatheredPolygon owns an array in the arena, which grows with the polygon. It promises that an arena without
// room changes nothing but has_failed(), and that free() gives all of its memory back.
#pragma once

#include <cstddef>
#include <new>

#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"

#if SPANGLE_GATHERS_POLYGONS

namespace spangle::gl {

template <class Clipped> class GatheredPolygon {
  public:
    int count() const { return count_; }
    /// True if the arena had no room for all corners.
    bool has_failed() const { return failed_; }
    Clipped& operator[](int i) const { return corner_[i]; }

    /// Returns a new corner after the others, or null if the arena has no room. When the array is full, one
    /// of twice the size replaces it.
    Clipped* add(Context& context) {
        if (count_ == capacity_) {
            const int room = capacity_ != 0 ? 2 * capacity_ : 8;
            void* const memory =
                room < (1 << 20) ? context.arena->allocate(sizeof(Clipped) * static_cast<std::size_t>(room))
                                 : nullptr;
            failed_ = failed_ || memory == nullptr;
            if (memory == nullptr)
                return nullptr;
            auto* const more = static_cast<Clipped*>(memory);
            for (int i = 0; i < count_; ++i)
                new (more + i) Clipped(corner_[i]);
            context.arena->free(corner_);
            context.render.gathered = corner_ = more;
            capacity_ = room;
        }
        return new (corner_ + count_++) Clipped;
    }

    /// Forgets all corners, and gives their memory back.
    void free(Context& context) {
        context.arena->free(corner_);
        context.render.gathered = corner_ = nullptr;
        count_ = capacity_ = 0;
        failed_ = false;
    }

  private:
    Clipped* corner_ = nullptr;
    int count_ = 0, capacity_ = 0;
    bool failed_ = false;
};

} // namespace spangle::gl

#endif
