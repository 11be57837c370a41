// Makes GL calls of a state's words, on Spangle and on any other GL.
#pragma once

#include "tests/tools/bench/states/words.hpp"

namespace spangle::bench::states {

inline constexpr int canvas_width = 320, canvas_height = 240;

/// Sets everything that the state says in a context with GL's initial state, textures included.
void apply(const State& state);

/// Clears the buffers, and for EQUAL draws the depths. This work is neither counted nor timed.
void prepare(const State& state, int amount);

} // namespace spangle::bench::states
