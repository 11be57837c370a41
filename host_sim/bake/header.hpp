// What was baked as a C++ header of constants (spangle/baked.hpp).
#pragma once

#include <string>
#include <vector>

#include "host_sim/bake/mesh.hpp"
#include "host_sim/bake/texture.hpp"

namespace spangle::bake {

struct HeaderInput {
    std::string name;      ///< of the namespace, inside of spangle::baked
    std::string command;   ///< that writes it again
    const BakedMesh* mesh; ///< null: textures only
    const std::vector<BakedTexture>* textures;
    const std::vector<bool>* translucent; ///< of the pictures
};

std::string write_header(const HeaderInput& input);

/// Letters, digits and underscores, not a digit first; empty: nothing of it can be kept.
std::string identifier_of(const std::string& text);

} // namespace spangle::bake
