// Small programs of public GL that draw what no scene draws. Each shows one system, in a picture that is
// compared with Mesa's.
#pragma once

#include "boards/scenes/scene.hpp"

namespace spangle::oracle {

scenes::SceneList probes();

/// Returns the scene or probe with this id, or null.
const scenes::Scene* find_picture(const char* id);

} // namespace spangle::oracle
