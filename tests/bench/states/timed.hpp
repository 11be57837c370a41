// Times states that standard input names, on the GL that this is compiled for: "NUMBER MICROSECONDS" of each.
#pragma once

#include "tests/bench/states/words.hpp"

namespace spangle::bench::states {

/// `select` makes a context current whose state is GL's default; false: there is none. Returns main()'s
/// status.
int time_all(std::uint32_t seed, bool (*select)(const State&));

} // namespace spangle::bench::states
