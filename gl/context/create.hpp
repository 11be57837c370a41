// Functions that EGL calls to create contexts in an arena and to give them their drawable.
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

struct ContextConfig {
    raster::Tier tier = raster::Tier::exact;
    const Engine* engine = nullptr; ///< engine of the numeric policy; it must not be null
};

/// Creates a context with GL's initial state. Null: the arena has no room. With `share`, it shares objects
/// with that context, and `arena` must be that context's arena.
Context* create_context(Arena& arena, const ContextConfig& config, Context* share);

/// Frees the context, and the shared objects with the last context of their group. A current context is
/// released first.
void destroy_context(Context* context);

/// Makes a context current, whose drawable has been set. The first drawable gives viewport, scissor box, draw
/// buffer and read buffer their initial values (GL 1.3, 2.10.1, 4.1.2 and 4.2.1).
void make_current(Context& context);
/// Makes a context current on one surface, which is both drawn to and read from.
void make_current(Context* context, const raster::Surface& surface, bool double_buffered);

/// Moves the context's drawable to another part of the window. `recording` records drawing from now on, or
/// `batches` leaves out batches that do not reach this part. If both are null, neither happens.
void move_drawable(Context& context, const raster::Surface& surface, bool read_too,
                   const Recording* recording = nullptr, raster::BatchRows* batches = nullptr);

#if SPANGLE_HAS_RECORDS
/// hold_objects() keeps the objects that recorded draws refer to until release_objects(), even if the context
/// is destroyed. Earlier images of textures stay until forget_images(), when no record refers to them any
/// more.
ShareGroup* hold_objects(Context& context);
void release_objects(ShareGroup* share);
void forget_images(Context& context);
bool has_objects(const Context& context, const ShareGroup& share);
#endif

} // namespace spangle::gl
