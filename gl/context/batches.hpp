// What the rest of GL knows of bands that leave out batches of primitives (raster/band/batch_rows.hpp).
#pragma once

#include "gl/context/context.hpp"
#include "gl/vertex/engine.hpp"
#include "raster/band/batch_rows.hpp"

namespace spangle::gl {

/// Between Begin and End, that nothing comes of the vertices.
inline bool leaves_out([[maybe_unused]] const Context& context) {
#if SPANGLE_SKIPS_BATCHES
    return context.drawable.batches != nullptr && context.drawable.batches->leaves_out();
#else
    return false;
#endif
}

/// A batch has begun: wrappers do not even read its vertices where nothing comes of them.
inline void set_left_out(Context& context) {
    const unsigned others = context.gate & ~unsigned{gate_left_out};
    context.gate = static_cast<std::uint8_t>(leaves_out(context) ? others | gate_left_out : others);
}

/// End and Begin of the same primitive.
inline void restart(Context& context) {
    context.engine->end(context);
    context.engine->begin(context, context.primitive);
    set_left_out(context);
}

/// The program is told what differs from band to band, and may draw by it.
inline void distrust_batches([[maybe_unused]] Context& context) {
#if SPANGLE_SKIPS_BATCHES
    if (context.drawable.batches != nullptr)
        context.drawable.batches->distrust();
#endif
}

} // namespace spangle::gl
