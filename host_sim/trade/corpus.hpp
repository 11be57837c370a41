// Programs that are measured beside the scenes: each is one system of GL, or one place where numbers are far
// apart.
#pragma once

#include "boards/scenes/scene.hpp"

namespace spangle::trade {

/// All of them, in the order of their ids.
scenes::SceneList corpus();
/// Whether a program of it needs a stencil buffer.
bool needs_stencil(const scenes::Scene& program);

} // namespace spangle::trade
