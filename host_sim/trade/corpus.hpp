// Programs that are measured beside the scenes. Each shows one system of GL, or a case with numbers of very
// different sizes.
#pragma once

#include "boards/scenes/scene.hpp"

namespace spangle::trade {

/// All programs of the corpus, in the order of their ids.
scenes::SceneList corpus();
/// Whether a program of the corpus needs a stencil buffer.
bool needs_stencil(const scenes::Scene& program);

} // namespace spangle::trade
