// Which states there are: number n of a seed is the same state on every machine and in every program.
#pragma once

#include "tests/bench/states/words.hpp"

namespace spangle::bench::states {

/// Each key, which is all but surface and tier, is drawn on both surfaces in each tier: number n is key n
/// / 6.
inline constexpr std::uint32_t variants = 6;

/// Keys come in pairs of neighbours: an odd key differs from the one before it in one word.
State state(std::uint32_t seed, std::uint32_t number);

/// Whether the word means anything beside those before it.
bool applies(const State& state, Word word);

/// Words that apply to both states and differ. The texture of one that has none is one word, whatever follows
/// from it.
int distance(const State& a, const State& b);

/// The same shape, which nothing hides and nothing colours: its fragments are those that both GLs are charged
/// for.
State bare(const State& state);

} // namespace spangle::bench::states
