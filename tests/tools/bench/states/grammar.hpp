// Defines the states: number n of a seed is the same state on every machine and in every program.
#pragma once

#include "tests/tools/bench/states/words.hpp"

namespace spangle::bench::states {

/// A key is everything but surface and tier. Each key is drawn on both surfaces in each tier, so number n has
/// key n / 6.
inline constexpr std::uint32_t variants = 6;

/// Keys come in pairs of neighbours: an odd key differs from the key before it in one word.
State state(std::uint32_t seed, std::uint32_t number);

/// Returns whether the word has a meaning with the words before it.
bool applies(const State& state, Word word);

/// Counts the words that apply to both states and differ. If only one state has a texture, this counts as one
/// word, whatever follows from it.
int distance(const State& a, const State& b);

/// Returns a state of the same shape that nothing hides and nothing colours. Costs of both GLs are divided by
/// its fragments.
State bare(const State& state);

} // namespace spangle::bench::states
