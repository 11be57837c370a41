// Small programs of public GL that draw what no scene does: each shows one system, for a picture beside
// Mesa's.
#pragma once

#include "boards/scenes/scene.hpp"

namespace spangle::oracle {

scenes::SceneList probes();

/// The scene or probe with this id, or null.
const scenes::Scene* find_picture(const char* id);

} // namespace spangle::oracle
