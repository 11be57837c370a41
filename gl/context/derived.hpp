// Tells which derived state depends on a member of the context.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>

#include "gl/context/context.hpp"

namespace spangle::gl {

namespace detail {

/// The members of the context from an offset on, and what is derived from them.
struct DerivedPart {
    std::uint16_t begin;
    std::uint16_t dirty; ///< set of Dirty bits
};

/// Parts of the context in the order of their offsets; each ends where the next one begins. Vertices depend
/// on matrices, lights, texture units and fog. Fragments depend on everything but client state, queries,
/// lists, lights and materials. Current attributes are compared where they are used, so nothing is derived
/// from them. The matrix mode chooses a matrix, and nothing is derived from it either.
inline constexpr DerivedPart derived_parts[] = {
    {0, dirty_all},
    {offsetof(Context, current), dirty_none},
    {offsetof(Context, polygon), dirty_fragment},
    {offsetof(Context, fog), dirty_others | dirty_fragment},
    {offsetof(Context, arrays), dirty_none},
    {offsetof(Context, pixel_mode), dirty_fragment},
    {offsetof(Context, list), dirty_none},
    {offsetof(Context, lighting), dirty_normals | dirty_fragment},
#if SPANGLE_FEATURE_LIGHTING
    {offsetof(Context, lighting.light_enabled), dirty_lights | dirty_fragment},
    {offsetof(Context, lighting.light), dirty_lights},
    {offsetof(Context, lighting.material), dirty_materials},
#endif
    {offsetof(Context, texture), dirty_others | dirty_fragment},
    {offsetof(Context, transform), dirty_none},
    {offsetof(Context, transform.viewport), dirty_viewport | dirty_fragment},
    {offsetof(Context, transform.normalize), dirty_normals},
#if SPANGLE_FEATURE_CLIP_PLANES
    {offsetof(Context, transform.clip_plane_on), dirty_others},
#endif
    {offsetof(Context, transform.projection), dirty_transform},
};

constexpr bool derived_parts_are_in_order() {
    std::uint16_t last = 0;
    for (const DerivedPart& part : derived_parts) {
        if (part.begin < last)
            return false;
        last = part.begin;
    }
    return true;
}
static_assert(derived_parts_are_in_order());

} // namespace detail

/// Returns the derived state that depends on the member `offset` bytes into the context.
constexpr Dirty derived_from(std::size_t offset) {
    const detail::DerivedPart* part = detail::derived_parts + std::size(detail::derived_parts);
    do
        --part;
    while (offset < part->begin);
    return static_cast<Dirty>(part->dirty);
}

} // namespace spangle::gl
