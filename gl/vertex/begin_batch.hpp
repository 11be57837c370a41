// Begins and restarts primitives: in the engine, and in the gate that wrappers of vertex commands read.
#pragma once

#include "gl/context/batches.hpp"
#include "gl/vertex/engine.hpp"

namespace spangle::gl {

/// Begins a primitive of mode Context::primitive. If the current band leaves the primitive out, the gate
/// keeps the wrappers from reading its vertices.
inline void begin_batch(Context& context) {
    context.engine->begin(context, context.primitive);
    const unsigned others = context.gate & ~unsigned{gate_left_out};
    context.gate = static_cast<std::uint8_t>(is_skipped(context) ? others | gate_left_out : others);
}

/// Ends the primitive and begins another one of the same mode.
inline void restart_primitive(Context& context) {
    context.engine->end(context);
    begin_batch(context);
}

} // namespace spangle::gl
