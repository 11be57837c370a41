// What is drawn in a state: the same places in every state of one shape and view.
#pragma once

#include "tests/bench/states/words.hpp"

namespace spangle::bench::states {

inline constexpr int nearest = 1, farthest = 16; ///< distances that are seen

/// How many triangles, lines, points or sprites are enough to count instructions by, and to time.
int amount_to_count(const State& state);
int amount_to_time(const State& state);

/// Computes the vertices of so many, and hands GL arrays of them.
void set_vertices(const State& state, int amount);

/// One call of glDrawArrays.
void draw(const State& state, int amount);

} // namespace spangle::bench::states
