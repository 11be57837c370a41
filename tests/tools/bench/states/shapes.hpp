// The shapes that are drawn in a state. The places are the same in every state of one shape and view.
#pragma once

#include "tests/tools/bench/states/words.hpp"

namespace spangle::bench::states {

inline constexpr int nearest = 1, farthest = 16; ///< range of visible distances

/// Returns how many triangles, lines, points or sprites are enough to count instructions, and to time.
int amount_to_count(const State& state);
int amount_to_time(const State& state);

/// Computes the vertices of `amount` primitives, and gives GL arrays of them.
void set_vertices(const State& state, int amount);

/// Draws by one call of glDrawArrays.
void draw(const State& state, int amount);

} // namespace spangle::bench::states
