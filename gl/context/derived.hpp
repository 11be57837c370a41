// Tells which derived state depends on a member of the context.
#pragma once

#include <cstddef>

#include "gl/context/context.hpp"

namespace spangle::gl {

/// Returns the derived state that depends on the member `offset` bytes into the context. Vertices depend on
/// matrices, lights, texture units and fog. Fragments depend on everything but client state, queries and
/// lists. Current attributes are compared where they are used, so nothing is derived from them.
constexpr Dirty derived_from(std::size_t offset) {
    static_assert(offsetof(Context, current) < offsetof(Context, polygon) &&
                  offsetof(Context, polygon) < offsetof(Context, fragment_ops) &&
                  offsetof(Context, fragment_ops) < offsetof(Context, fog) &&
                  offsetof(Context, fog) < offsetof(Context, arrays) &&
                  offsetof(Context, eval) < offsetof(Context, lighting) &&
                  offsetof(Context, lighting) < offsetof(Context, texture) &&
                  offsetof(Context, texture) < offsetof(Context, transform));
    const auto among = [offset](std::size_t begin, std::size_t end) {
        return begin <= offset && offset < end;
    };
    if (among(offsetof(Context, current), offsetof(Context, polygon)) ||
        among(offsetof(Context, arrays), offsetof(Context, pixel_mode)) ||
        among(offsetof(Context, list), offsetof(Context, lighting)))
        return dirty_none;
    if (among(offsetof(Context, polygon), offsetof(Context, fog)) ||
        among(offsetof(Context, pixel_mode), offsetof(Context, list)))
        return dirty_fragment;
    return dirty_all;
}

} // namespace spangle::gl
