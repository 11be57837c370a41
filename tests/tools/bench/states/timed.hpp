// Times the states that standard input names, on the GL that this file is compiled for. Prints "NUMBER
// MICROSECONDS" for each.
#pragma once

#include "tests/tools/bench/states/words.hpp"

namespace spangle::bench::states {

/// `select` makes a context with GL's initial state current, or returns false if there is none. time_all()
/// returns main()'s status.
int time_all(std::uint32_t seed, bool (*select)(const State&));

} // namespace spangle::bench::states
