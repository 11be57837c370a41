// The door EGL uses: contexts are made of memory from an arena, and meet their drawable here.
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

struct ContextConfig {
    raster::Tier tier = raster::Tier::exact;
    const Engine* engine = nullptr; ///< the numeric policy; required
};

/// A context with GL's initial state, or null when the arena has no room. With `share`, objects are shared
/// with that context, and the arena is the one it came from.
Context* create_context(Arena& arena, const ContextConfig& config, Context* share);

/// Frees the context, and the shared objects with the last one of a group. Releases it first if it is
/// current.
void destroy_context(Context* context);

/// MakeCurrent's half in GL, of a context whose drawable is set. The first drawable gives viewport, scissor
/// box, draw and read buffer (GL 1.3, 2.10.1, 4.1.2, 4.2.1).
void make_current(Context& context);
/// On one surface, which is drawn to and read.
void make_current(Context* context, const raster::Surface& surface, bool double_buffered);

/// The context's drawable shows another part of itself. From now on drawing is recorded, or batches that do
/// not reach this part are left out, or neither.
void move_drawable(Context& context, const raster::Surface& surface, bool read_too,
                   const Recording* recording = nullptr, raster::BatchRows* batches = nullptr);

#if SPANGLE_HAS_RECORDS
/// The objects that recorded draws look at: they stay while somebody holds them, whatever becomes of the
/// context. Textures' earlier images go with forget_images(), when no record looks at them any more.
ShareGroup* hold_objects(Context& context);
void release_objects(ShareGroup* share);
void forget_images(Context& context);
bool has_objects(const Context& context, const ShareGroup& share);
#endif

} // namespace spangle::gl
