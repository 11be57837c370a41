#include "gl/pixel/compiled_state_cache.hpp"

#include <cstring>

#include "gl/vertex/engine.hpp"

namespace spangle::gl {

void CompiledStateCache::compile(const Engine& engine, const raster::FragmentState& state,
                                 const raster::Surface& target, std::uint32_t texture_changes,
                                 raster::DrawState& out) {
    const CacheKey origin = {texture_changes,
                             target.format,
                             target.depth_format,
                             target.depth != nullptr,
                             target.depth_stride == target.color_stride,
                             true};
    for (const Entry& kept : entries_)
        // The comparison includes padding. If padding differs, the state is compiled again, with the same
        // result.
        if (kept.origin == origin && std::memcmp(static_cast<const void*>(&kept.state.fragment),
                                                 static_cast<const void*>(&state), sizeof state) == 0) {
            std::memcpy(static_cast<void*>(&out), &kept.state, sizeof out);
            return;
        }
    engine.compile(state, target, out);
    Entry& kept = entries_[next_replaced_];
    next_replaced_ = (next_replaced_ + 1) % (sizeof entries_ / sizeof entries_[0]);
    kept.origin = origin;
    std::memcpy(static_cast<void*>(&kept.state), &out, sizeof out);
}

} // namespace spangle::gl
