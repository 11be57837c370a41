// Probes of evaluators (rows H01 and H02).
#pragma once

#include "boards/scenes/scene.hpp"

namespace spangle::oracle {

extern const scenes::Scene patches;

} // namespace spangle::oracle
