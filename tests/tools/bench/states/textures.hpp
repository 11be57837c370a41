// Makes the textures of a state.
#pragma once

#include "tests/tools/bench/states/words.hpp"

namespace spangle::bench::states {

inline constexpr int texture_size = 64, sprite_size = 32; ///< texels each way

/// Makes and binds the state's textures, sets their parameters, and enables them.
void set_textures(const State& state);

/// Deletes what set_textures() made.
void forget_textures();

} // namespace spangle::bench::states
