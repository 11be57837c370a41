// Probes of the vertex half (rows B, C, D11 and F20).
#pragma once

#include "boards/scenes/scene.hpp"

namespace spangle::oracle {

extern const scenes::Scene outlines, divided_quads, two_units, cut_torus, sphere_mapped, planes_mapped;

} // namespace spangle::oracle
