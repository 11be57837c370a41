// How a primitive begins and begins anew: by the engine, and for the wrappers of vertices.
#pragma once

#include "gl/context/batches.hpp"
#include "gl/vertex/engine.hpp"

namespace spangle::gl {

/// The primitive of Context::primitive begins. Wrappers do not even read its vertices where its band leaves
/// it out.
inline void begin_batch(Context& context) {
    context.engine->begin(context, context.primitive);
    const unsigned others = context.gate & ~unsigned{gate_left_out};
    context.gate = static_cast<std::uint8_t>(leaves_out(context) ? others | gate_left_out : others);
}

/// End and Begin of the same primitive.
inline void restart(Context& context) {
    context.engine->end(context);
    begin_batch(context);
}

} // namespace spangle::gl
