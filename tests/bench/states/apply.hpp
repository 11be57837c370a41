// A state's words as GL calls, on Spangle and on any other GL.
#pragma once

#include "tests/bench/states/words.hpp"

namespace spangle::bench::states {

inline constexpr int canvas_width = 320, canvas_height = 240;

/// Sets what the state says in a context whose state is GL's default, textures included.
void apply(const State& state);

/// Clears what is drawn on, and for EQUAL draws the depths; nothing of this is counted or timed.
void prepare(const State& state, int amount);

} // namespace spangle::bench::states
