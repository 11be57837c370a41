// The vertices that clipping makes of one primitive.
//
// ClippedVertexPool owns a fixed number of vertices, and knows which of them are corners of the polygon that
// is being clipped. A vertex that one plane cut off is free for the next plane. The pool never allocates
// memory.
#pragma once

#include <bit>
#include <cstdint>

namespace spangle::gl {

/// `Count` vertices of the kind `Clipped`.
template <class Clipped, int Count> class ClippedVertexPool {
  public:
    static_assert(Count <= 32);

    Clipped& operator[](int i) { return vertex_[i]; }
    /// Takes a free vertex. Null: all vertices are corners.
    Clipped* take() {
        if (free_ == 0)
            return nullptr;
        const int i = std::countr_zero(free_);
        free_ &= free_ - 1;
        return &vertex_[i];
    }
    /// Frees all vertices except the n corners. Corners may lie elsewhere.
    template <class V> void keep(V* const* corners, int n);

  private:
    /// Bit i is set if vertex_[i] is free.
    std::uint32_t free_ = 0;
    Clipped vertex_[Count];
};

template <class Clipped, int Count>
template <class V>
[[gnu::noinline]] void ClippedVertexPool<Clipped, Count>::keep(V* const* corners, int n) {
    free_ = static_cast<std::uint32_t>((std::uint64_t{1} << Count) - 1);
    for (int i = 0; i < n; ++i) {
        const std::uintptr_t at =
            reinterpret_cast<std::uintptr_t>(corners[i]) - reinterpret_cast<std::uintptr_t>(vertex_);
        if (at < sizeof vertex_)
            free_ &= ~(1u << at / sizeof(Clipped));
    }
}

} // namespace spangle::gl
